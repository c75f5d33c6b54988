#include "limes/subdiv/forest.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "limes/core/error.h"
#include "limes/subdiv/refinement_step.h"
#include "limes/subdiv/schemes.h"

namespace limes {
namespace {

std::size_t as_index(int i) {
  return static_cast<std::size_t>(i);
}

bool only_triangles(const Topology& t) {
  return t.num_faces() > 0 && t.uniform_face_size() == 3;
}

Features checked_features(const Adjacency& control, const Mesh& mesh, const Scheme& scheme,
                          const RefineOptions& options) {
  if (scheme.boundary == Boundary::creases && options.boundary == BoundaryRule::none)
    throw InputError(
        "boundary rule none drops faces, which local refinement does not do; take rule edges or "
        "edges-and-corners");
  Features features = control_features(control, mesh, scheme, options);
  const RefinementStep refuses_what_does_not_fit(control, features, scheme);
  return features;
}

/// Corners of the children of a face, as uniform refinement orders them (split.h).
std::array<FaceCorners, 4> corners_of_children(const FaceCorners& v, const ChildNodes& made) {
  const auto& e = made.sides;
  if (!made.centre.valid())
    return {FaceCorners{v[0], e[0], e[2]}, FaceCorners{v[1], e[1], e[0]},
            FaceCorners{v[2], e[2], e[1]}, FaceCorners{e[0], e[1], e[2]}};
  std::array<FaceCorners, 4> children;
  for (std::size_t i = 0; i < 4; ++i)
    children[i] = {v[i], e[i], made.centre, e[(i + 3) % 4]};
  return children;
}

}  // namespace

const Scheme& forest_scheme(const Scheme& scheme, const Topology& control) {
  if (!is_quadrisection(scheme.split))
    throw UsageError(
        "--scheme: {} does not split faces into four; local refinement takes catmull-clark, "
        "kobbelt or linear on quads, loop, butterfly or linear on triangles",
        scheme.name);
  const bool either = scheme.patch == LimitPatch::bilinear;
  if (either && only_triangles(control)) return linear_triangles();
  const int size = regular_face_size(scheme);
  for (int f = 0; f < control.num_faces(); ++f)
    if (control.face_size(FaceId(f)) != size)
      throw InputError("face {} has {} corners; local refinement {}", f,
                       control.face_size(FaceId(f)),
                       size == 3 ? fmt::format("by {} needs triangles", scheme.name)
                       : either  ? "needs quads, which one step of refine makes, or triangles only"
                                 : "needs quads, which one step of refine makes");
  return scheme;
}

Forest::Forest(const Mesh& control, const Scheme& scheme, const RefineOptions& options,
               SplitUnit unit, LimitsOf limits, Placement placement)
    : Forest(std::make_shared<const Root>(control), forest_scheme(scheme, control.topology),
             options, unit, std::move(limits), std::move(placement)) {}

Forest::Forest(std::shared_ptr<const Root> root, const Scheme& scheme, const RefineOptions& options,
               SplitUnit unit, LimitsOf limits, Placement placement)
    : root_(std::move(root)),
      size_(regular_face_size(scheme)),
      unit_(size_ == 3 ? SplitUnit::faces : unit),
      nodes_(root_->adjacency, root_->mesh.points.span(),
             checked_features(root_->adjacency, root_->mesh, scheme, options), scheme,
             std::move(limits)),
      placement_(std::move(placement)) {
  LIMES_ASSERT(!placement_ || scheme.interpolatory);
  const Topology& topology = root_->mesh.topology;
  // Room for the first children, so that a small step does not copy the control faces.
  faces_.reserve(with_room(static_cast<std::size_t>(topology.num_faces())));
  faces_.resize(static_cast<std::size_t>(topology.num_faces()));
  root_offsets_.assign(static_cast<std::size_t>(topology.num_vertices()) + 1, 0);
  for (const VertexId v : topology.corners())
    ++root_offsets_[static_cast<std::size_t>(v.value) + 1];
  for (std::size_t v = 1; v < root_offsets_.size(); ++v)
    root_offsets_[v] += root_offsets_[v - 1];
  root_faces_.resize(topology.corners().size());
  std::vector<int> next(root_offsets_.begin(), root_offsets_.end() - 1);
  for (int i = 0; i < topology.num_faces(); ++i) {
    const FaceId f(i);
    std::copy_n(topology.face(f).begin(), size_, faces_[f].corners.begin());
    faces_[f].root = f;
    for (const VertexId v : topology.face(f)) {
      int& at = next[static_cast<std::size_t>(v.value)];
      root_faces_[static_cast<std::size_t>(at++)] = f;
    }
  }
}

bool Forest::before(FaceId a, FaceId b) const {
  const Face &x = face(a), &y = face(b);
  return x.root != y.root ? x.root < y.root : x.path < y.path;
}

template <class Visit>
void Forest::for_each_made_at(int level, VertexId v, const Visit& visit) const {
  if (level == 0) {
    // Only the first vertices are the control mesh's.
    const auto i = static_cast<std::size_t>(v.value);
    if (i + 1 >= root_offsets_.size()) return;
    for (int k = root_offsets_[i]; k < root_offsets_[i + 1]; ++k)
      visit(root_faces_[static_cast<std::size_t>(k)]);
    return;
  }
  const auto at = faces_at_.find(ForestNodes::level_key(level, v));
  if (at == faces_at_.end()) return;
  for (const FaceId f : at->second)
    visit(f);
}

std::vector<FaceId> Forest::faces_at(int level, VertexId v) const {
  std::vector<FaceId> faces;
  for_each_made_at(level, v, [&](FaceId f) {
    if (exists(f)) faces.push_back(f);
  });
  return faces;
}

FaceAncestry Forest::ancestry(FaceId f) const {
  return {face(f).root, face(f).level, face(f).path};
}

HalfedgeId Forest::control_side(FaceId f, int side) const {
  // Child i begins at corner i: its first side is half of its parent's side i, its last of i - 1.
  FaceId g = f;
  for (; face(g).parent.valid(); g = face(g).parent) {
    const bool in_the_middle = child_index(g) == size_;
    if (in_the_middle || (side != 0 && side != size_ - 1)) return {};
    side = (child_index(g) + side) % size_;
  }
  return root_->mesh.topology.halfedge(g, side);
}

std::vector<FaceId> Forest::leaves() const {
  std::vector<FaceId> all, open;
  for (int root = 0; root < root_->mesh.topology.num_faces(); ++root) {
    open.push_back(FaceId(root));
    while (!open.empty()) {
      const FaceId f = open.back();
      open.pop_back();
      if (!face(f).split) {
        all.push_back(f);
        continue;
      }
      for (int i = 3; i >= 0; --i)
        open.push_back(FaceId(face(f).first_child.value + i));
    }
  }
  return all;
}

/// What is split together with f.
std::vector<FaceId> Forest::family(FaceId f) const {
  const FaceId parent = face(f).parent;
  if (unit_ == SplitUnit::faces || !parent.valid()) return {f};
  const int first = face(parent).first_child.value;
  return {FaceId(first), FaceId(first + 1), FaceId(first + 2), FaceId(first + 3)};
}

void Forest::request(FaceId f, Levels& wanted, std::unordered_set<std::int32_t>& seen) const {
  for (const FaceId g : family(f)) {
    if (face(g).split || !seen.insert(g.value).second) continue;
    const auto level = static_cast<std::size_t>(face(g).level);
    if (wanted.size() <= level) wanted.resize(level + 1);
    wanted[level].push_back(g);
    request_around(g, wanted, seen);
  }
}

/// Faces of the parent's level, the parent among them, whose children share a vertex with one of the
/// parent's children; some may be visited twice.
template <class Visit>
void Forest::for_each_made_around_child(FaceId parent, int child, const Visit& visit) const {
  const int level = face(parent).level;
  // What shares a corner with a child at a corner, or the middle of a side, has the parent's corner.
  if (child < size_) return for_each_made_at(level, corners(parent)[as_index(child)], visit);
  for (int i = 0; i < size_; ++i) {
    const VertexId end = corners(parent)[as_index((i + 1) % size_)];
    for_each_made_at(level, corners(parent)[as_index(i)], [&](FaceId n) {
      const auto v = corners(n);
      if (std::find(v.begin(), v.end(), end) != v.end()) visit(n);
    });
  }
}

/// Before g can be split, all faces around its corners must exist on its level: those that its
/// parent's neighbours become.
void Forest::request_around(FaceId g, Levels& wanted,
                            std::unordered_set<std::int32_t>& seen) const {
  const FaceId parent = face(g).parent;
  if (!parent.valid()) return;
  for_each_made_around_child(parent, child_index(g), [&](FaceId n) {
    if (exists(n) && !face(n).split) request(n, wanted, seen);
  });
}

int Forest::refine(std::span<const FaceId> leaves) {
  Levels wanted;
  std::unordered_set<std::int32_t> seen;
  for (const FaceId f : leaves) {
    LIMES_ASSERT(exists(f) && !face(f).split);
    if (face(f).level == max_level)
      throw InputError(
          "face {} has a face on level {}, which cannot be split; {} levels are the most",
          face(f).root.value, max_level, max_level);
    request(f, wanted, seen);
  }
  for (const std::vector<FaceId>& faces : wanted) {
    make_children(faces);
    for (const FaceId f : faces)
      faces_[f].split = true;
  }
  return static_cast<int>(seen.size());
}

/// Adds the faces that share a vertex with a face of the patch; all are of one level.
void Forest::add_neighbours(std::vector<FaceId>& patch) const {
  const std::size_t num_before = patch.size();
  for (std::size_t i = 0; i < num_before; ++i) {
    const FaceId f = patch[i];
    for (const VertexId v : corners(f))
      for_each_made_at(face(f).level, v, [&](FaceId n) { patch.push_back(n); });
  }
  sort_unique(patch);
}

void Forest::sort_unique(std::vector<FaceId>& faces) const {
  // By number first: that needs no look at the faces, and most of them are there several times.
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  const auto in_order = [&](FaceId a, FaceId b) { return before(a, b); };
  if (!std::is_sorted(faces.begin(), faces.end(), in_order))
    std::sort(faces.begin(), faces.end(), in_order);
}

bool Forest::touches_curve(FaceId f) const {
  const auto v = corners(f);
  return std::any_of(v.begin(), v.end(), [&](VertexId x) { return nodes_.on_curve(x); });
}

/// The faces whose children lie around some faces of a level: those around it as a child of its parent, or
/// at all corners of the parent where two rings are needed.
std::vector<FaceId> Forest::parents_around(std::span<const FaceId> faces) const {
  std::vector<FaceId> around;
  for (const FaceId f : faces) {
    const FaceId parent = face(f).parent;
    if (!parent.valid()) continue;
    const auto add = [&](FaceId n) { around.push_back(n); };
    for_each_made_around_child(parent, child_index(f), add);
    if (!touches_curve(f)) continue;
    for (const VertexId v : corners(parent))
      for_each_made_at(face(parent).level, v, add);
  }
  sort_unique(around);
  return around;
}

/// What the children of some faces of a level depend on.
std::vector<FaceId> Forest::patch_around(std::span<const FaceId> faces) const {
  std::vector<FaceId> patch(faces.begin(), faces.end());
  add_neighbours(patch);
  std::vector<FaceId> wide;  // those where two rings are needed
  for (const FaceId f : faces)
    if (face(f).level == 0 || touches_curve(f)) wide.push_back(f);
  add_neighbours(wide);
  add_neighbours(wide);
  patch.insert(patch.end(), wide.begin(), wide.end());
  sort_unique(patch);
  return patch;
}

/// Makes the children of faces of one level that have none yet. What they depend on is made first:
/// usually it exists already, by balance. The patch is ordered like uniform refinement, so that rings
/// start where they do there: that makes positions equal bitwise.
void Forest::make_children(std::vector<FaceId> faces) {
  const auto has_children = [&](FaceId f) { return face(f).first_child.valid(); };
  faces.erase(std::remove_if(faces.begin(), faces.end(), has_children), faces.end());
  if (faces.empty()) return;
  sort_unique(faces);
  make_children(parents_around(faces));
  const int level = face(faces[0]).level;
  const std::vector<FaceId> patch = patch_around(faces);
  std::vector<FaceCorners> in_patch;
  std::vector<bool> wanted;
  for (const FaceId f : patch) {
    in_patch.push_back(face(f).corners);
    wanted.push_back(std::binary_search(faces.begin(), faces.end(), f,
                                        [&](FaceId a, FaceId b) { return before(a, b); }));
  }
  const int num_before = nodes_.size();
  const std::vector<ChildNodes> made = nodes_.make(level, in_patch, wanted);
  if (placement_) place(faces, made, num_before);
  for (std::size_t k = 0; k < faces.size(); ++k) {
    const FaceId f = faces[k];
    faces_[f].first_child = FaceId(faces_.size());
    const std::array<FaceCorners, 4> children = corners_of_children(face(f).corners, made[k]);
    for (std::size_t i = 0; i < 4; ++i) {
      Face child;
      child.corners = children[i];
      child.path = 4 * face(f).path + static_cast<std::int64_t>(i);
      child.root = face(f).root;
      child.parent = f;
      child.level = level + 1;
      const FaceId number(faces_.size());
      faces_.push_back(child);
      for (const VertexId v : corners(number))
        faces_at_[ForestNodes::level_key(level + 1, v)].push_back(number);
    }
  }
}

/// Moves the vertices made for the children of some faces; those from number `num_before` on are new.
void Forest::place(std::span<const FaceId> faces, std::span<const ChildNodes> made,
                   int num_before) {
  std::vector<char> placed(static_cast<std::size_t>(nodes_.size() - num_before), 0);
  for (std::size_t k = 0; k < faces.size(); ++k) {
    const FaceId root = face(faces[k]).root;
    std::array<Vec3, 4> corners, middles;
    for (std::size_t i = 0; i < as_index(size_); ++i) {
      const VertexId v = made[k].sides[i];
      const bool is_new = v.value >= num_before &&
                          !std::exchange(placed[static_cast<std::size_t>(v.value - num_before)], 1);
      if (is_new)
        nodes_.place(
            v, placement_(nodes_.position(v), root, control_side(faces[k], static_cast<int>(i))));
      corners[i] = nodes_.position(face(faces[k]).corners[i]);
      middles[i] = nodes_.position(v);
    }
    if (!made[k].centre.valid()) continue;
    nodes_.place(made[k].centre, placement_(between_sides(corners, middles), root, HalfedgeId()));
  }
}

std::vector<ChildNodes> Forest::child_nodes(std::span<const FaceId> faces) {
  Levels levels;
  for (const FaceId f : faces) {
    const auto level = static_cast<std::size_t>(face(f).level);
    if (levels.size() <= level) levels.resize(level + 1);
    levels[level].push_back(f);
  }
  for (std::vector<FaceId>& level : levels)
    make_children(std::move(level));
  std::vector<ChildNodes> nodes;
  for (const FaceId f : faces) {
    const int first = face(f).first_child.value;
    ChildNodes& n = nodes.emplace_back();
    for (int i = 0; i < size_; ++i)
      n.sides[as_index(i)] = corners(FaceId(first + i))[1];
    if (size_ == 4) n.centre = corners(FaceId(first))[2];
  }
  return nodes;
}

/// Whether no split face shares a vertex with the children of f, which are leaves.
bool Forest::can_merge(FaceId f) const {
  bool free = true;
  for (int i = 0; i < 4; ++i)
    for (const VertexId v : corners(child(f, i)))
      for_each_made_at(face(f).level + 1, v,
                       [&](FaceId n) { free = free && !(exists(n) && face(n).split); });
  return free;
}

int Forest::coarsen(std::span<const FaceId> leaves) {
  std::unordered_map<std::int32_t, int> marked;  // children of each parent
  std::vector<FaceId> sorted(leaves.begin(), leaves.end());
  std::sort(sorted.begin(), sorted.end());
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  Levels parents;
  for (const FaceId f : sorted) {
    LIMES_ASSERT(exists(f) && !face(f).split);
    const FaceId parent = face(f).parent;
    if (!parent.valid() || ++marked[parent.value] < 4) continue;
    const auto level = static_cast<std::size_t>(face(parent).level);
    if (parents.size() <= level) parents.resize(level + 1);
    parents[level].push_back(parent);
  }
  int merged = 0;
  // From the finest level on; what is merged on one level does not block others of that level.
  for (auto level = parents.rbegin(); level != parents.rend(); ++level)
    for (const FaceId f : *level) {
      if (!face(f).split) continue;  // merged with its family
      const std::vector<FaceId> together = family(f);
      const auto fits = [&](FaceId g) {
        const auto at = marked.find(g.value);
        return at != marked.end() && at->second == 4 && can_merge(g);
      };
      if (!std::all_of(together.begin(), together.end(), fits)) continue;
      for (const FaceId g : together)
        faces_[g].split = false;
      merged += static_cast<int>(together.size());
    }
  return merged;
}

}  // namespace limes
