// What coarsening refuses, and what it says then.

#include <gtest/gtest.h>

#include <random>

#include "limes/core/error.h"
#include "limes/subdiv/coarsen.h"
#include "subdiv/coarsen_meshes.h"

namespace limes {
namespace {

std::string error_of(const Mesh& mesh, double tolerance = CoarsenOptions{}.tolerance) {
  try {
    (void)coarsen(mesh, {.tolerance = tolerance});
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Coarsen, SaysWhereAMeshIsNotRefined) {
  Mesh moved = refined(read_shape("catmark_torus"));
  const int last = moved.points.size() - 1;  // a face point
  moved.points[VertexId(last)] += 0.01 * size_of(moved) * Vec3::UnitX();
  const std::string message = error_of(moved);
  EXPECT_NE(message.find("vertex " + std::to_string(last) + " is "), std::string::npos) << message;
  EXPECT_NE(message.find("of the diagonal"), std::string::npos) << message;

  EXPECT_NE(error_of(read_shape("catmark_pyramid")).find("leaves quads only"), std::string::npos);
  EXPECT_NE(error_of(read_shape("catmark_cube")).find("are not refined: "), std::string::npos);
}

TEST(Coarsen, SaysWhyACubeIsNotUnique) {
  const std::string message = error_of(refined(read_shape("catmark_cube")));
  EXPECT_NE(message.find("vertices 0, 1, 2, 3, 4, 5, 6, 7 are not unique"), std::string::npos)
      << message;
}

TEST(Coarsen, RefusesWhatTheBoundaryRuleTookAway) {
  Mesh mesh = read_shape("catmark_xord_boundary");
  mesh.tags.boundary = BoundaryRule::none;
  Mesh fine = refined(mesh);
  if (fine.topology.num_faces() == 0) return;
  EXPECT_NE(error_of(fine).find("boundary rule is none"), std::string::npos);
}

// The bound that comes before least squares never refuses what least squares would accept.
TEST(Coarsen, RefusesAtOnceOnlyWhatIsTooFarAway) {
  std::mt19937 random(5);
  const auto noise = [&] { return static_cast<double>(random()) / 4294967296.0 - 0.5; };
  for (const char* name : {"catmark_torus", "catmark_torus_creases0", "catmark_pole8"}) {
    Mesh mesh = refined(read_shape(name));
    for (const double size : {1e-9, 1e-5, 1e-2}) {
      Mesh moved = mesh;
      for (Vec3& x : moved.points)
        x += size * size_of(mesh) * Vec3(noise(), noise(), noise());
      const double residual = coarsen(moved, {.tolerance = 1}).residual;
      const double just = residual / size_of(moved) * (1 + 1e-9);
      EXPECT_NO_THROW((void)coarsen(moved, {.tolerance = just})) << name << size;
      const std::string message = error_of(moved, 0.01 * just);
      EXPECT_NE(message.find(" is at least "), std::string::npos) << message;
    }
  }
}

}  // namespace
}  // namespace limes
