#include "limes/subdiv/quadrisection_labels.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "limes/core/error.h"

namespace limes {

std::vector<std::vector<FaceId>> edge_components(const Adjacency& adjacency) {
  const Topology& topology = adjacency.topology();
  std::vector<bool> seen(static_cast<std::size_t>(topology.num_faces()), false);
  std::vector<std::vector<FaceId>> components;
  for (int first = 0; first < topology.num_faces(); ++first) {
    if (seen[static_cast<std::size_t>(first)]) continue;
    seen[static_cast<std::size_t>(first)] = true;
    std::vector<FaceId> component{FaceId(first)};
    for (std::size_t next = 0; next < component.size(); ++next) {
      const FaceId f = component[next];
      for (int i = 0; i < topology.face_size(f); ++i) {
        const HalfedgeId twin = adjacency.twin(topology.halfedge(f, i));
        if (!twin.valid()) continue;
        const FaceId g = adjacency.face(twin);
        if (seen[static_cast<std::size_t>(g.value)]) continue;
        seen[static_cast<std::size_t>(g.value)] = true;
        component.push_back(g);
      }
    }
    std::sort(component.begin(), component.end());
    components.push_back(std::move(component));
  }
  return components;
}

namespace {

/// The labels of a child face, from its old corner on.
constexpr std::array pattern{VertexOrigin::old_vertex, VertexOrigin::edge, VertexOrigin::face,
                             VertexOrigin::edge};

const char* name_of(VertexOrigin origin) {
  switch (origin) {
    case VertexOrigin::old_vertex:
      return "an old vertex";
    case VertexOrigin::edge:
      return "an edge point";
    default:
      return "a face point";
  }
}

/// Walks from face to face; each face has its old corner at one of its four corners.
class Labeller {
 public:
  Labeller(const Adjacency& adjacency, VertexOrigins& origins, std::vector<bool>& visited)
      : adjacency_(adjacency), origins_(origins), visited_(visited) {}

  std::string label(const std::vector<FaceId>& component, int first_old) {
    for (const FaceId f : component) {
      visited_[static_cast<std::size_t>(f.value)] = false;
      for (const VertexId v : adjacency_.topology().face(f))
        origins_[v] = VertexOrigin::unknown;
    }
    std::string why = label_face(component.front(), first_old);
    for (std::size_t next = 0; next < queue_.size() && why.empty(); ++next)
      why = label_neighbours(queue_[next]);
    for (std::size_t i = 0; i < component.size() && why.empty(); ++i)
      for (const VertexId v : adjacency_.topology().face(component[i]))
        if (why.empty()) why = check_valence(v);
    return why;
  }

 private:
  std::string label_face(FaceId f, int old_corner) {
    const auto corners = adjacency_.topology().face(f);
    for (int i = 0; i < 4; ++i) {
      const VertexId v = corners[static_cast<std::size_t>((old_corner + i) % 4)];
      const VertexOrigin wanted = pattern[static_cast<std::size_t>(i)];
      if (origins_[v] != VertexOrigin::unknown && origins_[v] != wanted)
        return fmt::format("face {} would make vertex {} {}, its neighbours {}", f.value, v.value,
                           name_of(wanted), name_of(origins_[v]));
      origins_[v] = wanted;
    }
    visited_[static_cast<std::size_t>(f.value)] = true;
    queue_.push_back(f);
    return {};
  }

  std::string label_neighbours(FaceId f) {
    for (int i = 0; i < 4; ++i) {
      const HalfedgeId twin = adjacency_.twin(adjacency_.topology().halfedge(f, i));
      if (!twin.valid()) continue;
      const FaceId g = adjacency_.face(twin);
      if (visited_[static_cast<std::size_t>(g.value)]) continue;
      // The two labels of the shared edge fix the other two.
      const int side = adjacency_.corner_index(twin);
      const VertexOrigin from = origins_[adjacency_.from(twin)];
      const VertexOrigin to = origins_[adjacency_.to(twin)];
      for (int k = 0; k < 4; ++k)
        if (pattern[static_cast<std::size_t>(k)] == from &&
            pattern[static_cast<std::size_t>((k + 1) % 4)] == to)
          if (std::string why = label_face(g, (side - k + 4) % 4); !why.empty()) return why;
    }
    return {};
  }

  [[nodiscard]] std::string check_valence(VertexId v) const {
    const int valence = adjacency_.valence(v);
    const bool boundary = adjacency_.is_boundary(v);
    if (origins_[v] == VertexOrigin::edge && valence != (boundary ? 3 : 4))
      return fmt::format("vertex {} would be an edge point, but has {} edges", v.value, valence);
    if (origins_[v] == VertexOrigin::face && boundary)
      return fmt::format("vertex {} would be a face point, but lies on the boundary", v.value);
    if (origins_[v] == VertexOrigin::face && valence < 3)
      return fmt::format("vertex {} would be the point of a face with {} corners", v.value,
                         valence);
    return {};
  }

  const Adjacency& adjacency_;
  VertexOrigins& origins_;
  std::vector<bool>& visited_;  // by face
  std::vector<FaceId> queue_;
};

/// Halfedge of a child that starts at its old corner.
HalfedgeId half_of(const Adjacency& adjacency, const VertexOrigins& origins, FaceId child) {
  for (int i = 0; i < 4; ++i) {
    const HalfedgeId h = adjacency.topology().halfedge(child, i);
    if (origins[adjacency.from(h)] == VertexOrigin::old_vertex) return h;
  }
  throw InternalError("unsplit: a face without an old vertex");
}

/// Children of the coarse face around a face point, counter-clockwise, the lowest first.
std::vector<FaceId> children_around(const Adjacency& adjacency, VertexId face_point) {
  std::vector<FaceId> children;
  const HalfedgeId start = adjacency.ring_start(face_point);
  for (HalfedgeId h = start;;) {
    children.push_back(adjacency.face(h));
    h = adjacency.ring_next(h);
    if (h == start) break;
  }
  std::rotate(children.begin(), std::min_element(children.begin(), children.end()), children.end());
  return children;
}

}  // namespace

QuadrisectionLabels::QuadrisectionLabels(const Adjacency& adjacency)
    : adjacency_(&adjacency),
      origins_(static_cast<std::size_t>(adjacency.topology().num_vertices()),
               VertexOrigin::unknown),
      visited_(static_cast<std::size_t>(adjacency.topology().num_faces()), false) {}

std::string QuadrisectionLabels::label(const std::vector<FaceId>& component, int first_old) {
  return Labeller(*adjacency_, origins_, visited_).label(component, first_old);
}

Unsplit unsplit(const Adjacency& adjacency, const VertexOrigins& origins,
                const std::vector<FaceId>& faces, bool all_vertices) {
  const Topology& fine = adjacency.topology();
  Unsplit coarse;
  std::vector<VertexId> old;
  if (all_vertices)
    for (int v = 0; v < fine.num_vertices(); ++v)
      if (!adjacency.ring_start(VertexId(v)).valid()) old.emplace_back(v);
  std::vector<int> offsets{0};
  std::vector<VertexId> corners;  // fine ids first
  for (const FaceId f : faces) {
    const VertexId face_point = adjacency.to(adjacency.next(half_of(adjacency, origins, f)));
    const std::vector<FaceId> children = children_around(adjacency, face_point);
    if (children.front() != f) continue;  // each coarse face once, at its first child
    coarse.face_point.push_back(face_point);
    for (const FaceId child : children) {
      const HalfedgeId h = half_of(adjacency, origins, child);
      corners.push_back(adjacency.from(h));
      coarse.child.push_back(child);
      coarse.half.push_back(h);
    }
    offsets.push_back(static_cast<int>(corners.size()));
  }
  old.insert(old.end(), corners.begin(), corners.end());
  std::sort(old.begin(), old.end());
  old.erase(std::unique(old.begin(), old.end()), old.end());
  for (VertexId& v : corners)
    v = VertexId(std::lower_bound(old.begin(), old.end(), v) - old.begin());
  coarse.topology = Topology(static_cast<int>(old.size()), std::move(offsets), std::move(corners));
  coarse.old_vertex = std::move(old);
  return coarse;
}

}  // namespace limes
