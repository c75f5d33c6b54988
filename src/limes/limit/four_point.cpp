#include "limes/limit/four_point.h"

#include <array>
#include <vector>

#include "limes/core/error.h"

namespace limes {
namespace {

/// A point nearer to an end of the span than 2^-200 is that end.
constexpr std::size_t max_depth = 200;

/// Which half of the span, of that half, ... holds t until t is the start (or the end) of what is
/// left.
struct Path {
  std::vector<int> halves;
  bool at_end = false;
};

Path path_to(double t) {
  LIMES_ASSERT(0.0 <= t && t <= 1.0);
  Path path;
  while (t != 0.0 && t != 1.0 && path.halves.size() < max_depth) {
    const int half = t < 0.5 ? 0 : 1;
    path.halves.push_back(half);
    t = 2.0 * t - half;  // exact
  }
  path.at_end = t == 1.0 || (path.halves.size() == max_depth && t >= 0.5);
  return path;
}

/// Takes row back from the points (or differences) of a half to those of the whole.
template <int n, class ChildRow>
Eigen::Matrix<double, 1, n> pull_back(Eigen::Matrix<double, 1, n> row,
                                      const std::vector<int>& halves, const ChildRow& child_row) {
  std::array<Eigen::Matrix<double, n, n>, 2> A;
  for (int half = 0; half < 2; ++half)
    for (int i = 0; i < n; ++i)
      A[static_cast<std::size_t>(half)].row(i) = child_row(i - 2 + half);
  for (auto it = halves.rbegin(); it != halves.rend(); ++it)
    row = row * A[static_cast<std::size_t>(*it)];
  return row;
}

}  // namespace

SixWeights four_point_value(double t, double omega) {
  const Path path = path_to(t);
  // Point j of the next level, counted in halves of the span from its start.
  const auto child_row = [&](int j) {
    SixWeights row = SixWeights::Zero();
    const int i = (j + 4) / 2;  // index in the row of the point at j or before
    if (j % 2 == 0) {
      row(i) = 1.0;
    } else {
      row(i) = row(i + 1) = 0.5 + omega;
      row(i - 1) = row(i + 2) = -omega;
    }
    return row;
  };
  SixWeights row = SixWeights::Zero();
  row(path.at_end ? 3 : 2) = 1.0;
  return pull_back<6>(row, path.halves, child_row);
}

SixWeights four_point_derivative(double t, double omega) {
  const Path path = path_to(t);
  // Differences d_i = f_{i+1} - f_i, times two from level to level, follow
  //   d_{2i} = d_i + 2 omega (d_{i-1} - d_{i+1}),  d_{2i+1} = d_i - 2 omega (d_{i-1} - d_{i+1}):
  // rows that do not shrink, so that digits keep their weight however long the path is.
  using FiveWeights = Eigen::Matrix<double, 1, 5>;
  const auto child_row = [&](int j) {
    FiveWeights row = FiveWeights::Zero();
    const int i = (j + 4) / 2;
    const double outer = (j % 2 == 0 ? 2.0 : -2.0) * omega;
    row(i) = 1.0;
    row(i - 1) = outer;
    row(i + 1) = -outer;
    return row;
  };
  // At a point: (f_1 - f_{-1} - 2 omega (f_2 - f_{-2})) / (2 - 8 omega).
  FiveWeights row = FiveWeights::Zero();
  const double scale = 1.0 / (2.0 - 8.0 * omega);
  const int at = path.at_end ? 1 : 0;  // d_{-2 + at} ... d_{1 + at} around the point
  row(at) = row(at + 3) = -2.0 * omega * scale;
  row(at + 1) = row(at + 2) = (1.0 - 2.0 * omega) * scale;
  row = pull_back<5>(row, path.halves, child_row);

  SixWeights weights = SixWeights::Zero();
  for (int i = 0; i < 5; ++i) {
    weights(i) -= row(i);
    weights(i + 1) += row(i);
  }
  return weights;
}

}  // namespace limes
