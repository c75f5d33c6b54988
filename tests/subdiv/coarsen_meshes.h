#pragma once

#include <algorithm>
#include <string>

#include "limes/io/io.h"
#include "limes/mesh/measure.h"
#include "limes/subdiv/refine.h"
#include "limes/subdiv/schemes.h"

namespace limes {

inline BoundaryRule rule_of(const Mesh& mesh) {
  return mesh.tags.boundary.value_or(BoundaryRule::edges);
}

inline Mesh refined(const Mesh& mesh, int levels = 1) {
  return refine(mesh, find_scheme("catmull-clark"), {levels, rule_of(mesh)});
}

inline double size_of(const Mesh& mesh) {
  return bounding_box(mesh).diagonal();
}

inline double largest_distance(const Mesh& a, const Mesh& b) {
  double largest = 0;
  for (int v = 0; v < a.points.size(); ++v)
    largest = std::max(largest, (a.points[VertexId(v)] - b.points[VertexId(v)]).norm());
  return largest;
}

inline Mesh read_shape(const std::string& name) {
  Mesh mesh = read_mesh(LIMES_TEST_DATA_DIR "/opensubdiv/" + name + ".obj").mesh;
  if (mesh.tags.boundary == BoundaryRule::none) mesh.tags.boundary = BoundaryRule::edges;
  return mesh;
}

}  // namespace limes
