#pragma once

#include <array>
#include <optional>
#include <vector>

#include "limes/mesh/adjacency.h"
#include "limes/subdiv/features.h"
#include "limes/subdiv/stencil.h"

namespace limes {

/// An edge as part of a curve of an open net.
struct CurveEdge {
  bool on_curve = false;
  std::array<VertexId, 2> beyond;  ///< the curve's next vertices; none beyond a breakpoint
};

/// A net cut along its curves and continued beyond them by a layer of extrapolated faces, so that
/// every vertex of the mesh lies inside: the rules for closed nets then serve open ones
/// [kobbelt_1996]. Curves are the boundary and the infinitely sharp edges. A curve ends at its
/// breakpoints: infinitely sharp vertices, and vertices where not exactly two curve edges meet.
///
///      p'---q'          p'  = 2 p - mean of the other ends of the inner edges at p
///      |    |           A vertex of one face (p, q, r, s) without inner edges: 2 p - r,
///      p----q  curve    or at a breakpoint three vertices: 2 p - q, 2 p - s and their sum - p.
///      |    |
///
/// Faces and halfedges keep their ids; the layer's come behind them. A vertex on an inner curve is
/// there once for every part that meets in it: the first keeps its id, the others and the
/// extrapolated ones have new ids and stand for a few vertices of the mesh, see resolve().
class OpenNet {
 public:
  /// Keeps a reference to the mesh. Precondition: all faces are quads.
  /// @throws InputError for semi-sharp edges and vertices, and for an inner crease of one edge, which
  ///         cannot be cut
  OpenNet(const Adjacency& mesh, const Features& features);
  OpenNet(const OpenNet&) = delete;
  OpenNet& operator=(const OpenNet&) = delete;
  ~OpenNet() = default;

  /// The continued net.
  [[nodiscard]] const Adjacency& adjacency() const { return net_ ? *net_ : *mesh_; }

  [[nodiscard]] bool on_curve(HalfedgeId h) const {
    return !curve_.empty() && curve_[mesh_->edge(h)] != 0;
  }
  /// A halfedge of the mesh as part of its curve, if it has one: what lies beyond its start and its
  /// end.
  [[nodiscard]] CurveEdge curve(HalfedgeId h) const;

  /// Replaces vertices that only the continued net has by those they stand for. Copies leave the
  /// groups as they are: which part keeps a vertex shows in no bit, so that a piece of a mesh gets
  /// the bits of the whole.
  void resolve(Stencil& stencil) const;

 private:
  struct Term {
    VertexId vertex;
    double weight;
  };
  /// The faces of one part at a curve vertex, and what lies beyond.
  struct Sector {
    VertexId vertex;   // of the mesh
    VertexId copy;     // of the net
    HalfedgeId first;  // along the curve, away from the vertex; the part's faces to the left
    HalfedgeId last;   // along the curve, towards the vertex
    VertexId over_first, over_last;  // extrapolated vertices beside `copy` across the two edges
    VertexId between;                // the third at the breakpoint of a single face, else none
  };

  void find_curves(const Features& features);
  void find_sectors();
  void extrapolate(Sector& sector);
  void build_net();
  VertexId add_vertex(std::vector<Term> row);
  [[nodiscard]] bool is_breakpoint(VertexId v) const;
  /// The other end of the curve edge at v that is not `edge`; none if v is a breakpoint.
  [[nodiscard]] VertexId next_on_curve(VertexId v, EdgeId edge) const;

  const Adjacency* mesh_;
  IdArray<EdgeId, char> curve_;           // empty: the net is closed and smooth
  IdArray<VertexId, char> breakpoint_;    // likewise
  IdArray<HalfedgeId, VertexId> corner_;  // corners of the faces after the cuts
  std::vector<Sector> sectors_;
  std::vector<std::vector<Term>> rows_;  // of the net's vertices that the mesh does not have
  Topology topology_;
  std::optional<Adjacency> net_;
};

}  // namespace limes
