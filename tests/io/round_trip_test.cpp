#include <bit>
#include <cmath>
#include <random>

#include "io/expect.h"
#include "limes/io/io.h"

// What a writer puts down reads back to the same bits.

namespace limes {
namespace {

/// Any finite double, every exponent alike.
double any_double(std::mt19937_64& random) {
  double x;
  do
    x = std::bit_cast<double>(random());
  while (!std::isfinite(x));
  return x;
}

/// 500 vertices with any coordinates; faces with 3 to 300 corners; every tag and name.
Mesh random_mesh(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  constexpr int num_vertices = 500;
  std::vector<int> offsets{0};
  std::vector<VertexId> corners;
  for (int f = 0; f < 200; ++f) {
    const int size = f == 77 ? 300 : 3 + below(5);
    const int first = below(num_vertices);
    for (int k = 0; k < size; ++k)
      corners.emplace_back((first + k) % num_vertices);
    offsets.push_back(static_cast<int>(corners.size()));
  }
  Mesh mesh;
  mesh.topology = Topology(num_vertices, offsets, corners);
  for (int v = 0; v < num_vertices; ++v)
    mesh.points.push_back(Vec3(any_double(random), any_double(random), any_double(random)));
  mesh.points[VertexId(0)] = Vec3(-0.0, 5e-324, 1.7976931348623157e308);
  return mesh;
}

void add_tags_and_names(Mesh& mesh, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto single = [&] { return static_cast<float>(std::ldexp(double(random() >> 40U), -20)); };
  for (int f = 0; f < 50; ++f) {
    const auto face = mesh.topology.face(FaceId(f));
    mesh.tags.creases.push_back({face[0], face[1], single()});
    mesh.tags.corners.push_back({face[2], single()});
  }
  mesh.tags.holes = {FaceId(3), FaceId(199)};
  mesh.tags.boundary = BoundaryRule::edges_and_corners;
  mesh.tags.crease_method = CreaseMethod::chaikin;
  mesh.tags.smooth_triangles = true;
  mesh.groups = {{"first", {FaceId(0), FaceId(1), FaceId(5)}},
                 {"#hash", {FaceId(1), FaceId(199)}},
                 {"\xc3\xbc", {FaceId(5), FaceId(6)}}};
  FaceGroup odd{"odd part", {}}, even{"even", {}};
  for (int f = 0; f < mesh.topology.num_faces(); ++f)
    (f % 2 == 0 ? even : odd).faces.emplace_back(f);
  mesh.parts = {even, odd};
}

void expect_same_bits(const Mesh& a, const Mesh& b) {
  ASSERT_EQ(a.points.size(), b.points.size());
  for (int v = 0; v < a.points.size(); ++v)
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_EQ(std::bit_cast<std::uint64_t>(a.points[VertexId(v)][axis]),
                std::bit_cast<std::uint64_t>(b.points[VertexId(v)][axis]));
  EXPECT_EQ(a.topology, b.topology);
}

class RoundTrip : public testing::TestWithParam<std::uint64_t> {};

TEST_P(RoundTrip, Obj) {
  Mesh mesh = random_mesh(GetParam());
  add_tags_and_names(mesh, GetParam());
  const MeshFile back = read_obj(written(write_obj, mesh), "f");
  EXPECT_TRUE(back.remarks.empty());
  expect_same_bits(mesh, back.mesh);
  EXPECT_EQ(back.mesh.tags.creases, mesh.tags.creases);
  EXPECT_EQ(back.mesh.tags.corners, mesh.tags.corners);
  EXPECT_EQ(back.mesh.tags.holes, mesh.tags.holes);
  EXPECT_EQ(back.mesh.tags.boundary, mesh.tags.boundary);
  EXPECT_EQ(back.mesh.tags.crease_method, mesh.tags.crease_method);
  EXPECT_EQ(back.mesh.tags.smooth_triangles, mesh.tags.smooth_triangles);
  EXPECT_EQ(names_of(back.mesh.groups), names_of(mesh.groups));
  EXPECT_EQ(names_of(back.mesh.parts), names_of(mesh.parts));
}

TEST_P(RoundTrip, Off) {
  const Mesh mesh = random_mesh(GetParam());
  const MeshFile back = read_off(written(write_off, mesh), "f");
  EXPECT_TRUE(back.remarks.empty());
  expect_same_bits(mesh, back.mesh);
}

TEST_P(RoundTrip, Ply) {
  const Mesh mesh = random_mesh(GetParam());  // has a face with more than 255 corners
  const MeshFile back = read_ply(written(write_ply, mesh), "f");
  EXPECT_TRUE(back.remarks.empty());
  expect_same_bits(mesh, back.mesh);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RoundTrip, testing::Values(1, 2, 3));

TEST(RoundTripOnce, PlyWithShortLists) {
  const Mesh mesh =
      read_off("OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0.1\n4 0 1 2 3\n3 2 1 0\n", "f").mesh;
  const std::string bytes = written(write_ply, mesh);
  EXPECT_NE(bytes.find("property list uchar int vertex_indices"), std::string::npos);
  expect_same_bits(mesh, read_ply(bytes, "f").mesh);
}

TEST(RoundTripOnce, StlKeepsSinglePrecisionAndTriangles) {
  const Mesh mesh =
      read_off("OFF\n5 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0.1\n0 0 1\n4 0 1 2 3\n3 0 4 1\n", "f").mesh;
  const std::string bytes = written(write_stl, mesh);
  ASSERT_EQ(bytes.size(), 84U + 3 * 50U);
  const Mesh back = read_stl(bytes, "f").mesh;
  EXPECT_EQ(faces_of(back), (Faces{{0, 1, 2}, {0, 2, 3}, {0, 4, 1}}));
  EXPECT_EQ(back.points[VertexId(3)], Vec3(0, 1, static_cast<double>(0.1F)));
  // the normal of the first triangle, right behind the header
  EXPECT_EQ(bytes.substr(84, 12), std::string("\0\0\0\0\0\0\0\0\0\0\x80\x3f", 12));
}

}  // namespace
}  // namespace limes
