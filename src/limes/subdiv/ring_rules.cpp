#include "limes/subdiv/ring_rules.h"

#include <tuple>

#include "limes/subdiv/crease.h"

namespace limes {

bool operator<(const RingPattern& a, const RingPattern& b) {
  return std::tie(a.num_faces, a.sharpness, a.edge_sharpness) <
         std::tie(b.num_faces, b.sharpness, b.edge_sharpness);
}

RingPattern decayed(CreaseMethod method, const RingPattern& pattern) {
  RingPattern child = pattern;
  child.sharpness = decayed(pattern.sharpness);
  for (std::size_t k = 0; k < child.edge_sharpness.size(); ++k)
    child.edge_sharpness[k] = decayed_at_vertex(method, k, pattern.edge_sharpness);
  return child;
}

void write_ring_rules(const Scheme& scheme, const RuleOptions& options, const RingPattern& pattern,
                      RingRules& out) {
  const int edges = pattern.num_edges();
  const int faces = pattern.num_faces;
  const bool triangles = scheme.split == Split::triangles;
  const int face_size = triangles ? 3 : 4;
  const auto end = [&](int k) { return VertexId(1 + (k + edges) % edges); };
  out.edges.resize(static_cast<std::size_t>(edges));
  std::vector<VertexId> neighbours;
  for (int k = 0; k < edges; ++k) {
    neighbours.emplace_back(1 + k);
    const bool boundary = edges > faces && (k == 0 || k == edges - 1);
    const float s = pattern.edge_sharpness[static_cast<std::size_t>(k)];
    Stencil& stencil = out.edges[static_cast<std::size_t>(k)];
    stencil.clear();
    scheme.edge_rule({.ends = {VertexId(0), VertexId(1 + k)},
                      .faces = {FaceId(boundary && k > 0 ? k - 1 : k % faces),
                                boundary ? FaceId() : FaceId((k + faces - 1) % faces)},
                      .face_sizes = {face_size, boundary ? 0 : face_size},
                      .num_faces = boundary ? 1 : 2,
                      .opposite = {triangles ? end(boundary && k > 0 ? k - 1 : k + 1) : VertexId(),
                                   triangles && !boundary ? end(k - 1) : VertexId()},
                      .sharpness = s,
                      .child_sharp = is_sharp(decayed(s))},
                     options, stencil);
  }
  std::vector<FaceId> face_ids;
  for (int i = 0; i < faces; ++i)
    face_ids.emplace_back(i);
  const RingPattern child = decayed(options.crease_method, pattern);
  out.vertex.clear();
  scheme.vertex_rule({VertexId(0), neighbours, face_ids, pattern.sharpness, child.sharpness,
                      pattern.edge_sharpness, child.edge_sharpness},
                     options, out.vertex);
}

const RingRulesCache::Entry* RingRulesCache::find(const RingPattern& pattern, int num_steps) {
  Entry* const first = entry(pattern);
  Entry* at = first;
  for (int step = 1; at && step < num_steps; ++step) {
    if (!at->next) at->next = entry(decayed(options_.crease_method, at->pattern));
    at = at->next;
  }
  return at ? first : nullptr;
}

RingRulesCache::Entry* RingRulesCache::entry(const RingPattern& pattern) {
  const auto found = entries_.find(pattern);
  if (found != entries_.end()) return &found->second;
  if (entries_.size() >= max_patterns) return nullptr;
  Entry& made = entries_[pattern];
  made.pattern = pattern;
  write_ring_rules(*scheme_, options_, pattern, made.rules);
  return &made;
}

}  // namespace limes
