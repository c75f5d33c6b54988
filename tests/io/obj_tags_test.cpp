#include <fmt/format.h>

#include <fstream>
#include <iterator>

#include "io/expect.h"
#include "limes/io/io.h"

namespace limes {
namespace {

/// Two triangles 0 1 2 and 0 2 3 (counted from 0) with the given tag lines from line 7 on.
MeshFile tagged(std::string_view lines) {
  return read_obj(fmt::format("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n{}", lines),
                  "f");
}
std::string refused(std::string_view lines) {
  try {
    static_cast<void>(tagged(lines));
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

CreaseTag crease(int a, int b, float s) {
  return {VertexId(a), VertexId(b), s};
}
CornerTag corner(int v, float s) {
  return {VertexId(v), s};
}
using Creases = std::vector<CreaseTag>;
using Corners = std::vector<CornerTag>;

TEST(ObjTags, CreasesCountVerticesFromZero) {
  EXPECT_EQ(tagged("t crease 2/1/0 0 2 2.5\n").mesh.tags.creases, (Creases{crease(0, 2, 2.5F)}));
  EXPECT_EQ(tagged("t crease 2/1 0 1 10\n").mesh.tags.creases, (Creases{crease(0, 1, 10)}));
}

TEST(ObjTags, ChainsAndPairsOfCreases) {
  const MeshFile chain = tagged("t crease 3/1/0 0 1 2 4\n");
  EXPECT_EQ(chain.mesh.tags.creases, (Creases{crease(0, 1, 4), crease(1, 2, 4)}));
  EXPECT_TRUE(chain.remarks.empty());
  EXPECT_EQ(tagged("t crease 3/2/0 0 1 2 4 5\n").mesh.tags.creases,
            (Creases{crease(0, 1, 4), crease(1, 2, 5)}));
  EXPECT_EQ(tagged("t crease 4/2/0 0 1 2 3 4 5\n").mesh.tags.creases,
            (Creases{crease(0, 1, 4), crease(2, 3, 5)}));
  const MeshFile either = tagged("t crease 4/1/0 0 1 2 3 4\n");
  EXPECT_EQ(either.mesh.tags.creases.size(), 3U);
  EXPECT_EQ(either.remarks,
            std::vector<std::string>{
                "f:7: crease tag read as a chain of edges, not as pairs of vertices"});
}

TEST(ObjTags, CreaseOnNoEdgeIsLeftOut) {
  const MeshFile file = tagged("t crease 2/1/0 0 1 1\nt crease 2/1/0 1 3 2\n");
  EXPECT_EQ(file.mesh.tags.creases, (Creases{crease(0, 1, 1)}));
  EXPECT_EQ(file.remarks,
            std::vector<std::string>{"f:8: crease between vertices that share no edge left out"});
}

TEST(ObjTags, Corners) {
  EXPECT_EQ(tagged("t corner 1/1/0 3 1.5\nt corner 2/1/0 0 1 2\nt corner 2/2/0 1 2 3 4\n")
                .mesh.tags.corners,
            (Corners{corner(3, 1.5F), corner(0, 2), corner(1, 2), corner(1, 3), corner(2, 4)}));
}

TEST(ObjTags, TagsMayStandBeforeTheMesh) {
  const Mesh mesh =
      read_obj("t corner 1/1/0 2 1\nt hole 1/0/0 0\nv 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3", "f").mesh;
  EXPECT_EQ(mesh.tags.corners, (Corners{corner(2, 1)}));
  EXPECT_EQ(mesh.tags.holes, std::vector{FaceId(0)});
}

TEST(ObjTags, HolesCountFacesOfTheFile) {
  // the face with two corners is left out but counts
  const MeshFile file = read_obj(
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2\nf 1 2 3\nf 3 2 1\nt hole 1/0/0 2\nt hole 2/0/0 0 2\n",
      "f");
  EXPECT_EQ(file.mesh.tags.holes, std::vector{FaceId(1)});
  EXPECT_EQ(refused("t hole 1/0/0 2\n"),
            "f:7: tag 'hole': face 2 does not exist; tags count faces from 0 to 1");
}

TEST(ObjTags, BoundaryAndMethods) {
  EXPECT_FALSE(tagged("").mesh.tags.boundary.has_value());
  EXPECT_EQ(tagged("t interpolateboundary 1/0/0 0\n").mesh.tags.boundary, BoundaryRule::none);
  EXPECT_EQ(tagged("t interpolateboundary 1/0/0 1\n").mesh.tags.boundary,
            BoundaryRule::edges_and_corners);
  EXPECT_EQ(tagged("t interpolateboundary 1/0/0 2\n").mesh.tags.boundary, BoundaryRule::edges);
  EXPECT_NE(refused("t interpolateboundary 1/0/0 3\n"), "");
  EXPECT_EQ(tagged("t creasemethod 0/0/1 chaikin\n").mesh.tags.crease_method,
            CreaseMethod::chaikin);
  EXPECT_EQ(tagged("t creasemethod 0/0/1 normal\n").mesh.tags.crease_method, CreaseMethod::uniform);
  EXPECT_EQ(refused("t creasemethod 0/0/1 sharp\n"),
            "f:7: tag 'creasemethod': one word is right: 'normal' or 'chaikin'");
  EXPECT_TRUE(tagged("t smoothtriangles 0/0/1 smooth\n").mesh.tags.smooth_triangles);
  EXPECT_FALSE(tagged("t smoothtriangles 0/0/1 catmark\n").mesh.tags.smooth_triangles);
}

TEST(ObjTags, UnknownTagsAreRemarks) {
  EXPECT_EQ(tagged("t wobble 0/0/1 x\n").remarks,
            std::vector<std::string>{"f:7: unknown tag 'wobble' ignored"});
  EXPECT_TRUE(tagged("t facevaryinginterpolateboundary 1/0/0 1\n").remarks.empty());
}

TEST(ObjTags, HierarchicalEditsAreRefused) {
  EXPECT_EQ(refused("t vertexedit 3/1/4 0 0 3 1 add P value 1\n"),
            "f:7: tag 'vertexedit': hierarchical edits are not supported; remove them");
}

TEST(ObjTags, CountsMustFitTheLine) {
  EXPECT_EQ(refused("t crease 99999999/1/0 0 1 2.0\n"),
            "f:7: tag 'crease' announces 99999999/1/0 values, the line has 3");
  EXPECT_NE(refused("t crease 2/1/0 0 1\n"), "");
  EXPECT_NE(refused("t crease 2/1/0 0 1 2 3\n"), "");
  EXPECT_NE(refused("t crease 9223372036854775807/9223372036854775807/3 0 1\n"), "");
  for (const std::string_view counts : {"", "2", "-1/4/0", "a/b/c", "2/1/0/0", "2//1"})
    EXPECT_NE(refused(fmt::format("t crease {} 0 1 2\n", counts)), "") << counts;
}

TEST(ObjTags, ValuesMustBeNumbersOfTheMesh) {
  EXPECT_EQ(refused("t crease 2/1/0 0 4 1\n"),
            "f:7: tag 'crease': vertex 4 does not exist; tags count vertices from 0 to 3");
  EXPECT_NE(refused("t corner 1/1/0 -1 1\n"), "");
  EXPECT_EQ(refused("t corner 1/1/0 1.5 1\n"), "f:7: tag 'corner': '1.5' is no whole number");
  EXPECT_EQ(refused("t corner 1/1/0 1 nan\n"),
            "f:7: tag 'corner': 'nan' is no finite number; write it like 2.5");
  EXPECT_NE(refused("t corner 0/1/0 1\n"), "");
  EXPECT_NE(refused("t crease 1/1/0 1 1\n"), "");
  EXPECT_NE(refused("t crease 3/3/0 0 1 2 1 1 1\n"), "");
}

TEST(ObjTags, NegativeSharpnessIsZero) {
  const MeshFile file = tagged("t corner 2/2/0 0 1 -1 -2\nt corner 1/1/0 2 -3\n");
  EXPECT_EQ(file.mesh.tags.corners, (Corners{corner(0, 0), corner(1, 0), corner(2, 0)}));
  EXPECT_EQ(file.remarks,
            std::vector<std::string>{"f:7: negative sharpness taken as 0 (also line 8)"});
}

std::string manual() {
  std::ifstream in(LIMES_TEST_DATA_DIR "/../../docs/formats.md");
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(ObjTags, TheExampleOfTheManualIsWhatIsWritten) {
  const std::string text = manual();
  const std::size_t begin = text.find("```text\n") + 8;
  const std::string example = text.substr(begin, text.find("```", begin) - begin);
  const MeshFile file = read_obj(example, "f");
  EXPECT_TRUE(file.remarks.empty());
  EXPECT_EQ(written(write_obj, file.mesh), example);
}

TEST(ObjTags, TheTableOfTheManualIsRead) {
  // a row of seven quads: edges 0-1, 1-2, 2-3, 4-7 and 6-7 exist on its lower side
  std::string mesh;
  for (int i = 0; i < 16; ++i)
    mesh += fmt::format("v {} {} 0\n", i % 8, i / 8);
  for (int i = 0; i < 13; ++i)
    mesh += i < 7 ? fmt::format("f {} {} {} {}\n", i + 1, i + 2, i + 10, i + 9)
                  : std::string("f 5 8 16 13\n");
  const std::string text = manual();
  int num_tags = 0;
  for (std::size_t at = text.find("| `t "); at != std::string::npos;
       at = text.find("| `t ", at + 1)) {
    const std::string tag = text.substr(at + 3, text.find('`', at + 3) - at - 3);
    EXPECT_TRUE(read_obj(mesh + tag, "f").remarks.empty()) << tag;
    ++num_tags;
  }
  EXPECT_EQ(num_tags, 8);
}

}  // namespace
}  // namespace limes
