#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/program.h"
#include "limes/io/io.h"

namespace limes::test {
namespace {

TEST(Coarsen, UndoesRefineOnFiles) {
  const TempFolder folder;
  for (const char* name : {"torus.obj", "rook.obj", "pawn.obj"}) {
    ASSERT_EQ(run_limes({"refine", data_file(name), "-o", folder / "fine.obj", "--scheme",
                         "catmull-clark", "--levels", "1"})
                  .exit_code,
              0);
    const Result result =
        run_limes({"coarsen", folder / "fine.obj", "-o", folder / "back.obj", "--json"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const Mesh want = read_mesh(data_file(name)).mesh;
    const Mesh got = read_mesh(folder / "back.obj").mesh;
    const auto json = nlohmann::json::parse(result.out);
    EXPECT_EQ(json["vertices"], want.topology.num_vertices());
    EXPECT_EQ(json["faces"], want.topology.num_faces());
    EXPECT_LT(json["residual"], 1e-12);
    ASSERT_EQ(got.topology, want.topology) << name;
    EXPECT_EQ(got.tags.creases.size(), want.tags.creases.size()) << name;
    for (int v = 0; v < want.points.size(); ++v)
      ASSERT_LT((got.points[VertexId(v)] - want.points[VertexId(v)]).norm(), 1e-12) << name;
  }
}

/// Old vertices stay, so dropping the others gives the mesh back to the bit, breakpoints as tags.
TEST(Coarsen, UndoesKobbelt) {
  const TempFolder folder;
  for (const char* name : {"torus.obj", "cube.obj"}) {
    ASSERT_EQ(run_limes({"refine", data_file(name), "-o", folder / "fine.obj", "--scheme",
                         "kobbelt", "--levels", "1", "--tension", "0.7"})
                  .exit_code,
              0);
    const Result result = run_limes({"coarsen", folder / "fine.obj", "-o", folder / "back.obj",
                                     "--scheme", "kobbelt", "--tension", "0.7", "--json"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const Mesh want = read_mesh(data_file(name)).mesh;
    const Mesh got = read_mesh(folder / "back.obj").mesh;
    EXPECT_EQ(nlohmann::json::parse(result.out)["residual"], 0.0);
    EXPECT_EQ(got.topology, want.topology) << name;
    EXPECT_EQ(got.points, want.points) << name;
    expect_failure(run_limes({"coarsen", folder / "fine.obj", "-o", folder / "x.obj", "--scheme",
                              "kobbelt", "--tension", "1"}),
                   3, "away from where refinement would put it");
  }
  expect_failure(
      run_limes({"coarsen", data_file("cube.obj"), "-o", folder / "x.obj", "--scheme", "sqrt3"}), 2,
      "not sqrt3");
}

TEST(Coarsen, RefusesWhatIsNotRefined) {
  const TempFolder folder;
  expect_failure(run_limes({"coarsen", data_file("pawn.obj"), "-o", folder / "x.obj"}), 3,
                 "pawn.obj: face 0 and those around it are not refined: ");
  expect_failure(run_limes({"coarsen", data_file("rook.obj"), "-o", folder / "x.obj"}), 3,
                 "leaves quads only");
  expect_failure(run_limes({"coarsen", data_file("torus.obj"), "-o", folder / "x.obj"}), 3,
                 "not a refined mesh: vertex ");
  expect_failure(
      run_limes({"coarsen", data_file("torus.obj"), "-o", folder / "x.obj", "--tolerance", "-1"}),
      2, "--tolerance");
  EXPECT_TRUE(folder.list().empty());
}

}  // namespace
}  // namespace limes::test
