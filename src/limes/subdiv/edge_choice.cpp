#include "limes/subdiv/edge_choice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "limes/core/error.h"
#include "limes/core/parallel.h"

namespace limes {
namespace {

/// The start and end of an edge's first halfedge.
std::array<VertexId, 2> ends_of(const Adjacency& mesh, EdgeId e) {
  const HalfedgeId h = mesh.halfedge(e);
  return {mesh.from(h), mesh.to(h)};
}

/// Where edges of equal length stand: by the first of their ends, then by their place around it.
class RadialOrder {
 public:
  explicit RadialOrder(const Adjacency& mesh)
      : mesh_(mesh),
        rank_(static_cast<std::size_t>(mesh.topology().num_vertices())),
        num_faces_(rank_.vector().size()),
        place_(static_cast<std::size_t>(mesh.topology().num_corners())) {
    for_each_index(rank_.size(), [&](std::int64_t v) { walk(VertexId(v)); });
  }

  struct Key {
    std::uint64_t rank;
    int place;
    friend auto operator<=>(const Key&, const Key&) = default;
  };
  [[nodiscard]] Key operator()(EdgeId e) const {
    const HalfedgeId h = mesh_.halfedge(e), twin = mesh_.twin(h);
    const VertexId a = mesh_.from(h), b = mesh_.to(h);
    if (rank_[a] < rank_[b]) return {rank_[a], place_[h]};
    // The last edge of a boundary vertex comes in only.
    return {rank_[b], twin.valid() ? place_[twin] : num_faces_[b]};
  }

 private:
  /// Rank of v, and places of the halfedges that leave it.
  void walk(VertexId v) {
    const HalfedgeId start = first_around(v);
    int count = 0;
    for (HalfedgeId h = start; h.valid();) {
      place_[h] = count++;
      h = mesh_.ring_next(h);
      if (h == start) break;
    }
    num_faces_[v] = count;
    const bool boundary = mesh_.is_boundary(v);
    const auto few_edges = static_cast<std::uint64_t>(INT32_MAX - count - (boundary ? 1 : 0));
    rank_[v] = (boundary ? std::uint64_t{1} << 62 : 0) | few_edges << 31 |
               static_cast<std::uint64_t>(v.value);
  }
  [[nodiscard]] HalfedgeId first_around(VertexId v) const {
    const HalfedgeId start = mesh_.ring_start(v);
    if (!start.valid() || mesh_.is_boundary(v)) return start;
    HalfedgeId first = start;
    for (HalfedgeId h = mesh_.ring_next(start); h != start; h = mesh_.ring_next(h))
      if (mesh_.to(h) < mesh_.to(first)) first = h;
    return first;
  }

  const Adjacency& mesh_;
  IdArray<VertexId, std::uint64_t> rank_;  // boundary, few edges, number: the lowest goes first
  IdArray<VertexId, int> num_faces_;
  IdArray<HalfedgeId, int> place_;
};

/// Sorts edges by (lower, higher) vertex.
void sort_by_vertices(const Adjacency& mesh, std::vector<EdgeId>& edges) {
  using Entry = std::pair<std::uint64_t, EdgeId>;
  std::vector<Entry> entries;
  entries.reserve(edges.size());
  for (const EdgeId e : edges) {
    const auto [a, b] = ends_of(mesh, e);
    const auto [low, high] = std::minmax(a, b);
    entries.emplace_back(
        static_cast<std::uint64_t>(low.value) << 32 | static_cast<std::uint64_t>(high.value), e);
  }
  std::sort(entries.begin(), entries.end());
  std::transform(entries.begin(), entries.end(), edges.begin(),
                 [](const Entry& entry) { return entry.second; });
}

struct LongEdge {
  double length;
  EdgeId edge;
};

/// All edges in the order in which they are asked.
std::vector<LongEdge> sorted_edges(const Adjacency& mesh, std::span<const Vec3> points) {
  std::vector<LongEdge> edges(static_cast<std::size_t>(mesh.num_edges()));
  for_each_index(mesh.num_edges(), [&](std::int64_t i) {
    const auto [a, b] = ends_of(mesh, EdgeId(i));
    const Vec3 d =
        points[static_cast<std::size_t>(a.value)] - points[static_cast<std::size_t>(b.value)];
    edges[static_cast<std::size_t>(i)] = {std::hypot(d.x(), d.y(), d.z()), EdgeId(i)};
  });
  std::sort(edges.begin(), edges.end(), [](const LongEdge& x, const LongEdge& y) {
    return x.length != y.length ? x.length > y.length : x.edge < y.edge;
  });

  const RadialOrder radial(mesh);
  for (auto first = edges.begin(); first != edges.end();) {
    const double least = first->length * (1.0 - equal_lengths);
    const auto last =
        std::find_if(first, edges.end(), [&](const LongEdge& e) { return e.length < least; });
    if (last - first > 1)
      std::sort(first, last, [&](const LongEdge& x, const LongEdge& y) {
        return radial(x.edge) < radial(y.edge);
      });
    first = last;
  }
  return edges;
}

}  // namespace

std::vector<EdgeId> longest_edges(const Adjacency& mesh, std::span<const Vec3> points) {
  IdArray<FaceId, char> taken(static_cast<std::size_t>(mesh.topology().num_faces()), 0);
  std::vector<EdgeId> chosen;
  for (const LongEdge& candidate : sorted_edges(mesh, points)) {
    const HalfedgeId h = mesh.halfedge(candidate.edge), twin = mesh.twin(h);
    if (taken[mesh.face(h)] || (twin.valid() && taken[mesh.face(twin)])) continue;
    taken[mesh.face(h)] = 1;
    if (twin.valid()) taken[mesh.face(twin)] = 1;
    chosen.push_back(candidate.edge);
  }
  sort_by_vertices(mesh, chosen);
  return chosen;
}

namespace {

/// The valence that each vertex has, or would have inside, in a regular 4-8 mesh.
class RegularValences {
 public:
  explicit RegularValences(const Adjacency& mesh)
      : mesh_(mesh), valence_(static_cast<std::size_t>(mesh.topology().num_vertices()), 0) {
    for (int v = 0; v < valence_.size(); ++v)
      if (mesh.ring_start(VertexId(v)).valid() && !mesh.is_boundary(VertexId(v)))
        set_interior(VertexId(v));
    while (!waiting_.empty()) {
      const VertexId v = waiting_.back();
      waiting_.pop_back();
      conclude_around(v);
    }
    for (int f = 0; f < mesh.topology().num_faces(); ++f)
      require_one_of_valence_4(FaceId(f));
  }
  [[nodiscard]] int operator[](VertexId v) const { return valence_[v]; }

 private:
  void set(VertexId v, int valence) {
    if (valence_[v] != 0) return;
    valence_[v] = valence;
    waiting_.push_back(v);
  }
  void set_interior(VertexId v) {
    const int valence = mesh_.valence(v);
    if (valence != 4 && valence != 8)
      throw InputError("vertex {} has {} edges; a regular 4-8 mesh has 4 or 8 at every vertex",
                       v.value, valence);
    set(v, valence);
  }
  /// What a face knows of two corners, or of its vertex of valence 4, it says of the others.
  void conclude_around(VertexId v) {
    const HalfedgeId start = mesh_.ring_start(v);
    for (HalfedgeId h = start; h.valid();) {
      const VertexId a = mesh_.to(h), b = mesh_.from(mesh_.prev(h));
      if (valence_[v] == 4) {
        set(a, 8);
        set(b, 8);
      } else if (valence_[a] == 8) {
        set(b, 4);
      } else if (valence_[b] == 8) {
        set(a, 4);
      }
      h = mesh_.ring_next(h);
      if (h == start) break;
    }
  }
  void require_one_of_valence_4(FaceId f) const {
    const auto corners = mesh_.topology().face(f);
    int fours = 0, eights = 0;
    for (const VertexId v : corners) {
      fours += valence_[v] == 4 ? 1 : 0;
      eights += valence_[v] == 8 ? 1 : 0;
    }
    if (fours != 1 || eights != 2)
      throw InputError(
          "face {} has not one vertex of valence 4 and two of valence 8, as every face of a "
          "regular "
          "4-8 mesh does",
          f.value);
  }

  const Adjacency& mesh_;
  IdArray<VertexId, int> valence_;  // 0: not known
  std::vector<VertexId> waiting_;   // known, but their faces were not asked
};

}  // namespace

std::vector<EdgeId> edges_between_valence_8(const Adjacency& mesh) {
  const RegularValences valence(mesh);
  std::vector<EdgeId> chosen;
  for (int e = 0; e < mesh.num_edges(); ++e) {
    const auto [a, b] = ends_of(mesh, EdgeId(e));
    if (valence[a] == 8 && valence[b] == 8) chosen.emplace_back(e);
  }
  sort_by_vertices(mesh, chosen);
  return chosen;
}

std::vector<EdgeId> newest_vertex_edges(const Adjacency& mesh) {
  std::vector<EdgeId> edges;
  for (int f = 0; f < mesh.topology().num_faces(); ++f) {
    const HalfedgeId h = mesh.topology().halfedge(FaceId(f), 1), twin = mesh.twin(h);
    LIMES_ASSERT(!twin.valid() || mesh.corner_index(twin) == 1);
    if (!twin.valid() || h < twin) edges.push_back(mesh.edge(h));
  }
  sort_by_vertices(mesh, edges);
  return edges;
}

}  // namespace limes
