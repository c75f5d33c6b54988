#include "limes/subdiv/structured_triangles.h"

#include <algorithm>
#include <bit>
#include <limits>

#include "limes/core/error.h"
#include "limes/core/interrupt.h"
#include "limes/core/parallel.h"
#include "limes/subdiv/crease.h"
#include "limes/subdiv/refined_features.h"
#include "limes/subdiv/triangle_sides.h"

namespace limes {

bool StructuredTriangles::applies(const Topology& topology, const Features& features,
                                  const Scheme& scheme) {
  const bool varying = features.crease_method != CreaseMethod::uniform &&
                       std::any_of(features.edges.begin(), features.edges.end(),
                                   [](const SharpEdge& e) { return !is_infinite(e.sharpness); });
  return topology.uniform_face_size() == 3 && !varying && !features.sector_stencils &&
         regular_triangle_masks(scheme).has_value();
}

StructuredTriangles::StructuredTriangles(const Adjacency& control, const Features& features,
                                         const Scheme& scheme, int depth)
    : control_(&control),
      features_(features),
      scheme_(&scheme),
      masks_(regular_triangle_masks(scheme).value()),
      numbering_(depth),
      rings_(control, features, scheme, depth) {
  LIMES_ASSERT(applies(control.topology(), features, scheme));
  const Topology& topology = control.topology();
  const Sharpness sharpness(control, features);
  triangles_.resize(static_cast<std::size_t>(topology.num_faces()));
  number_runs();
  number_sides(sharpness);
  for_each_block(topology.num_faces(), 256, [&](std::int64_t begin, std::int64_t end) {
    check_interrupt();
    for (std::int64_t f = begin; f < end; ++f)
      gather_grid(FaceId(f));
  });
  for (int ring = 0; ring < rings_.size(); ++ring)
    place_ring(ring);
  for (int v = 0; v < topology.num_vertices(); ++v)
    if (!control.ring_start(VertexId(v)).valid()) unused_.push_back(VertexId(v));
}

int StructuredTriangles::num_faces() const {
  return control_->topology().num_faces() << (2 * numbering_.depth());
}

void StructuredTriangles::number_runs() {
  const std::int64_t faces = control_->topology().num_faces();
  std::int64_t vertices = control_->topology().num_vertices();
  constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max();
  const std::int64_t fine_faces = faces << (2 * numbering_.depth());
  for (int birth = 1; birth <= numbering_.depth(); ++birth) {
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
      t.line[side] = line_of(sharpness.edge(e), !twin.valid());
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

void StructuredTriangles::place_ring(int ring) {
  const HalfedgeId start = control_->ring_start(rings_.vertex(ring));
  int edge = 0;
  for (HalfedgeId h = start; h.valid(); ++edge) {
    const auto corner = static_cast<std::size_t>(control_->corner_index(h));
    Triangle& t = triangles_[static_cast<std::size_t>(control_->face(h).value)];
    t.ring[corner] = ring;
    t.ring_edge[corner] = edge;
    h = control_->ring_next(h);
    if (h == start) break;
  }
}

const StructuredTriangles::Line* StructuredTriangles::line_of(float sharpness, bool boundary) {
  if (!is_sharp(sharpness)) return nullptr;
  const auto [at, is_new] = lines_.try_emplace({sharpness, boundary});
  Line& line = at->second;
  if (!is_new) return &line;
  for (float s = sharpness; is_sharp(s) && static_cast<int>(line.size()) < numbering_.depth();
       s = decayed(s))
    line.push_back(triangle_line_rules(*scheme_, s, boundary));
  return &line;
}

int StructuredTriangles::first_of_run(FaceId f, int birth) const {
  const int n = 1 << (birth - 1);
  return first_vertex_[static_cast<std::size_t>(birth)] + f.value * (3 * n * (n - 1) / 2) +
         n * triangle(f).sides_before;
}

void StructuredTriangles::corners(std::span<VertexId> out) const {
  LIMES_ASSERT(static_cast<std::int64_t>(out.size()) == std::int64_t{3} * num_faces());
  const std::int64_t per_triangle = std::int64_t{3} << (2 * numbering_.depth());
  for_each_block(control_->topology().num_faces(), 16, [&](std::int64_t begin, std::int64_t end) {
    check_interrupt();
    for (std::int64_t f = begin; f < end; ++f)
      split_triangle(FaceId(f), out.data() + f * per_triangle);
  });
}

void StructuredTriangles::split_triangle(FaceId f, VertexId* out) const {
  // The last step is written to its place, those before to two buffers in turn.
  constexpr std::size_t most = std::size_t{3} << (2 * TriangleNumbering::max_depth - 2);
  thread_local std::array<std::array<VertexId, most>, 2> buffers;
  const Triangle& t = triangle(f);
  const VertexId* corners = control_->topology().face(f).data();
  for (int birth = 1; birth <= numbering_.depth(); ++birth) {
    VertexId* fine =
        birth == numbering_.depth() ? out : buffers[static_cast<std::size_t>(birth % 2)].data();
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

Features StructuredTriangles::features() const {
  return refined_features(*control_, features_, Split::triangles, numbering_.depth());
}

}  // namespace limes
