#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <unordered_map>
#include <vector>

#include "limes/core/types.h"
#include "limes/mesh/adjacency.h"
#include "limes/subdiv/edge_sharpness.h"
#include "limes/subdiv/features.h"
#include "limes/subdiv/scheme.h"

namespace limes {

/// Corners of a quad, or of a triangle; the fourth is invalid then.
using FaceCorners = std::array<VertexId, 4>;
/// The same where faces are known to be quads.
using QuadCorners = FaceCorners;

/// The vertices that a face's split adds: in the middle of its sides, and of a quad itself.
struct ChildNodes {
  std::array<VertexId, 4> sides;  ///< of a triangle three
  VertexId centre;                ///< of a triangle invalid
};

/// Limit positions of the vertices of a mesh: what schemes that move their vertices need for their
/// placement. Right at vertices whose ring of faces is complete; the others may be anything.
using LimitsOf =
    std::function<IdArray<VertexId, Vec3>(const Topology&, const Features&, std::span<const Vec3>)>;

/// Capacity for an array of so many elements that will grow a little; unused memory costs nothing.
[[nodiscard]] constexpr std::size_t with_room(std::size_t size) {
  return size + size / 2;
}

/// The vertices of a forest of quadtrees (forest.h): which there are, where they lie, and what is
/// sharp. Vertices of the control mesh keep their ids, others are numbered as they are made. A vertex
/// once made is kept and keeps its place. Knows faces and their levels, not the trees. All faces are
/// quads or all are triangles, as the scheme splits.
class ForestNodes {
 public:
  /// @param control  needed during construction only
  /// @param limits   of schemes that are not interpolatory
  ForestNodes(const Adjacency& control, std::span<const Vec3> points, const Features& features,
              const Scheme& scheme, LimitsOf limits);

  /// Of a vertex as one of a level, for tables.
  [[nodiscard]] static std::uint64_t level_key(int level, VertexId v);

  [[nodiscard]] int size() const { return positions_.size(); }
  /// On the limit surface.
  [[nodiscard]] const Vec3& position(VertexId v) const { return positions_[v]; }
  /// Moves a vertex of an interpolatory scheme, from which no others were made yet.
  void place(VertexId v, const Vec3& x) { positions_[v] = x; }
  /// Whether a vertex lies on the boundary or on a sharp edge.
  [[nodiscard]] bool on_curve(VertexId v) const { return on_curve_[v] != 0; }
  /// The vertex in the middle of an edge; invalid if none was made.
  [[nodiscard]] VertexId middle(VertexId a, VertexId b) const;
  [[nodiscard]] float edge_sharpness(VertexId a, VertexId b) const { return sharp_edges_.of(a, b); }
  [[nodiscard]] float vertex_sharpness(int level, VertexId v) const;

  /// Makes the vertices that splitting some faces adds, by one step of the scheme on a patch.
  /// @param patch   faces of one level in the order of uniform refinement: those to be split, and all
  ///                that share a vertex with them; two rings of the control mesh, and around those
  ///                with a vertex on a curve, since what lies beyond it depends on its next vertex
  /// @param wanted  for each face whether it is to be split
  /// @return of the wanted faces
  std::vector<ChildNodes> make(int level, std::span<const FaceCorners> patch,
                               const std::vector<bool>& wanted);

 private:
  struct Patch;
  struct Middle {
    VertexId older;   // end of the edge; none: the vertex is no middle
    VertexId before;  // in the list
  };

  [[nodiscard]] const Vec3& value(int level, VertexId v) const;
  [[nodiscard]] Features features_of(const Patch& patch, int level) const;
  ChildNodes make_children_of(const Patch& patch, FaceId face, std::span<VertexId> nodes);
  VertexId middle_or_new(VertexId a, VertexId b, bool on_curve);
  VertexId add_vertex(bool on_curve);
  void keep_sharp(const Topology& child, const Features& features, int level,
                  std::span<const VertexId> nodes);

  const Scheme* scheme_;
  RuleOptions options_;
  LimitsOf limits_;
  IdArray<VertexId, Vec3> positions_;
  IdArray<VertexId, char> on_curve_;
  // Each middle of an edge hangs in a list at the end that was made later, which has few edges to older ones.
  IdArray<VertexId, VertexId> last_middle_;
  IdArray<VertexId, Middle> middle_;
  std::vector<Vec3> control_;  // of schemes that are not interpolatory; likewise the next
  std::unordered_map<std::uint64_t, Vec3> values_;  // by level and vertex, from level 1 on
  EdgeSharpness sharp_edges_;
  std::unordered_map<std::uint64_t, SharpVertex> corners_;  // by level and vertex
};

}  // namespace limes
