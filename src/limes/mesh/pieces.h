#pragma once

#include <array>
#include <span>
#include <vector>

#include "limes/mesh/adjacency.h"

namespace limes {

// How faces and corners hang together on any mesh, however broken; defects, repair and measure are
// built on it. All corners must name vertices that exist.

/// Following halfedge of every halfedge in its face.
[[nodiscard]] IdArray<HalfedgeId, HalfedgeId> next_halfedges(const Topology& topology);

/// Faces that can be reached over edges with exactly two faces.
struct Piece {
  int num_faces = 0;
  int num_turned = 0;      ///< faces to turn so that all run alike; at most half of them
  bool orientable = true;  ///< false: no way of turning faces makes all run alike
  /// Two halfedges that run along one edge in the same direction, the first in face order; for a
  /// piece that is not orientable, two that clash however the faces are turned.
  std::array<HalfedgeId, 2> clash{};
};

struct FacePieces {
  std::vector<Piece> pieces;     ///< in order of their first face
  IdArray<FaceId, int> piece;    ///< index into pieces
  IdArray<FaceId, char> turned;  ///< 1: turn this face; the smaller part of the piece
};
[[nodiscard]] FacePieces find_pieces(const Topology& topology, const EdgeGroups& edges);

/// The fan of every corner, named by its first corner: corners at one vertex that hang together
/// over edges, or follow each other in a face. A vertex with more than one fan is a bow tie.
[[nodiscard]] IdArray<HalfedgeId, HalfedgeId> corner_fans(const Topology& topology,
                                                          const EdgeGroups& edges);

/// Whether the faces at some vertex form more than one fan.
/// @param adjacency  by Adjacency::Check::edges
[[nodiscard]] bool has_bow_ties(const Adjacency& adjacency);

/// The corners of the same faces where every fan at a vertex has a vertex of its own: the first fan keeps
/// the vertex, each other has a copy.
struct FansApart {
  std::vector<VertexId> corners;
  /// What copies are copies of; copy i is vertex num_vertices() + i, in the order of their first corners.
  std::vector<VertexId> original;
};
[[nodiscard]] FansApart fans_apart(const Topology& topology);

/// The halfedges along the edge between two vertices, by bisection; empty when no edge joins them.
[[nodiscard]] std::span<const HalfedgeId> halfedges_between(
    const Topology& topology, const EdgeGroups& edges, const IdArray<HalfedgeId, HalfedgeId>& next,
    VertexId a, VertexId b);

/// Sets of numbers [0, size) that only grow together. The first number of a set names it.
class DisjointSets {
 public:
  explicit DisjointSets(int size);
  [[nodiscard]] int find(int i);
  void join(int a, int b);

 private:
  std::vector<int> parent_;
};

}  // namespace limes
