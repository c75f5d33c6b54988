#include "limes/mesh/repair.h"

#include <algorithm>
#include <utility>

#include "limes/core/error.h"
#include "limes/core/text.h"
#include "limes/mesh/defect_list.h"
#include "limes/mesh/duplicates.h"
#include "limes/mesh/pieces.h"

namespace limes {
namespace {

/// The steps change the mesh one after the other; each says what it did.
class Repair {
 public:
  explicit Repair(const Mesh& mesh) : mesh_(mesh) {
    for (int f = 0; f < mesh.topology.num_faces(); ++f)
      original_face_.push_back(FaceId(f));
  }

  RepairResult run() {
    require_vertices();
    drop_tags();
    drop_duplicates();
    turn_faces();
    split_bow_ties();
    remove_unused();
    return {std::move(mesh_), std::move(done_)};
  }

 private:
  void require_vertices() const;
  void drop_tags();
  void drop_duplicates();
  void keep_faces(const std::vector<FaceId>& kept);
  void turn_faces();
  void split_bow_ties();
  using Copy = std::pair<VertexId, VertexId>;  // the old vertex and the new one
  void move_creases(const std::vector<VertexId>& corners);
  void copy_corner_tags(const std::vector<Copy>& copies);
  void remove_unused();
  void set_corners(std::vector<VertexId> corners);

  std::vector<VertexId> corners() const {
    const auto all = mesh_.topology.corners();
    return {all.begin(), all.end()};
  }
  template <class... Args>
  void say(fmt::format_string<Args...> format, Args&&... args) {
    done_.push_back(fmt::format(format, std::forward<Args>(args)...));
  }

  Mesh mesh_;
  std::vector<FaceId> original_face_;  // of each face that is left
  std::vector<std::string> done_;
};

void Repair::require_vertices() const {
  const Topology& topology = mesh_.topology;
  for (int f = 0; f < topology.num_faces(); ++f)
    for (const VertexId v : topology.face(FaceId(f)))
      if (!v.valid() || v.value >= topology.num_vertices())
        throw InputError(
            "cannot be repaired: face {} names vertex {}; the mesh has vertices 0 to {}", f,
            v.value, topology.num_vertices() - 1);
}

/// Tags on what does not exist, and those with a negative sharpness.
void Repair::drop_tags() {
  const Topology& topology = mesh_.topology;
  const EdgeGroups edges = group_by_edge(topology);
  const auto next = next_halfedges(topology);
  const auto exists = [&](VertexId v) { return v.valid() && v.value < topology.num_vertices(); };
  Tags& tags = mesh_.tags;
  std::size_t dropped = std::erase_if(tags.creases, [&](const CreaseTag& t) {
    return !(t.sharpness >= 0) || !exists(t.a) || !exists(t.b) ||
           halfedges_between(topology, edges, next, t.a, t.b).empty();
  });
  dropped += std::erase_if(
      tags.corners, [&](const CornerTag& t) { return !(t.sharpness >= 0) || !exists(t.vertex); });
  dropped += std::erase_if(tags.holes,
                           [&](FaceId f) { return !f.valid() || f.value >= topology.num_faces(); });
  if (dropped > 0)
    say("left out {} on what does not exist or with a negative sharpness",
        counted(dropped, "tag", "tags"));
}

std::vector<int> offsets_of(const Topology& topology) {
  std::vector<int> offsets{0};
  for (int f = 0; f < topology.num_faces(); ++f)
    offsets.push_back(offsets.back() + topology.face_size(FaceId(f)));
  return offsets;
}

/// The same faces with other vertices at their corners; `corners` may name more vertices than
/// there were.
void Repair::set_corners(std::vector<VertexId> corners) {
  mesh_.topology = Topology(mesh_.points.size(), offsets_of(mesh_.topology), std::move(corners));
}

void Repair::drop_duplicates() {
  std::vector<FaceId> dropped;
  for (const FacePair& pair : find_duplicate_faces(mesh_.topology).same_order)
    dropped.push_back(pair.later);
  if (dropped.empty()) return;
  std::vector<FaceId> kept;
  for (const FaceId f : original_face_)
    if (!std::binary_search(dropped.begin(), dropped.end(), f)) kept.push_back(f);
  keep_faces(kept);
  say("left out {} an earlier one ({})",
      counted(dropped.size(), "face that repeats", "faces that repeat"), list_ids(dropped));
}

void Repair::keep_faces(const std::vector<FaceId>& kept) {
  std::vector<int> offsets{0};
  std::vector<VertexId> corners;
  std::vector<int> lines;
  IdArray<FaceId, FaceId> new_face(static_cast<std::size_t>(mesh_.topology.num_faces()));
  for (std::size_t i = 0; i < kept.size(); ++i) {
    const auto face = mesh_.topology.face(kept[i]);
    new_face[kept[i]] = FaceId(static_cast<std::int64_t>(i));
    corners.insert(corners.end(), face.begin(), face.end());
    offsets.push_back(static_cast<int>(corners.size()));
    if (!mesh_.face_lines.empty())
      lines.push_back(mesh_.face_lines[static_cast<std::size_t>(kept[i].value)]);
  }
  const auto renumber = [&](std::vector<FaceId>& faces) {
    for (FaceId& f : faces)
      f = new_face[f];
    std::erase_if(faces, [](FaceId f) { return !f.valid(); });
  };
  for (auto* groups : {&mesh_.groups, &mesh_.parts}) {
    for (FaceGroup& group : *groups)
      renumber(group.faces);
    std::erase_if(*groups, [](const FaceGroup& group) { return group.faces.empty(); });
  }
  renumber(mesh_.tags.holes);
  mesh_.topology = Topology(mesh_.points.size(), std::move(offsets), std::move(corners));
  mesh_.face_lines = std::move(lines);
  original_face_ = kept;
}

void Repair::turn_faces() {
  const Topology& topology = mesh_.topology;
  const FacePieces found = find_pieces(topology, group_by_edge(topology));
  for (const Piece& piece : found.pieces)
    if (!piece.orientable)
      throw InputError(
          "cannot be repaired: a piece of {} faces has one side only, like a Moebius "
          "strip; cut it open along a line of edges",
          piece.num_faces);
  std::vector<VertexId> turned_corners = corners();
  std::vector<FaceId> turned;
  for (int f = 0; f < topology.num_faces(); ++f) {
    if (found.turned[FaceId(f)] == 0) continue;
    const auto begin = turned_corners.begin() + topology.halfedge(FaceId(f), 0).value;
    std::reverse(begin + 1, begin + topology.face_size(FaceId(f)));  // the first corner stays
    turned.push_back(original_face_[static_cast<std::size_t>(f)]);
  }
  if (turned.empty()) return;
  set_corners(std::move(turned_corners));
  say("turned {} around so that neighbours run alike ({})", counted(turned.size(), "face", "faces"),
      list_ids(turned));
}

void Repair::split_bow_ties() {
  FansApart apart = fans_apart(mesh_.topology);
  std::vector<Copy> copies;
  for (const VertexId v : apart.original) {
    copies.push_back({v, VertexId(mesh_.points.size())});
    mesh_.points.push_back(mesh_.points[v]);
  }
  if (copies.empty()) return;
  std::sort(copies.begin(), copies.end());
  std::vector<VertexId> split;
  for (const Copy& copy : copies)
    if (split.empty() || split.back() != copy.first) split.push_back(copy.first);
  move_creases(apart.corners);
  copy_corner_tags(copies);
  set_corners(std::move(apart.corners));
  say("split {} where fans of faces met ({}); {} added",
      counted(split.size(), "vertex", "vertices"), list_ids(split),
      counted(copies.size(), "vertex", "vertices"));
}

/// Lets creases follow their edges; `corners` are the new ones. All sides along an edge lie in one
/// fan at each of its ends, so the first of them tells.
void Repair::move_creases(const std::vector<VertexId>& corners) {
  const Topology& topology = mesh_.topology;
  const EdgeGroups edges = group_by_edge(topology);
  const auto next = next_halfedges(topology);
  for (CreaseTag& tag : mesh_.tags.creases) {
    const HalfedgeId h = halfedges_between(topology, edges, next, tag.a, tag.b).front();
    const bool forward = topology.corner(h) == tag.a;
    tag.a = corners[static_cast<std::size_t>((forward ? h : next[h]).value)];
    tag.b = corners[static_cast<std::size_t>((forward ? next[h] : h).value)];
  }
}

/// Copies the tag that counts, which is the last, of every vertex that was split.
/// @param copies ascending
void Repair::copy_corner_tags(const std::vector<Copy>& copies) {
  IdArray<VertexId, float> sharpness(static_cast<std::size_t>(mesh_.topology.num_vertices()), -1);
  for (const CornerTag& tag : mesh_.tags.corners)
    sharpness[tag.vertex] = tag.sharpness;
  for (const auto& [vertex, copy] : copies)
    if (sharpness[vertex] >= 0) mesh_.tags.corners.push_back({copy, sharpness[vertex]});
}

void Repair::remove_unused() {
  IdArray<VertexId, VertexId> new_vertex(static_cast<std::size_t>(mesh_.points.size()));
  for (const VertexId v : mesh_.topology.corners())
    new_vertex[v] = VertexId(0);  // used; numbered below, in the old order
  IdArray<VertexId, Vec3> points;
  std::vector<VertexId> removed;
  for (int i = 0; i < mesh_.points.size(); ++i) {
    const VertexId v(i);
    if (!new_vertex[v].valid()) {
      removed.push_back(v);
      continue;
    }
    new_vertex[v] = VertexId(points.size());
    points.push_back(mesh_.points[v]);
  }
  if (removed.empty()) return;
  std::vector<VertexId> renumbered = corners();
  for (VertexId& v : renumbered)
    v = new_vertex[v];
  mesh_.points = std::move(points);
  set_corners(std::move(renumbered));

  Tags& tags = mesh_.tags;
  const std::size_t num_tags = tags.creases.size() + tags.corners.size();
  std::erase_if(tags.creases, [&](const CreaseTag& t) {
    return !new_vertex[t.a].valid() || !new_vertex[t.b].valid();
  });
  std::erase_if(tags.corners, [&](const CornerTag& t) { return !new_vertex[t.vertex].valid(); });
  const std::size_t lost = num_tags - tags.creases.size() - tags.corners.size();
  for (CreaseTag& t : tags.creases)
    t = {new_vertex[t.a], new_vertex[t.b], t.sharpness};
  for (CornerTag& t : tags.corners)
    t.vertex = new_vertex[t.vertex];
  say("removed {} of no face ({}){}", counted(removed.size(), "vertex", "vertices"),
      list_ids(removed), lost > 0 ? fmt::format(" with {}", counted(lost, "tag", "tags")) : "");
}

}  // namespace

RepairResult repair(const Mesh& mesh) {
  return Repair(mesh).run();
}

}  // namespace limes
