#include <gtest/gtest.h>

#include "limes/core/error.h"
#include "limes/mesh/shapes.h"
#include "limes/subdiv/refine.h"
#include "limes/subdiv/schemes.h"
#include "subdiv/zoo.h"
#include "witness/peers.h"

// Refined meshes against OpenMesh and CGAL where they implement the same rules: the same vertices to
// 1e-12, the same faces.

namespace limes::witness {
namespace {

using Peer = PlainMesh (*)(const Mesh&, int);

struct Comparison {
  std::string name;
  const char* scheme;
  Peer peer;
  bool boundaries;  ///< whether the peer has our rules there
  int levels;
};
void PrintTo(const Comparison& c, std::ostream* out) {
  *out << c.name;
}

class SameAsPeer : public testing::TestWithParam<Comparison> {};

TEST_P(SameAsPeer, OnEveryShape) {
  const Comparison& c = GetParam();
  const Scheme& scheme = find_scheme(c.scheme);
  int count = 0;
  for (const Shape& shape : zoo()) {
    const Tags& tags = shape.mesh.tags;
    if (!fits(scheme, shape.mesh) || !tags.creases.empty() || !tags.corners.empty()) continue;
    if (!c.boundaries && !is_closed(shape.mesh)) continue;
    SCOPED_TRACE(shape.name);
    EXPECT_EQ(difference(refine(shape.mesh, scheme, {.levels = c.levels}),
                         c.peer(shape.mesh, c.levels), 1e-12),
              "");
    ++count;
  }
  EXPECT_GE(count, 4);
}

INSTANTIATE_TEST_SUITE_P(
    Schemes, SameAsPeer,
    testing::Values(Comparison{"openmesh_sqrt3", "sqrt3", openmesh_sqrt3, true, 3},
                    Comparison{"openmesh_butterfly", "butterfly", openmesh_butterfly, true, 2},
                    Comparison{"cgal_doo_sabin", "doo-sabin", cgal_doo_sabin, false, 2},
                    Comparison{"cgal_sqrt3", "sqrt3", cgal_sqrt3, true, 3},
                    Comparison{"cgal_loop", "loop", cgal_loop, true, 2}),
    [](const auto& instance) { return instance.param.name; });

}  // namespace
}  // namespace limes::witness
