#include <fmt/format.h>

#include "io/expect.h"
#include "limes/io/io.h"

namespace limes {
namespace {

constexpr std::string_view body = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n3 2 1 0\n";

TEST(Off, PointsFacesAndLines) {
  const Mesh mesh = read_off(fmt::format("OFF\n4 2 0\n{}", body), "f").mesh;
  EXPECT_EQ(points_of(mesh), (Points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}));
  EXPECT_EQ(faces_of(mesh), (Faces{{0, 1, 2, 3}, {2, 1, 0}}));
  EXPECT_EQ(mesh.face_lines, (std::vector{7, 8}));
}

TEST(Off, EveryHeader) {
  for (const std::string_view head :
       {"OFF\n4 2 0\n", "4 2 0\n", "4 2\n", "OFF 4 2 0\n", "# c\n\nOFF # c\n# c\n4 2 0 # c\n",
        "COFF\n4 2 0\n", "NOFF\n4 2 0\n", "STOFF\n4 2 0\n", "STCNOFF\r\n4 2 0\r",
        "\xef\xbb\xbfOFF\n4 2 0\n"})
    EXPECT_EQ(faces_of(read_off(fmt::format("{}{}", head, body), "f").mesh).size(), 2U) << head;
  EXPECT_EQ(refusal(read_off, "4OFF\n4 2 0\n"),
            "f:1: '4OFF' cannot be read; OFF, COFF, NOFF, STOFF or the counts are right here");
  EXPECT_EQ(refusal(read_off, "OFF BINARY\n4 2 0\n"),
            "f:1: binary OFF is not supported; save it as text");
}

TEST(Off, ColoursAndNormalsAreIgnored) {
  const Mesh mesh =
      read_off(
          "COFF\n3 1 0\n0 0 0 255 0 0 255\n1 0 0 9 9 9 9\n0 1 0 9 9 9 9\n3 0 1 2 0.5 0.5 0.5\n",
          "f")
          .mesh;
  EXPECT_EQ(points_of(mesh), (Points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_EQ(faces_of(mesh), (Faces{{0, 1, 2}}));
}

TEST(Off, CountsMustFitTheFile) {
  EXPECT_EQ(refusal(read_off, "OFF\n2000000000 1 0\n0 0 0\n"),
            "f:2: 2000000000 vertices announced; the file is too short for them");
  EXPECT_EQ(refusal(read_off, "OFF\n1 2000000000 0\n0 0 0\n"),
            "f:2: 2000000000 faces announced; the file is too short for them");
  EXPECT_NE(refusal(read_off, "OFF\n-4 1 0\n0 0 0\n"), "");
  EXPECT_NE(refusal(read_off, "OFF\n4.0 1 0\n0 0 0\n"), "");
  EXPECT_NE(refusal(read_off, "OFF\n4\n0 0 0\n"), "");
  // the shortest lines there are still fit
  EXPECT_EQ(faces_of(read_off("3 2\n0 0 0\n0 1 0\n1 0 0\n3 0 1 2\n0", "f").mesh).size(), 1U);
}

TEST(Off, BrokenLines) {
  const auto with = [](std::string_view vertex, std::string_view face) {
    return refusal(read_off, fmt::format("OFF\n3 1 0\n0 0 0\n0 1 0\n{}\n{}\n", vertex, face));
  };
  EXPECT_EQ(with("1 0 0", "3 0 1 2"), "");
  EXPECT_EQ(with("1 0", "3 0 1 2"),
            "f:5: coordinate '' is no finite number; three like 1.5 or -2e-3 are right");
  EXPECT_NE(with("1 nan 0", "3 0 1 2"), "");
  EXPECT_EQ(with("1 0 0", "9 0 1 2"), "f:6: a face with 9 corners names only 3");
  EXPECT_EQ(with("1 0 0", "3 0 1 3"),
            "f:6: vertex 3 does not exist; the file has 3 vertices, numbered from 0");
  EXPECT_EQ(with("1 0 0", "3 0 1 -1").rfind("f:6: vertex -1 does not exist", 0), 0U);
  EXPECT_EQ(with("1 0 0", "3 0 1 1.5"), "f:6: vertex '1.5' is no whole number");
  EXPECT_NE(with("1 0 0", "-3 0 1 2"), "");
  EXPECT_EQ(with("1 0 0", ""), "f:7: the file ends here; a face expected");
}

TEST(Off, WhatFollowsIsARemark) {
  EXPECT_EQ(read_off(fmt::format("4 2 0\n{}# end\n\n2 0 1\n", body), "f").remarks,
            std::vector<std::string>{"f:10: lines after the last face ignored"});
  EXPECT_TRUE(read_off(fmt::format("4 2 0\n{}# end\n\n", body), "f").remarks.empty());
}

}  // namespace
}  // namespace limes
