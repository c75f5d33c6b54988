#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "limes/core/id_array.h"
#include "limes/core/types.h"
#include "limes/mesh/tags.h"
#include "limes/mesh/topology.h"

namespace limes {

/// A named set of faces (OBJ 'g', PLY none). A face may be in several groups.
struct FaceGroup {
  std::string name;
  std::vector<FaceId> faces;  // ascending
};

/// A named whole number for every face.
struct FaceField {
  std::string name;
  std::vector<std::int64_t> values;
};

/// What files and bindings exchange: topology, positions, tags and names.
struct Mesh {
  Topology topology;
  IdArray<VertexId, Vec3> points;
  Tags tags;
  std::vector<FaceGroup> groups;       ///< OBJ 'g'
  std::vector<FaceGroup> parts;        ///< OBJ 'o'; empty, or every face is in exactly one part
  std::vector<FaceField> face_fields;  ///< written to ply and vtu; readers and refinement make none

  /// Where an element came from, for messages: line of each face (1-based), empty if not a text
  /// file.
  std::vector<int> face_lines;
};

}  // namespace limes
