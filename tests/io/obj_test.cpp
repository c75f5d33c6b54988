#include <fmt/format.h>

#include "io/expect.h"
#include "limes/io/io.h"

namespace limes {
namespace {

constexpr std::string_view square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

Mesh obj(std::string_view text) {
  return read_obj(text, "f").mesh;
}
Mesh on_square(std::string_view lines) {
  return obj(fmt::format("{}{}", square, lines));
}
std::string refused_on_square(std::string_view lines) {
  return refusal(read_obj, fmt::format("{}{}", square, lines));
}
std::vector<std::string> remarks_on_square(std::string_view lines) {
  return read_obj(fmt::format("{}{}", square, lines), "f").remarks;
}

TEST(Obj, PointsFacesAndLines) {
  const Mesh mesh =
      obj("# a comment\nv 1.5 -2e-3 +.5\n\n  v\t0 1. 2 # another\nv 3 4 5\nf 1 2 3\n");
  EXPECT_EQ(points_of(mesh), (Points{{1.5, -0.002, 0.5}, {0, 1, 2}, {3, 4, 5}}));
  EXPECT_EQ(faces_of(mesh), (Faces{{0, 1, 2}}));
  EXPECT_EQ(mesh.face_lines, std::vector{6});
}

TEST(Obj, EveryLineEnd) {
  for (const std::string_view end : {"\n", "\r\n", "\r"}) {
    const std::string text = fmt::format("v 0 0 0{0}{0}v 1 0 0{0}v 0 1 0{0}f 1 2 3{0}f 3 2 1", end);
    const Mesh mesh = obj(text);
    EXPECT_EQ(faces_of(mesh), (Faces{{0, 1, 2}, {2, 1, 0}}));
    EXPECT_EQ(mesh.face_lines, (std::vector{5, 6}));
  }
}

TEST(Obj, ByteOrderMarkIsSkippedOnceAtTheFront) {
  EXPECT_EQ(faces_of(obj("\xef\xbb\xbfv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")).size(), 1U);
}

TEST(Obj, ContinuedLines) {
  const Mesh mesh = on_square("f 1 2 \\\n  3 \\\n4\nf 4 3 2\n");
  EXPECT_EQ(faces_of(mesh), (Faces{{0, 1, 2, 3}, {3, 2, 1}}));
  EXPECT_EQ(mesh.face_lines, (std::vector{5, 8}));
  // a comment that ends in a backslash does not swallow the next line
  EXPECT_EQ(faces_of(on_square("# C:\\models\\\nf 1 2 3\n")).size(), 1U);
  // a backslash at the end of the file joins nothing
  EXPECT_EQ(faces_of(on_square("f 1 2 3 \\")), (Faces{{0, 1, 2}}));
  // words do not grow together
  EXPECT_EQ(faces_of(on_square("f 1 2 3\\\n4\n")), (Faces{{0, 1, 2, 3}}));
}

TEST(Obj, RelativeIndicesCountWhatCameBefore) {
  EXPECT_EQ(faces_of(obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 1 1 0\nf -1 -2 2\n")),
            (Faces{{0, 1, 2}, {3, 2, 1}}));
  EXPECT_EQ(refused_on_square("f -5 -4 -3\n"),
            "f:5: relative vertex -5 does not exist; 4 vertices come before it");
}

TEST(Obj, VerticesMayComeLater) {
  EXPECT_EQ(faces_of(obj("f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n")), (Faces{{0, 1, 2}}));
}

TEST(Obj, SlashForms) {
  EXPECT_EQ(faces_of(on_square("f 1 2/ 3/9 4//9\nf 1//2 2/1/2 3// 4/-1/-1\n")),
            (Faces{{0, 1, 2, 3}, {0, 1, 2, 3}}));
  for (const std::string_view corner : {"1/2/3/4", "/1", "1/a", "1/2/b", "1.0", "a", "1,2", "0x1"})
    EXPECT_EQ(refused_on_square(fmt::format("f 2 {} 3\n", corner)),
              fmt::format("f:5: corner '{}' is not understood; 7, 7/1, 7//2 and 7/1/2 are right",
                          corner));
}

TEST(Obj, VerticesThatDoNotExist) {
  EXPECT_EQ(refused_on_square("f 1 2 5\n"),
            "f:5: vertex 5 does not exist; the file has 4 vertices, numbered from 1");
  EXPECT_EQ(refused_on_square("\nf 1 2 3\nf 0 1 2\n"),
            "f:7: vertex 0 does not exist; vertices are numbered from 1");
  EXPECT_EQ(refused_on_square("f 1 2 4294967297\n"),
            "f:5: vertex 4294967297 does not exist; vertices are numbered from 1, at most to "
            "2147483647");
}

TEST(Obj, NumbersOfAVertex) {
  // weight; colour; both: checked and left out
  EXPECT_EQ(points_of(obj("v 0 0 0 1\nv 1 0 0 .1 .2 .3\nv 0 1 0 1 .1 .2 .3\nf 1 2 3")),
            (Points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_EQ(read_obj("v 0 0 0 2\nv 1 0 0\nv 0 1 0\nf 1 2 3", "f").remarks,
            std::vector<std::string>{"f:1: weight of a vertex ignored; all weigh the same"});
  for (const std::string_view line : {"v", "v 1", "v 1 2", "v 1 2 3 4 5", "v 1 2 3 4 5 6 7 8"})
    EXPECT_EQ(refusal(read_obj, line).rfind("f:1: a vertex with", 0), 0U) << line;
  for (const std::string_view word : {"nan", "inf", "1e999", "1,5", "0x1p1", "1.2.3", "1e", "--1"})
    EXPECT_EQ(
        refusal(read_obj, fmt::format("v 0 0 0\nv 0 {} 0\n", word)),
        fmt::format("f:2: coordinate '{}' is no finite number; write it like 1.5 or -2e-3", word));
}

TEST(Obj, NumbersAreRoundedOnce) {
  const Mesh mesh =
      obj("v 0.1 9007199254740993 2.2250738585072011e-308\nv 1e-400 -0 4.9e-324\nv 0 1 0\nf 1 2 3");
  EXPECT_EQ(mesh.points[VertexId(0)], Vec3(0.1, 9007199254740992.0, 2.2250738585072011e-308));
  EXPECT_EQ(mesh.points[VertexId(1)][0], 0.0);
  EXPECT_TRUE(std::signbit(mesh.points[VertexId(1)][1]));
  EXPECT_EQ(mesh.points[VertexId(1)][2], 4.9e-324);
}

TEST(Obj, SmallFacesAreLeftOut) {
  const MeshFile file = read_obj(fmt::format("{}f 1\nf 1 2 3\nf 1 2\nf\n", square), "f");
  EXPECT_EQ(faces_of(file.mesh), (Faces{{0, 1, 2}}));
  EXPECT_EQ(file.remarks, std::vector<std::string>{
                              "f:5: face with fewer than 3 corners left out (also lines 7, 8)"});
}

TEST(Obj, NothingToRead) {
  EXPECT_EQ(refusal(read_obj, ""),
            "f: no faces; a mesh needs at least one face with three corners");
  EXPECT_EQ(refused_on_square("f 1 2\n"),
            "f: no faces (1 with fewer than 3 corners left out); a mesh needs at least one face "
            "with three corners");
}

TEST(Obj, UnknownKeywordsAreNamedOnce) {
  EXPECT_EQ(remarks_on_square("f 1 2 3\nfoo\nvn 0 0 1\nfoo 1\nusemtl x\nfoo\nfoo\nfoo\nfoo\n"),
            std::vector<std::string>{
                "f:6: unknown keyword 'foo' ignored (also lines 8, 10, 11 and 2 more)"});
}

TEST(Obj, RemarksAreLimited) {
  std::string lines = "f 1 2 3\n";
  for (int i = 0; i < 50; ++i)
    lines += fmt::format("key{}\n", i);
  const auto remarks = remarks_on_square(lines);
  EXPECT_EQ(remarks.size(), 21U);
  EXPECT_EQ(remarks.back(), "f: 30 more remarks");
}

TEST(Obj, Groups) {
  const Mesh mesh =
      on_square("f 1 2 3\ng a b\nf 1 2 4\ng b a b\nf 2 3 4\ng\nf 1 3 4\ng empty\ng a\nf 1 2 3\n");
  EXPECT_EQ(names_of(mesh.groups), "a: 1 2 4; b: 1 2");
  EXPECT_TRUE(mesh.parts.empty());
}

TEST(Obj, GroupsAtOnceAreLimited) {
  std::string names;
  for (int i = 0; i < 64; ++i)
    names += fmt::format(" n{}", i);
  EXPECT_EQ(on_square(fmt::format("g{}\nf 1 2 3\n", names)).groups.size(), 64U);
  EXPECT_EQ(refused_on_square(fmt::format("g{} one\nf 1 2 3\n", names)),
            "f:5: more than 64 groups at once; a face can be in 64 groups");
}

TEST(Obj, Parts) {
  const Mesh mesh =
      on_square("f 1 2 3\no left wing \nf 1 2 4\no\nf 2 3 4\no left wing\nf 1 3 4\no none\n");
  EXPECT_EQ(names_of(mesh.parts), "default: 0 2; left wing: 1 3");
}

TEST(Obj, NamesThatAreNotUtf8) {
  const MeshFile file = read_obj(fmt::format("{}g fl\xfcgel \xc3\xbc\nf 1 2 3\n", square), "f");
  EXPECT_EQ(names_of(file.mesh.groups), "fl?gel: 0; \xc3\xbc: 0");
  EXPECT_EQ(file.remarks.size(), 1U);
}

TEST(Obj, BinaryAndUtf16AreRefused) {
  using namespace std::string_view_literals;
  EXPECT_EQ(refusal(read_obj, "v 0 0 0\nv 1\0 0"sv), "f:2: NUL byte; a text file is expected here");
  EXPECT_EQ(refusal(read_obj, "\xff\xfev\0 \0"sv), "f:1: UTF-16 text; save it as UTF-8 or ASCII");
}

}  // namespace
}  // namespace limes
