#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "limes/mesh/shapes.h"
#include "limes/subdiv/refine.h"
#include "limit/surface.h"

// Area of a flat regular n-gon from n quads, integrated tile by tile: values, derivatives and the
// shrinking rings around the extraordinary vertex in one number that is known exactly.

namespace limes::test {
namespace {

struct GaussRule {
  std::array<double, 3> point{0.5 - std::sqrt(0.15), 0.5, 0.5 + std::sqrt(0.15)};
  std::array<double, 3> weight{5.0 / 18, 8.0 / 18, 5.0 / 18};
};

/// Signed area of the square [u, u + w] x [v, v + w] of a face; exact where it is one bicubic, since
/// the Jacobian has degree 5 in each direction.
double square_area(const LimitSurface& surface, FaceId f, double u, double v, double w) {
  const GaussRule rule;
  double area = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const Vec2 uv(u + w * rule.point[i], v + w * rule.point[j]);
      const SurfacePoint p = surface.evaluate(f, 0, uv);
      area += w * w * rule.weight[i] * rule.weight[j] * p.first->xu.cross(p.first->xv).z();
    }
  return area;
}

/// Rings of three tiles around corner c of a face, down to a depth, and the square that is left.
double face_area(const LimitSurface& surface, FaceId f, int corner, int depth) {
  double area = 0;
  const auto tile = [&](double u, double v, double w) {
    switch (corner) {
      case 0:
        return square_area(surface, f, u, v, w);
      case 1:
        return square_area(surface, f, 1 - u - w, v, w);
      case 2:
        return square_area(surface, f, 1 - u - w, 1 - v - w, w);
      default:
        return square_area(surface, f, u, 1 - v - w, w);
    }
  };
  double w = 0.5;
  for (int k = 1; k <= depth; ++k, w /= 2)
    area += tile(w, 0, w) + tile(w, w, w) + tile(0, w, w);
  return area + tile(0, 0, 2 * w);
}

double polygon_area(int n, int depth) {
  const Mesh fine = refine(shapes::disk(n, 1), find_scheme("catmull-clark"),
                           {.levels = 3, .boundary = BoundaryRule::edges_and_corners});
  const Surface s(fine);
  double area = 0;
  for (int f = 0; f < fine.topology.num_faces(); ++f) {
    const auto corners = fine.topology.face(FaceId(f));
    int corner = 0;
    while (corner < 4 && corners[static_cast<std::size_t>(corner)] != VertexId(0))
      ++corner;
    area += corner < 4 ? face_area(s.limit, FaceId(f), corner, depth)
                       : square_area(s.limit, FaceId(f), 0, 0, 1);
  }
  return area;
}

TEST(Area, OfAFlatPolygonIsExact) {
  for (const int n : {3, 4, 5, 6, 8}) {
    const double exact = 0.5 * n * std::sin(2 * std::acos(-1.0) / n);
    EXPECT_NEAR(polygon_area(n, 20) / exact, 1, 1e-13) << n;
    EXPECT_NEAR(polygon_area(n, 8) / exact, 1, 1e-8) << n;
  }
}

}  // namespace
}  // namespace limes::test
