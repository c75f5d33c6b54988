#include "limes/problem/condition.h"

#include <fmt/format.h>

#include <cmath>

#include "limes/core/error.h"
#include "limes/core/text.h"

namespace limes {
namespace {
constexpr double relative_tolerance = 1e-9;
}  // namespace

Condition::Condition(std::string_view text, double diagonal)
    : formula_(text, relative_tolerance * diagonal) {}

bool Condition::operator()(const Vec3& x) const {
  const double value = formula_(x);
  if (std::isnan(value))
    throw InputError("where = {} has no value at ({:.6g}, {:.6g}, {:.6g})", quote(formula_.text()),
                     x.x(), x.y(), x.z());
  if (value != 0 && value != 1)
    throw InputError(
        "where = {} is {:.6g} at ({:.6g}, {:.6g}, {:.6g}), neither true nor false; compare, as in "
        "x == 0",
        quote(formula_.text()), value, x.x(), x.y(), x.z());
  return value == 1;
}

std::string describe_extent(const Vec3& low, const Vec3& high) {
  return fmt::format(
      "the mesh has x from {:.6g} to {:.6g}, y from {:.6g} to {:.6g}, z from {:.6g} "
      "to {:.6g}",
      low.x(), high.x(), low.y(), high.y(), low.z(), high.z());
}

}  // namespace limes
