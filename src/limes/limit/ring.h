#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "limes/subdiv/features.h"
#include "limes/subdiv/scheme.h"

namespace limes {

/// The piece of a mesh that determines the limit of one face, as a small mesh of its own: the face,
/// then all faces that share a vertex with it, numbered by a fixed walk. Rings with equal key have
/// equal limit functions, up to the control points.
struct Ring {
  Topology topology;  ///< face 0 is the face itself, its corner 0 is vertex 0
  Features features;
  int num_controls = 0;            ///< the first vertices: those the limit depends on
  std::vector<VertexId> vertices;  ///< of the large mesh, for every local vertex
};

/// Precondition: the faces around the corners of f are manifold.
[[nodiscard]] Ring gather_ring(const Adjacency& adjacency, const Features& features,
                               const Sharpness& sharpness, const Scheme& scheme, FaceId f);

/// The vertices of gather_ring in the same order, found directly, if the ring is of the most common
/// kind: 3 x 3 quads with 16 different vertices and nothing sharp at the corners of f. For schemes
/// that reach one ring.
[[nodiscard]] std::optional<std::array<VertexId, 16>> plain_ring(const Adjacency& adjacency,
                                                                 const Sharpness& sharpness,
                                                                 FaceId f);

/// Equal for rings that have the same topology and features.
[[nodiscard]] std::string ring_key(const Ring& ring);

}  // namespace limes
