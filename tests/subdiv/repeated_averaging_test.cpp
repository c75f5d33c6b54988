#include <gtest/gtest.h>

#include "limes/subdiv/refine.h"
#include "limes/subdiv/schemes.h"
#include "subdiv/fits.h"
#include "subdiv/zoo.h"

namespace limes {
namespace {

/// The definition [zorin_schroeder_2001]: linear refinement, then the mean of each quad's corners. Both
/// number by the corners of the mesh in file order; dual faces leave out none of them on closed meshes.
TEST(RepeatedAveraging, IsTheMiddleOfEveryQuadOfLinearRefinement) {
  const Scheme& scheme = find_scheme("repeated-averaging");
  int count = 0;
  for (const Shape& s : zoo()) {
    if (!fits(scheme, s.mesh) || !is_closed(s.mesh)) continue;
    SCOPED_TRACE(s.name);
    const Mesh quads = refine(s.mesh, find_scheme("linear"), {.levels = 1});
    const Mesh dual = refine(s.mesh, scheme, {.levels = 1});
    ASSERT_EQ(dual.points.size(), quads.topology.num_faces());
    for (int f = 0; f < quads.topology.num_faces(); ++f) {
      Vec3 middle = Vec3::Zero();
      for (const VertexId v : quads.topology.face(FaceId(f)))
        middle += quads.points[v] / 4;
      EXPECT_LE((dual.points[VertexId(f)] - middle).norm(), 1e-14 * (1 + middle.norm())) << f;
    }
    ++count;
  }
  EXPECT_GE(count, 5);
}

/// On quads with vertices of valence 4 both are biquadratic B-splines.
TEST(RepeatedAveraging, IsDooSabinOnRegularMeshes) {
  const Mesh cube = shapes::cube();
  const Mesh a = refine(cube, find_scheme("repeated-averaging"), {.levels = 1});
  const Mesh b = refine(cube, find_scheme("doo-sabin"), {.levels = 1});
  ASSERT_EQ(a.points.size(), b.points.size());
  for (int v = 0; v < a.points.size(); ++v)
    EXPECT_LE((a.points[VertexId(v)] - b.points[VertexId(v)]).norm(), 1e-15);
}

}  // namespace
}  // namespace limes
