#include "limes/subdiv/uniform.h"
#include "limes/subdiv/structured.h"
#include "limes/subdiv/structured_triangles.h"

#include <gtest/gtest.h>

#ifdef LIMES_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <cstring>
#include <filesystem>
#include <random>

#include "limes/core/error.h"
#include "limes/io/io.h"
#include "limes/mesh/shapes.h"
#include "limes/subdiv/schemes.h"
#include "subdiv/zoo.h"

// Uniform refinement against one general step after another: the same numbers, the same bits.

namespace limes {
namespace {

struct Refined {
  Topology topology;
  Features features;
  std::vector<Vec3> points;
};

/// Several steps, each by the general rules.
Refined refined_step_by_step(const Mesh& mesh, const Features& features, const Scheme& scheme,
                             int levels) {
  Refined result{mesh.topology, features, mesh.points.vector()};
  for (int level = 0; level < levels; ++level) {
    const Adjacency adjacency(result.topology, Adjacency::Check::edges);
    const RefinementStep step(adjacency, result.features, scheme);
    std::vector<Vec3> fine(static_cast<std::size_t>(step.num_child_vertices()));
    step.apply(result.points, fine);
    Topology child = step.child_topology();
    result = {std::move(child), step.child_features(), std::move(fine)};
  }
  return result;
}

bool same_bits(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  if (a.size() != b.size()) return false;
  return a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Vec3)) == 0;
}

/// As many levels as leave a mesh that is quickly refined, at most one more than grids can hold.
int levels_for(const Topology& topology) {
  int levels = 1;
  for (int faces = 4 * topology.num_corners(); faces <= 40000 && levels < 6; faces *= 4)
    ++levels;
  return levels;
}

std::vector<Vec3> positions(UniformRefinement& refinement, std::span<const Vec3> control) {
  std::vector<Vec3> fine(static_cast<std::size_t>(refinement.num_vertices()));
  refinement.positions(control, fine);
  return fine;
}

void expect_same_as_step_by_step(const Mesh& mesh, BoundaryRule boundary, const Scheme& scheme,
                                 ExtraordinaryWeights weights = ExtraordinaryWeights::standard) {
  const Adjacency adjacency(mesh.topology);
  Features features = resolve_tags(adjacency, mesh.tags, boundary);
  features.weights = weights;
  for (int levels = 1; levels <= levels_for(mesh.topology); ++levels) {
    SCOPED_TRACE(levels);
    const Refined expected = refined_step_by_step(mesh, features, scheme, levels);
    UniformRefinement refinement(adjacency, features, scheme, levels);
    EXPECT_EQ(refinement.num_faces(), expected.topology.num_faces());
    EXPECT_EQ(refinement.topology(), expected.topology);
    EXPECT_EQ(refinement.features().edges, expected.features.edges);
    EXPECT_EQ(refinement.features().vertices, expected.features.vertices);
    EXPECT_TRUE(same_bits(positions(refinement, mesh.points.span()), expected.points));
  }
}

/// Moves a few vertices and renews what moves with them.
void expect_update_renews_all(const Mesh& mesh, const Scheme& scheme) {
  const Adjacency adjacency(mesh.topology);
  const Features features = resolve_tags(adjacency, mesh.tags, BoundaryRule::edges);
  UniformRefinement refinement(adjacency, features, scheme, levels_for(mesh.topology));
  std::vector<Vec3> control = mesh.points.vector();
  std::vector<Vec3> updated = positions(refinement, control);
  std::mt19937 random(7);
  for (std::size_t count = 1; count <= 3; ++count) {
    std::vector<VertexId> moved;
    for (std::size_t i = 0; i < count; ++i) {
      moved.emplace_back(random() % control.size());
      control[static_cast<std::size_t>(moved.back().value)] += Vec3(0.1, -0.2, 0.3);
    }
    refinement.update(control, moved, updated);
    UniformRefinement fresh(adjacency, features, scheme, levels_for(mesh.topology));
    EXPECT_TRUE(same_bits(updated, positions(fresh, control)));
  }
}

class UniformOnFiles : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    try {
      mesh = read_mesh(std::string(LIMES_TEST_DATA_DIR) + "/opensubdiv/" + GetParam()).mesh;
      const Adjacency adjacency(mesh.topology);
    } catch (const InputError& e) {
      GTEST_SKIP() << "not refined by the general rules either: " << e.what();
    }
  }
  Mesh mesh;
};

TEST_P(UniformOnFiles, HasTheBitsOfSingleSteps) {
  for (const Scheme& scheme : all_schemes()) {
    if (scheme.needs_positions || !fits(scheme, mesh)) continue;
    SCOPED_TRACE(scheme.name);
    expect_same_as_step_by_step(mesh, BoundaryRule::edges, scheme);
  }
  expect_same_as_step_by_step(mesh, BoundaryRule::edges_and_corners, find_scheme("catmull-clark"));
}

TEST_P(UniformOnFiles, UpdateRenewsAllThatMoves) {
  for (const Scheme& scheme : all_schemes())
    if (!scheme.needs_positions && fits(scheme, mesh)) expect_update_renews_all(mesh, scheme);
}

std::vector<std::string> files() {
  std::vector<std::string> names;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::string(LIMES_TEST_DATA_DIR) + "/opensubdiv"))
    if (entry.path().extension() == ".obj") names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

INSTANTIATE_TEST_SUITE_P(OpenSubdivShapes, UniformOnFiles, testing::ValuesIn(files()),
                         [](const auto& file) {
                           std::string name = file.param.substr(0, file.param.size() - 4);
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

/// Sharpness anywhere, of all kinds.
Mesh with_random_tags(Mesh mesh, std::mt19937& random) {
  const Adjacency adjacency(mesh.topology);
  const std::array<float, 6> choices{0.4F, 1.0F, 1.7F, 2.5F, 3.0F, infinite_sharpness};
  for (int e = 0; e < adjacency.num_edges(); ++e) {
    const HalfedgeId h = adjacency.halfedge(EdgeId(e));
    if (random() % 3 == 0)
      mesh.tags.creases.push_back(
          {adjacency.from(h), adjacency.to(h), choices[random() % choices.size()]});
  }
  for (int v = 0; v < mesh.topology.num_vertices(); ++v)
    if (random() % 6 == 0)
      mesh.tags.corners.push_back({VertexId(v), choices[random() % choices.size()]});
  for (Vec3& x : mesh.points)
    x += Vec3::NullaryExpr([&] { return static_cast<double>(random() % 1000) * 1e-4; });
  return mesh;
}

TEST(UniformRefinement, HasTheBitsOfSingleStepsWithAnySharpness) {
  std::mt19937 random(11);
  const Scheme& scheme = find_scheme("catmull-clark");
  for (int i = 0; i < 8; ++i) {
    for (const Mesh& shape : {shapes::cube(), shapes::grid(4, 3), shapes::torus(4, 3),
                              shapes::disk(5, 2), shapes::half_disk(3, 2)}) {
      Mesh mesh = with_random_tags(shape, random);
      expect_same_as_step_by_step(mesh, BoundaryRule::edges, scheme);
      mesh.tags.crease_method = CreaseMethod::chaikin;
      expect_same_as_step_by_step(mesh, BoundaryRule::edges, scheme);
    }
  }
}

TEST(UniformRefinement, TrianglesHaveTheBitsOfSingleStepsWithAnySharpness) {
  std::mt19937 random(12);
  const Scheme& scheme = find_scheme("loop");
  for (int i = 0; i < 6; ++i) {
    for (const Mesh& shape :
         {shapes::icosahedron(), shapes::tetrahedron(), triangulated(shapes::grid(4, 3)),
          triangulated(shapes::torus(6, 5)), triangulated(shapes::disk(5, 2)),
          triangulated(shapes::half_disk(3, 2))}) {
      expect_same_as_step_by_step(triangulated(bumpy(shape)), BoundaryRule::edges, scheme);
      Mesh mesh = with_random_tags(shape, random);
      ASSERT_TRUE(StructuredTriangles::applies(
          mesh.topology, resolve_tags(Adjacency(mesh.topology), mesh.tags, BoundaryRule::edges),
          scheme));
      expect_same_as_step_by_step(mesh, BoundaryRule::edges, scheme);
      expect_update_renews_all(mesh, scheme);
      mesh.tags.crease_method = CreaseMethod::chaikin;
      expect_same_as_step_by_step(mesh, BoundaryRule::edges, scheme);
    }
  }
}

TEST(UniformRefinement, HasTheBitsOfSingleStepsWithOtherWeights) {
  for (const Mesh& shape : {shapes::cube(), shapes::disk(5, 2), shapes::half_disk(3, 2)}) {
    expect_same_as_step_by_step(bumpy(shape), BoundaryRule::edges, find_scheme("catmull-clark"),
                                ExtraordinaryWeights::quarters);
    expect_same_as_step_by_step(triangulated(bumpy(shape)), BoundaryRule::edges,
                                find_scheme("loop"), ExtraordinaryWeights::warren);
  }
}

/// More than 65,536 of them, as painted weights give.
TEST(UniformRefinement, TakesADifferentSharpnessOnEveryEdge) {
  Mesh mesh = shapes::grid(190, 190);
  const Adjacency adjacency(mesh.topology);
  for (int e = 0; e < adjacency.num_edges(); ++e) {
    const HalfedgeId h = adjacency.halfedge(EdgeId(e));
    mesh.tags.creases.push_back(
        {adjacency.from(h), adjacency.to(h), 0.5F + 1e-5F * static_cast<float>(e)});
  }
  const Features features = resolve_tags(adjacency, mesh.tags, BoundaryRule::edges);
  const Scheme& scheme = find_scheme("catmull-clark");
  ASSERT_TRUE(StructuredRefinement::applies(mesh.topology, features, scheme));
  ASSERT_GT(adjacency.num_edges(), 1 << 16);
  UniformRefinement refinement(adjacency, features, scheme, 2);
  EXPECT_TRUE(same_bits(positions(refinement, mesh.points.span()),
                        refined_step_by_step(mesh, features, scheme, 2).points));
}

TEST(UniformRefinement, KeepsVerticesWithoutFaces) {
  Mesh mesh = shapes::cube();
  const Topology& cube = mesh.topology;
  mesh.topology =
      Topology(9, 4, std::vector<VertexId>(cube.corners().begin(), cube.corners().end()));
  mesh.points.push_back(Vec3(1, 2, 3));
  expect_same_as_step_by_step(mesh, BoundaryRule::edges, find_scheme("catmull-clark"));
  expect_update_renews_all(mesh, find_scheme("catmull-clark"));
}

TEST(UniformRefinement, RefusesMoreVerticesThanCanBeNumbered) {
  const Mesh mesh = shapes::grid(200, 200);
  const Adjacency adjacency(mesh.topology);
  const Features features = resolve_tags(adjacency, mesh.tags, BoundaryRule::edges);
  const Scheme& scheme = find_scheme("catmull-clark");
  // Only counts here: the structured steps take no memory for what they could write.
  EXPECT_EQ(UniformRefinement(adjacency, features, scheme, 5).num_faces(), 40000 * 1024);
  const Mesh large = shapes::grid(800, 800);
  const Adjacency large_adjacency(large.topology);
  EXPECT_THROW(
      UniformRefinement(large_adjacency,
                        resolve_tags(large_adjacency, large.tags, BoundaryRule::edges), scheme, 5),
      InputError);
}

/// Every loop over a grid, with vectors of two doubles and with the widest of this machine.
TEST(QuadKernel, GivesTheSameBitsWithEveryInstructionSet) {
  const RegularMasks masks = regular_masks(find_scheme("catmull-clark")).value();
  const QuadRuns runs(QuadNumbering(4), 0b1010);
  const auto points = [&](const QuadKernel& kernel) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(-1, 1);
    QuadGrid grid;
    QuadGrid fine;
    for (int j = -1; j <= 9; ++j)
      for (int i = -1; i <= 9; ++i)
        grid.point(i, j) = Point4(Vec3(unit(random), unit(random), unit(random)));
    kernel.refine(masks, 8, grid.points(), fine.points());
    std::vector<Vec3> out(runs.offsets().size());
    kernel.write(fine.points(), runs.offsets().data(), static_cast<int>(out.size()), out.data());
    for (int k = -1; k <= 17; ++k)  // the margin
      for (const Point4& p :
           {fine.point(k, -1), fine.point(k, 17), fine.point(-1, k), fine.point(17, k)})
        p.store(out.emplace_back());
    return out;
  };
  EXPECT_TRUE(same_bits(points(QuadKernel::two_doubles()), points(QuadKernel::best())));
  const auto corners = [&](const QuadKernel& kernel) {
    std::vector<VertexId> coarse;
    for (int k = 0; k < 256; ++k)
      coarse.emplace_back(7 * k);
    std::vector<VertexId> fine(1024);
    kernel.split(64, coarse.data(), runs.edge_ranks(4).data(), 2000, 3000, fine.data());
    return fine;
  };
  EXPECT_EQ(corners(QuadKernel::two_doubles()), corners(QuadKernel::best()));
}

#ifdef LIMES_WITH_TBB
void expect_same_with_any_threads(const Mesh& mesh, const Scheme& scheme) {
  const Adjacency adjacency(mesh.topology);
  const Features features = resolve_tags(adjacency, mesh.tags, BoundaryRule::edges);
  std::vector<std::vector<Vec3>> results;
  std::vector<Topology> topologies;
  for (const std::size_t threads : {1, 2, 5}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    UniformRefinement refinement(adjacency, features, scheme, 5);
    results.push_back(positions(refinement, mesh.points.span()));
    topologies.push_back(refinement.topology());
  }
  for (const std::size_t other : {1, 2}) {
    EXPECT_TRUE(same_bits(results[0], results[other]));
    EXPECT_EQ(topologies[0], topologies[other]);
  }
}

TEST(UniformRefinement, DoesNotDependOnTheNumberOfThreads) {
  std::mt19937 random(3);
  const Mesh torus = shapes::torus(12, 9);
  expect_same_with_any_threads(with_random_tags(torus, random), find_scheme("catmull-clark"));
  expect_same_with_any_threads(with_random_tags(triangulated(torus), random), find_scheme("loop"));
}
#endif

TEST(TriangleKernel, GivesTheSameBitsWithEveryInstructionSet) {
  const RegularTriangleMasks masks = regular_triangle_masks(find_scheme("loop")).value();
  const TriangleNumbering numbering(4);
  const TriangleRuns runs(numbering, 0b101);
  const auto points = [&](const TriangleKernel& kernel) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(-1, 1);
    TriangleGrid grid;
    TriangleGrid fine;
    for (int j = -1; j <= 9; ++j)
      for (int i = -1; i + j <= 9; ++i)
        grid.point(i, j) = Point4(Vec3(unit(random), unit(random), unit(random)));
    kernel.refine(masks, 8, numbering.axes(4).data(), grid.points(), fine.points());
    std::vector<Vec3> out(runs.offsets().size());
    kernel.write(fine.points(), runs.offsets().data(), static_cast<int>(out.size()), out.data());
    for (int k = 0; k <= 17; ++k)  // the margin
      for (const Point4& p : {fine.point(k, -1), fine.point(-1, k), fine.point(17 - k, k)})
        p.store(out.emplace_back());
    return out;
  };
  EXPECT_TRUE(same_bits(points(TriangleKernel::two_doubles()), points(TriangleKernel::best())));
}

}  // namespace
}  // namespace limes
