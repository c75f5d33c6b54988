#pragma once

#include <map>
#include <utility>
#include <vector>

#include "limes/subdiv/crease.h"

namespace limes {

/// The rules of lines of sharp edges through the steps of a refinement, made once for each sharpness
/// that occurs. Rules: LineRules or TriangleLineRules.
template <class Rules>
class SharpLines {
 public:
  using Line = std::vector<Rules>;  ///< by step; none where no longer sharp

  /// The line of a sharpness, or null if that is smooth. Stays where it is.
  /// @param make  (sharpness, boundary) -> Rules of one step
  template <class Make>
  [[nodiscard]] const Line* find(float sharpness, bool boundary, int depth, const Make& make) {
    if (!is_sharp(sharpness)) return nullptr;
    const auto [at, is_new] = lines_.try_emplace({sharpness, boundary});
    Line& line = at->second;
    if (!is_new) return &line;
    for (float s = sharpness; is_sharp(s) && static_cast<int>(line.size()) < depth; s = decayed(s))
      line.push_back(make(s, boundary));
    return &line;
  }

 private:
  std::map<std::pair<float, bool>, Line> lines_;  // by sharpness and whether on the boundary
};

}  // namespace limes
