#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "limes/mesh/adjacency.h"
#include "limes/mesh/mesh.h"

namespace limes {

/// A `where` of a problem file, understood but not yet looked up in a mesh.
struct Where {
  enum class Kind { all, boundary, group, part, vertex, condition };
  Kind kind = Kind::all;
  std::string text;   ///< as written
  std::string name;   ///< of the group or part
  VertexId vertex{};  ///< counted from 0
};

/// Reads "all", "boundary", "group:NAME", "part:NAME", "vertex:12", or a condition in x, y, z.
/// @throws InputError that says what is wrong, without the place in a file
[[nodiscard]] Where parse_where(std::string_view text);

}  // namespace limes
