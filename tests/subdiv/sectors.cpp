#include "subdiv/sectors.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>

#include "limes/subdiv/edge_choice.h"

namespace limes {
namespace {

std::vector<Vec2> with_middles(const Adjacency& mesh, const Bisection& step,
                               std::vector<Vec2> places) {
  places.resize(static_cast<std::size_t>(step.child.num_vertices()));
  for (int e = 0; e < mesh.num_edges(); ++e) {
    const VertexId middle = step.middle[EdgeId(e)];
    const HalfedgeId h = mesh.halfedge(EdgeId(e));
    if (middle.valid())
      places[static_cast<std::size_t>(middle.value)] =
          0.5 * (places[static_cast<std::size_t>(mesh.from(h).value)] +
                 places[static_cast<std::size_t>(mesh.to(h).value)]);
  }
  return places;
}

std::pair<long, long> key(const Vec2& x) {
  return {std::lround(x.x() * 1e6), std::lround(x.y() * 1e6)};
}

}  // namespace

Sectors::Sectors(int n, int size) {
  const auto direction = [&](int s) {
    const double a = 2 * std::numbers::pi * s / n;
    return Vec2(std::cos(a), std::sin(a));
  };
  const auto add = [&](const Vec2& place, double ring) {
    coarse_places_.push_back(place);
    ring_.push_back(ring);
    return VertexId(static_cast<std::int64_t>(coarse_places_.size()) - 1);
  };
  add(Vec2::Zero(), 0);
  // Sector s has the vertices i along its first side, i >= 1, and j along its second, j >= 0.
  const auto corner = [&](int s, int i, int j) {
    if (i == 0 && j == 0) return VertexId(0);
    if (i == 0) {  // on the first side of the next sector
      i = j;
      j = 0;
      s = (s + 1) % n;
    }
    return VertexId(1 + (s * size + i - 1) * (size + 1) + j);
  };
  for (int s = 0; s < n; ++s)
    for (int i = 1; i <= size; ++i)
      for (int j = 0; j <= size; ++j)
        add(i * direction(s) + j * direction(s + 1), std::max(i, j));
  std::vector<VertexId> corners;
  for (int s = 0; s < n; ++s)
    for (int i = 0; i < size; ++i)
      for (int j = 0; j < size; ++j) {
        const VertexId centre =
            add((i + 0.5) * direction(s) + (j + 0.5) * direction(s + 1), std::max(i, j) + 0.5);
        const std::array<VertexId, 4> quad{corner(s, i, j), corner(s, i + 1, j),
                                           corner(s, i + 1, j + 1), corner(s, i, j + 1)};
        for (std::size_t k = 0; k < 4; ++k)
          corners.insert(corners.end(), {centre, quad[k], quad[(k + 1) % 4]});
      }
  coarse_ = Topology(static_cast<int>(coarse_places_.size()), 3, std::move(corners));

  const Adjacency coarse(coarse_);
  first_ = bisect(coarse, newest_vertex_edges(coarse), FirstCorner::newest);
  const std::vector<Vec2> between = with_middles(coarse, first_, coarse_places_);
  const Adjacency middle(first_.child);
  second_ = bisect(middle, newest_vertex_edges(middle), FirstCorner::newest);
  fine_places_ = with_middles(middle, second_, between);
}

std::vector<int> Sectors::inner_coarse(int rings) const {
  std::vector<int> inner;
  for (std::size_t v = 0; v < ring_.size(); ++v)
    if (ring_[v] <= rings) inner.push_back(static_cast<int>(v));
  return inner;
}

std::vector<int> Sectors::inner_fine(const std::vector<int>& coarse) const {
  std::map<std::pair<long, long>, int> at;
  for (std::size_t v = 0; v < fine_places_.size(); ++v)
    at[key(2 * fine_places_[v])] = static_cast<int>(v);
  std::vector<int> fine;
  for (const int v : coarse)
    fine.push_back(at.at(key(coarse_places_[static_cast<std::size_t>(v)])));
  return fine;
}

void Sectors::store_column(int vertex, int component, const std::vector<Vec3>& response,
                           const std::vector<int>& coarse, const std::vector<int>& fine,
                           MatrixX& result) {
  const auto column = std::find(coarse.begin(), coarse.end(), vertex);
  for (std::size_t i = 0; i < fine.size(); ++i) {
    const double weight = response[static_cast<std::size_t>(fine[i])][component];
    if (column != coarse.end())
      result(static_cast<Eigen::Index>(i), column - coarse.begin()) = weight;
    else
      EXPECT_EQ(weight, 0) << "the rule reaches out of the rings";
  }
}

std::vector<double> eigenvalues(const MatrixX& matrix) {
  const Eigen::EigenSolver<MatrixX> solver(matrix, false);
  std::vector<double> values;
  for (const auto& lambda : solver.eigenvalues())
    values.push_back(std::abs(lambda));
  std::sort(values.begin(), values.end(), std::greater<>());
  return values;
}

}  // namespace limes
