#include "limes/mesh/defects.h"

#include <array>
#include <cmath>

#include "limes/core/error.h"
#include "limes/mesh/defect_list.h"
#include "limes/mesh/duplicates.h"
#include "limes/mesh/pieces.h"

namespace limes {
namespace {

struct KindRow {
  DefectKind kind;
  std::string_view name;
  bool blocks_refinement;
  std::string_view repair;  // what repair() does about it; empty: nothing
};

constexpr std::array<KindRow, 15> kinds{{
    {DefectKind::missing_vertex, "missing-vertex", true, ""},
    {DefectKind::few_corners, "few-corners", true, ""},
    {DefectKind::repeated_corner, "repeated-corner", true, ""},
    {DefectKind::duplicate_face, "duplicate-face", true, "leaves one of them out"},
    {DefectKind::non_manifold_edge, "non-manifold-edge", true, ""},
    {DefectKind::non_orientable, "non-orientable", true, ""},
    {DefectKind::orientation, "orientation", true, "turns them"},
    {DefectKind::non_manifold_vertex, "non-manifold-vertex", true, "splits it"},
    {DefectKind::tag, "tag", true, "leaves it out"},
    {DefectKind::not_finite, "not-finite", true, ""},
    {DefectKind::coordinates, "coordinates", false, ""},
    {DefectKind::opposite_faces, "opposite-faces", false, ""},
    {DefectKind::zero_area, "zero-area", false, ""},
    {DefectKind::one_point, "one-point", false, ""},
    {DefectKind::unused_vertices, "unused-vertices", false, "removes them"},
}};

const KindRow& row(DefectKind kind) {
  return kinds[static_cast<std::size_t>(kind)];
}

/// Finds what does not depend on positions.
class TopologyCheck {
 public:
  TopologyCheck(const Mesh& mesh, DefectList& out)
      : mesh_(mesh),
        topology_(mesh.topology),
        face_of_(faces_of_halfedges(topology_)),
        next_(next_halfedges(topology_)),
        edges_(group_by_edge(topology_)),
        out_(out) {}

  void run() {
    check_corners();
    check_duplicates();
    check_edges();
    check_pieces();
    check_fans();
    check_tags();
    check_unused();
  }

 private:
  void check_corners();
  void check_duplicates();
  void check_edges();
  void check_pieces();
  void add_one_sided(const Piece& piece);
  void add_orientation(const Piece& piece, std::vector<FaceId> turned);
  void check_fans();
  void check_tags();
  void check_sharpness(float sharpness, std::vector<VertexId> vertices);
  void check_unused();

  bool exists(VertexId v) const { return v.valid() && v.value < topology_.num_vertices(); }

  const Mesh& mesh_;
  const Topology& topology_;
  IdArray<HalfedgeId, FaceId> face_of_;
  IdArray<HalfedgeId, HalfedgeId> next_;
  EdgeGroups edges_;
  DefectList& out_;
};

void TopologyCheck::check_corners() {
  std::vector<VertexId> scratch;
  for (int f = 0; f < topology_.num_faces(); ++f) {
    const auto face = topology_.face(FaceId(f));
    if (face.size() < 3)
      out_.add(DefectKind::few_corners, {FaceId(f)}, {},
               fmt::format("face {} has {} corners; three or more are right", f, face.size()));
    const VertexId twice = repeated_vertex(face, scratch);
    if (twice.valid())
      out_.add(DefectKind::repeated_corner, {FaceId(f)}, {twice},
               fmt::format("face {} has vertex {} at two corners; cut it into faces that have "
                           "each vertex once",
                           f, twice.value));
  }
}

void TopologyCheck::check_duplicates() {
  const DuplicateFaces found = find_duplicate_faces(topology_);
  const auto with_line = [&](FaceId face) {
    const int line = out_.line_of(face);
    return line > 0 ? fmt::format("{} (line {})", face.value, line) : std::to_string(face.value);
  };
  for (const auto& [earlier, later] : found.same_order)
    out_.add(DefectKind::duplicate_face, {earlier, later}, {},
             fmt::format("face {} repeats face {}", later.value, with_line(earlier)));
  for (const auto& [earlier, later] : found.opposite_order)
    out_.add(DefectKind::opposite_faces, {earlier, later}, {},
             fmt::format("face {} has the corners of face {} in opposite order", later.value,
                         with_line(earlier)));
}

void TopologyCheck::check_edges() {
  for (std::size_t g = 0; g + 1 < edges_.offsets.size(); ++g) {
    const int count = edges_.offsets[g + 1] - edges_.offsets[g];
    const HalfedgeId h = edges_.halfedges[static_cast<std::size_t>(edges_.offsets[g])];
    const VertexId a = topology_.corner(h), b = topology_.corner(next_[h]);
    if (count < 3 || a == b) continue;  // a == b: a corner twice in a row, reported as such
    std::vector<FaceId> faces;
    for (int k = edges_.offsets[g]; k < edges_.offsets[g + 1]; ++k)
      faces.push_back(face_of_[edges_.halfedges[static_cast<std::size_t>(k)]]);
    std::string message = fmt::format("edge {}-{} has {} faces ({}); at most two can be joined",
                                      a.value, b.value, count, list_ids(faces));
    out_.add(DefectKind::non_manifold_edge, std::move(faces), {a, b}, std::move(message));
  }
}

void TopologyCheck::check_pieces() {
  const FacePieces found = find_pieces(topology_, edges_);
  std::vector<std::vector<FaceId>> turned(found.pieces.size());
  for (int f = 0; f < topology_.num_faces(); ++f)
    if (found.turned[FaceId(f)] != 0)
      turned[static_cast<std::size_t>(found.piece[FaceId(f)])].emplace_back(f);
  for (std::size_t p = 0; p < found.pieces.size(); ++p) {
    if (!found.pieces[p].orientable)
      add_one_sided(found.pieces[p]);
    else if (found.pieces[p].num_turned > 0)
      add_orientation(found.pieces[p], std::move(turned[p]));
  }
}

void TopologyCheck::add_one_sided(const Piece& piece) {
  const auto [h, other] = piece.clash;
  const VertexId a = topology_.corner(h), b = topology_.corner(next_[h]);
  out_.add(DefectKind::non_orientable, {face_of_[h], face_of_[other]}, {a, b},
           fmt::format(
               "a piece of {} faces has one side only, like a Moebius strip (its twist "
               "closes at edge {}-{} between faces {} and {}); cut it open along a line of edges",
               piece.num_faces, a.value, b.value, face_of_[h].value, face_of_[other].value));
}

void TopologyCheck::add_orientation(const Piece& piece, std::vector<FaceId> turned) {
  const auto [h, other] = piece.clash;
  const VertexId a = topology_.corner(h), b = topology_.corner(next_[h]);
  std::string message = fmt::format(
      "faces {} and {} run along edge {}-{} in the same direction; turning {} of {} faces around "
      "mends this piece ({})",
      face_of_[h].value, face_of_[other].value, a.value, b.value, turned.size(), piece.num_faces,
      list_ids(turned));
  out_.add(DefectKind::orientation, std::move(turned), {a, b}, std::move(message));
}

void TopologyCheck::check_fans() {
  const auto fans = corner_fans(topology_, edges_);
  IdArray<VertexId, int> num_fans(static_cast<std::size_t>(topology_.num_vertices()), 0);
  for (int h = 0; h < topology_.num_corners(); ++h)
    if (fans[HalfedgeId(h)] == HalfedgeId(h)) ++num_fans[topology_.corner(HalfedgeId(h))];
  // the first face of every fan of the bow ties, ordered by vertex
  std::vector<std::pair<VertexId, FaceId>> firsts;
  for (int i = 0; i < topology_.num_corners(); ++i) {
    const HalfedgeId h(i);
    if (fans[h] == h && num_fans[topology_.corner(h)] > 1)
      firsts.emplace_back(topology_.corner(h), face_of_[h]);
  }
  std::stable_sort(firsts.begin(), firsts.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  for (std::size_t begin = 0, end = 0; begin < firsts.size(); begin = end) {
    const VertexId v = firsts[begin].first;
    std::vector<FaceId> faces;
    for (; end < firsts.size() && firsts[end].first == v; ++end)
      faces.push_back(firsts[end].second);
    std::string message = fmt::format(
        "vertex {} joins {} fans of faces that share no edge there (one face of each: {})", v.value,
        faces.size(), list_ids(faces));
    out_.add(DefectKind::non_manifold_vertex, std::move(faces), {v}, std::move(message));
  }
}

void TopologyCheck::check_sharpness(float sharpness, std::vector<VertexId> vertices) {
  if (sharpness >= 0) return;  // false for NaN
  out_.add(DefectKind::tag, {}, std::move(vertices),
           fmt::format("a tag has sharpness {}; 0 or more is right", sharpness));
}

void TopologyCheck::check_tags() {
  for (const CreaseTag& tag : mesh_.tags.creases) {
    check_sharpness(tag.sharpness, {tag.a, tag.b});
    if (!exists(tag.a) || !exists(tag.b) ||
        halfedges_between(topology_, edges_, next_, tag.a, tag.b).empty())
      out_.add(DefectKind::tag, {}, {tag.a, tag.b},
               fmt::format("a crease tag joins vertices {} and {}, which share no edge",
                           tag.a.value, tag.b.value));
  }
  for (const CornerTag& tag : mesh_.tags.corners) {
    check_sharpness(tag.sharpness, {tag.vertex});
    if (!exists(tag.vertex))
      out_.add(DefectKind::tag, {}, {tag.vertex},
               fmt::format("a corner tag marks vertex {}; the mesh has vertices 0 to {}",
                           tag.vertex.value, topology_.num_vertices() - 1));
  }
  for (const FaceId f : mesh_.tags.holes)
    if (!f.valid() || f.value >= topology_.num_faces())
      out_.add(DefectKind::tag, {}, {},
               fmt::format("a hole tag marks face {}; the mesh has faces 0 to {}", f.value,
                           topology_.num_faces() - 1));
}

void TopologyCheck::check_unused() {
  IdArray<VertexId, char> used(static_cast<std::size_t>(topology_.num_vertices()), 0);
  for (const VertexId v : topology_.corners())
    used[v] = 1;
  std::vector<VertexId> unused;
  for (int v = 0; v < topology_.num_vertices(); ++v)
    if (used[VertexId(v)] == 0) unused.emplace_back(v);
  if (unused.empty()) return;
  std::string message = fmt::format("no face uses {} of {} vertices ({})", unused.size(),
                                    topology_.num_vertices(), list_ids(unused));
  out_.add(DefectKind::unused_vertices, {}, std::move(unused), std::move(message));
}

/// Corners without a vertex; the other checks cannot run on such a mesh.
bool add_missing_vertices(const Topology& topology, DefectList& out) {
  bool any = false;
  for (int f = 0; f < topology.num_faces(); ++f)
    for (const VertexId v : topology.face(FaceId(f))) {
      if (v.valid() && v.value < topology.num_vertices()) continue;
      any = true;
      out.add(DefectKind::missing_vertex, {FaceId(f)}, {v},
              fmt::format("face {} names vertex {}; the mesh has vertices 0 to {}", f, v.value,
                          topology.num_vertices() - 1));
    }
  return any;
}

}  // namespace

std::string_view name_of(DefectKind kind) {
  return row(kind).name;
}

bool blocks_refinement(DefectKind kind) {
  return row(kind).blocks_refinement;
}

bool can_be_repaired(DefectKind kind) {
  return !row(kind).repair.empty();
}

std::vector<Defect> find_defects(const Mesh& mesh) {
  LIMES_ASSERT(mesh.points.size() == mesh.topology.num_vertices());
  DefectList defects(mesh);
  if (!add_missing_vertices(mesh.topology, defects)) {
    TopologyCheck(mesh, defects).run();
    add_geometric_defects(mesh, defects);
  }
  return defects.take();
}

void require_refinable(const Mesh& mesh, std::string_view file) {
  for (const Defect& defect : find_defects(mesh)) {
    if (!blocks_refinement(defect.kind)) continue;
    const std::string where =
        defect.line > 0 ? fmt::format("{}:{}", file, defect.line) : std::string(file);
    const std::string_view help = row(defect.kind).repair;
    throw InputError("{}: {}{}", where, defect.message,
                     help.empty() ? "" : fmt::format("; --repair {}", help));
  }
}

}  // namespace limes
