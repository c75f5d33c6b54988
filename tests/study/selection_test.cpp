#include "limes/problem/selection.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "limes/core/error.h"
#include "limes/io/io.h"

namespace limes {
namespace {

// A strip of 2 x 2 unit squares, z = 0, with a fifth face that hangs on the right side and a vertex
// without a face. Groups overlap; there is no part.
//
//   6---7---8
//   | 2 | 3 |
//   3---4---5---10      9 lies alone at (9, 9)
//   | 0 | 1 | 4 |
//   0---1---2---11
constexpr std::string_view strip = R"(v 0 0 0
v 1 0 0
v 2 0 0
v 0 1 0
v 1 1 0
v 2 1 0
v 0 2 0
v 1 2 0
v 2 2 0
v 9 9 0
v 3 1 0
v 3 0 0
g left
f 1 2 5 4
g right lower
f 2 3 6 5
g left
f 4 5 8 7
g right
f 5 6 9 8
g lower
f 3 12 11 6
)";

// Two faces apart, each a part.
constexpr std::string_view two_parts = R"(o near
v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
f 1 2 3 4
o far
v 5 0 0
v 6 0 0
v 6 1 0
v 5 1 0
f 5 6 7 8
)";

constexpr std::string_view closed = R"(v 0 0 0
v 1 0 0
v 0 1 0
v 0 0 1
f 1 3 2
f 1 2 4
f 2 3 4
f 3 1 4
)";

struct Model {
  explicit Model(std::string_view obj)
      : mesh(read_obj(obj, "m.obj").mesh), adjacency(mesh.topology) {}
  Mesh mesh;
  Adjacency adjacency;

  [[nodiscard]] Selection select(std::string_view where) const {
    return {mesh, adjacency, mesh.points.span(), where, Place{"p.toml:7", false, 7}};
  }
  [[nodiscard]] std::vector<int> vertices(std::string_view where) const {
    const Selection selection = select(where);
    std::vector<int> result;
    for (std::size_t v = 0; v < selection.vertices().size(); ++v)
      if (selection.vertices()[v]) result.push_back(static_cast<int>(v));
    return result;
  }
  [[nodiscard]] std::vector<int> faces(std::string_view where) const {
    std::vector<int> result;
    for (const FaceId f : select(where).faces())
      result.push_back(f.value);
    return result;
  }
  /// Vertices at the ends, as "0-1 1-2".
  [[nodiscard]] std::string edges(std::string_view where) const {
    std::string result;
    for (const HalfedgeId h : select(where).boundary_edges())
      result += fmt::format("{}-{} ", adjacency.from(h).value, adjacency.to(h).value);
    return result.substr(0, result.find_last_not_of(' ') + 1);
  }
  [[nodiscard]] std::string message(std::string_view where) const {
    try {
      (void)select(where);
    } catch (const InputError& error) {
      return error.what();
    }
    ADD_FAILURE() << where << " was accepted";
    return {};
  }
};

using Ints = std::vector<int>;

TEST(Selection, All) {
  const Model m(strip);
  EXPECT_EQ(m.vertices("all"), (Ints{0, 1, 2, 3, 4, 5, 6, 7, 8, 10, 11})) << "9 has no face";
  EXPECT_EQ(m.faces("all"), (Ints{0, 1, 2, 3, 4}));
  EXPECT_EQ(m.edges("all"), "0-1 3-0 1-2 7-6 6-3 5-8 8-7 2-11 11-10 10-5");
}

TEST(Selection, Boundary) {
  const Model m(strip);
  EXPECT_EQ(m.vertices("boundary"), (Ints{0, 1, 2, 3, 5, 6, 7, 8, 10, 11}));
  EXPECT_EQ(m.faces("boundary"), (Ints{4})) << "the one face without the vertex inside";
  EXPECT_EQ(m.edges("boundary"), m.edges("all"));
}

TEST(Selection, ConditionsAreTestedAtVertices) {
  const Model m(strip);
  EXPECT_EQ(m.vertices("x == 0"), (Ints{0, 3, 6}));
  EXPECT_EQ(m.faces("x == 0"), Ints{});
  EXPECT_EQ(m.edges("x == 0"), "3-0 6-3");
  EXPECT_EQ(m.faces("x <= 1"), (Ints{0, 2}));
  EXPECT_EQ(m.edges("x <= 1 and y > 0.5"), "7-6 6-3");
  EXPECT_EQ(m.vertices("hypot(x - 1, y - 1) < 0.1"), (Ints{4}));
  EXPECT_EQ(m.edges("y == 1"), "10-5") << "the edges between faces are no boundary";
  EXPECT_EQ(m.edges("x == 2"), "5-8") << "both ends of 2-5 are selected, but it lies inside";
  EXPECT_EQ(m.vertices("x > 2 ? y == 1 : 0"), (Ints{10}));
}

TEST(Selection, VertexAndGroups) {
  const Model m(strip);
  EXPECT_EQ(m.vertices("vertex:4"), (Ints{4}));
  EXPECT_EQ(m.vertices(" vertex: 11 "), (Ints{11}));
  EXPECT_EQ(m.faces("vertex:4"), Ints{});
  EXPECT_EQ(m.faces("group:left"), (Ints{0, 2}));
  EXPECT_EQ(m.faces("group:right"), (Ints{1, 3}));
  EXPECT_EQ(m.faces("group:lower"), (Ints{1, 4}));
  EXPECT_EQ(m.vertices("group:lower"), (Ints{1, 2, 4, 5, 10, 11}));
  EXPECT_EQ(m.edges("group:right"), "1-2 5-8 8-7");
  EXPECT_EQ(m.edges("group:left"), "0-1 3-0 7-6 6-3");
}

// All corners of a face may be in a group without the face being so.
TEST(Selection, AGroupHasExactlyItsFaces) {
  Model m(strip);
  m.mesh.groups = {{"ring", {FaceId(0), FaceId(3)}}, {"cover", {FaceId(0), FaceId(3), FaceId(4)}}};
  EXPECT_EQ(m.faces("group:cover"), (Ints{0, 3, 4})) << "1 has its corners in it, and is not";
  EXPECT_EQ(m.edges("group:cover").find("1-2"), std::string::npos);
}

TEST(Selection, Parts) {
  const Model m(two_parts);
  EXPECT_EQ(m.faces("part:far"), (Ints{1}));
  EXPECT_EQ(m.vertices("part:near"), (Ints{0, 1, 2, 3}));
  EXPECT_EQ(m.edges("part:far"), "4-5 5-6 6-7 7-4");
}

TEST(Selection, EqualMeansWithinABillionthOfTheDiagonal) {
  // the diagonal of the used points is (3, 2): 3.606
  Model m(strip);
  m.mesh.points[VertexId(3)].x() = 3.5e-9;
  m.mesh.points[VertexId(6)].x() = 3.7e-9;
  EXPECT_EQ(m.vertices("x == 0"), (Ints{0, 3}));
  for (Vec3& p : m.mesh.points)
    p *= 1e6;
  EXPECT_EQ(m.vertices("x == 0"), (Ints{0, 3})) << "whatever the unit";
}

// Limit positions, not the mesh's own.
TEST(Selection, TestsThePointsItIsGiven) {
  const Model m(strip);
  std::vector<Vec3> pushed(m.mesh.points.begin(), m.mesh.points.end());
  for (Vec3& p : pushed)
    p.x() += 10;
  const Selection selection(m.mesh, m.adjacency, pushed, "x == 10", Place{"p.toml:7", false, 7});
  EXPECT_TRUE(selection.vertices()[3]);
  EXPECT_EQ(std::count(selection.vertices().begin(), selection.vertices().end(), true), 3);
}

TEST(Selection, EmptyOnesSayWhatThereIs) {
  const Model m(strip);
  const Model tetrahedron(closed);
  const auto expect = [](const std::string& message, std::string_view where,
                         const std::string& words) {
    const std::string head = "p.toml:7: where = '" + std::string(where) + "' ";
    EXPECT_EQ(message.substr(0, head.size()), head);
    EXPECT_NE(message.find(words), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  };
  const auto check = [&](std::string_view where, const std::string& words) {
    expect(m.message(where), where, words);
  };
  check("x == 7",
        "selects no vertex; after refinement, on the limit surface, the mesh has x from 0 to 3, y "
        "from 0 to 2, z from 0 to 0");
  check("x == 9", "selects no vertex");  // the vertex there has no face
  check("group:lefd", "did you mean 'left'?");
  check("group:zzzzzzz", "known are left, right, lower");
  check("part:left", "the mesh has no parts");
  check("vertex:12", "vertices count from 0 to 11");
  check("vertex:9", "no face uses that vertex");
  check("x - 5", "is -5 at (0, 0, 0), neither true nor false; compare, as in x == 0");
  check("sqrt(x - 1)", "has no value at (0, 0, 0)");
  expect(tetrahedron.message("boundary"), "boundary", "the mesh has no boundary");
  expect(tetrahedron.message("group:a"), "group:a", "the mesh has no groups");
}

TEST(Selection, SaysWhatIsNoSelection) {
  const Model m(strip);
  const auto check = [&](std::string_view where, const std::string& words) {
    const std::string message = m.message(where);
    EXPECT_EQ(message.substr(0, 17), "p.toml:7: where: ") << message;
    EXPECT_NE(message.find(words), std::string::npos) << message;
  };
  check("", "an empty text selects nothing");
  check("everything", "or a condition such as x == 0");
  check("boundry", "did you mean 'boundary'?");
  check("All", "did you mean 'all'?");
  check("groups:left", "did you mean 'group'?");
  check("vertex:x", "'x' is no vertex; they count from 0, as in vertex:12");
  check("vertex:99999999999", "is no vertex");
  check("group:", "lacks a name");
  check("x = 0", "== compares");
  check("0 < x < 1", "write '0 < x and x < 1'");
}

TEST(Selection, OverridesAreWrongUsage) {
  const Model m(strip);
  const Place place{"--set support.0.where", true, 0};
  EXPECT_THROW((void)Selection(m.mesh, m.adjacency, m.mesh.points.span(), "x == 7", place),
               UsageError);
}

TEST(Selection, MessagesWithoutALineNameTheFile) {
  const Model m(strip);
  try {
    (void)Selection(m.mesh, m.adjacency, m.mesh.points.span(), "x == 7", Place{"p.toml", false, 0});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).substr(0, 15), "p.toml: where =");
  }
}

}  // namespace
}  // namespace limes
