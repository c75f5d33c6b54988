#pragma once

#include <limits>
#include <map>

#include "limes/mesh/mesh.h"

namespace limes {

/// Smallest box around the vertices that faces use. Empty: lower > upper.
struct Bounds {
  Vec3 lower = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 upper = Vec3::Constant(-std::numeric_limits<double>::infinity());

  /// Length of the diagonal, 0 when empty; no square overflows or vanishes on the way.
  [[nodiscard]] double diagonal() const { return 4.0 * quarter_diagonal(); }
  /// A quarter of it, which is finite for any finite coordinates.
  [[nodiscard]] double quarter_diagonal() const;
};
[[nodiscard]] Bounds bounding_box(const Mesh& mesh);

/// Length of the vector area of a face's corner polygon (its area if it is flat and simple).
struct ScaledArea {
  double area;      ///< unit of length squared; may overflow or vanish where squares do
  double relative;  ///< divided by the squared size of the face's bounding box; NaN if not finite
};
[[nodiscard]] ScaledArea face_area(const Mesh& mesh, FaceId face);

/// Counts and sizes of a mesh, however broken. O(n log n).
struct MeshMeasure {
  int vertices = 0;  ///< all, also those of no face
  int edges = 0;     ///< pairs of different vertices that a side of a face joins
  int faces = 0;
  int components = 0;      ///< of faces that share vertices
  int boundary_loops = 0;  ///< connected curves of edges with one face; touching loops count once
  int euler = 0;           ///< vertices of faces - edges + faces

  /// How many vertices have so many edges; vertices of no face are left out.
  std::map<int, int> valence_interior;
  std::map<int, int> valence_boundary;  ///< those at an edge with one face

  Bounds bounds;
  double area = 0;  ///< sum over faces
};
[[nodiscard]] MeshMeasure measure(const Mesh& mesh);

}  // namespace limes
