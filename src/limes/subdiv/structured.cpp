#include "limes/subdiv/structured.h"

#include <algorithm>
#include <limits>

#include "limes/core/error.h"
#include "limes/subdiv/quad_sides.h"

namespace limes {

bool StructuredRefinement::applies(const Topology& topology, const Features& features,
                                   const Scheme& scheme) {
  return topology.uniform_face_size() == 4 && can_follow(features) &&
         regular_masks(scheme).has_value();
}

StructuredRefinement::StructuredRefinement(const Adjacency& control, const Features& features,
                                           const Scheme& scheme, int depth)
    : GridRefinement(control, features, scheme, depth),
      masks_(regular_masks(scheme).value()),
      numbering_(depth) {
  LIMES_ASSERT(applies(control.topology(), features, scheme));
  quads_.resize(static_cast<std::size_t>(control.topology().num_faces()));
  number_runs();
  number_sides(Sharpness(control, features));
  gather_grids();
}

void StructuredRefinement::number_runs() {
  const std::int64_t faces = control_->topology().num_faces();
  std::int64_t vertices = control_->topology().num_vertices();
  constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max();
  if (faces << (2 * depth_ + 2) > most)
    throw InputError("refinement would have {} faces; at most {} can be numbered",
                     faces << (2 * depth_), most / 4);
  for (int birth = 1; birth <= depth_; ++birth) {
    const std::int64_t n = std::int64_t{1} << (birth - 1);
    const std::int64_t edges = control_->num_edges() * n + faces * 2 * n * (n - 1);
    if (vertices + edges + faces * n * n > most)
      throw InputError("refinement would have {} vertices; at most {} can be numbered",
                       vertices + edges + faces * n * n, most);
    first_edge_vertex_[static_cast<std::size_t>(birth)] = static_cast<int>(vertices);
    first_face_vertex_[static_cast<std::size_t>(birth)] = static_cast<int>(vertices + edges);
    vertices += edges + faces * n * n;
  }
  num_vertices_ = static_cast<int>(vertices);
}

void StructuredRefinement::number_sides(const Sharpness& sharpness) {
  const auto make_rules = [&](float s, bool boundary) { return line_rules(*scheme_, s, boundary); };
  int sides = 0;
  for (int f = 0; f < control_->topology().num_faces(); ++f) {
    Quad& q = quads_[static_cast<std::size_t>(f)];
    q.sides_before = sides;
    q.owned = 0;
    for (int s = 0; s < 4; ++s) {
      const HalfedgeId h = control_->topology().halfedge(FaceId(f), s);
      const HalfedgeId twin = control_->twin(h);
      if (!twin.valid() || h < twin) {
        q.owned |= 1U << s;
        ++sides;
      }
      q.line[static_cast<std::size_t>(s)] =
          lines_.find(sharpness.edge(control_->edge(h)), !twin.valid(), depth_, make_rules);
    }
    auto& runs = runs_[q.owned];
    if (!runs) runs = std::make_unique<QuadRuns>(numbering_, q.owned);
  }
}

void StructuredRefinement::gather_grid(FaceId f) {
  Quad& q = quads_[static_cast<std::size_t>(f.value)];
  for (int s = 0; s < 4; ++s)
    gather_side(f, s, q);
  q.ring.fill(-1);
  q.own_corners = 0;
  for (int c = 0; c < 4; ++c) {
    const HalfedgeId h = control_->topology().halfedge(f, c);
    const VertexId v = control_->from(h);
    if (rings_.ring_of(v) < 0 && control_->ring_start(v) == h) q.own_corners |= 1U << c;
  }
}

void StructuredRefinement::gather_side(FaceId f, int side, Quad& q) const {
  const HalfedgeId h = control_->topology().halfedge(f, side);
  const HalfedgeId twin = control_->twin(h);

  // On the grid of one cell: the two corners, the margin beyond the side and the margin's corner.
  // Where nothing lies beyond, or something irregular, any point does: nobody reads what comes of it.
  const QuadSide at(side, 1);
  const auto slot = [&](GridPoint p) -> VertexId& {
    return q.control[static_cast<std::size_t>(4 * (p.j + 1) + p.i + 1)];
  };
  const GridPoint outwards = -1 * at.inward();
  const VertexId from = control_->from(h);
  slot(at.node(0)) = from;
  slot(at.node(0) + outwards) = from;
  slot(at.node(1) + outwards) = control_->to(h);
  slot(at.node(0) + outwards - at.direction()) = from;
  if (!twin.valid()) return;
  const HalfedgeId beside = control_->next(twin);
  slot(at.node(0) + outwards) = control_->to(beside);
  slot(at.node(1) + outwards) = control_->from(control_->prev(twin));
  const HalfedgeId opposite = control_->twin(beside);
  if (opposite.valid())
    slot(at.node(0) + outwards - at.direction()) = control_->from(control_->prev(opposite));
}

void StructuredRefinement::place_ring(FaceId f, int corner, int ring, int edge) {
  Quad& q = quads_[static_cast<std::size_t>(f.value)];
  q.ring[static_cast<std::size_t>(corner)] = ring;
  q.ring_edge[static_cast<std::size_t>(corner)] = edge;
}

int StructuredRefinement::first_of_edge_run(FaceId f, int birth) const {
  const int n = 1 << (birth - 1);
  return first_edge_vertex_[static_cast<std::size_t>(birth)] + f.value * 2 * n * (n - 1) +
         n * quad(f).sides_before;
}

int StructuredRefinement::first_of_face_run(FaceId f, int birth) const {
  const int n = 1 << (birth - 1);
  return first_face_vertex_[static_cast<std::size_t>(birth)] + f.value * n * n;
}

void StructuredRefinement::split_face(FaceId f, VertexId* out) const {
  // The last step is written to its place, those before to two buffers in turn.
  constexpr std::size_t most = std::size_t{1} << (2 * QuadNumbering::max_depth);
  thread_local std::array<std::array<VertexId, most>, 2> buffers;
  const QuadRuns& r = runs(quad(f));
  const auto borrowed = borrowed_sides(f);
  const VertexId* corners = control_->topology().face(f).data();
  for (int birth = 1; birth <= depth_; ++birth) {
    VertexId* fine = birth == depth_ ? out : buffers[static_cast<std::size_t>(birth % 2)].data();
    kernel_->split(1 << (2 * birth - 2), corners, r.edge_ranks(birth).data(),
                   first_of_edge_run(f, birth), first_of_face_run(f, birth), fine);
    for (int s = 0; s < 4; ++s)
      if (borrowed[static_cast<std::size_t>(s)].runs)
        borrow_side(r.side_vertices(birth, s), borrowed[static_cast<std::size_t>(s)], birth, fine);
    corners = fine;
  }
}

std::array<StructuredRefinement::BorrowedSide, 4> StructuredRefinement::borrowed_sides(
    FaceId f) const {
  std::array<BorrowedSide, 4> borrowed{};
  for (int s = 0; s < 4; ++s) {
    if (((quad(f).owned >> s) & 1U) != 0) continue;
    const HalfedgeId twin = control_->twin(control_->topology().halfedge(f, s));
    const FaceId owner = control_->face(twin);
    borrowed[static_cast<std::size_t>(s)] = {owner, control_->corner_index(twin),
                                             &runs(quad(owner))};
  }
  return borrowed;
}

void StructuredRefinement::borrow_side(const QuadRuns::SideVertex* vertices,
                                       const BorrowedSide& side, int birth,
                                       VertexId* corners) const {
  const int n = 1 << (birth - 1);
  const int first = first_of_edge_run(side.owner, birth);
  const std::uint16_t* rank = side.runs->side_ranks(birth, side.side) + n;  // in reverse order
  for (int k = 0; k < n; ++k, ++vertices)
    corners[vertices->first] = corners[vertices->second] = VertexId(first + *--rank);
}

}  // namespace limes
