// Coarsening undoes refinement: on every shape of OpenSubdiv's zoo, in any numbering.

#include "limes/subdiv/coarsen.h"

#include <gtest/gtest.h>

#include <Eigen/QR>
#include <algorithm>
#include <filesystem>
#include <numeric>
#include <random>

#include "limes/core/error.h"
#include "limes/io/io.h"
#include "limes/mesh/defects.h"
#include "limes/mesh/measure.h"
#include "limes/subdiv/refine.h"
#include "limes/subdiv/refinement_step.h"
#include "limes/subdiv/schemes.h"
#include "subdiv/coarsen_meshes.h"

namespace limes {
namespace {

/// Shapes that can be refined, with a boundary rule whose result can be undone.
std::vector<std::string> shapes() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(LIMES_TEST_DATA_DIR "/opensubdiv")) {
    const std::string name = entry.path().stem().string();
    if (entry.path().extension() != ".obj" || name.find("hedit") != std::string::npos) continue;
    const auto defects = find_defects(read_mesh(entry.path()).mesh);
    const bool blocked = std::any_of(defects.begin(), defects.end(),
                                     [](const Defect& d) { return blocks_refinement(d.kind); });
    if (!blocked) names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

/// Sharpness that vanishes in one step leaves nothing to find it by.
bool loses_tags(const Mesh& mesh) {
  const Mesh fine = refined(mesh);
  const auto fades = [](const auto& tag) { return tag.sharpness > 0 && tag.sharpness <= 1; };
  // Chaikin's rule may take more than 1 away.
  const bool chaikin = mesh.tags.crease_method == CreaseMethod::chaikin &&
                       fine.tags.creases.size() < 2 * mesh.tags.creases.size();
  return chaikin || std::any_of(mesh.tags.creases.begin(), mesh.tags.creases.end(), fades) ||
         std::any_of(mesh.tags.corners.begin(), mesh.tags.corners.end(), fades);
}

/// Rank of the operator by a dense decomposition that knows nothing of graphs. Vertices without
/// faces keep their values and count.
bool has_full_rank(const Mesh& mesh) {
  const Adjacency adjacency(mesh.topology);
  const Features features = resolve_tags(adjacency, mesh.tags, rule_of(mesh));
  const MatrixX S = RefinementStep(adjacency, features, find_scheme("catmull-clark")).matrix();
  Eigen::ColPivHouseholderQR<MatrixX> qr(S);
  qr.setThreshold(1e-10);
  return qr.rank() == S.cols();
}

/// Sharpness by edge and vertex, whatever the order and direction of the tags.
Tags sorted(Tags tags, const Topology& topology, BoundaryRule rule) {
  const Adjacency adjacency(topology);
  Tags result = tags_of(adjacency.topology(), resolve_tags(adjacency, tags, rule));
  result.holes = std::move(tags.holes);
  return result;
}

class Shapes : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Coarsen, Shapes, testing::ValuesIn(shapes()),
                         [](const auto& shape) { return shape.param; });

TEST_P(Shapes, ComeBackInTheirOwnNumbering) {
  const Mesh mesh = read_shape(GetParam());
  const Mesh fine = refined(mesh);
  if (mesh.topology.num_vertices() < 400 && !has_full_rank(mesh)) {
    EXPECT_THROW((void)coarsen(fine), InputError);
    return;
  }
  if (loses_tags(mesh)) {
    // Nothing to undo it by, unless the positions do not show it.
    try {
      EXPECT_LE(coarsen(fine).residual, 1e-6 * size_of(fine));
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("not a refined mesh"), std::string::npos);
    }
    return;
  }
  const CoarsenResult coarse = coarsen(fine);
  ASSERT_EQ(coarse.mesh.topology, mesh.topology);
  EXPECT_LT(largest_distance(coarse.mesh, mesh), 1e-11 * size_of(mesh));
  EXPECT_TRUE(coarse.remarks.empty()) << coarse.remarks.front();
  const Tags want = sorted(mesh.tags, mesh.topology, rule_of(mesh));
  const Tags got = sorted(coarse.mesh.tags, mesh.topology, rule_of(mesh));
  ASSERT_EQ(got.creases.size(), want.creases.size());
  for (std::size_t i = 0; i < want.creases.size(); ++i) {
    EXPECT_EQ(got.creases[i].a, want.creases[i].a);
    EXPECT_NEAR(got.creases[i].sharpness, want.creases[i].sharpness, 1e-5F);
  }
  EXPECT_EQ(got.corners, want.corners);
  EXPECT_EQ(got.holes, want.holes);

  const Mesh again = refined(coarse.mesh);
  ASSERT_EQ(again.topology, fine.topology);
  EXPECT_LT(largest_distance(again, fine), 1e-12 * size_of(fine));
}

/// The same mesh with vertices, faces and first corners in random order.
Mesh shuffled(const Mesh& mesh, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<int> vertex(static_cast<std::size_t>(mesh.topology.num_vertices()));
  std::iota(vertex.begin(), vertex.end(), 0);
  std::shuffle(vertex.begin(), vertex.end(), random);
  std::vector<int> face(static_cast<std::size_t>(mesh.topology.num_faces()));
  std::iota(face.begin(), face.end(), 0);
  std::shuffle(face.begin(), face.end(), random);
  const auto moved = [&](VertexId v) {
    return VertexId(vertex[static_cast<std::size_t>(v.value)]);
  };

  Mesh out;
  out.points.resize(vertex.size());
  for (int v = 0; v < mesh.points.size(); ++v)
    out.points[moved(VertexId(v))] = mesh.points[VertexId(v)];
  std::vector<VertexId> corners;
  for (const int f : face) {
    const auto old = mesh.topology.face(FaceId(f));
    const std::size_t turn = random() % 4;
    for (std::size_t i = 0; i < 4; ++i)
      corners.push_back(moved(old[(i + turn) % 4]));
  }
  out.topology = Topology(mesh.topology.num_vertices(), 4, std::move(corners));
  out.tags = mesh.tags;
  for (CreaseTag& t : out.tags.creases)
    t = {moved(t.a), moved(t.b), t.sharpness};
  for (CornerTag& t : out.tags.corners)
    t.vertex = moved(t.vertex);
  out.tags.holes.clear();
  return out;
}

/// Every vertex of one mesh lies on one of the other, and there are as many.
void expect_same_vertices(const Mesh& a, const Mesh& b, double tolerance) {
  ASSERT_EQ(a.points.size(), b.points.size());
  for (const Vec3& x : a.points) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Vec3& y : b.points)
      nearest = std::min(nearest, (x - y).norm());
    ASSERT_LT(nearest, tolerance);
  }
}

TEST_P(Shapes, ComeBackFromAnyNumbering) {
  const Mesh mesh = read_shape(GetParam());
  if (mesh.topology.num_vertices() > 400 || loses_tags(mesh) || !has_full_rank(mesh)) return;
  const Mesh coarse = coarsen(shuffled(refined(mesh), 7)).mesh;
  EXPECT_EQ(coarse.topology.num_faces(), mesh.topology.num_faces());
  EXPECT_EQ(coarse.topology.num_corners(), mesh.topology.num_corners());
  expect_same_vertices(coarse, mesh, 1e-11 * size_of(mesh));
  EXPECT_EQ(coarse.tags.creases.size(),
            sorted(mesh.tags, mesh.topology, rule_of(mesh)).creases.size());
}

TEST(Coarsen, TakesBackLevelByLevel) {
  // Regular everywhere: the labels are four times ambiguous, the positions decide.
  const Mesh torus = read_mesh(LIMES_DATA_DIR "/torus.obj").mesh;
  for (const int levels : {1, 2, 3}) {
    const Mesh coarse = coarsen(shuffled(refined(torus, levels), 3)).mesh;
    expect_same_vertices(coarse, refined(torus, levels - 1), 1e-11 * size_of(torus));
  }
  const Mesh pawn = read_mesh(LIMES_DATA_DIR "/pawn.obj").mesh;
  const Mesh coarse = coarsen(refined(pawn, 2)).mesh;
  EXPECT_LT(largest_distance(coarse, refined(pawn)), 1e-11 * size_of(pawn));
}

TEST(Coarsen, AgreesWithTheClosedForm) {
  // From V' = (n - 3)/n V + 2/n^2 sum of midpoints + 1/n^2 sum F and E = (2 midpoint + F + F')/4:
  // V = (n V' + sum F / n - 4 sum E / n) / (n - 3). ([barendrecht_2013] prints it wrongly.)
  const Mesh pawn = read_mesh(LIMES_DATA_DIR "/pawn.obj").mesh;
  const Mesh fine = refined(pawn);
  const Adjacency adjacency(fine.topology);
  const Mesh coarse = coarsen(fine).mesh;
  const Sharpness sharpness(adjacency, resolve_tags(adjacency, fine.tags, BoundaryRule::edges));
  int checked = 0;
  for (int v = 0; v < coarse.topology.num_vertices(); ++v) {  // old vertices keep their ids
    const int n = adjacency.valence(VertexId(v));
    if (n == 3 || adjacency.is_boundary(VertexId(v))) continue;
    Vec3 edges = Vec3::Zero(), faces = Vec3::Zero();
    bool smooth = true;
    HalfedgeId h = adjacency.ring_start(VertexId(v));
    for (int i = 0; i < n; ++i, h = adjacency.ring_next(h)) {
      smooth = smooth && sharpness.edge(adjacency.edge(h)) == 0.0F;
      edges += fine.points[adjacency.to(h)];
      faces += fine.points[adjacency.to(adjacency.next(h))];
    }
    if (!smooth) continue;
    const Vec3 old = (n * fine.points[VertexId(v)] + faces / n - 4.0 * edges / n) / (n - 3);
    EXPECT_LT((old - coarse.points[VertexId(v)]).norm(), 1e-12) << v;
    ++checked;
  }
  EXPECT_GT(checked, 300);
}

Mesh joined(const Mesh& a, const Mesh& b) {
  Mesh out = a;
  std::vector<int> offsets{0};
  std::vector<VertexId> corners;
  for (const Mesh* m : {&a, &b})
    for (int f = 0; f < m->topology.num_faces(); ++f) {
      for (const VertexId v : m->topology.face(FaceId(f)))
        corners.emplace_back(v.value + (m == &b ? a.topology.num_vertices() : 0));
      offsets.push_back(static_cast<int>(corners.size()));
    }
  for (const Vec3& x : b.points)
    out.points.push_back(x);
  out.topology = Topology(out.points.size(), std::move(offsets), std::move(corners));
  return out;
}

TEST(Coarsen, TakesEveryComponentByItself) {
  const Mesh mesh = joined(read_shape("catmark_torus"), read_shape("catmark_pyramid"));
  const Mesh coarse = coarsen(refined(mesh)).mesh;
  ASSERT_EQ(coarse.topology, mesh.topology);
  EXPECT_LT(largest_distance(coarse, mesh), 1e-11 * size_of(mesh));
}

TEST(Coarsen, CarriesGroupsPartsAndHoles) {
  Mesh mesh = read_shape("catmark_torus");
  const int n = mesh.topology.num_faces();
  mesh.groups = {{"some", {FaceId(1), FaceId(2), FaceId(5)}}};
  mesh.parts = {{"low", {}}, {"high", {}}};
  for (int f = 0; f < n; ++f)
    mesh.parts[f < n / 2 ? 0 : 1].faces.emplace_back(f);
  mesh.tags.holes = {FaceId(3)};
  Mesh fine = refined(mesh);
  const CoarsenResult whole = coarsen(fine);
  EXPECT_EQ(whole.mesh.groups[0].faces, mesh.groups[0].faces);
  EXPECT_EQ(whole.mesh.parts[0].faces, mesh.parts[0].faces);
  EXPECT_EQ(whole.mesh.parts[1].faces, mesh.parts[1].faces);
  EXPECT_EQ(whole.mesh.tags.holes, mesh.tags.holes);
  EXPECT_TRUE(whole.remarks.empty());

  fine.groups[0].faces.pop_back();  // a child of face 5 leaves
  const CoarsenResult split = coarsen(fine);
  EXPECT_EQ(split.mesh.groups[0].faces, (std::vector<FaceId>{FaceId(1), FaceId(2)}));
  ASSERT_EQ(split.remarks.size(), 1U);
  EXPECT_NE(split.remarks[0].find("group some"), std::string::npos);
}

TEST(Coarsen, AcceptsRoundedFiles) {
  const Mesh mesh = read_shape("catmark_torus");
  Mesh fine = refined(mesh);
  for (Vec3& x : fine.points)
    x = (x * 1e6).array().round() / 1e6;
  const CoarsenResult coarse = coarsen(fine);
  EXPECT_LT(largest_distance(coarse.mesh, mesh), 1e-5);
  EXPECT_LT(coarse.residual, 2e-6);
}

}  // namespace
}  // namespace limes
