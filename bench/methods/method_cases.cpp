#include "method_cases.h"

#include <cmath>
#include <limits>
#include <memory>
#include <random>
#include <utility>

#include "boundary_tree.h"
#include "limes/core/error.h"
#include "limes/mesh/shapes.h"
#include "limes/subdiv/schemes.h"
#include "rational.h"
#include "stam.h"

namespace bench {

using namespace limes;

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

const Scheme& catmull_clark() {
  return find_scheme("catmull-clark");
}

FaceCase make_case(std::string name, Mesh mesh, int face, FaceCase::Kind kind,
                   BoundaryRule boundary = BoundaryRule::edges) {
  limes::test::perturb(mesh, 0.1);
  return {std::move(name), limes::test::make_model(mesh, boundary), FaceId(face), kind};
}

Ring ring_of(const FaceCase& c) {
  const Adjacency adjacency(c.model.topology);
  return gather_ring(adjacency, c.model.features, Sharpness(adjacency, c.model.features),
                     catmull_clark(), c.face);
}

SurfaceJet position_only(const Vec3& x) {
  const Vec3 none = Vec3::Constant(nan);
  return {x, none, none, none, none, none};
}

Evaluate by_limes(const FaceCase& c) {
  struct Tables {
    LimitBasis basis;
    BulkEvaluator bulk;
    explicit Tables(const FaceCase& at)
        : basis(at.model.topology, at.model.features, catmull_clark()),
          bulk(basis, at.model.points) {}
  };
  return [tables = std::make_shared<Tables>(c), face = c.face](const Place& p) {
    SurfaceJet jet;
    (void)tables->bulk.evaluate({face, 0, p.uv}, 2, jet);
    return jet;
  };
}

Evaluate by_stam(const FaceCase& c) {
  const Ring ring = ring_of(c);
  const auto table = std::make_shared<StamTable>(ring, catmull_clark());
  return [table, projected = table->project(controls_of(ring, c.model.points))](const Place& p) {
    return table->evaluate(projected, p.uv);
  };
}

/// Controls in the order of BoundaryTree, from the 4 x 4 or 3 x 3 grid points that cases have there.
Points grid_controls(const FaceCase& c, BoundaryTree::Face& face) {
  LIMES_ASSERT(c.kind != FaceCase::Kind::inner);
  const bool corner = c.kind == FaceCase::Kind::corner;
  face = corner ? BoundaryTree::Face::corner : BoundaryTree::Face::boundary;
  const int width = corner ? 3 : 4;
  const int first = c.face.value - (corner ? 0 : 1);
  Points out(3 * width, 3);
  for (int line = 0; line < 3; ++line)
    for (int i = 0; i < width; ++i)
      out.row(width * line + i) = c.model.points[static_cast<std::size_t>(5 * line + first + i)];
  return out;
}

Evaluate by_tree(const FaceCase& c) {
  BoundaryTree::Face face{};
  const Points controls = grid_controls(c, face);
  return [tree = std::make_shared<BoundaryTree>(face), controls](const Place& p) {
    return tree->evaluate(controls, p.uv);
  };
}

Evaluate by_phantoms(const FaceCase& c) {
  BoundaryTree::Face face{};
  const Points controls = grid_controls(c, face);
  return [patch = Points(phantom_matrix(face) * controls)](const Place& p) {
    return jet_of(bicubic_weights(p.uv, Mat2::Identity()).transpose() * patch);
  };
}

Evaluate by_rationals(const FaceCase& c) {
  const Ring ring = ring_of(c);
  const auto evaluator = std::make_shared<RationalEvaluator>(catmull_clark());
  return [=, controls = controls_of(ring, c.model.points)](const Place& p) {
    const VectorX weights = evaluator->weights(ring, 0, {p.u, p.v, p.denominator});
    return position_only(controls.transpose() * weights);
  };
}

Evaluate by_refinement(const FaceCase& c) {
  return [&c](const Place& p) {
    return position_only(
        limes::test::limit_by_refinement(c.model, catmull_clark(), c.face, 0, p.uv, 20));
  };
}

}  // namespace

std::vector<FaceCase> face_cases() {
  using Kind = FaceCase::Kind;
  std::vector<FaceCase> out{
      make_case("regular", shapes::torus(8, 6), 0, Kind::inner),
  };
  for (const int n : {3, 5, 8, 32})
    out.push_back(make_case(fmt::format("valence {}", n), shapes::disk(n, 3), 0, Kind::inner));
  const auto sharp_corners = BoundaryRule::edges_and_corners;
  out.push_back(make_case("boundary", shapes::grid(4, 4), 1, Kind::boundary, sharp_corners));
  out.push_back(make_case("corner", shapes::grid(4, 4), 0, Kind::corner, sharp_corners));
  out.push_back(make_case("boundary vertex with 3 faces", shapes::half_disk(3, 3), 0, Kind::inner));
  out.push_back(make_case("boundary vertex with 4 faces", shapes::half_disk(4, 3), 0, Kind::inner));
  Mesh creased = shapes::torus(8, 6);
  const auto corners = creased.topology.face(FaceId(0));
  creased.tags.creases = {{corners[0], corners[1], 2.3F}};
  out.push_back(make_case("semi-sharp crease", creased, 0, Kind::inner));
  return out;
}

std::vector<Place> sample_places(const FaceCase& c, int n) {
  std::mt19937_64 random(1998);
  std::uniform_int_distribution<int> any(1, 126);
  std::vector<Place> out;
  for (int i = 0; i < n; ++i) {
    // p / (127 * 2^k): eventually periodic with a period of 7 levels or a multiple
    const int k = i % 2 == 0 ? 0 : i % 20 + 1;
    const std::int64_t q = std::int64_t{127} << k;
    const std::int64_t v = any(random);
    std::int64_t u = any(random);
    if (c.kind == FaceCase::Kind::boundary) u <<= k;  // close to the side, not to its corner
    out.push_back(
        {u, v, q, Vec2(static_cast<double>(u), static_cast<double>(v)) / static_cast<double>(q)});
  }
  return out;
}

std::vector<Method> all_methods() {
  return {
      {"limes (ring powers)", "all", false, by_limes},
      {"eigenvectors", "one extraordinary vertex, no Jordan block", false, by_stam},
      {"binary tree", "regular faces at a boundary", true, by_tree},
      {"phantoms", "regular faces at a boundary", true, by_phantoms},
      {"rational parameters", "all, positions", false, by_rationals},
      {"refinement, 20 levels", "all, positions", false, by_refinement},
  };
}

}  // namespace bench
