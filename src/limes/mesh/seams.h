#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "limes/mesh/adjacency.h"
#include "limes/mesh/mesh.h"

namespace limes {

/// A boundary edge of one part and that of another on the same place: ends[i] of one is tied to
/// tied[i] of the other.
struct TiedEdge {
  std::array<VertexId, 2> ends, tied;
  friend bool operator==(const TiedEdge&, const TiedEdge&) = default;
};

/// Where two parts with vertices of their own share a boundary polygon.
/// @param tolerance  largest distance between vertices that are tied
/// @return in order of the first part's halfedges
/// @throws InputError if a vertex of one part lies on or near (2 % of its length) a boundary edge of the
///         other and no vertex of that is there: names the parts, the vertex and its distance from
///         the nearest
[[nodiscard]] std::vector<TiedEdge> tie_parts(const Mesh& mesh, const Adjacency& adjacency,
                                              const FaceGroup& first, const FaceGroup& second,
                                              double tolerance);

/// Boundary edges as pairs of ends after one step that splits every edge in the middle, where edge
/// vertices follow the old ones in order of the edges (quadrisection, first step on n-gons).
[[nodiscard]] std::vector<std::array<VertexId, 2>> split_edges(
    const Adjacency& coarse, std::span<const std::array<VertexId, 2>> edges);
[[nodiscard]] std::vector<TiedEdge> split_edges(const Adjacency& coarse,
                                                std::span<const TiedEdge> edges);

/// For each vertex the lowest one that it is tied to, over any number of seams; else itself.
[[nodiscard]] IdArray<VertexId, VertexId> tied_nodes(int num_vertices,
                                                     std::span<const TiedEdge> edges);

}  // namespace limes
