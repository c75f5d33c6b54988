#pragma once

#include "limes/limit/ring.h"
#include "limes/subdiv/crease.h"

namespace limes {

/// A ring with what patches are recognised by: its sides, and the sharp edges at its corners. Keeps a
/// reference to the ring.
class RingView {
 public:
  explicit RingView(const Ring& ring)
      : ring_(ring),
        adjacency_(ring.topology, Adjacency::Check::edges),
        sharpness_(adjacency_, ring.features) {}

  [[nodiscard]] const Ring& ring() const { return ring_; }
  [[nodiscard]] const Adjacency& adjacency() const { return adjacency_; }
  [[nodiscard]] const Sharpness& sharpness() const { return sharpness_; }

  /// From corner c of the ring's face to the next; c counts round.
  [[nodiscard]] HalfedgeId side(int c) const {
    return ring_.topology.halfedge(FaceId(0), c % ring_.topology.face_size(FaceId(0)));
  }
  [[nodiscard]] float edge_sharpness(HalfedgeId h) const {
    return sharpness_.edge(adjacency_.edge(h));
  }
  [[nodiscard]] bool is_infinitely_sharp(HalfedgeId h) const {
    return is_infinite(edge_sharpness(h));
  }

  /// Numbers of sharp and of infinitely sharp edges at a vertex.
  struct SharpCount {
    int sharp = 0, infinite = 0;
  };
  [[nodiscard]] SharpCount count_sharp(VertexId v) const {
    SharpCount count;
    const auto add = [&](HalfedgeId h) {
      const float s = edge_sharpness(h);
      count.sharp += is_sharp(s);
      count.infinite += is_infinite(s);
    };
    const HalfedgeId start = adjacency_.ring_start(v);
    for (HalfedgeId h = start; h.valid();) {
      add(h);
      const HalfedgeId next = adjacency_.ring_next(h);
      if (!next.valid()) add(adjacency_.prev(h));
      if (next == start) break;
      h = next;
    }
    return count;
  }

 private:
  const Ring& ring_;
  Adjacency adjacency_;
  Sharpness sharpness_;
};

}  // namespace limes
