#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <random>

#include "limes/core/error.h"
#include "limes/mesh/shapes.h"
#include "limes/subdiv/crease.h"
#include "limes/subdiv/refine.h"
#include "limes/subdiv/refinement_step.h"
#include "limes/subdiv/schemes.h"
#include "oracle/correspondence.h"
#include "oracle/shapes.h"

// Refined meshes against OpenSubdiv: positions, topology, numbering and left-over sharpness of three
// levels of every shape, with every boundary rule.

namespace limes::oracle {
namespace {

/// One of our meshes with what refinement needs, level by level.
struct Level {
  explicit Level(Topology t) : topology(std::move(t)), adjacency(topology) {}
  Topology topology;
  Adjacency adjacency;
  Features features;
  std::vector<Vec3> points;
};

std::unique_ptr<Level> first_level(const Mesh& mesh, BoundaryRule boundary) {
  auto level = std::make_unique<Level>(mesh.topology);
  level->features = resolve_tags(level->adjacency, mesh.tags, boundary);
  level->points = mesh.points.vector();
  return level;
}

std::unique_ptr<Level> next_level(const Level& parent, const Scheme& scheme) {
  const RefinementStep step(parent.adjacency, parent.features, scheme);
  auto child = std::make_unique<Level>(step.child_topology());
  child->features = step.child_features();
  child->points.resize(static_cast<std::size_t>(step.num_child_vertices()));
  step.apply(parent.points, child->points);
  return child;
}

double largest_difference(const Correspondence& c, const std::vector<Vec3>& ours,
                          const std::vector<Vec3>& theirs) {
  double worst = 0.0;
  for (std::size_t v = 0; v < theirs.size(); ++v)
    worst = std::max(worst, (ours[static_cast<std::size_t>(c.vertex[v])] - theirs[v]).norm());
  return worst;
}

/// Sharpness as OpenSubdiv has it: edges by their ends, the boundary left out.
void expect_same_sharpness(const Correspondence& c, const Level& ours,
                           const osd::Far::TopologyLevel& theirs) {
  const Tags tags = tags_of(ours.adjacency.topology(), ours.features);
  std::vector<std::array<float, 3>> our_edges, their_edges;
  for (const CreaseTag& t : tags.creases) {
    const auto [a, b] = std::minmax(t.a.value, t.b.value);
    our_edges.push_back({static_cast<float>(a), static_cast<float>(b), t.sharpness});
  }
  for (int e = 0; e < theirs.GetNumEdges(); ++e) {
    if (theirs.IsEdgeBoundary(e) || theirs.GetEdgeSharpness(e) <= 0) continue;
    const auto ends = theirs.GetEdgeVertices(e);
    const auto [a, b] = std::minmax(c.vertex[static_cast<std::size_t>(ends[0])],
                                    c.vertex[static_cast<std::size_t>(ends[1])]);
    their_edges.push_back(
        {static_cast<float>(a), static_cast<float>(b), theirs.GetEdgeSharpness(e)});
  }
  std::sort(our_edges.begin(), our_edges.end());
  std::sort(their_edges.begin(), their_edges.end());
  ASSERT_EQ(our_edges.size(), their_edges.size());
  for (std::size_t i = 0; i < our_edges.size(); ++i) {
    EXPECT_EQ(our_edges[i][0], their_edges[i][0]);
    EXPECT_EQ(our_edges[i][1], their_edges[i][1]);
    EXPECT_NEAR(our_edges[i][2], their_edges[i][2], 1e-6F) << "edge " << our_edges[i][0];
  }
  std::vector<float> our_vertices(ours.points.size(), 0.0F);
  for (const CornerTag& t : tags.corners)
    our_vertices[static_cast<std::size_t>(t.vertex.value)] = t.sharpness;
  for (int v = 0; v < theirs.GetNumVertices(); ++v)
    if (theirs.GetVertexFaces(v).size() > 0) {
      EXPECT_EQ(our_vertices[static_cast<std::size_t>(c.vertex[static_cast<std::size_t>(v)])],
                theirs.GetVertexSharpness(v))
          << "vertex " << v;
    }
}

void compare_levels(const Mesh& mesh, const Scheme& scheme, BoundaryRule boundary) {
  const int levels = 3;
  const auto refiner = make_refiner(mesh, scheme, boundary);
  const auto theirs = refine_uniformly(*refiner, mesh, levels);
  const double size = size_of(mesh);
  auto ours = first_level(mesh, boundary);
  Correspondence c = identity(mesh.topology);
  for (int level = 1; level <= levels; ++level) {
    SCOPED_TRACE(testing::Message() << "level " << level);
    auto child = next_level(*ours, scheme);
    std::string wrong;
    c = descend(c, refiner->GetLevel(level - 1), refiner->GetLevel(level), ours->topology,
                child->topology, wrong);
    ASSERT_EQ(wrong, "");
    EXPECT_LE(largest_difference(c, child->points, theirs[static_cast<std::size_t>(level)]),
              1e-12 * size);
    if (scheme.name != "linear") expect_same_sharpness(c, *child, refiner->GetLevel(level));
    ours = std::move(child);
  }

  // The public function takes the same steps, and leaves out what OpenSubdiv makes holes.
  const Mesh refined = refine(mesh, scheme, {.levels = levels, .boundary = boundary});
  if (boundary != BoundaryRule::none) {
    EXPECT_EQ(refined.topology, ours->topology);
    EXPECT_EQ(refined.points.vector(), ours->points);
    return;
  }
  Mesh without_holes = mesh;
  without_holes.tags.holes.clear();
  const auto shown = make_refiner(without_holes, scheme, boundary);
  refine_uniformly(*shown, mesh, levels);
  std::vector<int> theirs_of(c.face.size());
  for (std::size_t f = 0; f < c.face.size(); ++f)
    theirs_of[static_cast<std::size_t>(c.face[f])] = static_cast<int>(f);
  std::vector<std::vector<Vec3>> kept;
  for (std::size_t f = 0; f < c.face.size(); ++f) {
    if (shown->GetLevel(levels).IsFaceHole(theirs_of[f])) continue;
    const auto face = ours->topology.face(FaceId(static_cast<std::int64_t>(f)));
    kept.emplace_back();
    for (const VertexId v : face)
      kept.back().push_back(ours->points[static_cast<std::size_t>(v.value)]);
  }
  ASSERT_EQ(refined.topology.num_faces(), static_cast<int>(kept.size()));
  for (std::size_t f = 0; f < kept.size(); ++f)
    for (std::size_t i = 0; i < kept[f].size(); ++i)
      EXPECT_EQ(refined.points[refined.topology.face(FaceId(static_cast<std::int64_t>(f)))[i]],
                kept[f][i]);
}

class OpenSubdivRefine : public testing::TestWithParam<Case> {};

TEST_P(OpenSubdivRefine, ThreeLevelsAgree) {
  compare_levels(read_shape(GetParam().shape), find_scheme("catmull-clark"), GetParam().boundary);
}

INSTANTIATE_TEST_SUITE_P(Shapes, OpenSubdivRefine, testing::ValuesIn(manifold_cases("catmark")),
                         [](const auto& c) { return name_of(c.param); });

class OpenSubdivBilinear : public testing::TestWithParam<Case> {};

TEST_P(OpenSubdivBilinear, ThreeLevelsAgree) {
  compare_levels(read_shape(GetParam().shape), find_scheme("linear"), GetParam().boundary);
}

INSTANTIATE_TEST_SUITE_P(Shapes, OpenSubdivBilinear, testing::ValuesIn(manifold_cases("bilinear")),
                         [](const auto& c) { return name_of(c.param); });

class OpenSubdivLoop : public testing::TestWithParam<Case> {};

TEST_P(OpenSubdivLoop, ThreeLevelsAgree) {
  compare_levels(read_shape(GetParam().shape), find_scheme("loop"), GetParam().boundary);
}

INSTANTIATE_TEST_SUITE_P(Shapes, OpenSubdivLoop, testing::ValuesIn(manifold_cases("loop")),
                         [](const auto& c) { return name_of(c.param); });

/// Every edge and some vertices with a random sharpness: blends of all kinds, far more than the
/// shapes have.
Mesh with_random_sharpness(Mesh mesh, std::mt19937& random) {
  const std::vector<float> choices{0,    0,    0,    0.1F, 0.3F, 0.5F, 0.8F, 1.0F,
                                   1.2F, 1.6F, 2.0F, 2.7F, 3.5F, 6.0F, 10.0F};
  const auto pick = [&] { return choices[random() % choices.size()]; };
  const Adjacency adjacency(mesh.topology);
  for (int e = 0; e < adjacency.num_edges(); ++e) {
    const HalfedgeId h = adjacency.halfedge(EdgeId(e));
    mesh.tags.creases.push_back({adjacency.from(h), adjacency.to(h), pick()});
  }
  for (int v = 0; v < mesh.topology.num_vertices(); v += 4)
    mesh.tags.corners.push_back({VertexId(v), pick()});
  return mesh;
}

TEST(OpenSubdivRandom, SharpnessOfAllKinds) {
  std::mt19937 random(2003);
  for (int round = 0; round < 60; ++round) {
    Mesh mesh = round % 3 == 0   ? shapes::torus(4, 3)
                : round % 3 == 1 ? shapes::icosahedron()
                                 : shapes::grid_with_hole(5);
    mesh.tags.crease_method = round % 2 == 0 ? CreaseMethod::chaikin : CreaseMethod::uniform;
    SCOPED_TRACE(round);
    mesh = with_random_sharpness(std::move(mesh), random);
    compare_levels(mesh, find_scheme("catmull-clark"), BoundaryRule::edges);
    if (round % 3 == 1) compare_levels(mesh, find_scheme("loop"), BoundaryRule::edges);
  }
}

/// What is no surface is refused with the name of the culprit.
TEST(OpenSubdivShapes, RefusesWhatIsNoSurface) {
  int refused = 0;
  for (const std::string& shape : shapes_with("")) {
    const std::string expected = refusal_of(shape);
    if (expected.empty()) continue;
    ++refused;
    SCOPED_TRACE(shape);
    try {
      const Mesh mesh = read_shape(shape);
      const bool loop = shape.rfind("loop", 0) == 0;
      (void)refine(mesh, find_scheme(loop ? "loop" : "catmull-clark"), {});
      ADD_FAILURE() << "accepted";
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(expected), std::string::npos) << error.what();
    }
  }
  EXPECT_EQ(refused, 15);
}

}  // namespace
}  // namespace limes::oracle
