#pragma once

#include <compare>
#include <cstdint>

namespace limes {

/// Index of one kind of mesh element. Four bytes, ordered; ids of different kinds do not compare.
template <class Tag>
struct Id {
  std::int32_t value = -1;

  constexpr Id() = default;
  constexpr explicit Id(std::int64_t index) : value(static_cast<std::int32_t>(index)) {}

  [[nodiscard]] constexpr bool valid() const { return value >= 0; }
  friend constexpr auto operator<=>(Id, Id) = default;
};

using VertexId = Id<struct VertexTag>;
using EdgeId = Id<struct EdgeTag>;
using FaceId = Id<struct FaceTag>;
/// One directed side of a face; the side from corner i to corner i + 1 has the index of corner i.
using HalfedgeId = Id<struct HalfedgeTag>;

}  // namespace limes
