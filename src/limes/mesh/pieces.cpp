#include "limes/mesh/pieces.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace limes {

IdArray<HalfedgeId, HalfedgeId> next_halfedges(const Topology& topology) {
  IdArray<HalfedgeId, HalfedgeId> next(static_cast<std::size_t>(topology.num_corners()));
  for (int f = 0; f < topology.num_faces(); ++f) {
    const int size = topology.face_size(FaceId(f));
    for (int i = 0; i < size; ++i)
      next[topology.halfedge(FaceId(f), i)] =
          topology.halfedge(FaceId(f), i + 1 == size ? 0 : i + 1);
  }
  return next;
}

namespace {

/// The other halfedge of every edge with exactly two; invalid elsewhere. Sides from a vertex to
/// itself have no direction and join nothing.
IdArray<HalfedgeId, HalfedgeId> find_partners(const Topology& topology, const EdgeGroups& edges) {
  const auto next = next_halfedges(topology);
  IdArray<HalfedgeId, HalfedgeId> partner(static_cast<std::size_t>(topology.num_corners()));
  for (std::size_t g = 0; g + 1 < edges.offsets.size(); ++g) {
    if (edges.offsets[g + 1] - edges.offsets[g] != 2) continue;
    const auto first = static_cast<std::size_t>(edges.offsets[g]);
    const HalfedgeId h = edges.halfedges[first];
    if (topology.corner(h) == topology.corner(next[h])) continue;
    partner[edges.halfedges[first]] = edges.halfedges[first + 1];
    partner[edges.halfedges[first + 1]] = edges.halfedges[first];
  }
  return partner;
}

/// Walks breadth first through one piece after the other and turns each face to run like the face
/// it was reached from.
class PieceWalk {
 public:
  PieceWalk(const Topology& topology, const EdgeGroups& edges)
      : topology_(topology),
        face_of_(faces_of_halfedges(topology)),
        partner_(find_partners(topology, edges)) {
    found_.piece.resize(static_cast<std::size_t>(topology.num_faces()), -1);
    found_.turned.resize(static_cast<std::size_t>(topology.num_faces()), 0);
  }

  FacePieces run() {
    for (int f = 0; f < topology_.num_faces(); ++f)
      if (found_.piece[FaceId(f)] < 0) walk_from(FaceId(f));
    return std::move(found_);
  }

 private:
  void walk_from(FaceId first) {
    reached_ = {first};
    found_.piece[first] = static_cast<int>(found_.pieces.size());
    found_.pieces.emplace_back();
    for (std::size_t i = 0; i < reached_.size(); ++i)
      visit(reached_[i]);
    finish_piece();
  }

  void visit(FaceId face) {
    Piece& piece = found_.pieces.back();
    for (int i = 0; i < topology_.face_size(face); ++i) {
      const HalfedgeId h = topology_.halfedge(face, i);
      const HalfedgeId other = partner_[h];
      if (!other.valid()) continue;
      const FaceId neighbour = face_of_[other];
      const bool same_way = topology_.corner(h) == topology_.corner(other);
      const char turned = static_cast<char>((found_.turned[face] != 0) != same_way);
      if (found_.piece[neighbour] < 0) {
        found_.piece[neighbour] = found_.piece[face];
        found_.turned[neighbour] = turned;
        reached_.push_back(neighbour);
      } else if (found_.turned[neighbour] != turned && piece.orientable) {
        piece.orientable = false;
        piece.clash = {std::min(h, other), std::max(h, other)};
      }
    }
  }

  void finish_piece() {
    Piece& piece = found_.pieces.back();
    piece.num_faces = static_cast<int>(reached_.size());
    for (const FaceId f : reached_)
      piece.num_turned += found_.turned[f];
    if (2 * piece.num_turned > piece.num_faces) {
      for (const FaceId f : reached_)
        found_.turned[f] = static_cast<char>(1 - found_.turned[f]);
      piece.num_turned = piece.num_faces - piece.num_turned;
    }
    if (!piece.orientable || piece.num_turned == 0) return;
    std::sort(reached_.begin(), reached_.end());
    for (const FaceId f : reached_)
      for (int i = 0; i < topology_.face_size(f); ++i) {
        const HalfedgeId h = topology_.halfedge(f, i);
        const HalfedgeId other = partner_[h];
        if (!other.valid() || topology_.corner(h) != topology_.corner(other)) continue;
        piece.clash = {h, other};
        return;
      }
  }

  const Topology& topology_;
  IdArray<HalfedgeId, FaceId> face_of_;
  IdArray<HalfedgeId, HalfedgeId> partner_;
  FacePieces found_;
  std::vector<FaceId> reached_;
};

}  // namespace

FacePieces find_pieces(const Topology& topology, const EdgeGroups& edges) {
  return PieceWalk(topology, edges).run();
}

IdArray<HalfedgeId, HalfedgeId> corner_fans(const Topology& topology, const EdgeGroups& edges) {
  const auto next = next_halfedges(topology);
  DisjointSets sets(topology.num_corners());
  for (std::size_t g = 0; g + 1 < edges.offsets.size(); ++g) {
    const HalfedgeId first = edges.halfedges[static_cast<std::size_t>(edges.offsets[g])];
    const bool to_itself = topology.corner(first) == topology.corner(next[first]);
    for (int k = edges.offsets[g]; k < edges.offsets[g + 1]; ++k) {
      const HalfedgeId h = edges.halfedges[static_cast<std::size_t>(k)];
      if (to_itself) {
        sets.join(h.value, next[h].value);
        continue;
      }
      const bool same_way = topology.corner(first) == topology.corner(h);
      sets.join(first.value, same_way ? h.value : next[h].value);
      sets.join(next[first].value, same_way ? next[h].value : h.value);
    }
  }
  IdArray<HalfedgeId, HalfedgeId> fans(static_cast<std::size_t>(topology.num_corners()));
  for (int h = 0; h < topology.num_corners(); ++h)
    fans[HalfedgeId(h)] = HalfedgeId(sets.find(h));
  return fans;
}

bool has_bow_ties(const Adjacency& adjacency) {
  int num_in_rings = 0;
  for (int v = 0; v < adjacency.topology().num_vertices(); ++v)
    num_in_rings += adjacency.num_ring_faces(VertexId(v));
  return num_in_rings != adjacency.topology().num_corners();
}

FansApart fans_apart(const Topology& topology) {
  const auto fans = corner_fans(topology, group_by_edge(topology));
  FansApart out;
  out.corners.assign(topology.corners().begin(), topology.corners().end());
  IdArray<VertexId, char> met(static_cast<std::size_t>(topology.num_vertices()), 0);
  for (int i = 0; i < topology.num_corners(); ++i) {
    const HalfedgeId h(i);
    const VertexId v = topology.corner(h);
    VertexId& corner = out.corners[static_cast<std::size_t>(i)];
    if (fans[h] != h) {
      corner = out.corners[static_cast<std::size_t>(fans[h].value)];
    } else if (met[v] == 0) {
      met[v] = 1;
    } else {
      corner = VertexId(topology.num_vertices() + static_cast<std::int64_t>(out.original.size()));
      out.original.push_back(v);
    }
  }
  return out;
}

std::span<const HalfedgeId> halfedges_between(const Topology& topology, const EdgeGroups& edges,
                                              const IdArray<HalfedgeId, HalfedgeId>& next,
                                              VertexId a, VertexId b) {
  using Ends = std::pair<VertexId, VertexId>;
  const Ends wanted = std::minmax(a, b);
  const auto ends_of = [&](int offset) -> Ends {
    const HalfedgeId h = edges.halfedges[static_cast<std::size_t>(offset)];
    return std::minmax(topology.corner(h), topology.corner(next[h]));
  };
  const auto last = edges.offsets.end() - 1;
  const auto group = std::partition_point(edges.offsets.begin(), last,
                                          [&](int offset) { return ends_of(offset) < wanted; });
  if (group == last || ends_of(*group) != wanted) return {};
  return std::span(edges.halfedges)
      .subspan(static_cast<std::size_t>(*group), static_cast<std::size_t>(*(group + 1) - *group));
}

DisjointSets::DisjointSets(int size) : parent_(static_cast<std::size_t>(size)) {
  std::iota(parent_.begin(), parent_.end(), 0);
}

int DisjointSets::find(int i) {
  const auto parent = [&](int k) -> int& { return parent_[static_cast<std::size_t>(k)]; };
  while (parent(i) != i) {
    parent(i) = parent(parent(i));  // halves the path on the way
    i = parent(i);
  }
  return i;
}

void DisjointSets::join(int a, int b) {
  a = find(a);
  b = find(b);
  parent_[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
}

}  // namespace limes
