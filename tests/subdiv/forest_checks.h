#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <utility>
#include <vector>

#include "limes/mesh/adjacency.h"
#include "limes/mesh/measure.h"
#include "limes/subdiv/forest_mesh.h"

namespace limes {

// What holds for every forest, whatever its faces.

inline FaceId leaf_at(const Forest& forest, const FaceAncestry& place) {
  for (const FaceId f : forest.leaves())
    if (forest.ancestry(f) == place) return f;
  ADD_FAILURE() << "no leaf at root " << place.root.value << " path " << place.path;
  return {};
}

inline bool by_coordinates(const Vec3& a, const Vec3& b) {
  return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
}

/// Every leaf's corners have the bits of uniform refinement.
inline void expect_uniform_positions(const Forest& forest, const std::vector<Mesh>& uniform) {
  for (const FaceId f : forest.leaves()) {
    const FaceAncestry a = forest.ancestry(f);
    const Mesh& level = uniform[static_cast<std::size_t>(a.level)];
    const std::int64_t number = (std::int64_t{a.root.value} << (2 * a.level)) + a.path;
    const auto corners = level.topology.face(FaceId(number));
    for (std::size_t i = 0; i < corners.size(); ++i)
      ASSERT_EQ(forest.nodes().position(forest.corners(f)[i]), level.points[corners[i]])
          << "level " << a.level << " face " << number << " corner " << i;
  }
}

inline std::vector<Mesh> uniform_levels(const Mesh& control, const Scheme& scheme, int levels) {
  std::vector<Mesh> all;
  for (int k = 0; k <= levels; ++k)
    all.push_back(refine(control, scheme, {.levels = k}));
  return all;
}

inline void expect_balanced(const Forest& forest) {
  std::map<int, std::pair<int, int>> levels;  // of the leaves at each vertex
  const std::vector<FaceId> leaves = forest.leaves();
  for (const FaceId f : leaves)
    for (const VertexId v : forest.corners(f)) {
      const int level = forest.ancestry(f).level;
      const auto [at, is_new] = levels.try_emplace(v.value, level, level);
      at->second.first = std::min(at->second.first, level);
      at->second.second = std::max(at->second.second, level);
    }
  for (const auto& [v, range] : levels)
    EXPECT_LE(range.second - range.first, 1) << "vertex " << v;
}

/// A surface of the same kind as the control mesh: every edge joins two faces or lies on a boundary
/// that the control mesh has as well.
inline void expect_conforming(const Mesh& mesh, const Mesh& control) {
  EXPECT_NO_THROW(Adjacency(mesh.topology));
  const MeshMeasure now = measure(mesh), before = measure(control);
  EXPECT_EQ(now.euler, before.euler);
  EXPECT_EQ(now.boundary_loops, before.boundary_loops);
  EXPECT_EQ(now.components, before.components);
}

/// Positions of the closure's vertices too: each is one of uniform refinement, one level finer.
inline void expect_positions_among(const Mesh& mesh, std::vector<Vec3> finest) {
  std::sort(finest.begin(), finest.end(), by_coordinates);
  for (const Vec3& x : mesh.points)
    EXPECT_TRUE(std::binary_search(finest.begin(), finest.end(), x, by_coordinates))
        << x.transpose();
}

struct Model {
  const char* name;
  Mesh mesh;
};

inline Mesh shaken(Mesh mesh) {
  std::mt19937 random(7);
  for (Vec3& x : mesh.points)
    for (int axis = 0; axis < 3; ++axis)
      x[axis] += 0.05 * (static_cast<double>(random() % 1000) / 1000.0 - 0.5);
  return mesh;
}

inline std::vector<FaceId> some_leaves(const Forest& forest, std::mt19937& random, unsigned one_in,
                                       int finest) {
  std::vector<FaceId> chosen;
  for (const FaceId f : forest.leaves())
    if (random() % one_in == 0 && forest.ancestry(f).level < finest) chosen.push_back(f);
  return chosen;
}

inline std::vector<FaceId> all_but_some(const Forest& forest, std::mt19937& random,
                                        unsigned one_in) {
  std::vector<FaceId> chosen;
  for (const FaceId f : forest.leaves())
    if (one_in == 1 || random() % one_in != 0) chosen.push_back(f);
  return chosen;
}

}  // namespace limes
