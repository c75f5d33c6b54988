#pragma once

#include <span>

#include "limes/core/id_array.h"
#include "limes/subdiv/forest_mesh.h"

namespace limes {

/// A mesh of quads with hanging vertices as one without: each is a corner, of 180 degrees, of the face in whose
/// side it hangs. Then neighbours share whole edges, and who asks for neighbours, boundaries or rings is
/// told right.
struct HangingFaces {
  Topology topology;  ///< the same vertices and faces
  /// Of each corner of the quads, four to a face, which corner it is here.
  IdArray<HalfedgeId, HalfedgeId> corners;

  /// Corner i of the quad; i in [0, 4).
  [[nodiscard]] HalfedgeId corner(FaceId face, int i) const {
    return corners[HalfedgeId(4 * face.value + i)];
  }
  /// The vertex that hangs in the side from corner i of the quad, as a corner of the face; invalid if none does.
  [[nodiscard]] HalfedgeId inside(FaceId face, int i) const;
  /// The side of the quad that a halfedge lies on.
  [[nodiscard]] int side(FaceId face, HalfedgeId h) const;
};

/// @param quads    of forest_mesh() with Closure::hanging
/// @param hanging  its hanging vertices
[[nodiscard]] HangingFaces hanging_faces(const Topology& quads,
                                         std::span<const HangingVertex> hanging);

}  // namespace limes
