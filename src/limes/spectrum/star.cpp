#include "limes/spectrum/star.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "limes/core/error.h"
#include "limes/mesh/shapes.h"
#include "limes/spectrum/impulses.h"
#include "limes/subdiv/edge_choice.h"
#include "limes/subdiv/quasi_smoothing.h"
#include "limes/subdiv/refinement_step.h"
#include "limes/subdiv/schemes.h"

namespace limes {
namespace {

constexpr int most_valence = 100;

bool is_dual(Split split) {
  return split == Split::dual || split == Split::mid_edge;
}

bool is_four_eight(Split split) {
  return split == Split::four_eight || split == Split::longest_edges;
}

Star star_of(Mesh mesh, int sectors) {
  Star star;
  star.topology = std::move(mesh.topology);
  star.points = std::move(mesh.points.vector());
  star.sectors = sectors;
  return star;
}

/// Around an n-gon: what Doo-Sabin makes of a star, a face around its middle vertex.
Star dual_star(int n, int rings) {
  Star star =
      refine_star(star_of(shapes::star(n, rings / 2 + 2), n), find_scheme("doo-sabin")).child;
  star.around_face = true;
  star.options.level = 0;
  star.first_angle = std::numbers::pi / n;
  return star;
}

/// The regular 4-8 pattern around a vertex with two edges per sector: what the first step of four-eight
/// makes of a star of quads.
Star four_eight_star(int sectors, int rings) {
  return refine_star(star_of(shapes::star(sectors, rings), sectors), find_scheme("four-eight"))
      .child;
}

/// quasi-four-eight chooses edges by their lengths. Where the pattern repeats (the paper's stationary
/// case) these are the edges opposite the newest vertices, and its smoothing is linear; the rules of
/// the boundary do not matter here.
StarStep refine_stationary(const Star& star) {
  const Adjacency adjacency(star.topology, Adjacency::Check::edges);
  const Bisection step = bisect(adjacency, newest_vertex_edges(adjacency), FirstCorner::newest);
  const auto smooth = [&](std::span<const Vec3> coarse, std::span<Vec3> fine) {
    quasi_smoothing(adjacency, step, {}, {.boundary = QuasiBoundary::fixed}, coarse, fine);
  };
  StarStep result{star, {}};
  result.child.topology = step.child;
  ++result.child.options.level;
  result.child.points.resize(static_cast<std::size_t>(step.child.num_vertices()));
  smooth(star.points, result.child.points);
  constexpr int reach =
      4;  // a vertex depends on corners of faces around it and across their far sides
  result.matrix = matrix_of_action(adjacency, reach, step.child.num_vertices(), smooth);
  return result;
}

double angle_of(const Vec3& x) {
  return std::atan2(x.y(), x.x());
}

/// The angle between two directions, 0 to pi.
double angle_between(double a, double b) {
  return std::abs(std::remainder(a - b, 2 * std::numbers::pi));
}

}  // namespace

int steps_per_period(const Scheme& scheme) {
  const bool turns = scheme.split == Split::sqrt3 || scheme.split == Split::mid_edge ||
                     is_four_eight(scheme.split);
  return turns ? 2 : 1;
}

int rings_per_period(const Scheme& scheme) {
  return scheme.split == Split::sqrt3 ? 3 : 2;
}

bool has_valence(const Scheme& scheme, int valence) {
  if (valence > most_valence) return false;
  return is_four_eight(scheme.split) ? valence >= 4 && valence % 2 == 0 : valence >= 3;
}

void require_valence(const Scheme& scheme, int valence) {
  if (has_valence(scheme, valence)) return;
  if (is_four_eight(scheme.split))
    throw UsageError("--valence: {} is not possible with {}; even ones from 4 to {} are", valence,
                     scheme.name, most_valence);
  throw UsageError("--valence: {} is not possible with {}; 3 to {} are", valence, scheme.name,
                   most_valence);
}

namespace {

Star untensed_star(const Scheme& scheme, int valence, int rings) {
  if (is_dual(scheme.split)) return dual_star(valence, rings);
  if (is_four_eight(scheme.split)) return four_eight_star(valence / 2, rings);
  if (scheme.faces == FaceKind::triangles)
    return star_of(shapes::triangle_star(valence, rings), valence);
  return star_of(shapes::star(valence, rings), valence);
}

}  // namespace

Star control_star(const Scheme& scheme, int valence, int rings, const RuleOptions& options) {
  LIMES_ASSERT(has_valence(scheme, valence));
  Star star = untensed_star(scheme, valence, rings);
  const int level = star.options.level;
  star.options = options;
  star.options.level = level;
  return star;
}

StarStep refine_star(const Star& star, const Scheme& scheme) {
  if (scheme.needs_positions) return refine_stationary(star);
  const Adjacency adjacency(star.topology, Adjacency::Check::edges);
  Features features;
  static_cast<RuleOptions&>(features) = star.options;
  const RefinementStep step(adjacency, features, scheme);
  StarStep result{star, step.matrix()};
  result.child.topology = step.child_topology();
  result.child.options = step.child_features();
  // Positions that show the sectors whatever the tension.
  features.tension = RuleOptions{}.tension;
  result.child.points.resize(static_cast<std::size_t>(step.num_child_vertices()));
  RefinementStep(adjacency, features, scheme).apply(star.points, result.child.points);
  return result;
}

StarWalk::StarWalk(const Star& star)
    : star_(&star), adjacency_(star.topology, Adjacency::Check::edges) {
  find_first_spoke();
  count_rings();
}

void StarWalk::find_first_spoke() {
  const Topology& topology = star_->topology;
  const auto point = [&](VertexId v) { return star_->points[static_cast<std::size_t>(v.value)]; };
  std::vector<std::pair<HalfedgeId, VertexId>> spokes;  // and what shows their direction
  double least = std::numeric_limits<double>::infinity();
  if (star_->around_face) {
    FaceId middle;
    for (int f = 0; f < topology.num_faces(); ++f) {
      Vec3 sum = Vec3::Zero();
      for (const VertexId v : topology.face(FaceId(f)))
        sum += point(v);
      if (sum.norm() / topology.face_size(FaceId(f)) >= least) continue;
      least = sum.norm() / topology.face_size(FaceId(f));
      middle = FaceId(f);
    }
    for (int i = 0; i < topology.face_size(middle); ++i)
      spokes.emplace_back(topology.halfedge(middle, i),
                          topology.corner(topology.halfedge(middle, i)));
  } else {
    VertexId middle;
    for (int v = 0; v < topology.num_vertices(); ++v) {
      if (point(VertexId(v)).norm() >= least) continue;
      least = point(VertexId(v)).norm();
      middle = VertexId(v);
    }
    HalfedgeId h = adjacency_.ring_start(middle);
    do {
      spokes.emplace_back(h, adjacency_.to(h));
      h = adjacency_.ring_next(h);
    } while (h != adjacency_.ring_start(middle));
  }
  const auto off = [&](const auto& spoke) {
    return angle_between(angle_of(point(spoke.second)), star_->first_angle);
  };
  const auto first = *std::min_element(
      spokes.begin(), spokes.end(), [&](const auto& a, const auto& b) { return off(a) < off(b); });
  LIMES_ASSERT(off(first) < 1e-6);
  first_spoke_ = first.first;
}

void StarWalk::count_rings() {
  const Topology& topology = star_->topology;
  ring_ = IdArray<VertexId, int>(static_cast<std::size_t>(topology.num_vertices()), -1);
  std::vector<VertexId> front;
  if (star_->around_face) {
    const auto corners = topology.face(adjacency_.face(first_spoke_));
    front.assign(corners.begin(), corners.end());
  } else {
    front = {adjacency_.from(first_spoke_)};
  }
  for (const VertexId v : front)
    ring_[v] = 0;
  for (int ring = 1; !front.empty(); ++ring) {
    std::vector<VertexId> next;
    for (const VertexId v : front) {
      HalfedgeId h = adjacency_.ring_start(v);
      do {
        for (const VertexId w : topology.face(adjacency_.face(h))) {
          if (ring_[w] >= 0) continue;
          ring_[w] = ring;
          next.push_back(w);
        }
        h = adjacency_.ring_next(h);
      } while (h.valid() && h != adjacency_.ring_start(v));
    }
    front = std::move(next);
  }
}

int StarWalk::outer_ring(FaceId f) const {
  int ring = 0;
  for (const VertexId v : star_->topology.face(f))
    ring = std::max(ring, ring_[v]);
  return ring;
}

int StarWalk::inner_ring(FaceId f) const {
  int ring = std::numeric_limits<int>::max();
  for (const VertexId v : star_->topology.face(f))
    ring = std::min(ring, ring_[v]);
  return ring;
}

HalfedgeId StarWalk::second_spoke() const {
  if (star_->around_face) return adjacency_.next(first_spoke_);
  const int spokes_per_sector =
      adjacency_.num_ring_faces(adjacency_.from(first_spoke_)) / star_->sectors;
  HalfedgeId h = first_spoke_;
  for (int i = 0; i < spokes_per_sector; ++i)
    h = adjacency_.ring_next(h);
  return h;
}

IdArray<VertexId, VertexId> StarWalk::same_walks(const StarWalk& other, HalfedgeId start,
                                                 int rings) const {
  const Topology& topology = star_->topology;
  IdArray<VertexId, VertexId> image(static_cast<std::size_t>(topology.num_vertices()));
  std::vector<bool> seen(static_cast<std::size_t>(topology.num_faces()), false);
  std::vector<std::pair<HalfedgeId, HalfedgeId>> stack{{first_spoke_, start}};
  seen[static_cast<std::size_t>(adjacency_.face(first_spoke_).value)] = true;
  while (!stack.empty()) {
    auto [ours, theirs] = stack.back();
    stack.pop_back();
    const int size = topology.face_size(adjacency_.face(ours));
    LIMES_ASSERT(other.star_->topology.face_size(other.adjacency_.face(theirs)) == size);
    for (int i = 0; i < size; ++i) {
      VertexId& known = image[adjacency_.from(ours)];
      LIMES_ASSERT(!known.valid() || known == other.adjacency_.from(theirs));
      known = other.adjacency_.from(theirs);
      const HalfedgeId across = adjacency_.twin(ours);
      if (across.valid() && !seen[static_cast<std::size_t>(adjacency_.face(across).value)] &&
          outer_ring(adjacency_.face(across)) <= rings) {
        LIMES_ASSERT(other.adjacency_.twin(theirs).valid());
        seen[static_cast<std::size_t>(adjacency_.face(across).value)] = true;
        stack.emplace_back(across, other.adjacency_.twin(theirs));
      }
      ours = adjacency_.next(ours);
      theirs = other.adjacency_.next(theirs);
    }
  }
  return image;
}

}  // namespace limes
