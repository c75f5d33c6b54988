#pragma once

#include <span>
#include <vector>

namespace limes {

/// Which parts of a mesh are refined, from their squared errors.
enum class MarkingKind {
  doerfler,  ///< the fewest that together have a share of the whole [doerfler_1996]
  maximum,   ///< those whose error (not squared) is at least a share of the largest
  fraction   ///< a share of their number, rounded up, the largest first
};

/// Numbers of the marked parts, ascending; of equal errors the lower number first. Nothing if all
/// errors are zero.
/// @param squares  squared errors, >= 0
/// @param share    in (0, 1]
[[nodiscard]] std::vector<int> marked(std::span<const double> squares, MarkingKind kind,
                                      double share);

}  // namespace limes
