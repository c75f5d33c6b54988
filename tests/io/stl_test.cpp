#include <fmt/format.h>

#include <limits>

#include "io/expect.h"
#include "limes/io/bytes.h"
#include "limes/io/io.h"

namespace limes {
namespace {

std::string facet(std::string_view a, std::string_view b, std::string_view c) {
  return fmt::format(
      "facet normal nan 0 1\nouter loop\nvertex {}\nvertex {}\nvertex {}\nendloop\nendfacet\n", a,
      b, c);
}

void append_float(std::string& bytes, float value) {
  const auto raw = number_bytes(value);
  bytes.append(raw.data(), raw.size());
}

/// A binary file with the given corners, nine floats per triangle.
std::string binary(std::string header, const std::vector<std::vector<float>>& triangles) {
  header.resize(80, ' ');
  const auto count = number_bytes(static_cast<std::uint32_t>(triangles.size()));
  std::string bytes = header + std::string(count.data(), count.size());
  for (const auto& corners : triangles) {
    for (int i = 0; i < 3; ++i)
      append_float(bytes, std::numeric_limits<float>::quiet_NaN());  // the normal is not read
    for (const float x : corners)
      append_float(bytes, x);
    bytes += "ab";
  }
  return bytes;
}

const std::vector<std::vector<float>> two = {{0, 0, 0, 1, 0, 0, 1, 1, 0},
                                             {-0.0F, 0, 0, 1, 1, 0, 0, 0.1F, 0}};
const Points two_points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, static_cast<double>(0.1F), 0}};
const Faces two_faces = {{0, 1, 2}, {0, 2, 3}};

TEST(Stl, TextIsWeldedByPosition) {
  const MeshFile file =
      read_stl("solid any name facet\n" + facet("0 0 0", "1 0 0", "1 1 0") +
                   facet("-0 0.0 0e5", "1 1 0", "0 0.1 0") + "endsolid any name\n",
               "f");
  EXPECT_EQ(points_of(file.mesh), (Points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0.1, 0}}));
  EXPECT_EQ(faces_of(file.mesh), two_faces);
  EXPECT_EQ(file.mesh.face_lines, (std::vector{2, 9}));
  EXPECT_EQ(file.remarks,
            std::vector<std::string>{"f: 6 corners welded to 4 vertices by equal position"});
}

TEST(Stl, UpperCaseAndSeveralSolids) {
  const std::string one = "SOLID a\n" + facet("0 0 0", "1 0 0", "1 1 0") + "ENDSOLID\n";
  EXPECT_EQ(faces_of(read_stl(one + "\r\n" + one, "f").mesh), (Faces{{0, 1, 2}, {0, 1, 2}}));
}

TEST(Stl, Binary) {
  for (const char* const header : {"binary", "solid but binary", ""}) {
    const Mesh mesh = read_stl(binary(header, two), "f").mesh;
    EXPECT_EQ(points_of(mesh), two_points);
    EXPECT_EQ(faces_of(mesh), two_faces);
    EXPECT_TRUE(mesh.face_lines.empty());
  }
}

TEST(Stl, BytesBehindTheTrianglesAreARemark) {
  for (const char* const header : {"binary", "solid but binary"})
    EXPECT_EQ(read_stl(binary(header, two) + "xyz", "f").remarks.at(0),
              "f: 3 bytes after the last triangle ignored");
}

TEST(Stl, CountsMustFitTheFile) {
  std::string lie = binary("binary", two);
  lie.replace(80, 4, "\xff\xff\xff\xff");
  EXPECT_EQ(refusal(read_stl, lie),
            "f: 4294967295 triangles announced; the file is too short for them");
  const std::string whole = binary("binary", two);
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_NE(refusal(read_stl, std::string_view(whole).substr(0, size)), "") << size;
}

TEST(Stl, CollapsedTrianglesAreLeftOut) {
  const MeshFile file = read_stl("solid\n" + facet("0 0 0", "1 0 0", "0 0 0") +
                                     facet("0 0 0", "1 0 0", "1 1 0") + "endsolid\n",
                                 "f");
  EXPECT_EQ(faces_of(file.mesh), (Faces{{0, 1, 2}}));
  EXPECT_EQ(file.mesh.face_lines, std::vector{9});
  EXPECT_EQ(file.remarks.at(0), "f:2: triangle with two corners in one place left out");
}

TEST(Stl, BrokenText) {
  const auto text = [](const std::string& rest) { return refusal(read_stl, "solid x\n" + rest); };
  EXPECT_EQ(text("facet normal 0 0 1\nouter loop\nvertex 0 0\nvertex 1 0 0\n"),
            "f:5: coordinate 'vertex' is no finite number; write it like 1.5 or -2e-3");
  EXPECT_EQ(text("facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nendloop\n"),
            "f:6: 'endloop'; 'vertex' expected");
  EXPECT_EQ(text("facet normal 0 0 1\nouter"), "f:3: the file ends here; 'loop' expected");
  EXPECT_EQ(text(facet("0 0 0", "1 0 0", "1 1 0")),
            "f:9: the file ends here; 'facet' or 'endsolid' expected");
  EXPECT_EQ(text("face\n"), "f:2: 'face'; 'facet' or 'endsolid' expected");
  EXPECT_EQ(text("endsolid\nmore\n"), "f:3: 'more'; 'solid' expected");
  EXPECT_EQ(text(facet("0 0 0", "1e39 nan 0", "1 1 0")),
            "f:5: coordinate 'nan' is no finite number; write it like 1.5 or -2e-3");
  EXPECT_EQ(refusal(read_stl, "solo\n"),
            "f: no STL file; it begins with 'solid' or has a header of 84 bytes");
}

TEST(Stl, InfiniteBinaryCoordinate) {
  auto triangles = two;
  triangles[1][4] = std::numeric_limits<float>::infinity();
  EXPECT_EQ(refusal(read_stl, binary("binary", triangles)),
            "f: triangle 1: coordinates are not finite");
}

}  // namespace
}  // namespace limes
