#pragma once

#include <span>
#include <vector>

#include "limes/core/id_array.h"
#include "limes/core/types.h"
#include "limes/mesh/adjacency.h"
#include "limes/mesh/tags.h"

namespace limes {

struct SharpEdge {
  HalfedgeId halfedge;  ///< the edge's first halfedge
  float sharpness;      ///< > 0
  friend bool operator==(const SharpEdge&, const SharpEdge&) = default;
};

struct SharpVertex {
  VertexId vertex;
  float sharpness;   ///< > 0
  double angle = 0;  ///< of the surface at a boundary corner, in radians; 0: not measured
  friend bool operator==(const SharpVertex&, const SharpVertex&) = default;
};

/// Weights of smooth vertices that are not regular.
enum class ExtraordinaryWeights {
  standard,  ///< as the scheme is known: catmull-clark and loop as in OpenSubdiv
  quarters,  ///< catmull-clark: a quarter, a half and a quarter at every valence [catmull_clark_1978]
  warren     ///< loop: 3/(8n), 3/16 at valence 3 [warren_weimer_2001]
};

/// What the rules depend on besides the neighbourhood: the same everywhere on a mesh.
struct RuleOptions {
  CreaseMethod crease_method = CreaseMethod::uniform;
  bool smooth_triangles = false;
  ExtraordinaryWeights weights = ExtraordinaryWeights::standard;
  double tension = 1.0;  ///< of interpolatory schemes, 1: cubic precision
  int level = 0;         ///< steps made since the control mesh
  /// Weights at the boundary follow the angle of the surface there, see sector.h.
  bool sector_stencils = false;
  friend bool operator==(const RuleOptions&, const RuleOptions&) = default;
};

/// What the rules of a scheme need besides the topology: tags resolved to its edges and vertices.
/// Boundary edges are always infinitely sharp and not listed.
struct Features : RuleOptions {
  std::vector<SharpEdge> edges;       ///< ascending by halfedge
  std::vector<SharpVertex> vertices;  ///< ascending

  /// The same options some steps down; no edges and vertices.
  [[nodiscard]] Features without_tags(int steps) const {
    Features next;
    static_cast<RuleOptions&>(next) = *this;
    next.level += steps;
    return next;
  }
};

/// Resolves a mesh's tags. With edges_and_corners, boundary vertices with one face become corners.
/// @throws InputError for a crease tag on a pair of vertices that no edge joins, or a vertex that
///         does not exist
[[nodiscard]] Features resolve_tags(const Adjacency& adjacency, const Tags& tags,
                                    BoundaryRule boundary);

/// Asks for sector stencils: measures the angle of the surface at the boundary vertices that are
/// corners, as the sum of their faces' angles. points: one per vertex.
void measure_corners(const Adjacency& adjacency, std::span<const Vec3> points, Features& features);

/// The inverse, for files: features of a refined mesh as tags.
[[nodiscard]] Tags tags_of(const Topology& topology, const Features& features);

/// Sharpness by edge and vertex, dense; no memory where nothing is sharp.
class Sharpness {
 public:
  Sharpness(const Adjacency& adjacency, const Features& features);

  /// Sharpness of an edge; infinite on the boundary.
  [[nodiscard]] float edge(EdgeId e) const {
    if (adjacency_->is_boundary(e)) return infinite_sharpness;
    return edges_.empty() ? 0.0F : edges_[e];
  }
  [[nodiscard]] float vertex(VertexId v) const { return vertices_.empty() ? 0.0F : vertices_[v]; }
  /// Angle of the surface at a boundary vertex: that of a corner, else pi.
  [[nodiscard]] double angle(VertexId v) const;

 private:
  const Adjacency* adjacency_;
  IdArray<EdgeId, float> edges_;
  IdArray<VertexId, float> vertices_;
  IdArray<VertexId, double> angles_;  // only for sector stencils
};

}  // namespace limes
