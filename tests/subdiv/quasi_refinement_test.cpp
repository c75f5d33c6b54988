#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <numbers>
#include <set>
#include <tuple>

#include "limes/core/error.h"
#include "limes/io/io.h"
#include "limes/mesh/shapes.h"
#include "limes/subdiv/edge_choice.h"
#include "limes/subdiv/features.h"
#include "limes/subdiv/quasi_four_eight.h"
#include "limes/subdiv/refinement_step.h"
#include "limes/subdiv/schemes.h"
#include "subdiv/meshes48.h"
#include "subdiv/zoo.h"

// Refinement of quasi 4-8: which edges are split, and what that does to the mesh.

namespace limes {
namespace {

Mesh after(const Mesh& mesh, int levels) {
  return refine_quasi_four_eight(mesh, {.levels = levels}).mesh;
}

int valence(const Mesh& mesh, VertexId v) {
  return Adjacency(mesh.topology).valence(v);
}

void expect_binary_steps(const Mesh& start, int levels) {
  Mesh mesh = start;
  for (int level = 0; level < levels; ++level) {
    const QuasiRefinement next = refine_quasi_four_eight(mesh, {.levels = 1});
    expect_binary_step(mesh.topology, next.mesh.topology, next.num_unsplit_faces.at(0));
    mesh = next.mesh;
  }
}

TEST(QuasiRefinement, EveryStepIsAMatchingOfFaces) {
  for (const Mesh& mesh :
       {shapes::tetrahedron(), shapes::icosahedron(), triangulated(shapes::torus(6, 4)),
        triangulated(shapes::torus(5, 5)), triangulated(shapes::cube()), fan(9, Centre::first),
        triangulated(shapes::grid_with_hole(5)), triangulated(shapes::cylinder(5, 3))})
    expect_binary_steps(mesh, 5);
}

TEST(QuasiRefinement, EveryStepIsAMatchingOnModels) {
  for (const char* name : {"rook.obj", "pawn.obj", "block.obj", "block_cut.obj"}) {
    SCOPED_TRACE(name);
    Mesh mesh = read_mesh(std::filesystem::path(LIMES_DATA_DIR) / name).mesh;
    mesh.tags = {};                          // some are semi-sharp
    expect_binary_steps(after(mesh, 0), 3);  // after 0 steps: cut into triangles
  }
}

TEST(QuasiRefinement, FansHaveTheValencesOfFigures5And8) {
  const std::map<int, int> expected{{3, 6}, {4, 8}, {5, 10}, {6, 6}, {9, 10}, {12, 12}};
  for (const auto& [n, middle] : expected) {
    for (const Centre centre : {Centre::first, Centre::last}) {
      SCOPED_TRACE(n);
      const VertexId v(centre == Centre::first ? 0 : n);
      const int levels = n <= 6 ? 8 : 4;
      for (int level = 1; level <= levels; ++level) {
        const QuasiRefinement result = refine_quasi_four_eight(fan(n, centre), {.levels = level});
        EXPECT_EQ(valence(result.mesh, v), middle);
        EXPECT_EQ(num_irregular(result.mesh.topology), middle == 8 ? 0 : 1);
        EXPECT_EQ(result.num_unsplit_faces.back(), 0);
      }
    }
  }
}

/// "the algorithm constructed the same subdivision as in the triangle of Figure 5(a)"
TEST(QuasiRefinement, HexagonIsTheTriangleOneStepLater) {
  for (int k = 0; k <= 5; ++k)
    EXPECT_EQ(canonical_code(after(fan(6, Centre::first), k).topology),
              canonical_code(after(fan(3, Centre::first), k + 1).topology));
}

TEST(QuasiRefinement, FansOfTwiceTheSectorsAreOneStepAhead) {
  for (const int n : {4, 5})
    for (int k = 0; k <= 3; ++k)
      EXPECT_EQ(canonical_code(after(fan(2 * n, Centre::first), k).topology),
                canonical_code(after(fan(n, Centre::first), k + 1).topology));
  EXPECT_NE(canonical_code(after(fan(12, Centre::first), 1).topology),
            canonical_code(after(fan(6, Centre::first), 2).topology));
}

TEST(QuasiRefinement, TheNumberingOfAHexagonDoesNotMatter) {
  for (int k = 1; k <= 4; ++k)
    EXPECT_EQ(canonical_code(after(fan(6, Centre::first), k).topology),
              canonical_code(after(fan(6, Centre::last), k).topology));
}

TEST(QuasiRefinement, StretchedHexagonOfFigure6) {
  Mesh hexagon = fan(6, Centre::first);
  for (Vec3& x : hexagon.points)
    if (x.x() > 1e-9) x.x() *= 2;
  const Mesh fine = after(hexagon, 4);
  EXPECT_EQ(valence(fine, VertexId(0)), 8);
  EXPECT_EQ(num_irregular(fine.topology), 0);
}

TEST(QuasiRefinement, ToriAreRegular) {
  for (const auto& [columns, lines] : {std::pair(8, 4), {8, 6}, {12, 6}, {8, 8}}) {
    const Mesh torus = triangulated(shapes::torus(columns, lines));
    for (int level = 1; level <= 4; ++level) {
      const Mesh fine = after(torus, level);
      const int quarter = fine.topology.num_faces() / 4;
      EXPECT_EQ(interior_valences(fine.topology), (std::map<int, int>{{4, quarter}, {8, quarter}}));
    }
  }
  EXPECT_GT(num_irregular(after(triangulated(shapes::torus(6, 4)), 3).topology), 0);
}

/// A torus of radii 2 and 1, vertex lines i + j, each quad cut from its corner (i, j).
Mesh numbered_torus(int columns, int lines) {
  Mesh mesh;
  std::vector<VertexId> corners;
  const auto at = [&](int i, int j) { return VertexId(lines * (i % columns) + j % lines); };
  for (int i = 0; i < columns; ++i)
    for (int j = 0; j < lines; ++j) {
      const double a = 2 * std::numbers::pi * i / columns, b = 2 * std::numbers::pi * j / lines;
      const double r = 2 + std::cos(b);
      mesh.points.push_back(Vec3(r * std::cos(a), r * std::sin(a), std::sin(b)));
      corners.insert(corners.end(), {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j),
                                     at(i + 1, j + 1), at(i, j + 1)});
    }
  mesh.topology = Topology(columns * lines, 3, std::move(corners));
  return mesh;
}

/// Counts of the programs that made tests/data/quasi48: on these tori the steps leave faces whole, and
/// the number of irregular vertices grows.
TEST(QuasiRefinement, IrregularToriHaveTheKnownCounts) {
  struct Row {
    int columns, lines;
    std::vector<int> unsplit, irregular;
  };
  for (const Row& row : {Row{6, 4, {10, 12, 24, 40}, {14, 32, 48, 95}},
                         Row{5, 5, {10, 10, 20, 40}, {10, 30, 40, 85}}}) {
    std::vector<int> irregular;
    for (int level = 1; level <= 4; ++level) {
      const QuasiRefinement made =
          refine_quasi_four_eight(numbered_torus(row.columns, row.lines), {.levels = level});
      irregular.push_back(num_irregular(made.mesh.topology));
      if (level == 4) {
        EXPECT_EQ(made.num_unsplit_faces, row.unsplit);
      }
    }
    EXPECT_EQ(irregular, row.irregular);
  }
}

TEST(QuasiRefinement, LongestEdgesJoinValence8OnRegularMeshes) {
  int steps = 0;
  for (const Mesh& start :
       {centre_triangles(shapes::grid(4, 3)), after(triangulated(shapes::torus(8, 6)), 2),
        after(triangulated(shapes::torus(12, 8)), 1)}) {
    Mesh mesh = start;
    for (int level = 0; level < 5; ++level) {
      const Adjacency adjacency(mesh.topology);
      EXPECT_EQ(longest_edges(adjacency, mesh.points.span()), edges_between_valence_8(adjacency));
      const Mesh by_length = after(mesh, 1);
      const Mesh by_valence =
          refine_quasi_four_eight(mesh, {.levels = 1, .split = QuasiSplit::interleaved}).mesh;
      EXPECT_EQ(by_length.topology, by_valence.topology);
      mesh = by_length;
      ++steps;
    }
  }
  EXPECT_EQ(steps, 15);
}

/// Faces by their vertices, from the lowest.
std::set<std::array<int, 3>> faces_of(const std::vector<std::array<int, 3>>& faces) {
  std::set<std::array<int, 3>> result;
  for (std::array<int, 3> f : faces) {
    std::rotate(f.begin(), std::min_element(f.begin(), f.end()), f.end());
    result.insert(f);
  }
  return result;
}

/// Section 2.2: every face into four, by the template of Figure 2, here with names of edges for the
/// split vertices, beside two interleaved steps.
TEST(QuasiRefinement, NormalRefinementIsTwoInterleavedSteps) {
  const Mesh mesh = after(triangulated(shapes::torus(8, 6)), 1);
  const Adjacency adjacency(mesh.topology);
  const QuasiRefinement once =
      refine_quasi_four_eight(mesh, {.levels = 1, .split = QuasiSplit::normal});
  ASSERT_EQ(once.mesh.topology.num_faces(), 4 * mesh.topology.num_faces());

  // Names in the refined mesh: a vertex between two old ones that an edge joined is that edge's.
  const Adjacency fine(once.mesh.topology);
  std::map<EdgeId, int> split;
  const QuasiRefinement half =
      refine_quasi_four_eight(mesh, {.levels = 1, .split = QuasiSplit::interleaved});
  const Adjacency between(half.mesh.topology);
  const auto first = edges_between_valence_8(adjacency);
  const auto second = edges_between_valence_8(between);
  for (std::size_t i = 0; i < first.size(); ++i)
    split[first[i]] = mesh.topology.num_vertices() + static_cast<int>(i);
  for (std::size_t i = 0; i < second.size(); ++i) {
    const HalfedgeId h = between.halfedge(second[i]);
    split[adjacency.edge(find_edge(adjacency, between.from(h), between.to(h)))] =
        half.mesh.topology.num_vertices() + static_cast<int>(i);
  }
  ASSERT_EQ(static_cast<int>(split.size()), adjacency.num_edges());

  std::vector<std::array<int, 3>> expected;
  for (int f = 0; f < mesh.topology.num_faces(); ++f) {
    HalfedgeId h = mesh.topology.halfedge(FaceId(f), 0);
    while (adjacency.valence(adjacency.from(h)) != 4)
      h = adjacency.next(h);
    const int u = adjacency.from(h).value, v = adjacency.to(h).value;
    const int w = adjacency.from(adjacency.prev(h)).value;
    const int s_uv = split[adjacency.edge(h)], s_vw = split[adjacency.edge(adjacency.next(h))];
    const int s_wu = split[adjacency.edge(adjacency.prev(h))];
    expected.insert(expected.end(),
                    {{w, s_wu, s_vw}, {u, s_vw, s_wu}, {u, s_uv, s_vw}, {v, s_vw, s_uv}});
  }
  std::vector<std::array<int, 3>> made;
  for (int f = 0; f < once.mesh.topology.num_faces(); ++f) {
    const auto face = once.mesh.topology.face(FaceId(f));
    made.push_back({face[0].value, face[1].value, face[2].value});
  }
  EXPECT_EQ(faces_of(made), faces_of(expected));
}

TEST(QuasiRefinement, RegularSplitsRefuseOtherMeshes) {
  const QuasiOptions options{.levels = 1, .split = QuasiSplit::interleaved};
  EXPECT_THROW(std::ignore = refine_quasi_four_eight(shapes::icosahedron(), options), InputError);
  const Mesh valence6 = triangulated(shapes::torus(3, 3));
  EXPECT_THROW(std::ignore = refine_quasi_four_eight(valence6, options), InputError);
  // No vertex inside says which of the two has valence 4.
  const Mesh two_triangles = triangulated(shapes::grid(1, 1));
  EXPECT_THROW(std::ignore = refine_quasi_four_eight(two_triangles, options), InputError);
}

TEST(QuasiRefinement, HasNoMatrix) {
  const Scheme& scheme = find_scheme("quasi-four-eight");
  EXPECT_FALSE(scheme.linear);
  EXPECT_TRUE(scheme.needs_positions);
  const Mesh mesh = shapes::icosahedron();
  const Adjacency adjacency(mesh.topology);
  EXPECT_THROW(RefinementStep(adjacency, {}, scheme), UsageError);
}

TEST(QuasiRefinement, RefusesTwoTrianglesBackToBack) {
  Mesh pillow = shapes::polygon(3);
  std::vector<VertexId> corners;
  for (const int v : {0, 1, 2, 2, 1, 0})
    corners.emplace_back(v);
  pillow.topology = Topology(3, 3, corners);
  EXPECT_THROW(std::ignore = refine_quasi_four_eight(pillow, {}), InputError);
}

TEST(QuasiRefinement, PolygonsAreCutAlongShortDiagonals) {
  Mesh mesh = shapes::grid(2, 1);
  mesh.points[VertexId(3)].x() = -1;  // the first quad's diagonals are 1-3 (longer) and 0-4
  const QuasiRefinement result = refine_quasi_four_eight(mesh, {.levels = 0});
  EXPECT_EQ(result.num_cut_faces, 2);
  ASSERT_EQ(result.mesh.topology.num_faces(), 4);
  const Adjacency adjacency(result.mesh.topology);
  EXPECT_TRUE(find_edge(adjacency, VertexId(0), VertexId(4)).valid());
  EXPECT_TRUE(
      find_edge(adjacency, VertexId(1), VertexId(5)).valid());  // as long as 2-4: the lowest
}

TEST(QuasiRefinement, ACutTakesNoEdgeThatIsThere) {
  // Two quads, back to back: one cut along 0-2, the other along 1-3.
  Mesh pillow = shapes::polygon(4);
  std::vector<VertexId> corners;
  for (const int v : {0, 1, 2, 3, 3, 2, 1, 0})
    corners.emplace_back(v);
  pillow.topology = Topology(4, 4, corners);
  const Mesh mesh = after(pillow, 0);
  EXPECT_EQ(Adjacency(mesh.topology).num_edges(), 6);
  expect_binary_steps(mesh, 3);
}

TEST(QuasiRefinement, GroupsHolesAndPartsGoToTheChildren) {
  Mesh mesh = shapes::grid(2, 1);
  mesh.groups = {{"left", {FaceId(0)}}};
  mesh.parts = {{"a", {FaceId(0)}}, {"b", {FaceId(1)}}};
  mesh.tags.holes = {FaceId(1)};
  mesh.tags.creases = {{VertexId(1), VertexId(4), infinite_sharpness}};  // stays straight
  const Mesh fine = after(mesh, 3);
  const auto on_the_left = [&](FaceId f) {
    Vec3 sum = Vec3::Zero();
    for (const VertexId v : fine.topology.face(f))
      sum += fine.points[v];
    return sum.x() / 3 < 1;
  };
  std::vector<FaceId> left, right;
  for (int f = 0; f < fine.topology.num_faces(); ++f)
    (on_the_left(FaceId(f)) ? left : right).emplace_back(f);
  EXPECT_EQ(fine.groups.at(0).faces, left);
  EXPECT_EQ(fine.parts.at(0).faces, left);
  EXPECT_EQ(fine.parts.at(1).faces, right);
  EXPECT_EQ(fine.tags.holes, right);
}

}  // namespace
}  // namespace limes
