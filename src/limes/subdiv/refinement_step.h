#pragma once

#include <span>

#include "limes/core/types.h"
#include "limes/mesh/adjacency.h"
#include "limes/subdiv/scheme.h"

namespace limes {

/// One step of a scheme on one mesh. The weights go straight to values (apply) or into a matrix,
/// from the same rules. Keeps references to all three arguments.
class RefinementStep {
 public:
  /// @throws InputError if the scheme does not fit the faces, naming the first that does not
  RefinementStep(const Adjacency& parent, const Features& features, const Scheme& scheme);

  [[nodiscard]] int num_child_vertices() const;
  [[nodiscard]] int num_child_faces() const;
  [[nodiscard]] Topology child_topology() const;
  [[nodiscard]] Features child_features() const;

  /// Values of the child's vertices. The same bits for any number of threads.
  /// @param coarse  one value per parent vertex
  /// @param fine    num_child_vertices() values, written
  void apply(std::span<const double> coarse, std::span<double> fine) const;
  void apply(std::span<const Vec2> coarse, std::span<Vec2> fine) const;
  void apply(std::span<const Vec3> coarse, std::span<Vec3> fine) const;

  /// Renews the values that change when some parent vertices have.
  /// @return the child vertices that were renewed, ascending
  std::vector<VertexId> update(std::span<const Vec3> coarse, std::span<const VertexId> changed,
                               std::span<Vec3> fine) const;

  /// The operator S with fine = S coarse, (num_child_vertices, num_parent_vertices); a vertex that
  /// no face uses keeps its value.
  [[nodiscard]] SparseMatrix matrix() const;

  /// Writes the row of one child vertex into a cleared stencil; of a face only where the scheme gives
  /// faces a new vertex.
  void face_stencil(NeighbourhoodWalk& walk, FaceId f, Stencil& out) const;
  void edge_stencil(NeighbourhoodWalk& walk, EdgeId e, Stencil& out) const;
  void vertex_stencil(NeighbourhoodWalk& walk, VertexId v, Stencil& out) const;

 private:
  [[nodiscard]] int num_face_points() const {
    return scheme_->split == Split::quads ? parent_->topology().num_faces() : 0;
  }
  template <class Value>
  void apply_values(std::span<const Value> coarse, std::span<Value> fine) const;

  const Adjacency* parent_;
  const Features* features_;
  const Scheme* scheme_;
  Sharpness sharpness_;

 public:
  /// For callers that walk on their own.
  [[nodiscard]] NeighbourhoodWalk walk() const { return {*parent_, *features_, sharpness_}; }
};

/// Adds a stencil to one matrix row, face points replaced by the means of their corners.
void append_stencil_row(int row, const Stencil& stencil, const Topology& topology,
                        std::vector<Triplet>& out);

}  // namespace limes
