#include "limes/mesh/junctions.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "limes/core/error.h"
#include "limes/mesh/duplicates.h"
#include "limes/mesh/pieces.h"

namespace limes {
namespace {

/// One run of the cut.
class Cut {
 public:
  explicit Cut(const Mesh& mesh)
      : mesh_(mesh),
        edges_(group_by_edge(mesh.topology)),
        next_(next_halfedges(mesh.topology)),
        num_junctions_(static_cast<std::size_t>(mesh.topology.num_vertices()), 0),
        fans_(mesh.topology.num_corners()) {}

  CutMesh run();

 private:
  /// All halfedges along an edge.
  [[nodiscard]] std::span<const HalfedgeId> group(std::size_t g) const {
    return std::span(edges_.halfedges)
        .subspan(static_cast<std::size_t>(edges_.offsets[g]),
                 static_cast<std::size_t>(edges_.offsets[g + 1] - edges_.offsets[g]));
  }
  [[nodiscard]] bool is_junction(std::span<const HalfedgeId> along) const {
    return along.size() > 2 && corner(along[0]) != corner(next_[along[0]]);
  }
  [[nodiscard]] VertexId corner(HalfedgeId h) const { return mesh_.topology.corner(h); }
  void join_fans();
  void split_vertices();
  void require_apart() const;
  void move_creases();
  void set_corners(int num_before);

  const Mesh& mesh_;
  EdgeGroups edges_;
  IdArray<HalfedgeId, HalfedgeId> next_;
  IdArray<VertexId, int> num_junctions_;  // that end at a vertex
  DisjointSets fans_;                     // of corners
  std::vector<char> touches_;             // by fan: whether it has a junction
  std::vector<VertexId> corners_;         // of the faces, afterwards
  std::vector<VertexId> original_;        // of the copies
  CutMesh out_;
};

/// Corners at a vertex belong together over all edges but junctions.
void Cut::join_fans() {
  for (std::size_t g = 0; g + 1 < edges_.offsets.size(); ++g) {
    const auto along = group(g);
    if (is_junction(along)) {
      ++out_.num_edges;
      ++num_junctions_[corner(along[0])];
      ++num_junctions_[corner(next_[along[0]])];
      continue;
    }
    for (const HalfedgeId h : along.subspan(1)) {
      const bool same_way = corner(along[0]) == corner(h);
      fans_.join(along[0].value, (same_way ? h : next_[h]).value);
      fans_.join(next_[along[0]].value, (same_way ? next_[h] : h).value);
    }
  }
  touches_.assign(static_cast<std::size_t>(mesh_.topology.num_corners()), 0);
  for (std::size_t g = 0; g + 1 < edges_.offsets.size(); ++g)
    if (is_junction(group(g)))
      for (const HalfedgeId h : group(g))
        for (const HalfedgeId c : {h, next_[h]})
          touches_[static_cast<std::size_t>(fans_.find(c.value))] = 1;
}

void Cut::split_vertices() {
  corners_.assign(mesh_.topology.corners().begin(), mesh_.topology.corners().end());
  IdArray<VertexId, char> met(static_cast<std::size_t>(mesh_.topology.num_vertices()), 0);
  for (int h = 0; h < mesh_.topology.num_corners(); ++h) {
    const auto fan = static_cast<std::size_t>(fans_.find(h));
    const VertexId v = corner(HalfedgeId(h));
    VertexId& mine = corners_[static_cast<std::size_t>(h)];
    if (fan != static_cast<std::size_t>(h)) {
      mine = corners_[fan];  // named by its first corner
    } else if (touches_[fan] && met[v]) {
      mine = VertexId(out_.mesh.points.size());
      out_.mesh.points.push_back(mesh_.points[v]);
      original_.push_back(v);
    }
    met[v] = static_cast<char>(met[v] != 0 || touches_[fan] != 0);
  }
}

/// A junction of one edge whose ends both lie inside a piece does not cut it: faces on its two sides are
/// neighbours around the ends.
void Cut::require_apart() const {
  for (std::size_t g = 0; g + 1 < edges_.offsets.size(); ++g) {
    if (!is_junction(group(g))) continue;
    std::set<std::pair<VertexId, VertexId>> edges;
    for (const HalfedgeId h : group(g)) {
      const VertexId a = corners_[static_cast<std::size_t>(h.value)],
                     b = corners_[static_cast<std::size_t>(next_[h].value)];
      if (edges.insert(std::minmax(a, b)).second) continue;
      throw InputError(
          "the edge of vertices {} and {} has {} faces, and both ends lie inside a piece, which "
          "cannot be cut along one edge; split the edge once",
          corner(h).value, corner(next_[h]).value, group(g).size());
    }
  }
}

/// Those on junctions mean nothing any more, but do no harm.
void Cut::move_creases() {
  for (CreaseTag& tag : out_.mesh.tags.creases) {
    const auto along = halfedges_between(mesh_.topology, edges_, next_, tag.a, tag.b);
    if (along.empty()) continue;  // a defect, see find_defects()
    const HalfedgeId h = along.front();
    const bool forward = corner(h) == tag.a;
    tag.a = corners_[static_cast<std::size_t>((forward ? h : next_[h]).value)];
    tag.b = corners_[static_cast<std::size_t>((forward ? next_[h] : h).value)];
  }
}

void Cut::set_corners(int num_before) {
  IdArray<VertexId, float> sharpness(static_cast<std::size_t>(num_before), -1);
  for (const CornerTag& tag : mesh_.tags.corners)
    if (tag.vertex.valid() && tag.vertex.value < num_before) sharpness[tag.vertex] = tag.sharpness;
  for (int v = 0; v < num_before; ++v) {
    const int n = num_junctions_[VertexId(v)];
    if (n == 0 || n == 2) continue;
    sharpness[VertexId(v)] = infinite_sharpness;
    out_.mesh.tags.corners.push_back({VertexId(v), infinite_sharpness});
  }
  for (std::size_t i = 0; i < original_.size(); ++i)
    if (const float s = sharpness[original_[i]]; s >= 0)
      out_.mesh.tags.corners.push_back({VertexId(num_before + static_cast<int>(i)), s});
}

CutMesh Cut::run() {
  join_fans();
  out_.mesh = mesh_;
  if (out_.num_edges == 0) return std::move(out_);
  split_vertices();
  require_apart();
  const Topology& t = mesh_.topology;
  const int n = out_.mesh.points.size();
  if (t.uniform_face_size() > 0) {
    out_.mesh.topology = Topology(n, t.uniform_face_size(), corners_);
  } else {
    std::vector<int> offsets{0};
    for (int f = 0; f < t.num_faces(); ++f)
      offsets.push_back(offsets.back() + t.face_size(FaceId(f)));
    out_.mesh.topology = Topology(n, std::move(offsets), corners_);
  }
  move_creases();
  set_corners(t.num_vertices());
  return std::move(out_);
}

}  // namespace

CutMesh cut_junctions(const Mesh& mesh) {
  const auto corners = mesh.topology.corners();
  const bool complete = std::all_of(corners.begin(), corners.end(), [&](VertexId v) {
    return v.valid() && v.value < mesh.topology.num_vertices();
  });
  if (!complete) return {mesh};
  const DuplicateFaces twice = find_duplicate_faces(mesh.topology);
  if (!twice.same_order.empty() || !twice.opposite_order.empty()) return {mesh};
  return Cut(mesh).run();
}

std::vector<TiedEdge> junction_edges(const Mesh& mesh, const Adjacency& adjacency) {
  using Place = std::array<double, 6>;
  std::map<Place, std::vector<std::array<VertexId, 2>>> by_place;
  for (int h = 0; h < mesh.topology.num_corners(); ++h) {
    if (adjacency.twin(HalfedgeId(h)).valid()) continue;
    std::array ends{adjacency.from(HalfedgeId(h)), adjacency.to(HalfedgeId(h))};
    const auto key = [&] {
      const Vec3 &a = mesh.points[ends[0]], &b = mesh.points[ends[1]];
      return Place{a.x(), a.y(), a.z(), b.x(), b.y(), b.z()};
    };
    Place place = key();
    std::swap(ends[0], ends[1]);
    if (key() < place)
      place = key();
    else
      std::swap(ends[0], ends[1]);
    by_place[place].push_back(ends);
  }
  std::vector<TiedEdge> out;
  for (const auto& [place, edges] : by_place)
    for (std::size_t i = 0; edges.size() > 2 && i < edges.size(); ++i)
      for (std::size_t j = i + 1; j < edges.size(); ++j)
        out.push_back({edges[i], edges[j]});
  return out;
}

}  // namespace limes
