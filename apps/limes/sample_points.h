#pragma once

#include <filesystem>
#include <vector>

#include "limes/limit/limit_basis.h"

namespace limes::app {

/// A point of a limit surface by its parameters, as LimitBasis counts them.
struct SamplePoint {
  FaceId face;
  int corner;
  Vec2 uv;
  std::int64_t line;  ///< in its file
};

/// Reads a table with the columns face, corner, u, v in any order; others are ignored.
/// @throws InputError "FILE:LINE: ..." for what is no such table and for points outside their face
[[nodiscard]] std::vector<SamplePoint> read_sample_points(const std::filesystem::path& file,
                                                          const Topology& topology,
                                                          const Scheme& scheme);

}  // namespace limes::app
