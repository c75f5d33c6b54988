#include <cmath>
#include <numbers>

#include "limes/subdiv/schemes.h"

namespace limes {

/// Doo-Sabin subdivision [doo_sabin_1978]: of an n-gon, the vertex near corner 0 is
/// (n + 5)/(4n) V_0 + sum over j > 0 of (3 + 2 cos(2 pi j / n))/(4n) V_j; of a quad (9, 3, 1, 3)/16.
void doo_sabin_corner(const FaceNeighbourhood& face, int corner, const RuleOptions&, Stencil& out) {
  const std::size_t size = face.corners.size();
  const double n = static_cast<double>(size);
  const auto at = [&](std::size_t j) {
    return face.corners[(static_cast<std::size_t>(corner) + j) % size];
  };
  out.add((n + 5.0) / (4.0 * n), at(0));
  for (std::size_t j = 1; 2 * j < size; ++j) {
    const double angle = 2.0 * std::numbers::pi * static_cast<double>(j) / n;
    const double cosine = size == 4 ? 0.0 : std::cos(angle);
    const std::array<VertexId, 2> pair{at(j), at(size - j)};
    out.add((3.0 + 2.0 * cosine) / (4.0 * n), pair);
  }
  if (size % 2 == 0) out.add(1.0 / (4.0 * n), at(size / 2));
}

}  // namespace limes
