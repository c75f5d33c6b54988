#include "limes/subdiv/coarsen_tags.h"

#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "limes/subdiv/crease.h"
#include "limes/subdiv/neighbourhood.h"

namespace limes {
namespace {

/// The inverse of decayed(), where there is one.
float raised(float sharpness) {
  return is_sharp(sharpness) && !is_infinite(sharpness) ? sharpness + 1.0F : sharpness;
}

/// Sharpness one level up of the edges around a vertex, from that of their halves there.
///
/// Chaikin's rule, c_i = 3/4 s_i + 1/4 (sum - s_i) / (k - 1) - 1 over the k semi-sharp edges, keeps
/// the sum up to k: sum s = sum c + k; with it every s_i follows from its own c_i.
std::vector<float> raised_around_vertex(CreaseMethod method, const std::vector<float>& halves) {
  float sum = 0.0F;
  int count = 0;
  for (const float c : halves) {
    if (!is_sharp(c) || is_infinite(c)) continue;
    sum += c + 1.0F;
    ++count;
  }
  std::vector<float> edges;
  for (const float c : halves) {
    const bool simple = method == CreaseMethod::uniform || count < 2;
    if (simple || !is_sharp(c) || is_infinite(c)) {
      edges.push_back(raised(c));
      continue;
    }
    const float share = 0.25F / static_cast<float>(count - 1);
    edges.push_back((c + 1.0F - share * sum) / (0.75F - share));
  }
  return edges;
}

class TagCoarsener {
 public:
  TagCoarsener(const Adjacency& fine, const Features& features, const Sharpness& sharpness,
               const VertexOrigins& origins, const Unsplit& coarse, const Adjacency& adjacency)
      : fine_(fine),
        features_(features),
        sharpness_(sharpness),
        origins_(origins),
        coarse_(coarse),
        adjacency_(adjacency) {}

  CoarseTags run() {
    CoarseTags out;
    out.misfit = misfit();
    if (!out.misfit.empty()) return out;
    out.tags.crease_method = features_.crease_method;
    collect_creases(out.tags);
    for (int v = 0; v < adjacency_.topology().num_vertices(); ++v) {
      const float s = sharpness_.vertex(coarse_.old_vertex[static_cast<std::size_t>(v)]);
      if (is_sharp(s)) out.tags.corners.push_back({VertexId(v), raised(s)});
    }
    out.remark = unexplained(out.tags);
    return out;
  }

 private:
  [[nodiscard]] float half(HalfedgeId h) const {
    return sharpness_.edge(fine_.edge(coarse_.half[h]));
  }

  /// Refinement makes sharp only halves of old edges, and old vertices. (Features of other
  /// components are unlabelled or fit on their own.)
  [[nodiscard]] std::string misfit() const {
    const auto is_new = [&](VertexId v) {
      return origins_[v] == VertexOrigin::edge || origins_[v] == VertexOrigin::face;
    };
    for (const SharpEdge& e : features_.edges) {
      const VertexId a = fine_.from(e.halfedge);
      const VertexId b = fine_.to(e.halfedge);
      if (is_new(a) && is_new(b))
        return fmt::format("the crease between vertices {} and {} would run inside a face", a.value,
                           b.value);
    }
    for (const SharpVertex& v : features_.vertices)
      if (is_new(v.vertex))
        return fmt::format("vertex {} is a corner, but would be a new vertex", v.vertex.value);
    return {};
  }

  void collect_creases(Tags& tags) const {
    if (features_.edges.empty()) return;
    IdArray<HalfedgeId, float> estimate(static_cast<std::size_t>(coarse_.half.size()), 0.0F);
    std::vector<HalfedgeId> ring;
    std::vector<float> halves;
    for (int v = 0; v < adjacency_.topology().num_vertices(); ++v) {
      ring.clear();
      halves.clear();
      const HalfedgeId start = adjacency_.ring_start(VertexId(v));
      for (HalfedgeId h = start; h.valid();) {
        ring.push_back(h);
        halves.push_back(half(h));
        h = adjacency_.ring_next(h);
        if (h == start) break;
      }
      const auto edges = raised_around_vertex(features_.crease_method, halves);
      for (std::size_t i = 0; i < ring.size(); ++i)
        estimate[ring[i]] = edges[i];
    }
    for (int e = 0; e < adjacency_.num_edges(); ++e) {
      const HalfedgeId h = adjacency_.halfedge(EdgeId(e));
      const HalfedgeId twin = adjacency_.twin(h);
      if (!twin.valid()) continue;  // always infinitely sharp
      const float s = is_sharp(estimate[h]) ? estimate[h] : estimate[twin];
      if (is_sharp(s)) tags.creases.push_back({adjacency_.from(h), adjacency_.to(h), s});
    }
  }

  /// Refines the tags again and compares.
  [[nodiscard]] std::string unexplained(const Tags& tags) const {
    constexpr float tolerance = 1e-4F;
    const Features features = resolve_tags(adjacency_, tags, BoundaryRule::edges);
    const Sharpness sharpness(adjacency_, features);
    NeighbourhoodWalk walk(adjacency_, features, sharpness);
    for (int i = 0; i < coarse_.half.size(); ++i) {
      const HalfedgeId h(i);
      if (!adjacency_.twin(h).valid()) continue;
      const float there = half(h);
      const float made = features.edges.empty() ? 0.0F : walk.child_sharpness_at_start(h);
      if (std::abs(there - made) <= tolerance) continue;
      const HalfedgeId f = coarse_.half[h];
      return fmt::format(
          "the crease between vertices {} and {} has sharpness {}; refined from the coarse mesh it "
          "would have {}",
          fine_.from(f).value, fine_.to(f).value, there, made);
    }
    return {};
  }

  const Adjacency& fine_;
  const Features& features_;
  const Sharpness& sharpness_;
  const VertexOrigins& origins_;
  const Unsplit& coarse_;
  const Adjacency& adjacency_;
};

}  // namespace

CoarseTags coarsen_tags(const Adjacency& fine, const Features& features, const Sharpness& sharpness,
                        const VertexOrigins& origins, const Unsplit& coarse,
                        const Adjacency& adjacency) {
  return TagCoarsener(fine, features, sharpness, origins, coarse, adjacency).run();
}

}  // namespace limes
