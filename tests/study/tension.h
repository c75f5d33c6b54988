#pragma once

#include <string>

namespace limes::testing {

/// Everything but mesh and material of a plate between x = 0 and x = `end`, pulled at `end` with a
/// force per length; held at x = 0, and in y at the origin. Probe "end" at (end, 1).
inline std::string tension(const std::string& end, const std::string& force) {
  return R"(
[model]
kind = "plane-stress"
[[support]]
where = "x == 0"
fix = ["ux"]
[[support]]
where = "x == 0 and y == 0"
fix = ["uy"]
[[load]]
where = "x == )" +
         end + R"("
force_per_length = [)" +
         force + R"(, 0]
[[probe]]
name = "end"
at = [)" +
         end + ", 1, 0]\n";
}

}  // namespace limes::testing
