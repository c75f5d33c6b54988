#include "limes/subdiv/uniform.h"

#include <algorithm>

#include "limes/core/error.h"
#include "limes/core/memory.h"

namespace limes {

/// A step by the general rules and the mesh it makes.
struct UniformRefinement::GeneralStep {
  GeneralStep(const Adjacency& parent, Features parent_features, const Scheme& scheme)
      : features(std::move(parent_features)), step(parent, features, scheme) {}

  /// The mesh after the step: what another step needs.
  void make_child() {
    topology = step.child_topology();
    adjacency.emplace(topology, Adjacency::Check::edges);
    points.resize(static_cast<std::size_t>(step.num_child_vertices()));
  }

  Features features;  ///< before the step
  RefinementStep step;
  Topology topology;  ///< after the step, if another one follows; points as well
  std::optional<Adjacency> adjacency;
  std::vector<Vec3> points;
};

UniformRefinement::UniformRefinement(const Adjacency& control, const Features& features,
                                     const Scheme& scheme, int levels) {
  LIMES_ASSERT(levels >= 1);
  const Adjacency* parent = &control;
  Features current = features;
  for (int left = levels; left > 0; --left) {
    structured_ = grid_refinement(*parent, current, scheme, left);
    if (structured_) return;
    general_.push_back(std::make_unique<GeneralStep>(*parent, std::move(current), scheme));
    GeneralStep& made = *general_.back();
    if (left == 1) return;
    made.make_child();
    current = made.step.child_features();
    parent = &*made.adjacency;
  }
}

UniformRefinement::~UniformRefinement() = default;

int UniformRefinement::num_vertices() const {
  return structured_ ? structured_->num_vertices() : general_.back()->step.num_child_vertices();
}

int UniformRefinement::num_faces() const {
  return structured_ ? structured_->num_faces() : general_.back()->step.num_child_faces();
}

void UniformRefinement::positions(std::span<const Vec3> control, std::span<Vec3> fine) {
  std::span<const Vec3> coarse = control;
  for (const auto& general : general_) {
    const bool last = general == general_.back() && !structured_;
    const std::span<Vec3> next = last ? fine : std::span(general->points);
    general->step.apply(coarse, next);
    coarse = next;
  }
  if (structured_) structured_->positions(coarse, fine);
}

void UniformRefinement::update(std::span<const Vec3> control, std::span<const VertexId> moved,
                               std::span<Vec3> fine) {
  std::span<const Vec3> coarse = control;
  std::vector<VertexId> changed(moved.begin(), moved.end());
  for (const auto& general : general_) {
    const bool last = general == general_.back() && !structured_;
    const std::span<Vec3> next = last ? fine : std::span(general->points);
    changed = general->step.update(coarse, changed, next);
    coarse = next;
  }
  if (structured_) structured_->update(coarse, changed, fine);
}

void UniformRefinement::corners(std::span<VertexId> out) const {
  if (structured_) return structured_->corners(out);
  const Topology topology = general_.back()->step.child_topology();
  std::copy(topology.corners().begin(), topology.corners().end(), out.begin());
}

Topology UniformRefinement::topology() const {
  if (!structured_) return general_.back()->step.child_topology();
  const int size = structured_->face_size();
  std::vector<VertexId> corners;
  resize_fresh(corners, static_cast<std::size_t>(size) * static_cast<std::size_t>(num_faces()));
  structured_->corners(corners);
  return {num_vertices(), size, std::move(corners)};
}

Features UniformRefinement::features() const {
  return structured_ ? structured_->features() : general_.back()->step.child_features();
}

}  // namespace limes
