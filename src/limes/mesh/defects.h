#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "limes/mesh/mesh.h"

namespace limes {

/// What can be wrong with a mesh that could be read.
enum class DefectKind {
  missing_vertex,       ///< a corner names a vertex that does not exist
  few_corners,          ///< a face with one or two corners
  repeated_corner,      ///< a face with the same vertex twice
  duplicate_face,       ///< two faces with the same corners in the same order
  non_manifold_edge,    ///< an edge with three or more faces
  non_orientable,       ///< a piece with one side, like a Moebius strip
  orientation,          ///< neighbours that run along their edge in the same direction
  non_manifold_vertex,  ///< a vertex where fans of faces meet that share no edge (bow tie)
  tag,                  ///< a tag on what does not exist, or with an impossible sharpness
  not_finite,           ///< a coordinate that is no finite number
  coordinates,          ///< squared lengths overflow, or vanish although the points differ
  opposite_faces,       ///< two faces with the same corners in opposite order
  zero_area,            ///< a face without area
  one_point,            ///< all vertices in one place
  unused_vertices       ///< vertices of no face
};

/// "non-manifold-edge" and so on: the value of `kind` in JSON.
[[nodiscard]] std::string_view name_of(DefectKind kind);
/// Whether refinement is undefined on such a mesh.
[[nodiscard]] bool blocks_refinement(DefectKind kind);
/// Whether repair() mends it.
[[nodiscard]] bool can_be_repaired(DefectKind kind);

struct Defect {
  DefectKind kind;
  std::vector<FaceId> faces;       ///< ascending
  std::vector<VertexId> vertices;  ///< for an edge its two ends
  int line = 0;         ///< of the first face, of a repeat the last, 1-based; 0 when unknown
  std::string message;  ///< one sentence; faces and vertices count from 0
};

/// Everything that is wrong, ordered by kind, then by place. Beyond ten of a kind one entry
/// without faces says how many more there are. Never throws on what a reader returned;
/// O(n log n). A closed pair of opposite faces (a pillow) is a valid surface and only mentioned.
[[nodiscard]] std::vector<Defect> find_defects(const Mesh& mesh);

/// @throws InputError "FILE:LINE: what is wrong; what would help" for the first defect that
///         refinement cannot be defined on (blocks_refinement)
void require_refinable(const Mesh& mesh, std::string_view file);

}  // namespace limes
