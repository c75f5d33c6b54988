#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "limes/core/error.h"
#include "limes/mesh/measure.h"

namespace limes {

/// A bounding-volume hierarchy over boxes, four children a node, balanced: the items of a node are
/// halved at the median of their centres along the longest axis, and halved again.
class BoxTree {
 public:
  /// Four boxes side by side: lower[axis][k], upper[axis][k] for box k.
  struct Boxes4 {
    std::array<std::array<double, 4>, 3> lower, upper;
  };

  BoxTree() = default;
  explicit BoxTree(std::span<const Bounds> boxes);

  /// Calls visit(item) for the items whose bounds are at most limit(), the smallest bound first
  /// among the children of each node.
  /// @param bounds  maps Boxes4 to four lower bounds, NaN for a box to leave out
  /// @param limit   the largest bound of interest at this time; may shrink
  template <class BoundsOf, class Limit, class Visit>
  void traverse(const BoundsOf& bounds, const Limit& limit, const Visit& visit) const;

 private:
  struct Node {
    Boxes4 boxes;
    std::array<std::int32_t, 4> child{none, none, none, none};  ///< node, or ~item
  };
  static constexpr std::int32_t none = std::numeric_limits<std::int32_t>::min();
  struct Entry {
    double bound;
    std::int32_t child;
  };
  struct Builder;

  /// Three children wait at each level above the one in work; 2^31 items have 16 levels.
  static constexpr std::size_t max_stack = 64;

  std::vector<Node> nodes_;
};

template <class BoundsOf, class Limit, class Visit>
void BoxTree::traverse(const BoundsOf& bounds, const Limit& limit, const Visit& visit) const {
  if (nodes_.empty()) return;
  std::array<Entry, max_stack> stack;
  std::size_t size = 0;
  stack[size++] = {-std::numeric_limits<double>::infinity(), 0};
  while (size > 0) {
    const Entry top = stack[--size];
    if (!(top.bound <= limit())) continue;
    if (top.child < 0) {
      visit(~top.child);
      continue;
    }
    const Node& node = nodes_[static_cast<std::size_t>(top.child)];
    const std::array<double, 4> lower = bounds(node.boxes);
    const double largest = limit();
    const std::size_t first = size;
    LIMES_ASSERT(size + 4 <= max_stack);
    for (std::size_t k = 0; k < 4; ++k) {
      if (node.child[k] == none || !(lower[k] <= largest)) continue;
      std::size_t at = size++;  // insert, the smallest last
      for (; at > first && stack[at - 1].bound < lower[k]; --at)
        stack[at] = stack[at - 1];
      stack[at] = {lower[k], node.child[k]};
    }
  }
}

}  // namespace limes
