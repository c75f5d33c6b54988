#include "limes/limit/box_tree.h"

#include <numeric>

namespace limes {

/// Splits a list of items until every part is one.
struct BoxTree::Builder {
  using Range = std::span<std::int32_t>;

  Builder(std::span<const Bounds> all, std::vector<Node>& out) : boxes(all), nodes(out) {}

  std::span<const Bounds> boxes;
  std::vector<Node>& nodes;

  [[nodiscard]] const Bounds& box(std::int32_t item) const {
    return boxes[static_cast<std::size_t>(item)];
  }
  [[nodiscard]] Vec3 centre(std::int32_t item) const {
    return 0.5 * box(item).lower + 0.5 * box(item).upper;
  }

  /// Moves the half with the smaller centres to the front; equal centres by number.
  [[nodiscard]] std::array<Range, 2> halve(Range items) const {
    if (items.size() < 2) return {items, Range()};
    Bounds spread;
    for (const std::int32_t i : items) {
      spread.lower = spread.lower.cwiseMin(centre(i));
      spread.upper = spread.upper.cwiseMax(centre(i));
    }
    int axis = 0;
    (spread.upper - spread.lower).maxCoeff(&axis);
    const auto before = [&](std::int32_t a, std::int32_t b) {
      const double ca = box(a).lower[axis] + box(a).upper[axis];
      const double cb = box(b).lower[axis] + box(b).upper[axis];
      return ca < cb || (ca == cb && a < b);
    };
    const std::size_t half = (items.size() + 1) / 2;
    std::nth_element(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(half), items.end(),
                     before);
    return {items.first(half), items.subspan(half)};
  }

  [[nodiscard]] Bounds around(Range items) const {
    Bounds all;
    for (const std::int32_t i : items) {
      all.lower = all.lower.cwiseMin(box(i).lower);
      all.upper = all.upper.cwiseMax(box(i).upper);
    }
    return all;
  }

  std::int32_t build(Range items) {
    const auto index = static_cast<std::int32_t>(nodes.size());
    nodes.push_back({});
    std::size_t k = 0;
    for (const Range half : halve(items)) {
      for (const Range part : halve(half)) {
        if (part.empty()) continue;
        const Bounds bounds = around(part);
        const std::int32_t child = part.size() > 1 ? build(part) : ~part[0];
        Node& node = nodes[static_cast<std::size_t>(index)];
        for (std::size_t axis = 0; axis < 3; ++axis) {
          node.boxes.lower[axis][k] = bounds.lower[static_cast<Eigen::Index>(axis)];
          node.boxes.upper[axis][k] = bounds.upper[static_cast<Eigen::Index>(axis)];
        }
        node.child[k++] = child;
      }
    }
    return index;
  }
};

BoxTree::BoxTree(std::span<const Bounds> boxes) {
  std::vector<std::int32_t> items(boxes.size());
  std::iota(items.begin(), items.end(), 0);
  if (!items.empty()) Builder(boxes, nodes_).build(items);
}

}  // namespace limes
