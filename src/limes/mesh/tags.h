#pragma once

#include <optional>
#include <string>
#include <vector>

#include "limes/core/ids.h"

namespace limes {

/// Sharpness from which an edge or vertex never becomes smooth (the limit that OpenSubdiv, OBJ tags
/// and USD share). Sharpness is single precision there and here: the same file, the same surface.
constexpr float infinite_sharpness = 10.0F;

struct CreaseTag {
  VertexId a, b;
  float sharpness;
  friend bool operator==(const CreaseTag&, const CreaseTag&) = default;
};

struct CornerTag {
  VertexId vertex;
  float sharpness;
  friend bool operator==(const CornerTag&, const CornerTag&) = default;
};

/// What happens at the boundary of Catmull-Clark and Loop surfaces.
enum class BoundaryRule {
  none,              ///< faces at the boundary only support the others and are dropped
  edges,             ///< boundary edges are creases: the boundary is a cubic B-spline
  edges_and_corners  ///< and boundary vertices with one face are corners
};

/// How semi-sharpness decays along a crease.
enum class CreaseMethod { uniform, chaikin };

/// The marks a file puts on a control mesh ('t' lines of OBJ), as read.
struct Tags {
  std::vector<CreaseTag> creases;
  std::vector<CornerTag> corners;
  std::vector<FaceId> holes;             ///< faces that shape their neighbours and are not shown
  std::optional<BoundaryRule> boundary;  ///< the file's own choice, if it made one
  CreaseMethod crease_method = CreaseMethod::uniform;
  bool smooth_triangles = false;  ///< OpenSubdiv's weights at edges of triangles
};

}  // namespace limes
