#pragma once

#include "limes/mesh/mesh.h"

namespace limes {

/// Parts of the plane around the vertex (0, 0).
enum class Region { plane, half_plane, quadrant };

/// A regular mesh of unit squares, or of their halves along (1, 1), with vertices at whole numbers:
/// all of them up to `reach` away, with y >= 0 in the half plane and the quadrant, with x >= 0 in the
/// quadrant.
struct Lattice {
  Mesh mesh;
  VertexId middle;  ///< at (0, 0)
};
[[nodiscard]] Lattice lattice(int face_size, Region region, int reach);

/// Tags the edges along y = 0 as creases: all, or (a dart) those with x >= 0.
enum class CreaseLine { through, ends };
void add_crease(Lattice& lattice, CreaseLine line, float sharpness = infinite_sharpness);

}  // namespace limes
