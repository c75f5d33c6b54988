#include "limes/subdiv/triangle_labels.h"

#include <fmt/format.h>

#include <algorithm>

#include "limes/core/error.h"

namespace limes {
namespace {

/// Walks from face to face: the labels of a common edge and of the vertex on this side tell the vertex
/// beyond.
class TriangleLabeller {
 public:
  TriangleLabeller(const Adjacency& adjacency, VertexOrigins& origins)
      : adjacency_(adjacency), origins_(origins) {}

  std::string label(const std::vector<FaceId>& component, int first) {
    for (const FaceId f : component)
      for (const VertexId v : adjacency_.topology().face(f))
        origins_[v] = VertexOrigin::unknown;
    const FaceId start = component.front();
    for (int i = 0; i < 3; ++i)
      origins_[adjacency_.topology().face(start)[static_cast<std::size_t>(i)]] =
          i == first ? VertexOrigin::old_vertex : VertexOrigin::edge;
    std::string why;
    queue_ = {start};
    visited_.resize(static_cast<std::size_t>(adjacency_.topology().num_faces()), 0);
    visited_[start] = 1;
    for (std::size_t next = 0; next < queue_.size() && why.empty(); ++next)
      why = label_neighbours(queue_[next]);
    for (std::size_t i = 0; i < component.size() && why.empty(); ++i)
      why = check_face(component[i]);
    return why;
  }

 private:
  std::string label_neighbours(FaceId f) {
    for (int i = 0; i < 3; ++i) {
      const HalfedgeId h = adjacency_.topology().halfedge(f, i);
      const HalfedgeId twin = adjacency_.twin(h);
      if (!twin.valid()) continue;
      const FaceId g = adjacency_.face(twin);
      const bool inner = origins_[adjacency_.from(h)] == VertexOrigin::edge &&
                         origins_[adjacency_.to(h)] == VertexOrigin::edge;
      const bool in_middle = origins_[adjacency_.from(adjacency_.prev(h))] == VertexOrigin::edge;
      const VertexOrigin wanted =
          inner && in_middle ? VertexOrigin::old_vertex : VertexOrigin::edge;
      const VertexId beyond = adjacency_.from(adjacency_.prev(twin));
      if (origins_[beyond] != VertexOrigin::unknown && origins_[beyond] != wanted)
        return fmt::format("face {} would make vertex {} {}, its neighbours {}", g.value,
                           beyond.value, name_of(wanted), name_of(origins_[beyond]));
      origins_[beyond] = wanted;
      if (visited_[g] != 0) continue;
      visited_[g] = 1;
      queue_.push_back(g);
    }
    return {};
  }

  [[nodiscard]] std::string check_face(FaceId f) const {
    const auto corners = adjacency_.topology().face(f);
    const auto edges = std::count_if(corners.begin(), corners.end(),
                                     [&](VertexId v) { return origins_[v] == VertexOrigin::edge; });
    for (const VertexId v : corners) {
      const int wanted = adjacency_.is_boundary(v) ? 4 : 6;
      if (origins_[v] == VertexOrigin::edge && adjacency_.valence(v) != wanted)
        return fmt::format("vertex {} would be an edge point, but has {} edges", v.value,
                           adjacency_.valence(v));
    }
    if (edges < 2) return fmt::format("face {} would have two old vertices", f.value);
    for (int i = 0; i < 3 && edges == 3; ++i)
      if (!adjacency_.twin(adjacency_.topology().halfedge(f, i)).valid())
        return fmt::format("face {} would lie in the middle of four, but has a boundary", f.value);
    return {};
  }

  static const char* name_of(VertexOrigin origin) {
    return origin == VertexOrigin::old_vertex ? "an old vertex" : "an edge point";
  }

  const Adjacency& adjacency_;
  VertexOrigins& origins_;
  IdArray<FaceId, char> visited_;
  std::vector<FaceId> queue_;
};

}  // namespace

std::string label_triangles(const Adjacency& adjacency, const std::vector<FaceId>& component,
                            int first, VertexOrigins& origins) {
  return TriangleLabeller(adjacency, origins).label(component, first);
}

Unsplit unsplit_triangles(const Adjacency& adjacency, const VertexOrigins& origins,
                          const std::vector<FaceId>& faces, bool all_vertices) {
  const Topology& fine = adjacency.topology();
  Unsplit coarse;
  std::vector<VertexId> old;
  if (all_vertices)
    for (int v = 0; v < fine.num_vertices(); ++v)
      if (!adjacency.ring_start(VertexId(v)).valid()) old.emplace_back(v);
  std::vector<VertexId> corners;  // fine ids first
  for (const FaceId f : faces) {
    const auto middle = fine.face(f);
    if (std::any_of(middle.begin(), middle.end(),
                    [&](VertexId v) { return origins[v] != VertexOrigin::edge; }))
      continue;
    for (int i = 0; i < 3; ++i) {
      // The child (v_i, e_i, e_{i-1}) lies beyond the middle's side from e_{i-1} to e_i.
      const HalfedgeId twin = adjacency.twin(fine.halfedge(f, (i + 2) % 3));
      const HalfedgeId half = adjacency.prev(twin);
      corners.push_back(adjacency.from(half));
      coarse.child.push_back(adjacency.face(twin));
      coarse.half.push_back(half);
    }
  }
  old.insert(old.end(), corners.begin(), corners.end());
  std::sort(old.begin(), old.end());
  old.erase(std::unique(old.begin(), old.end()), old.end());
  for (VertexId& v : corners)
    v = VertexId(std::lower_bound(old.begin(), old.end(), v) - old.begin());
  coarse.topology = Topology(static_cast<int>(old.size()), 3, std::move(corners));
  coarse.old_vertex = std::move(old);
  return coarse;
}

}  // namespace limes
