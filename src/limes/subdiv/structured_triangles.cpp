#include "limes/subdiv/structured_triangles.h"

#include <algorithm>
#include <bit>
#include <limits>

#include "limes/core/error.h"
#include "limes/subdiv/triangle_sides.h"

namespace limes {

bool StructuredTriangles::applies(const Topology& topology, const Features& features,
                                  const Scheme& scheme) {
  return topology.uniform_face_size() == 3 && can_follow(features) &&
         regular_triangle_masks(scheme).has_value();
}

StructuredTriangles::StructuredTriangles(const Adjacency& control, const Features& features,
                                         const Scheme& scheme, int depth)
    : GridRefinement(control, features, scheme, depth),
      masks_(regular_triangle_masks(scheme).value()),
      numbering_(depth) {
  LIMES_ASSERT(applies(control.topology(), features, scheme));
  triangles_.resize(static_cast<std::size_t>(control.topology().num_faces()));
  number_runs();
  number_sides(Sharpness(control, features));
  gather_grids();
}

void StructuredTriangles::number_runs() {
  const std::int64_t faces = control_->topology().num_faces();
  std::int64_t vertices = control_->topology().num_vertices();
  constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max();
  const std::int64_t fine_faces = faces << (2 * depth_);
  for (int birth = 1; birth <= depth_; ++birth) {
    const std::int64_t n = std::int64_t{1} << (birth - 1);
    first_vertex_[static_cast<std::size_t>(birth)] = static_cast<int>(vertices);
    vertices += control_->num_edges() * n + faces * 3 * n * (n - 1) / 2;
    if (std::max(vertices, 3 * fine_faces) > most)
      throw InputError("refinement would have {} faces; at most {} can be numbered", fine_faces,
                       most / 3);
  }
  num_vertices_ = static_cast<int>(vertices);
}

void StructuredTriangles::number_sides(const Sharpness& sharpness) {
  const auto make_rules = [&](float s, bool boundary) {
    return triangle_line_rules(*scheme_, s, boundary);
  };
  int sides = 0;
  for (int f = 0; f < control_->topology().num_faces(); ++f) {
    Triangle& t = triangles_[static_cast<std::size_t>(f)];
    t.sides_before = sides;
    t.owned = 0;
    for (int s = 0; s < 3; ++s) {
      const HalfedgeId h = control_->topology().halfedge(FaceId(f), s);
      const HalfedgeId twin = control_->twin(h);
      const EdgeId e = control_->edge(h);
      const bool owned = control_->halfedge(e) == h;
      if (owned) t.owned |= 1U << s;
      const auto side = static_cast<std::size_t>(s);
      t.lender[side] = owned ? -1 : control_->corner_index(twin);
      t.line[side] = lines_.find(sharpness.edge(e), !twin.valid(), depth_, make_rules);
    }
    sides += std::popcount(t.owned);
    auto& runs = runs_[t.owned];
    if (!runs) runs = std::make_unique<TriangleRuns>(numbering_, t.owned);
  }
}

namespace {

/// Place on the grid of one cell with its margin.
std::size_t control_slot(GridPoint p) {
  return static_cast<std::size_t>(4 * (p.j + 1) + p.i + 1);
}

}  // namespace

void StructuredTriangles::gather_grid(FaceId f) {
  Triangle& t = triangles_[static_cast<std::size_t>(f.value)];
  t.control.fill(control_->topology().face(f)[0]);
  t.ring.fill(-1);
  t.own_corners = 0;
  for (int c = 0; c < 3; ++c) {
    const HalfedgeId h = control_->topology().halfedge(f, c);
    const VertexId v = control_->from(h);
    t.control[control_slot(TriangleSide(c, 1).node(0))] = v;
    if (rings_.ring_of(v) < 0) {
      gather_corner(h, c, t);
      if (control_->ring_start(v) == h) t.own_corners |= 1U << c;
    } else if (const HalfedgeId twin = control_->twin(h); twin.valid()) {
      const GridPoint beyond = triangle_direction(2 * c + 5);
      t.control[control_slot(TriangleSide(c, 1).node(0) + beyond)] =
          control_->to(control_->next(twin));
    }
  }
}

/// The three neighbours of a regular corner that lie clockwise after the side that starts there, and
/// where its ring starts.
void StructuredTriangles::gather_corner(HalfedgeId h, int corner, Triangle& t) const {
  const HalfedgeId start = control_->ring_start(control_->from(h));
  HalfedgeId out = h;
  for (int turned = 0; turned < 6; ++turned) {
    if (out == start)
      t.corner_axis[static_cast<std::size_t>(corner)] = (2 * corner + 6 - turned) % 3;
    const int direction = 2 * corner - turned;
    if (turned >= 1 && turned <= 3)
      t.control[control_slot(TriangleSide(corner, 1).node(0) + triangle_direction(direction))] =
          control_->to(out);
    out = control_->next(control_->twin(out));
  }
}

void StructuredTriangles::place_ring(FaceId f, int corner, int ring, int edge) {
  Triangle& t = triangles_[static_cast<std::size_t>(f.value)];
  t.ring[static_cast<std::size_t>(corner)] = ring;
  t.ring_edge[static_cast<std::size_t>(corner)] = edge;
}

int StructuredTriangles::first_of_run(FaceId f, int birth) const {
  const int n = 1 << (birth - 1);
  return first_vertex_[static_cast<std::size_t>(birth)] + f.value * (3 * n * (n - 1) / 2) +
         n * triangle(f).sides_before;
}

void StructuredTriangles::split_face(FaceId f, VertexId* out) const {
  // The last step is written to its place, those before to two buffers in turn.
  constexpr std::size_t most = std::size_t{3} << (2 * TriangleNumbering::max_depth - 2);
  thread_local std::array<std::array<VertexId, most>, 2> buffers;
  const Triangle& t = triangle(f);
  const VertexId* corners = control_->topology().face(f).data();
  for (int birth = 1; birth <= depth_; ++birth) {
    VertexId* fine = birth == depth_ ? out : buffers[static_cast<std::size_t>(birth % 2)].data();
    kernel_->split(1 << (2 * birth - 2), corners, runs(t).edge_ranks(birth).data(),
                   first_of_run(f, birth), fine);
    for (int s = 0; s < 3; ++s)
      if (t.lender[static_cast<std::size_t>(s)] >= 0) borrow_side(f, s, birth, fine);
    corners = fine;
  }
}

/// Numbers of the vertices on a side that a lower face has numbered, in reverse order.
void StructuredTriangles::borrow_side(FaceId f, int side, int birth, VertexId* corners) const {
  const FaceId owner = control_->face(control_->twin(control_->topology().halfedge(f, side)));
  const int first = first_of_run(owner, birth);
  const int lender = triangle(f).lender[static_cast<std::size_t>(side)];
  const auto& theirs = runs(triangle(owner)).side_vertices(birth, lender);
  const auto& ours = runs(triangle(f)).side_vertices(birth, side);
  for (std::size_t k = 0; k < ours.size(); ++k)
    for (const std::uint16_t place : ours[k].places)
      corners[place] = VertexId(first + theirs[ours.size() - 1 - k].rank);
}

}  // namespace limes
