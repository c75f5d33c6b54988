#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "limes/core/id_array.h"
#include "limes/core/ids.h"
#include "limes/curve/polyline.h"

namespace limes {

/// The 'l' lines of an OBJ file, joined to curves.
class ObjPolylines {
 public:
  /// @param vertices  two or more, from 0; they may come later in the file
  /// @param line      1-based
  void add(std::span<const std::int64_t> vertices, std::int64_t line);

  /// @throws InputError if there are none, or for a vertex that does not exist, with its line
  [[nodiscard]] std::vector<Polyline> build(std::string_view file,
                                            const IdArray<VertexId, Vec3>& points) const;

 private:
  struct Statement {
    std::vector<std::int64_t> vertices;
    std::int64_t line;  ///< of the last part
  };
  std::vector<Statement> statements_;
};

}  // namespace limes
