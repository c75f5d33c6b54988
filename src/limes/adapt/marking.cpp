#include "limes/adapt/marking.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace limes {
namespace {

/// Below a sum or product by more than its rounding.
constexpr double hardly_less = 1 - 1e-12;

/// How many of the errors, the largest first, are marked.
std::size_t count(const std::vector<double>& descending, MarkingKind kind, double share) {
  switch (kind) {
    case MarkingKind::doerfler: {
      const double wanted =
          share * std::accumulate(descending.begin(), descending.end(), 0.0) * hardly_less;
      std::size_t n = 0;
      for (double sum = 0; n < descending.size() && sum < wanted; ++n)
        sum += descending[n];
      return n;
    }
    case MarkingKind::maximum: {
      const double least = share * share * descending.front() * hardly_less;
      return static_cast<std::size_t>(std::count_if(descending.begin(), descending.end(),
                                                    [&](double x) { return x >= least; }));
    }
    case MarkingKind::fraction:
      return static_cast<std::size_t>(
          std::ceil(share * static_cast<double>(descending.size()) * hardly_less));
  }
  return 0;
}

}  // namespace

std::vector<int> marked(std::span<const double> squares, MarkingKind kind, double share) {
  std::vector<int> order(squares.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
    return squares[static_cast<std::size_t>(a)] > squares[static_cast<std::size_t>(b)];
  });
  std::vector<double> descending;
  for (const int i : order)
    descending.push_back(squares[static_cast<std::size_t>(i)]);
  if (descending.empty() || !(descending.front() > 0)) return {};
  order.resize(std::min(order.size(), count(descending, kind, share)));
  std::sort(order.begin(), order.end());
  return order;
}

}  // namespace limes
