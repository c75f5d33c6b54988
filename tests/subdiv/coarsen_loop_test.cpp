// Coarsening undoes a step of Loop: on every shape of OpenSubdiv's zoo and ours, in any numbering.

#include <gtest/gtest.h>

#include <filesystem>
#include <numeric>
#include <random>

#include "limes/core/error.h"
#include "limes/io/io.h"
#include "limes/mesh/measure.h"
#include "limes/subdiv/coarsen.h"
#include "limes/subdiv/schemes.h"
#include "subdiv/zoo.h"

namespace limes {
namespace {

std::vector<Shape> triangle_shapes() {
  std::vector<Shape> out;
  for (Shape& s : zoo())
    if (fits(find_scheme("loop"), s.mesh)) out.push_back(std::move(s));
  for (const auto& entry : std::filesystem::directory_iterator(LIMES_TEST_DATA_DIR "/opensubdiv")) {
    const std::string name = entry.path().stem().string();
    if (entry.path().extension() != ".obj" || !name.starts_with("loop_")) continue;
    Mesh mesh = read_mesh(entry.path()).mesh;
    if (mesh.tags.boundary == BoundaryRule::none) mesh.tags.boundary = BoundaryRule::edges;
    try {
      (void)Adjacency(mesh.topology);
    } catch (const InputError&) {
      continue;  // no surface
    }
    if (fits(find_scheme("loop"), mesh)) out.push_back({name, std::move(mesh)});
  }
  return out;
}

Mesh refined_by_loop(const Mesh& mesh) {
  return refine(mesh, find_scheme("loop"),
                {.levels = 1, .boundary = mesh.tags.boundary.value_or(BoundaryRule::edges)});
}

bool loses_tags(const Mesh& mesh) {
  const auto fades = [](const auto& tag) { return tag.sharpness > 0 && tag.sharpness <= 2; };
  return std::any_of(mesh.tags.creases.begin(), mesh.tags.creases.end(), fades) ||
         std::any_of(mesh.tags.corners.begin(), mesh.tags.corners.end(), fades);
}

TEST(CoarsenLoop, UndoesAStep) {
  int count = 0;
  for (const Shape& shape : triangle_shapes()) {
    SCOPED_TRACE(shape.name);
    if (loses_tags(shape.mesh)) continue;
    const Mesh fine = refined_by_loop(shape.mesh);
    const CoarsenResult result = coarsen(fine, {.scheme = "loop"});
    EXPECT_EQ(result.mesh.topology, shape.mesh.topology);
    const double size = bounding_box(shape.mesh).diagonal();
    ASSERT_EQ(result.mesh.points.size(), shape.mesh.points.size());
    for (int v = 0; v < shape.mesh.points.size(); ++v)
      EXPECT_LE((result.mesh.points[VertexId(v)] - shape.mesh.points[VertexId(v)]).norm(),
                1e-12 * size);
    EXPECT_LE(result.residual, 1e-14 * size);
    EXPECT_EQ(refined_by_loop(result.mesh).tags.creases, fine.tags.creases);
    EXPECT_EQ(refined_by_loop(result.mesh).tags.corners, fine.tags.corners);
    ++count;
  }
  EXPECT_GE(count, 30);
}

/// Vertices renumbered, faces in another order and turned.
Mesh shuffled(const Mesh& mesh, std::mt19937& random) {
  std::vector<int> vertex(static_cast<std::size_t>(mesh.points.size()));
  std::iota(vertex.begin(), vertex.end(), 0);
  std::shuffle(vertex.begin(), vertex.end(), random);
  std::vector<int> face(static_cast<std::size_t>(mesh.topology.num_faces()));
  std::iota(face.begin(), face.end(), 0);
  std::shuffle(face.begin(), face.end(), random);
  Mesh out;
  out.points.resize(vertex.size());
  for (std::size_t v = 0; v < vertex.size(); ++v)
    out.points[VertexId(vertex[v])] = mesh.points[VertexId(static_cast<std::int64_t>(v))];
  std::vector<VertexId> corners;
  for (const int f : face) {
    const auto old = mesh.topology.face(FaceId(f));
    const std::size_t turn = random() % 3;
    for (std::size_t i = 0; i < 3; ++i)
      corners.emplace_back(vertex[static_cast<std::size_t>(old[(i + turn) % 3].value)]);
  }
  out.topology = Topology(mesh.points.size(), 3, std::move(corners));
  return out;
}

TEST(CoarsenLoop, NumberingDoesNotMatter) {
  std::mt19937 random(3);
  for (const Shape& shape : triangle_shapes()) {
    if (!shape.mesh.tags.creases.empty() || !shape.mesh.tags.corners.empty()) continue;
    if (shape.mesh.tags.boundary) continue;
    SCOPED_TRACE(shape.name);
    const Mesh fine = shuffled(refined_by_loop(shape.mesh), random);
    const CoarsenResult result = coarsen(fine, {.scheme = "loop"});
    EXPECT_EQ(result.mesh.points.size(), shape.mesh.points.size());
    EXPECT_EQ(result.mesh.topology.num_faces(), shape.mesh.topology.num_faces());
    EXPECT_LE(result.residual, 1e-13 * bounding_box(fine).diagonal());
  }
}

TEST(CoarsenLoop, ButterflyLosesItsNewVertices) {
  const Scheme& butterfly = find_scheme("butterfly");
  for (const Shape& shape : triangle_shapes()) {
    if (!fits(butterfly, shape.mesh)) continue;
    SCOPED_TRACE(shape.name);
    const CoarsenResult result =
        coarsen(refine(shape.mesh, butterfly, {.levels = 1}), {.scheme = "butterfly"});
    EXPECT_EQ(result.mesh.topology, shape.mesh.topology);
    EXPECT_EQ(result.mesh.points, shape.mesh.points);
    EXPECT_EQ(result.residual, 0);
  }
}

TEST(CoarsenLoop, RefusesWhatNoStepMakes) {
  EXPECT_THROW((void)coarsen(shapes::icosahedron(), {.scheme = "loop"}), InputError);
  Mesh fine = refined_by_loop(bumpy(shapes::icosahedron()));
  fine.points[VertexId(20)] += Vec3(0.01, 0, 0);
  try {
    (void)coarsen(fine, {.scheme = "loop"});
    ADD_FAILURE() << "accepted";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("vertex 20"), std::string::npos) << error.what();
  }
  EXPECT_THROW((void)coarsen(shapes::cube(), {.scheme = "loop"}), InputError);
}

}  // namespace
}  // namespace limes
