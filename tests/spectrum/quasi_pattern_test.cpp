#include "limes/spectrum/quasi_pattern.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <random>

#include "limes/mesh/shapes.h"
#include "limes/spectrum/pattern_code.h"
#include "limes/subdiv/edge_choice.h"
#include "limes/subdiv/quasi_four_eight.h"

namespace limes {
namespace {

constexpr VertexId middle(0);

/// The pattern that a pass will find, on the whole mesh.
std::vector<int> code_of(const Mesh& mesh, int rings = PatternOptions{}.rings) {
  const Adjacency adjacency(mesh.topology);
  return pattern_code(adjacency, middle, longest_edges(adjacency, mesh.points.span()), rings);
}

Mesh after(const Mesh& mesh, int passes) {
  return refine_quasi_four_eight(mesh, {.levels = passes}).mesh;
}

/// Figures 5 and 8 of [velho_quasi48], with the valence of the 9-gon from an independent program.
TEST(QuasiPattern, PolygonsReachTheValencesOfTheFigures) {
  const std::map<int, int> expected{{3, 6}, {4, 8}, {5, 10}, {6, 6}, {9, 10}, {12, 12}};
  for (const auto& [n, valence] : expected) {
    SCOPED_TRACE(n);
    const QuasiPattern pattern = quasi_pattern(shapes::triangle_star(n, 1));
    EXPECT_EQ(pattern.valence, valence);
    EXPECT_TRUE(pattern.repeats_after.has_value());
    EXPECT_EQ(pattern.period, 1);
    EXPECT_TRUE(pattern.regular);
  }
}

/// On the characteristic maps that an independent program found, the split edges are the longest of their
/// faces up to valence 16 (1.013 of the next), and no more from 18 (0.945).
TEST(QuasiPattern, IsRegularUpToValence16) {
  for (int n = 6; n <= 24; n += 2) {
    SCOPED_TRACE(n);
    const QuasiPattern pattern = quasi_pattern(shapes::triangle_star(n, 1));
    EXPECT_EQ(pattern.valence, n);
    EXPECT_TRUE(pattern.repeats_after.has_value());
    EXPECT_EQ(pattern.regular, n <= 16);
  }
}

/// The whole mesh, never cut back, by the scheme as it refines files.
TEST(QuasiPattern, IsThatOfTheWholeMesh) {
  struct Row {
    int sectors, rings;
  };
  for (const auto& [sectors, rings] :
       {Row{3, 1}, {4, 1}, {5, 1}, {6, 1}, {9, 1}, {18, 1}, {3, 12}, {7, 12}, {8, 12}}) {
    SCOPED_TRACE(testing::Message() << sectors << " sectors, " << rings << " rings");
    const Mesh control = shapes::triangle_star(sectors, rings);
    const QuasiPattern pattern = quasi_pattern(control);
    ASSERT_TRUE(pattern.repeats_after.has_value());
    const int first = *pattern.repeats_after, period = pattern.period;
    const Mesh then = after(control, first);
    EXPECT_EQ(Adjacency(then.topology).valence(middle), pattern.valence);
    const auto code = code_of(then);
    for (int pass = first - 1; pass < first + period; ++pass)
      if (pass != first) {
        EXPECT_NE(code_of(after(control, pass)), code) << pass;
      }
    EXPECT_EQ(code_of(after(control, first + period)), code);
  }
}

TEST(QuasiPattern, DoesNotDependOnTheCut) {
  for (const int sectors : {5, 7, 9, 18})
    for (const int size : {1, 12}) {
      SCOPED_TRACE(testing::Message() << sectors << " sectors, " << size << " rings");
      const Mesh control = shapes::triangle_star(sectors, size);
      const QuasiPattern pattern = quasi_pattern(control);
      const QuasiPattern deeper = quasi_pattern(control, {.kept_rings = 16});
      EXPECT_EQ(deeper.repeats_after, pattern.repeats_after);
      EXPECT_EQ(deeper.period, pattern.period);
      EXPECT_EQ(deeper.valence, pattern.valence);
      EXPECT_EQ(deeper.regular, pattern.regular);
      // More rings show it later: the control mesh must have left them all.
      const QuasiPattern wider = quasi_pattern(control, {.rings = 6});
      ASSERT_TRUE(wider.repeats_after.has_value());
      EXPECT_GE(*wider.repeats_after, *pattern.repeats_after);
      EXPECT_EQ(wider.period, pattern.period);
      EXPECT_EQ(wider.regular, pattern.regular);
    }
}

TEST(QuasiPattern, SaysWhenNothingRepeats) {
  const QuasiPattern pattern = quasi_pattern(shapes::triangle_star(5, 1), {.num_passes = 5});
  EXPECT_FALSE(pattern.repeats_after.has_value());
  EXPECT_FALSE(pattern.regular);
  EXPECT_EQ(pattern.valence, 10);
}

/// Other numbers of vertices and faces, the middle aside, and other first corners.
Mesh renumbered(const Mesh& mesh, std::mt19937& random) {
  std::vector<int> vertex(static_cast<std::size_t>(mesh.topology.num_vertices()));
  std::vector<int> face(static_cast<std::size_t>(mesh.topology.num_faces()));
  std::iota(vertex.begin(), vertex.end(), 0);
  std::iota(face.begin(), face.end(), 0);
  std::shuffle(vertex.begin() + 1, vertex.end(), random);
  std::shuffle(face.begin(), face.end(), random);
  Mesh result = mesh;
  std::vector<VertexId> corners;
  for (const int f : face)
    for (std::size_t k = 0; k < 3; ++k) {
      const VertexId old = mesh.topology.face(FaceId(f))[(k + static_cast<std::size_t>(f)) % 3];
      corners.emplace_back(vertex[static_cast<std::size_t>(old.value)]);
      result.points[corners.back()] = mesh.points[old];
    }
  result.topology = Topology(mesh.topology.num_vertices(), 3, std::move(corners));
  return result;
}

TEST(PatternCode, DoesNotDependOnNumbers) {
  std::mt19937 random(4);
  const Mesh mesh = after(shapes::triangle_star(5, 1), 7);  // lengths decide, no ties
  for (int i = 0; i < 5; ++i)
    EXPECT_EQ(code_of(renumbered(mesh, random)), code_of(mesh));
}

TEST(PatternCode, SeesEveryFaceAndMark) {
  const Mesh mesh = after(shapes::triangle_star(5, 1), 7);
  const Adjacency adjacency(mesh.topology);
  const std::vector<EdgeId> edges = longest_edges(adjacency, mesh.points.span());
  const std::vector<int> code = pattern_code(adjacency, middle, edges, 3);
  const IdArray<VertexId, int> ring = rings_around(mesh.topology, middle, 3);
  int num_faces = 0, num_marks_inside = 0;
  for (int f = 0; f < mesh.topology.num_faces(); ++f) {
    const auto corners = mesh.topology.face(FaceId(f));
    num_faces +=
        std::all_of(corners.begin(), corners.end(), [&](VertexId v) { return ring[v] <= 3; }) ? 1
                                                                                              : 0;
  }
  EXPECT_EQ(code.size(), 3U * static_cast<std::size_t>(num_faces));
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const HalfedgeId h = adjacency.halfedge(edges[i]);
    if (ring[adjacency.from(h)] > 2 || ring[adjacency.to(h)] > 2) continue;
    std::vector<EdgeId> fewer = edges;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
    EXPECT_NE(pattern_code(adjacency, middle, fewer, 3), code);
    ++num_marks_inside;
  }
  EXPECT_GT(num_marks_inside, 5);
}

}  // namespace
}  // namespace limes
