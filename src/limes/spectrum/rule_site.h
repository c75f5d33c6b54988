#pragma once

#include <memory>
#include <optional>

#include "limes/spectrum/lattice.h"
#include "limes/spectrum/rules.h"

namespace limes {

/// A mesh on which rules are read off: one step of a scheme as weights, and what each new vertex is
/// made from.
class RuleSite {
 public:
  /// @param step  number of the step, from 0; the mesh is refined so often before
  RuleSite(const Scheme& scheme, const Lattice& lattice, double tension, int step);
  RuleSite(const Scheme& scheme, const Star& star);
  RuleSite(const RuleSite&) = delete;
  RuleSite& operator=(const RuleSite&) = delete;

  [[nodiscard]] const Adjacency& adjacency() const { return *adjacency_; }
  [[nodiscard]] Vec2 point(VertexId v) const { return points_[to_index(v)].head<2>(); }

  /// The new vertices that are made from a vertex, its edges, its faces and their corners there.
  [[nodiscard]] std::vector<VertexId> children_around(VertexId v) const;
  /// Those that are made from a face's corners or sides.
  [[nodiscard]] std::vector<VertexId> children_in(FaceId f) const;
  [[nodiscard]] const ChildVertex& source(VertexId child) const {
    return sources_[to_index(child)];
  }
  /// The vertex, ends of the edge, or corners of the face that a new vertex is made from.
  [[nodiscard]] std::vector<VertexId> element(VertexId child) const;

  /// (new vertices, old vertices)
  [[nodiscard]] const SparseMatrix& matrix() const { return matrix_; }
  /// Where the step moves a new vertex from the mesh's own points.
  [[nodiscard]] Vec2 child_point(VertexId child) const;

 private:
  static std::size_t to_index(VertexId v) { return static_cast<std::size_t>(v.value); }
  void make_step(const Scheme& scheme, const Features& features);
  void bisect_and_smooth(const Scheme& scheme);

  Topology topology_;
  std::vector<Vec3> points_;
  std::unique_ptr<const Adjacency> adjacency_;
  std::vector<ChildVertex> sources_;
  SparseMatrix matrix_;
};

}  // namespace limes
