#include <fmt/format.h>

#include <bit>

#include "io/expect.h"
#include "limes/io/bytes.h"
#include "limes/io/io.h"

namespace limes {
namespace {

using namespace std::string_literals;

/// Appends numbers as bytes in either order.
class Bytes {
 public:
  explicit Bytes(bool big) : big_(big) {}
  template <class T>
  Bytes& add(T value) {
    auto raw = number_bytes(value);
    if (big_) std::reverse(raw.begin(), raw.end());
    bytes_.append(raw.data(), raw.size());
    return *this;
  }
  [[nodiscard]] const std::string& text() const { return bytes_; }

 private:
  bool big_;
  std::string bytes_;
};

const std::string plain_head =
    "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n";

std::string ascii(const std::string& rest) {
  return "ply\nformat ascii 1.0\n" + rest;
}

TEST(Ply, Text) {
  const Mesh mesh =
      read_ply(ascii("comment made by hand\n" + plain_head + "0 0 0.1\n1 0 0\n0 1 0\n3 0 1 2\n"),
               "f")
          .mesh;
  EXPECT_EQ(points_of(mesh), (Points{{0, 0, 0.1}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_EQ(faces_of(mesh), (Faces{{0, 1, 2}}));
  EXPECT_EQ(mesh.face_lines, std::vector{14});
}

/// Doubles and halves of every integer type, extra properties of every type before, between and
/// behind, extra elements around.
std::string odd_file(bool big) {
  Bytes data(big);
  // element camera: a double and a list of shorts
  data.add(1.5)
      .add(std::uint16_t{3})
      .add(std::int16_t{1})
      .add(std::int16_t{2})
      .add(std::int16_t{3});
  for (int v = 0; v < 4; ++v)
    data.add(std::int8_t{-1})
        .add(double(v) + 0.1)
        .add(std::uint8_t{2})
        .add(7.0F)
        .add(8.0F)
        .add(std::int16_t(-300 * v))
        .add(std::uint32_t{0xffffffff})
        .add(std::uint8_t(200 + v));
  for (int f = 0; f < 2; ++f) {
    data.add(std::uint8_t{255}).add(std::int32_t{3 + f});
    for (int k = 0; k < 3 + f; ++k)
      data.add(std::uint16_t(k));
    data.add(std::int32_t{1}).add(0.25);
  }
  data.add(std::int32_t{12});  // element edge
  return fmt::format(
             "ply\r\nformat binary_{}_endian 1.0\r\ncomment end_header is not here\r\nobj_info "
             "x\r\n"
             "element camera 1\r\nproperty float64 fov\r\nproperty list ushort short marks\r\n"
             "element vertex 4\r\nproperty char a\r\nproperty double x\r\n"
             "property list uint8 float32 weights\r\nproperty int16 y\r\nproperty uint flags\r\n"
             "property uchar z\r\n"
             "element face 2\r\nproperty uint8 red\r\nproperty list int ushort vertex_index\r\n"
             "property list int32 double extra\r\n"
             "element edge 1\r\nproperty int32 v\r\nend_header\r\n",
             big ? "big" : "little") +
         data.text();
}

TEST(Ply, BinaryOfBothOrdersAndEveryType) {
  for (const bool big : {false, true}) {
    const MeshFile file = read_ply(odd_file(big), "f");
    EXPECT_EQ(points_of(file.mesh),
              (Points{{0.1, 0, 200}, {1.1, -300, 201}, {2.1, -600, 202}, {3.1, -900, 203}}));
    EXPECT_EQ(faces_of(file.mesh), (Faces{{0, 1, 2}, {0, 1, 2, 3}}));
    EXPECT_TRUE(file.mesh.face_lines.empty());
    EXPECT_TRUE(file.remarks.empty());
  }
}

TEST(Ply, EveryTruncationOfABinaryFileIsRefused) {
  const std::string whole = odd_file(true);
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_NE(refusal(read_ply, std::string_view(whole).substr(0, size)), "") << size;
}

TEST(Ply, HeaderEndsInCrAndDataBeginWithLf) {
  // 0x0a is the first byte of the first coordinate; it belongs to the data
  std::string head =
      "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty char x\nproperty char y\n"
      "property char z\nelement face 1\nproperty list uchar uchar vertex_indices\nend_header\n";
  std::replace(head.begin(), head.end(), '\n', '\r');
  const Mesh mesh = read_ply(head + "\n\1\2\3\4\5\6\7\x8\3\0\1\2"s, "f").mesh;
  EXPECT_EQ(points_of(mesh), (Points{{10, 1, 2}, {3, 4, 5}, {6, 7, 8}}));
}

TEST(Ply, FacesMayComeBeforeVertices) {
  const Mesh mesh = read_ply(ascii("element face 1\nproperty list uchar int vertex_indices\n"
                                   "element vertex 3\nproperty int x\nproperty int y\n"
                                   "property int z\nend_header\n3 2 1 0 0 0 0 1 0 0 0 1 0"),
                             "f")
                        .mesh;
  EXPECT_EQ(faces_of(mesh), (Faces{{2, 1, 0}}));
}

TEST(Ply, BrokenHeaders) {
  const auto head = [](const std::string& text) { return refusal(read_ply, text); };
  EXPECT_EQ(head("plx\n"), "f:1: no PLY file; its first line is 'ply'");
  EXPECT_EQ(head(""), "f:1: no PLY file; its first line is 'ply'");
  EXPECT_EQ(head("ply\nformat ascii 1.0\n"), "f:3: the header ends without 'end_header'");
  EXPECT_EQ(head("ply\nformat text 1.0\n"),
            "f:2: format 'text' is unknown; ascii, binary_little_endian and binary_big_endian are "
            "right");
  EXPECT_EQ(head("ply\nelement vertex 1\nend_header\n"),
            "f:3: the header has no format; 'format ascii 1.0' is right");
  EXPECT_EQ(head("ply\nproperty float x\n"), "f:2: a property before the first element");
  EXPECT_EQ(head("ply\nelement vertex -1\n"),
            "f:2: element 'vertex': count '-1' is wrong; 0 or more is right");
  EXPECT_EQ(head("ply\nelement a 1\nelement a 1\n"), "f:3: element 'a' is declared twice");
  EXPECT_EQ(head("ply\nelement a 1\nproperty half x\n"),
            "f:3: type 'half' is unknown; char to uint, float and double are right");
  EXPECT_EQ(head("ply\nelement a 1\nproperty list float int x\n"),
            "f:3: the length of a list is a float; an integer type is right");
  EXPECT_EQ(head("ply\nelement a 1\nproperty int\n"),
            "f:3: a property without a name; 'property float x' is right");
  EXPECT_EQ(head("ply\nelmnt a 1\n"), "f:2: 'elmnt' is no keyword of a PLY header");
  EXPECT_EQ(head(ascii("element vertex 1\nproperty float x\nproperty float y\nend_header\n1 2\n")),
            "f: vertices have no property 'z'; x, y and z are needed");
  EXPECT_EQ(head(ascii("element face 1\nproperty int n\nend_header\n1\n")),
            "f: faces have no list 'vertex_indices'");
}

TEST(Ply, CountsMustFitTheFile) {
  EXPECT_EQ(refusal(read_ply,
                    "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\n"
                    "property float x\nproperty float y\nproperty float z\nend_header\n"),
            "f: element 'vertex' announces 4000000000 entries; the file is too short for them");
  EXPECT_NE(refusal(read_ply, ascii("element x 99\nproperty int a\nend_header\n1 2 3\n")), "");
  // entries without data cost nothing
  EXPECT_EQ(refusal(read_ply, ascii("element x 9000000000000\n" + plain_head +
                                    "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")),
            "");
}

TEST(Ply, ManyElementsAreReadInNoTime) {
  std::string header = "ply\nformat ascii 1.0\n";
  for (int i = 0; i < 200000; ++i)
    header += fmt::format("element e{} 0\n", i);
  EXPECT_EQ(
      read_ply(header + plain_head + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "f").mesh.points.size(), 3);
}

TEST(Ply, BrokenData) {
  const auto data = [](const std::string& text) {
    return refusal(read_ply, ascii(plain_head + text));
  };
  EXPECT_EQ(data("0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"), "");
  EXPECT_EQ(data("0 0 0\n1 x 0\n0 1 0\n3 0 1 2\n"),
            "f:11: 'x' is no finite number; write it like 1.5 or -2e-3");
  EXPECT_EQ(data("0 0 0\n1 0 0\n0 1 0\n3 0 1\n").rfind("f:14: the file ends here", 0), 0U);
  EXPECT_EQ(data("0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n"),
            "f:13: vertex 3 does not exist; the file has 3 vertices, numbered from 0");
  EXPECT_NE(data("0 0 0\n1 0 0\n0 1 0\n-3 0 1 2\n"), "");
  EXPECT_NE(data("0 0 0\n1 0 0\n0 1 0\n3 0 1 1.5\n"), "");
  EXPECT_NE(data("0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n"), "");
  EXPECT_NE(data("0 0 0\n1 0 0\n0 1 0\n3 0 1 1e300\n"), "");
  Bytes nan(false);
  for (int i = 0; i < 9; ++i)
    nan.add(i == 4 ? std::bit_cast<float>(0x7fc00000U) : 0.0F);
  EXPECT_EQ(refusal(read_ply, "ply\nformat binary_little_endian 1.0\n" + plain_head + nan.text() +
                                  "\3"s + std::string(12, '\0')),
            "f: vertex 1: coordinates are not finite");
}

TEST(Ply, WhatFollowsIsARemark) {
  EXPECT_EQ(read_ply(ascii(plain_head + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n7\n"), "f").remarks,
            std::vector<std::string>{"f: data after the last element ignored"});
}

}  // namespace
}  // namespace limes
