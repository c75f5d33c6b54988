#include "limes/mesh/defects.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "limes/core/error.h"
#include "mesh/meshes.h"

namespace limes {
namespace {

using ::testing::Test;

std::vector<DefectKind> kinds_of(const Mesh& mesh) {
  std::vector<DefectKind> kinds;
  for (const Defect& d : find_defects(mesh))
    kinds.push_back(d.kind);
  return kinds;
}

/// The only defect of that kind.
Defect only(const Mesh& mesh, DefectKind kind) {
  std::vector<Defect> found;
  for (Defect& d : find_defects(mesh))
    if (d.kind == kind) found.push_back(std::move(d));
  EXPECT_EQ(found.size(), 1U) << name_of(kind);
  return found.empty() ? Defect{} : found.front();
}

std::vector<FaceId> faces(std::initializer_list<int> ids) {
  std::vector<FaceId> result;
  for (const int id : ids)
    result.emplace_back(id);
  return result;
}

std::vector<VertexId> vertices(std::initializer_list<int> ids) {
  std::vector<VertexId> result;
  for (const int id : ids)
    result.emplace_back(id);
  return result;
}

std::string refusal(const Mesh& mesh) {
  try {
    require_refinable(mesh, "model.obj");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

using Kinds = std::vector<DefectKind>;

TEST(Defects, CubeHasNone) {
  EXPECT_EQ(kinds_of(make_cube()), Kinds{});
  EXPECT_EQ(refusal(make_cube()), "");
}

TEST(Defects, ThreeFacesOnOneEdge) {
  const Mesh mesh = make_mesh(5, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
  EXPECT_EQ(kinds_of(mesh), Kinds{DefectKind::non_manifold_edge});
  const Defect defect = only(mesh, DefectKind::non_manifold_edge);
  EXPECT_EQ(defect.faces, faces({0, 1, 2}));
  EXPECT_EQ(defect.vertices, vertices({0, 1}));
  EXPECT_EQ(refusal(mesh), "model.obj: edge 0-1 has 3 faces (0, 1, 2); at most two can be joined");
}

TEST(Defects, LineOfTheFirstFace) {
  Mesh mesh = make_mesh(5, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
  mesh.face_lines = {7, 8, 12};
  EXPECT_EQ(only(mesh, DefectKind::non_manifold_edge).line, 7);
  EXPECT_EQ(refusal(mesh).substr(0, 12), "model.obj:7:");
}

TEST(Defects, TwoFansAtOneVertex) {
  const Mesh mesh = make_mesh(7, {{0, 1, 2}, {2, 3, 4}, {2, 4, 5}, {6, 2, 5}});
  const Defect defect = only(mesh, DefectKind::non_manifold_vertex);
  EXPECT_EQ(defect.vertices, vertices({2}));
  EXPECT_EQ(defect.faces, faces({0, 1}));
  EXPECT_NE(refusal(mesh).find("vertex 2 joins 2 fans"), std::string::npos);
  EXPECT_NE(refusal(mesh).find("; --repair splits it"), std::string::npos);
}

TEST(Defects, FansJoinedByABadEdgeAreNoBowTie) {
  // the edge is the defect; its ends are not named a second time
  const Mesh mesh = make_mesh(5, {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}});
  EXPECT_EQ(kinds_of(mesh), Kinds{DefectKind::non_manifold_edge});
}

TEST(Defects, OneFaceTurned) {
  Mesh cube = make_mesh(
      8, {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {3, 7, 6, 2}, {0, 4, 6, 2}, {1, 3, 7, 5}});
  const Defect defect = only(cube, DefectKind::orientation);
  EXPECT_EQ(defect.faces, faces({3}));
  EXPECT_NE(defect.message.find("turning 1 of 6 faces"), std::string::npos) << defect.message;
  EXPECT_NE(refusal(cube).find("--repair turns them"), std::string::npos);
}

TEST(Defects, MoebiusStripHasOneSide) {
  // five quads around, the last glued with a twist
  const Mesh strip =
      make_mesh(10, {{0, 1, 3, 2}, {2, 3, 5, 4}, {4, 5, 7, 6}, {6, 7, 9, 8}, {8, 9, 0, 1}});
  EXPECT_EQ(kinds_of(strip), Kinds{DefectKind::non_orientable});
  EXPECT_EQ(refusal(strip).find("--repair"), std::string::npos);
}

TEST(Defects, FaceThatMeetsItselfInTheSameDirection) {
  const Mesh mesh = make_mesh(4, {{0, 1, 2, 0, 1, 3}});
  const Kinds kinds = kinds_of(mesh);
  EXPECT_EQ(kinds, (Kinds{DefectKind::repeated_corner, DefectKind::non_orientable}));
}

TEST(Defects, RepeatedCorner) {
  const Mesh keyhole = make_mesh(8, {{0, 1, 2, 3, 0, 4, 5, 6, 7, 4}});
  const Defect defect = only(keyhole, DefectKind::repeated_corner);
  EXPECT_EQ(defect.vertices, vertices({0}));
  EXPECT_NE(refusal(keyhole).find("face 0 has vertex 0 at two corners"), std::string::npos);
  // twice in a row
  EXPECT_EQ(only(make_mesh(3, {{0, 1, 1, 2}}), DefectKind::repeated_corner).vertices,
            vertices({1}));
}

TEST(Defects, ASideFromAVertexToItselfHasNoDirection) {
  const Mesh mesh = make_mesh(4, {{0, 0, 1, 2}, {1, 0, 0, 3}});
  EXPECT_EQ(kinds_of(mesh), (Kinds{DefectKind::repeated_corner, DefectKind::repeated_corner}));
  const Mesh thrice = make_mesh(7, {{0, 0, 1, 2}, {0, 0, 3, 4}, {0, 0, 5, 6}});
  EXPECT_EQ(kinds_of(thrice),
            (Kinds{DefectKind::repeated_corner, DefectKind::repeated_corner,
                   DefectKind::repeated_corner, DefectKind::non_manifold_vertex}));
}

TEST(Defects, InteriorVertexOfValenceOneIsARepeatedCorner) {
  // vertex 3 hangs on one edge inside the face: the smooth vertex rule has no meaning there
  const Mesh mesh = make_mesh(4, {{0, 1, 2, 3, 2}});
  EXPECT_EQ(only(mesh, DefectKind::repeated_corner).vertices, vertices({2}));
  EXPECT_NE(refusal(mesh), "");
}

TEST(Defects, SameFaceTwice) {
  const Mesh mesh = make_mesh(4, {{0, 1, 2, 3}, {2, 3, 0, 1}});
  const Defect defect = only(mesh, DefectKind::duplicate_face);
  EXPECT_EQ(defect.faces, faces({0, 1}));
  EXPECT_EQ(defect.message, "face 1 repeats face 0");
  EXPECT_NE(refusal(mesh).find("face 1 repeats face 0; --repair leaves one of them out"),
            std::string::npos);
}

TEST(Defects, PillowIsAValidSurface) {
  const Mesh pillow = make_mesh(3, {{0, 1, 2}, {2, 1, 0}});
  EXPECT_EQ(kinds_of(pillow), Kinds{DefectKind::opposite_faces});
  EXPECT_EQ(refusal(pillow), "");
}

TEST(Defects, DuplicatesAmongBothOrders) {
  const Mesh mesh = make_mesh(3, {{0, 2, 1}, {0, 1, 2}, {1, 0, 2}, {1, 2, 0}});
  EXPECT_EQ(only(mesh, DefectKind::opposite_faces).faces, faces({0, 1}));
  std::vector<std::vector<FaceId>> same;
  for (const Defect& d : find_defects(mesh))
    if (d.kind == DefectKind::duplicate_face) same.push_back(d.faces);
  EXPECT_EQ(same, (std::vector{faces({0, 2}), faces({1, 3})}));
}

TEST(Defects, FewCorners) {
  EXPECT_EQ(only(make_mesh(2, {{0, 1}}), DefectKind::few_corners).faces, faces({0}));
  EXPECT_NE(refusal(make_mesh(1, {{0}})), "");
}

TEST(Defects, UnusedVerticesInOneEntry) {
  Mesh mesh = make_mesh(13, {{0, 1, 2}});
  const Defect defect = only(mesh, DefectKind::unused_vertices);
  EXPECT_EQ(defect.vertices.size(), 10U);
  EXPECT_EQ(defect.message, "no face uses 10 of 13 vertices (3, 4, 5, 6, 7, 8, 9, 10 and 2 more)");
  EXPECT_EQ(refusal(mesh), "");
}

TEST(Defects, FacesWithoutArea) {
  Mesh mesh = make_mesh(4, {{0, 1, 2, 3}});
  // a bow-tie quad and three points on a line far from the origin
  mesh.points.vector() = {Vec3(0, 0, 0), Vec3(1, 1, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  EXPECT_EQ(only(mesh, DefectKind::zero_area).faces, faces({0}));
  Mesh line = make_mesh(3, {{0, 1, 2}});
  line.points.vector() = {Vec3(1e9, 0.1, 0.1), Vec3(1e9, 0.2, 0.2), Vec3(1e9, 0.3, 0.3)};
  EXPECT_EQ(kinds_of(line), Kinds{DefectKind::zero_area});
  EXPECT_EQ(refusal(line), "");
}

TEST(Defects, SmallOrDistantFacesHaveArea) {
  for (const double size : {1e-140, 1e-6, 1.0, 1e140}) {
    Mesh mesh = make_mesh(3, {{0, 1, 2}});
    mesh.points.vector() = {Vec3(0, 0, 0), Vec3(size, 0, 0), Vec3(0, size, 0)};
    EXPECT_EQ(kinds_of(mesh), Kinds{}) << size;
  }
  Mesh distant = make_mesh(3, {{0, 1, 2}});
  distant.points.vector() = {Vec3(1e9, 1e9, 1e9), Vec3(1e9 + 1, 1e9, 1e9), Vec3(1e9, 1e9 + 1, 1e9)};
  EXPECT_EQ(kinds_of(distant), Kinds{});
}

TEST(Defects, SquaresThatOverflowOrVanish) {
  Mesh huge = make_cube(), tiny = make_cube();
  for (Vec3& x : huge.points)
    x *= 1e300;
  for (Vec3& x : tiny.points)
    x *= 1e-200;
  EXPECT_EQ(kinds_of(huge), Kinds{DefectKind::coordinates});
  EXPECT_EQ(only(huge, DefectKind::coordinates).vertices.size(), 7U);  // all but the origin
  EXPECT_EQ(kinds_of(tiny), Kinds{DefectKind::coordinates});
  EXPECT_EQ(refusal(huge), "");
}

TEST(Defects, NotFinite) {
  Mesh mesh = make_cube();
  mesh.points[VertexId(3)][1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(kinds_of(mesh), Kinds{DefectKind::not_finite});
  EXPECT_NE(refusal(mesh), "");
}

TEST(Defects, AllInOnePoint) {
  Mesh mesh = make_cube();
  for (Vec3& x : mesh.points)
    x = Vec3(1, 2, 3);
  EXPECT_EQ(kinds_of(mesh), Kinds{DefectKind::one_point});
}

TEST(Defects, TagsOnWhatDoesNotExist) {
  const auto refused = [](const Tags& tags) {
    Mesh mesh = make_cube();
    mesh.tags = tags;
    return kinds_of(mesh) == Kinds{DefectKind::tag} && !refusal(mesh).empty();
  };
  Tags crease, far_crease, corner, hole, negative, nan;
  crease.creases = {{VertexId(0), VertexId(7), 2.0F}};
  far_crease.creases = {{VertexId(0), VertexId(8), 2.0F}};
  corner.corners = {{VertexId(8), 2.0F}};
  hole.holes = {FaceId(6)};
  negative.corners = {{VertexId(1), -1.0F}};
  nan.creases = {{VertexId(0), VertexId(1), std::nanf("")}};
  for (const Tags& tags : {crease, far_crease, corner, hole, negative, nan})
    EXPECT_TRUE(refused(tags));
  Tags fine;
  fine.creases = {{VertexId(1), VertexId(0), 2.0F}};
  fine.corners = {{VertexId(7), 10.0F}};
  fine.holes = {FaceId(5)};
  EXPECT_FALSE(refused(fine));
}

TEST(Defects, MissingVertexIsReportedAlone) {
  Mesh mesh = make_mesh(3, {{0, 1, 2}, {0, 1, 99}, {0, 1, 2}});
  EXPECT_EQ(kinds_of(mesh), Kinds{DefectKind::missing_vertex});
  EXPECT_EQ(only(mesh, DefectKind::missing_vertex).message,
            "face 1 names vertex 99; the mesh has vertices 0 to 2");
}

TEST(Defects, LongListsAreCut) {
  // 25 separate pairs of equal faces
  std::vector<int> offsets{0};
  std::vector<VertexId> corners;
  for (int pair = 0; pair < 25; ++pair)
    for (int k = 0; k < 6; ++k) {
      corners.emplace_back(3 * pair + k % 3);
      if (k % 3 == 2) offsets.push_back(static_cast<int>(corners.size()));
    }
  Mesh mesh = make_mesh(75, {{0, 1, 2}});
  mesh.topology = Topology(75, offsets, corners);
  std::vector<Defect> same;
  for (Defect& d : find_defects(mesh))
    if (d.kind == DefectKind::duplicate_face) same.push_back(std::move(d));
  ASSERT_EQ(same.size(), 11U);
  EXPECT_EQ(same.back().message, "15 more of this kind: duplicate-face");
  EXPECT_TRUE(same.back().faces.empty());
}

TEST(Defects, EveryKindHasItsOwnName) {
  for (int a = 0; a <= static_cast<int>(DefectKind::unused_vertices); ++a)
    for (int b = 0; b < a; ++b)
      EXPECT_NE(name_of(static_cast<DefectKind>(a)), name_of(static_cast<DefectKind>(b)));
  EXPECT_EQ(name_of(DefectKind::missing_vertex), "missing-vertex");
  EXPECT_EQ(name_of(DefectKind::tag), "tag");
  EXPECT_EQ(name_of(DefectKind::opposite_faces), "opposite-faces");
  EXPECT_EQ(name_of(DefectKind::unused_vertices), "unused-vertices");
}

}  // namespace
}  // namespace limes
