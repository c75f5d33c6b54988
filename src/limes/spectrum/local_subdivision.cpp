#include "limes/spectrum/local_subdivision.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "limes/core/error.h"

namespace limes {
namespace {

/// Rings at the rim of a star whose rules the boundary may change, and that a period may lack.
constexpr int rim = 4;

/// The star after a period and the matrix that leads there.
StarStep refine_period(const Star& star, const Scheme& scheme) {
  StarStep all = refine_star(star, scheme);
  for (int step = 1; step < steps_per_period(scheme); ++step) {
    StarStep next = refine_star(all.child, scheme);
    all = {std::move(next.child), next.matrix * all.matrix};
  }
  return all;
}

/// The rows of the child's vertices at the places of the star, columns in the order of the places.
SparseMatrix at_places(const SparseMatrix& S, const std::vector<VertexId>& vertices,
                       const IdArray<VertexId, VertexId>& child) {
  std::vector<int> place(static_cast<std::size_t>(S.cols()), -1);
  for (std::size_t p = 0; p < vertices.size(); ++p)
    place[static_cast<std::size_t>(vertices[p].value)] = static_cast<int>(p);
  std::vector<Triplet> entries;
  for (std::size_t p = 0; p < vertices.size(); ++p) {
    LIMES_ASSERT(child[vertices[p]].valid());
    for (SparseMatrix::InnerIterator entry(S, child[vertices[p]].value); entry; ++entry) {
      const int column = place[static_cast<std::size_t>(entry.col())];
      LIMES_ASSERT(column >= 0);
      if (entry.value() != 0) entries.emplace_back(static_cast<int>(p), column, entry.value());
    }
  }
  const auto size = static_cast<int>(vertices.size());
  SparseMatrix result(size, size);
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

}  // namespace

LocalSubdivision::LocalSubdivision(const Scheme& scheme, int valence, const RuleOptions& options,
                                   int rings)
    : star_(control_star(scheme, valence, rings + rim, options)),
      walk_(star_),
      num_steps_(steps_per_period(scheme)) {
  sort_places(rings);
  const StarStep period = refine_period(star_, scheme);
  const StarWalk child(period.child);
  matrix_ =
      at_places(period.matrix, vertices_, walk_.same_walks(child, child.first_spoke(), rings));
  num_invariant_rings_ = find_invariant_rings(rings);
}

void LocalSubdivision::sort_places(int rings) {
  // One sector by angle, the others by walking the same ways from the next spoke.
  const auto next = walk_.same_walks(walk_, walk_.second_spoke(), rings);
  const double sector = 2 * std::numbers::pi / star_.sectors;
  struct Spot {
    int ring;
    double angle, distance;
    VertexId vertex;
  };
  std::vector<Spot> spots;
  for (int v = 0; v < star_.topology.num_vertices(); ++v) {
    const Vec3& x = star_.points[static_cast<std::size_t>(v)];
    const double turned = std::atan2(x.y(), x.x()) - star_.first_angle + 1e-9;
    const double angle =
        turned - 2 * std::numbers::pi * std::floor(turned / (2 * std::numbers::pi));
    const int ring = walk_.ring(VertexId(v));
    if (ring <= rings && (angle < sector || next[VertexId(v)] == VertexId(v)))
      spots.push_back({ring, angle, x.norm(), VertexId(v)});
  }
  std::sort(spots.begin(), spots.end(), [](const Spot& a, const Spot& b) {
    if (a.ring != b.ring) return a.ring < b.ring;
    if (std::abs(a.angle - b.angle) > 1e-9) return a.angle < b.angle;
    return a.distance < b.distance;
  });
  int ring = -1, place = 0;
  for (const Spot& spot : spots) {
    place = spot.ring == ring ? place + 1 : 0;
    ring = spot.ring;
    VertexId v = spot.vertex;
    for (int s = 0; s < star_.sectors && (s == 0 || v != spot.vertex); ++s, v = next[v]) {
      places_.push_back({ring, place, s});
      vertices_.push_back(v);
    }
    LIMES_ASSERT(v == spot.vertex);
  }
}

int LocalSubdivision::first_place(int ring) const {
  const auto at = std::lower_bound(places_.begin(), places_.end(), StarPlace{ring, 0, 0});
  return static_cast<int>(at - places_.begin());
}

int LocalSubdivision::find_invariant_rings(int rings) const {
  // needs[r]: the outermost ring that ring r after the period depends on.
  std::vector<int> needs(static_cast<std::size_t>(rings) + 1, 0);
  for (int row = 0; row < matrix_.rows(); ++row) {
    int& need = needs[static_cast<std::size_t>(places_[static_cast<std::size_t>(row)].ring)];
    for (SparseMatrix::InnerIterator entry(matrix_, row); entry; ++entry)
      need = std::max(need, places_[static_cast<std::size_t>(entry.col())].ring);
  }
  int invariant = 0;
  for (int r = 0; r <= rings; ++r)
    if (needs[static_cast<std::size_t>(r)] >= r)
      invariant = std::max(r, needs[static_cast<std::size_t>(r)]);
  LIMES_ASSERT(invariant + rim < rings);
  return invariant;
}

Eigen::VectorXcd LocalSubdivision::extended(const Eigen::VectorXcd& invariant,
                                            std::complex<double> eigenvalue) const {
  LIMES_ASSERT(invariant.size() == num_invariant_places());
  Eigen::VectorXcd all = Eigen::VectorXcd::Zero(matrix_.rows());
  all.head(invariant.size()) = invariant;
  for (int row = num_invariant_places(); row < matrix_.rows(); ++row) {
    std::complex<double> sum = 0;
    for (SparseMatrix::InnerIterator entry(matrix_, row); entry; ++entry)
      sum += entry.value() * all[entry.col()];
    all[row] = sum / eigenvalue;
  }
  return all;
}

}  // namespace limes
