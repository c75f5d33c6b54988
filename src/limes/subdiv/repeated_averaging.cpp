#include <array>

#include "limes/subdiv/schemes.h"

namespace limes {

/// Repeated averaging of degree two [zorin_schroeder_2001]: of the four corners of each quad that linear
/// refinement makes, the middle. Of an n-gon, the vertex near corner 0 is the mean of V_0, the middles of
/// its two sides and the face's centroid: (2n + 1)/(4n) V_0 + (n + 2)/(8n) (V_1 + V_-1) + the others'
/// sum / (4n); of a quad (9, 3, 1, 3)/16.
void repeated_averaging_corner(const FaceNeighbourhood& face, int corner, const RuleOptions&,
                               Stencil& out) {
  const std::size_t size = face.corners.size();
  const double n = static_cast<double>(size);
  const auto at = [&](std::size_t j) {
    return face.corners[(static_cast<std::size_t>(corner) + j) % size];
  };
  out.add((2.0 * n + 1.0) / (4.0 * n), at(0));
  for (std::size_t j = 1; 2 * j < size; ++j) {
    const std::array<VertexId, 2> pair{at(j), at(size - j)};
    out.add(j == 1 ? (n + 2.0) / (8.0 * n) : 1.0 / (4.0 * n), pair);
  }
  if (size % 2 == 0) out.add(1.0 / (4.0 * n), at(size / 2));
}

}  // namespace limes
