#pragma once

#include <map>
#include <vector>

#include "limes/subdiv/scheme.h"

namespace limes {

/// What the rules of a scheme see of a ring of quads or triangles around a vertex. On the boundary there is one
/// edge more than faces, as in VertexNeighbourhood.
struct RingPattern {
  int num_faces = 0;
  float sharpness = 0;                ///< of the vertex
  std::vector<float> edge_sharpness;  ///< of the edges in ring order

  [[nodiscard]] int num_edges() const { return static_cast<int>(edge_sharpness.size()); }
  friend bool operator==(const RingPattern&, const RingPattern&) = default;
  friend bool operator<(const RingPattern& a, const RingPattern& b);
};

/// The rules on one pattern. Local ids: vertex 0 in the middle, the end 1 + k of edge k, the far
/// corner 1 + num_edges + i of face i if that is a quad.
struct RingRules {
  std::vector<Stencil> edges;
  Stencil vertex;
};

/// Asks a scheme for its rules.
void write_ring_rules(const Scheme& scheme, const RuleOptions& options, const RingPattern& pattern,
                      RingRules& out);
/// The pattern after a step.
[[nodiscard]] RingPattern decayed(CreaseMethod method, const RingPattern& pattern);

/// Rules of the patterns that occur, so that rings of one kind share them. Where nearly every ring is
/// of its own kind, as with painted sharpness, only the first ones are kept: this is not to become a
/// table of the whole mesh.
class RingRulesCache {
 public:
  struct Entry {
    RingPattern pattern;
    RingRules rules;
    Entry* next = nullptr;  ///< after a step
  };
  static constexpr std::size_t max_patterns = 2048;

  /// Keeps a reference to the scheme.
  RingRulesCache(const Scheme& scheme, const RuleOptions& options)
      : scheme_(&scheme), options_(options) {}
  RingRulesCache(const RingRulesCache&) = delete;
  RingRulesCache& operator=(const RingRulesCache&) = delete;

  /// Rules of a pattern, linked to those of the steps that follow; or null if there is no room.
  [[nodiscard]] const Entry* find(const RingPattern& pattern, int num_steps);

 private:
  [[nodiscard]] Entry* entry(const RingPattern& pattern);

  const Scheme* scheme_;
  RuleOptions options_;
  std::map<RingPattern, Entry> entries_;
};

}  // namespace limes
