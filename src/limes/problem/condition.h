#pragma once

#include <span>
#include <string>
#include <string_view>

#include "limes/core/types.h"
#include "limes/problem/expression.h"

namespace limes {

/// A `where` that is a condition in x, y, z, and the tolerance of its ==.
class Condition {
 public:
  /// @param diagonal  of the bounding box of what it is tested on; == means within 1e-9 of it
  /// @throws InputError if the text is no formula
  Condition(std::string_view text, double diagonal);

  /// @throws InputError where it is neither true nor false, without the place in a file
  [[nodiscard]] bool operator()(const Vec3& x) const;

 private:
  Expression formula_;
};

/// "the mesh has x from 0 to 1, y from ..."
[[nodiscard]] std::string describe_extent(const Vec3& low, const Vec3& high);

}  // namespace limes
