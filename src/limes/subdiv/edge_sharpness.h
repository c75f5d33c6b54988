#pragma once

#include <algorithm>
#include <cstdint>
#include <unordered_map>

#include "limes/core/ids.h"

namespace limes {

/// Sharpness of edges, which are named by their ends in any order. Those never set have 0.
class EdgeSharpness {
 public:
  void set(VertexId a, VertexId b, float sharpness) { by_ends_[key(a, b)] = sharpness; }
  [[nodiscard]] float of(VertexId a, VertexId b) const {
    const auto at = by_ends_.find(key(a, b));
    return at == by_ends_.end() ? 0.0F : at->second;
  }
  [[nodiscard]] bool empty() const { return by_ends_.empty(); }

 private:
  static std::uint64_t key(VertexId a, VertexId b) {
    const auto [low, high] = std::minmax(a.value, b.value);
    return (static_cast<std::uint64_t>(low) << 32) | static_cast<std::uint64_t>(high);
  }

  std::unordered_map<std::uint64_t, float> by_ends_;
};

}  // namespace limes
