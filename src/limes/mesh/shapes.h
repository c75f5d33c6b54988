#pragma once

#include "limes/mesh/mesh.h"

namespace limes::shapes {

// Small control meshes made in code, each with one feature that schemes must handle: for tests,
// benchmarks and examples. Faces are counter-clockwise, seen from outside or from +z.

/// Six quads, corners at +-1.
[[nodiscard]] Mesh cube();
/// Four triangles, on the unit sphere.
[[nodiscard]] Mesh tetrahedron();
/// Twenty triangles, valence 5, on the unit sphere.
[[nodiscard]] Mesh icosahedron();
/// columns x lines quads of valence 4, a closed surface. columns, lines >= 3.
[[nodiscard]] Mesh torus(int columns, int lines);

/// columns x lines unit squares in the plane z = 0; vertex i + (columns + 1) j is at (i, j).
[[nodiscard]] Mesh grid(int columns, int lines);
/// size x size unit squares without the middle one. size is odd, >= 3.
[[nodiscard]] Mesh grid_with_hole(int size);
/// A regular polygon with one face of n corners on the unit circle. n >= 3.
[[nodiscard]] Mesh polygon(int n);
/// The regular n-gon with corners on the unit circle, cut into n sectors of size x size quads
/// around a middle vertex of valence n, which is vertex 0. n >= 3.
[[nodiscard]] Mesh disk(int n, int size);
/// n sectors of size x size quads around vertex 0, as disk() has them, but with spokes of length 1
/// whatever n is. n >= 2.
[[nodiscard]] Mesh star(int n, int size);
/// n sectors of triangles around vertex 0, `size` rings of them; spokes of length 1. n >= 3.
[[nodiscard]] Mesh triangle_star(int n, int size);
/// num_faces sectors of size x size quads around vertex 0, which lies on the boundary; together
/// they cover the upper half of the unit disk (for one face a quarter).
[[nodiscard]] Mesh half_disk(int num_faces, int size);
/// A cylinder of columns x lines quads with two boundaries, axis z. columns >= 3.
[[nodiscard]] Mesh cylinder(int columns, int lines);
/// A one-sided strip of n quads, which no scheme can refine. n >= 3.
[[nodiscard]] Mesh moebius_strip(int n);

}  // namespace limes::shapes
