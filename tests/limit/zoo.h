#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "limes/mesh/mesh.h"

namespace limes::test {

/// A control mesh with one feature, and the faces around that feature.
struct Shape {
  std::string name;
  Mesh mesh;
  BoundaryRule boundary = BoundaryRule::edges;
  std::string scheme = "catmull-clark";
};

inline void PrintTo(const Shape& shape, std::ostream* out) {
  *out << shape.name;
}

/// Everything a limit must get right: interior valences 3 to 400, boundary valences, corners, sharp
/// and semi-sharp creases and darts, both crease methods, polygons, several features in one face.
std::vector<Shape> limit_shapes();

/// The same of triangles, for loop.
std::vector<Shape> loop_shapes();

}  // namespace limes::test
