#include "limes/subdiv/grid_refinement.h"

#include <algorithm>

#include "limes/core/error.h"
#include "limes/core/interrupt.h"
#include "limes/core/parallel.h"
#include "limes/subdiv/crease.h"
#include "limes/subdiv/refined_features.h"
#include "limes/subdiv/structured.h"
#include "limes/subdiv/structured_triangles.h"
#include "limes/subdiv/surroundings.h"

namespace limes {
namespace {

/// Calls work(i) for 0 <= i < count in blocks; can be interrupted between them.
template <class Work>
void for_each_until_interrupted(std::int64_t count, std::int64_t grain, const Work& work) {
  for_each_block(count, grain, [&](std::int64_t begin, std::int64_t end) {
    check_interrupt();
    for (std::int64_t i = begin; i < end; ++i)
      work(i);
  });
}

}  // namespace

bool GridRefinement::can_follow(const Features& features) {
  const bool even = features.crease_method == CreaseMethod::uniform ||
                    std::all_of(features.edges.begin(), features.edges.end(),
                                [](const SharpEdge& e) { return is_infinite(e.sharpness); });
  return even && !features.sector_stencils;
}

GridRefinement::GridRefinement(const Adjacency& control, const Features& features,
                               const Scheme& scheme, int depth)
    : control_(&control),
      features_(features),
      scheme_(&scheme),
      depth_(depth),
      rings_(control, features, scheme, depth) {
  for (int v = 0; v < control.topology().num_vertices(); ++v)
    if (!control.ring_start(VertexId(v)).valid()) unused_.push_back(VertexId(v));
}

void GridRefinement::gather_grids() {
  for_each_until_interrupted(control_->topology().num_faces(), 256,
                             [&](std::int64_t f) { gather_grid(FaceId(f)); });
  for (int ring = 0; ring < rings_.size(); ++ring) {
    const HalfedgeId start = control_->ring_start(rings_.vertex(ring));
    int edge = 0;
    for (HalfedgeId h = start; h.valid(); ++edge) {
      place_ring(control_->face(h), control_->corner_index(h), ring, edge);
      h = control_->ring_next(h);
      if (h == start) break;
    }
  }
}

void GridRefinement::positions(std::span<const Vec3> control, std::span<Vec3> fine) {
  LIMES_ASSERT(static_cast<int>(control.size()) == control_->topology().num_vertices());
  LIMES_ASSERT(static_cast<int>(fine.size()) == num_vertices_);
  for (const VertexId v : unused_)
    fine[static_cast<std::size_t>(v.value)] = control[static_cast<std::size_t>(v.value)];
  for_each_until_interrupted(rings_.size(), 64, [&](std::int64_t ring) {
    refine_ring(static_cast<int>(ring), control, fine);
  });
  for_each_until_interrupted(control_->topology().num_faces(), 16,
                             [&](std::int64_t f) { refine_face(FaceId(f), control, fine); });
}

void GridRefinement::refine_ring(int ring, std::span<const Vec3> control, std::span<Vec3> fine) {
  rings_.refine(ring, control, fine[static_cast<std::size_t>(rings_.vertex(ring).value)]);
}

void GridRefinement::update(std::span<const Vec3> control, std::span<const VertexId> moved,
                            std::span<Vec3> fine) {
  for (const VertexId v : moved)
    if (!control_->ring_start(v).valid())
      fine[static_cast<std::size_t>(v.value)] = control[static_cast<std::size_t>(v.value)];
  // What moves with a vertex: the rings at the corners of its faces, and all faces at these.
  const std::vector<VertexId> near = surrounded_by(*control_, moved).vertices;
  for (const VertexId v : near)
    if (const int ring = rings_.ring_of(v); ring >= 0) refine_ring(ring, control, fine);
  const std::vector<FaceId> faces = faces_around(*control_, near);
  for_each_until_interrupted(static_cast<std::int64_t>(faces.size()), 16, [&](std::int64_t i) {
    refine_face(faces[static_cast<std::size_t>(i)], control, fine);
  });
}

void GridRefinement::corners(std::span<VertexId> out) const {
  const std::int64_t per_face = std::int64_t{face_size()} << (2 * depth_);
  LIMES_ASSERT(static_cast<std::int64_t>(out.size()) ==
               per_face * control_->topology().num_faces());
  for_each_until_interrupted(control_->topology().num_faces(), 16, [&](std::int64_t f) {
    split_face(FaceId(f), out.data() + f * per_face);
  });
}

Features GridRefinement::features() const {
  return refined_features(*control_, features_, scheme_->split, depth_);
}

std::unique_ptr<GridRefinement> grid_refinement(const Adjacency& control, const Features& features,
                                                const Scheme& scheme, int depth) {
  const Topology& topology = control.topology();
  if (depth <= QuadNumbering::max_depth &&
      StructuredRefinement::applies(topology, features, scheme))
    return std::make_unique<StructuredRefinement>(control, features, scheme, depth);
  if (depth <= TriangleNumbering::max_depth &&
      StructuredTriangles::applies(topology, features, scheme))
    return std::make_unique<StructuredTriangles>(control, features, scheme, depth);
  return nullptr;
}

}  // namespace limes
