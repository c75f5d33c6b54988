#include "limes/adapt/recovery.h"

#include <gtest/gtest.h>

#include <set>

#include "convergence/plane_meshes.h"

namespace limes {
namespace {

const JoinsFaces all = [](HalfedgeId) { return true; };

Mesh squares(int m, int n) {
  return testing::grid(m, n, [&](const Vec2& p) { return Vec2(m * p.x(), n * p.y()); });
}

TEST(Recovery, EveryCornerIsInOnePatchAtItsVertex) {
  const Mesh mesh = testing::regular_polygon(5);
  const Adjacency adjacency(mesh.topology);
  for (const JoinsFaces& joined : {all, JoinsFaces([](HalfedgeId) { return false; })}) {
    std::set<HalfedgeId> seen;
    for (const RecoveryPatch& patch : recovery_patches(adjacency, joined))
      for (const HalfedgeId h : patch.corners) {
        EXPECT_TRUE(seen.insert(h).second);
        EXPECT_EQ(adjacency.from(h), patch.vertex);
      }
    EXPECT_EQ(static_cast<int>(seen.size()), mesh.topology.num_corners());
  }
}

// On 4 x 3 squares: 4 faces around an inner vertex; beside a border the two there and their joined
// neighbours, which are two beside it, and one beyond or two.
TEST(Recovery, PatchesGrowWhereFewFacesMeet) {
  const Mesh mesh = squares(4, 3);
  const Adjacency adjacency(mesh.topology);
  const auto patches = recovery_patches(adjacency, all);
  ASSERT_EQ(patches.size(), 20U);
  for (const RecoveryPatch& patch : patches) {
    const Vec3& x = mesh.points[patch.vertex];
    const bool side = x.x() == 0 || x.x() == 4, end = x.y() == 0 || x.y() == 3;
    EXPECT_EQ(patch.corners.size(), side && end ? 1U : side || end ? 2U : 4U);
    EXPECT_GE(patch.faces.size(), 3U);
    for (std::size_t i = 0; i < patch.corners.size(); ++i)
      EXPECT_EQ(patch.faces[i], adjacency.face(patch.corners[i]));
  }
}

// Between the columns x < 2 and x > 2 nothing is joined: a vertex on the line has a patch on each
// side, and no patch has faces of both.
TEST(Recovery, PatchesEndWhereFacesAreNotJoined) {
  const Mesh mesh = squares(4, 3);
  const Adjacency adjacency(mesh.topology);
  const auto right = [&](FaceId f) {
    return mesh.points[mesh.topology.face(f)[0]].x() >= 2;  // its lower left corner
  };
  const auto patches = recovery_patches(adjacency, [&](HalfedgeId h) {
    return right(adjacency.face(h)) == right(adjacency.face(adjacency.twin(h)));
  });
  EXPECT_EQ(patches.size(), 24U);
  for (const RecoveryPatch& patch : patches) {
    for (const FaceId f : patch.faces)
      EXPECT_EQ(right(f), right(patch.faces[0]));
    EXPECT_GE(patch.faces.size(), 3U);
  }
}

// On 4 x 3 squares the vertex (0, 1) takes its values from (1, 1) and (1, 2) and (1, 0) if that is
// inner: a border's vertices take none from each other, and a corner takes them from the only inner
// vertex of its face.
TEST(Recovery, BordersAreRecoveredFromInside) {
  const Mesh mesh = squares(4, 3);
  const Adjacency adjacency(mesh.topology);
  const auto patches = recovery_patches(adjacency, all);
  const auto sources = recovering_patches(adjacency, patches);
  ASSERT_EQ(sources.size(), patches.size());
  const auto points_of = [&](const Vec3& x) {
    std::set<std::pair<double, double>> out;
    for (std::size_t i = 0; i < patches.size(); ++i)
      if (mesh.points[patches[i].vertex] == x)
        for (const int k : sources[i]) {
          const Vec3& at = mesh.points[patches[static_cast<std::size_t>(k)].vertex];
          out.emplace(at.x(), at.y());
        }
    return out;
  };
  using Points = std::set<std::pair<double, double>>;
  EXPECT_EQ(points_of(Vec3(0, 0, 0)), (Points{{1, 1}}));
  EXPECT_EQ(points_of(Vec3(0, 1, 0)), (Points{{1, 1}, {1, 2}}));
  EXPECT_EQ(points_of(Vec3(2, 0, 0)), (Points{{1, 1}, {2, 1}, {3, 1}}));
  EXPECT_EQ(points_of(Vec3(2, 1, 0)), (Points{{2, 1}}));

  const Mesh strip = squares(3, 1);  // no inner vertex
  const Adjacency of_strip(strip.topology);
  const auto own = recovering_patches(of_strip, recovery_patches(of_strip, all));
  for (std::size_t i = 0; i < own.size(); ++i)
    EXPECT_EQ(own[i], (std::vector<int>{static_cast<int>(i)}));
}

TEST(Recovery, AFitOfALinearFunctionIsExact) {
  Eigen::Matrix<double, Eigen::Dynamic, 2> at(5, 2);
  at << 0.1, 0.2, -0.3, 0.1, 0.5, -0.4, -0.2, -0.6, 0.7, 0.3;
  for (const double scale : {1.0, 1e-9, 1e9}) {
    MatrixX values(5, 2);
    values.col(0) = (3 + 2 * at.col(0).array() - at.col(1).array()).matrix();
    values.col(1) = (-1 + 5 * at.col(1).array()).matrix();
    const VectorX origin = linear_fit(scale * at, values).at(Vec2::Zero());
    EXPECT_NEAR(origin(0), 3, 1e-13);
    EXPECT_NEAR(origin(1), -1, 1e-13);
  }
}

TEST(Recovery, PlacesOnALineGiveALinearFunctionAlongIt) {
  Eigen::Matrix<double, Eigen::Dynamic, 2> at(3, 2);
  at << 1, 0, 2, 0, 3, 0;
  const MatrixX values = (4 - at.col(0).array()).matrix();
  EXPECT_NEAR(linear_fit(at, values).at(Vec2::Zero())(0), 4, 1e-13);
  EXPECT_EQ(linear_fit(at.topRows(1), values.topRows(1)).at(Vec2::Zero())(0), 3);
}

}  // namespace
}  // namespace limes
