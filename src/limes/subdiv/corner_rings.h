#pragma once

#include <span>
#include <vector>

#include "limes/mesh/adjacency.h"
#include "limes/subdiv/point4.h"
#include "limes/subdiv/regular_rules.h"
#include "limes/subdiv/ring_rules.h"

namespace limes {

/// The faces around every vertex that is not regular (extraordinary, on a boundary or crease, sharp),
/// through all steps of a refinement. A scheme of reach one maps such a ring onto itself, so the
/// general rules are applied to the ring alone; the grids around it take from it what they cannot
/// know. Rings of one kind, by valence and sharpness, share their rules.
class CornerRings {
 public:
  /// Of a mesh of quads, or of triangles. Keeps references.
  /// Precondition: the scheme has RegularMasks; no semi-sharp edges with Chaikin's method, whose sharpness varies along an edge
  CornerRings(const Adjacency& adjacency, const Features& features, const Scheme& scheme,
              int num_steps);

  [[nodiscard]] int size() const { return static_cast<int>(rings_.size()); }
  /// Ring of a vertex, or -1 if the vertex is regular.
  [[nodiscard]] int ring_of(VertexId v) const { return ring_of_[v]; }

  /// Edge `by` places after an edge of a ring, or -1 beyond the ring's ends. Edges are numbered along
  /// the ring from Adjacency::ring_start() on, and face k lies between edges k and k + 1.
  [[nodiscard]] int turned(int ring, int edge, int by) const {
    const Ring& r = get(ring);
    int k = edge + by;
    if (r.num_edges > r.num_faces) return k >= 0 && k < r.num_edges ? k : -1;
    while (k >= r.num_edges)
      k -= r.num_edges;
    while (k < 0)
      k += r.num_edges;
    return k;
  }

  /// Refines one ring. Different rings may be refined at the same time.
  /// @param fine  position of the ring's vertex after the last step, written
  void refine(int ring, std::span<const Vec3> control, Vec3& fine);

  [[nodiscard]] VertexId vertex(int ring) const { return get(ring).vertex; }
  /// The ring's vertex after a step, 1 <= step < num_steps.
  [[nodiscard]] const Point4& position(int ring, int step) const { return point(ring, step, 0); }
  /// Other end of edge k of the ring after that step.
  [[nodiscard]] const Point4& end(int ring, int step, int edge) const {
    return point(ring, step, 1 + edge);
  }

 private:
  struct Ring {
    VertexId vertex;
    float sharpness;
    int num_edges, num_faces;
    std::size_t first_edge;              // in edge_sharpness_
    std::size_t first_point;             // in points_: num_edges + 1 for each step
    const RingRulesCache::Entry* rules;  // null: not shared
  };
  struct Workspace;

  [[nodiscard]] const Ring& get(int ring) const { return rings_[static_cast<std::size_t>(ring)]; }
  [[nodiscard]] const Point4& point(int ring, int step, int k) const {
    const Ring& r = get(ring);
    return points_[r.first_point + static_cast<std::size_t>((step - 1) * (r.num_edges + 1) + k)];
  }
  [[nodiscard]] bool is_regular(VertexId v, const Sharpness& sharpness) const;
  void add(VertexId v, const Sharpness& sharpness);
  void load(const Ring& ring, std::span<const Vec3> control, Workspace& w) const;
  void advance(const Ring& ring, const RingRules& rules, Workspace& w) const;
  [[nodiscard]] RingPattern pattern(const Ring& ring) const;

  const Adjacency* adjacency_;
  const Scheme* scheme_;
  RegularMasks masks_{};  // of quads
  bool triangles_;
  RuleOptions options_;
  int num_steps_;
  IdArray<VertexId, int> ring_of_;
  std::vector<Ring> rings_;
  std::vector<float> edge_sharpness_;
  std::vector<Point4> points_;
  RingRulesCache rules_;
};

}  // namespace limes
