#include "limes/subdiv/forest.h"
#include "limes/mesh/face_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>
#include <utility>

#include "limes/core/error.h"
#include "limes/core/interrupt.h"
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

template <class Levels>
auto& faces_of_level(Levels& levels, int level) {
  if (levels.size() <= as_index(level)) levels.resize(as_index(level) + 1);
  return levels[as_index(level)];
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
      throw FaceError(FaceId(f), "face {} has {} corners; local refinement {}", f,
                      control.face_size(FaceId(f)),
                      size == 3 ? fmt::format("by {} needs triangles", scheme.name)
                      : either  ? "needs quads, which one step of refine makes, or triangles only"
                                : "needs quads, which one step of refine makes");
  return scheme;
}

Forest::Forest(const Mesh& control, const Scheme& scheme, const RefineOptions& options,
               SplitUnit unit, LimitsOf limits, Placement placement)
    : Forest(std::make_shared<const ControlMesh>(control), forest_scheme(scheme, control.topology),
             options, unit, std::move(limits), std::move(placement)) {}

Forest::Forest(std::shared_ptr<const ControlMesh> root, const Scheme& scheme,
               const RefineOptions& options, SplitUnit unit, LimitsOf limits, Placement placement)
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
  const int num_roots = root_->mesh.topology.num_faces();
  const auto i = as_index(v.value);
  FaceId f = i < last_face_at_.size() ? last_face_at_[i] : FaceId();
  while (f.valid()) {
    if (face(f).level == level) visit(f);
    const FaceCorners& all = face(f).corners;
    const auto corner = std::find(all.begin(), all.end(), v) - all.begin();
    f = face_before_[as_index(f.value - num_roots)][static_cast<std::size_t>(corner)];
  }
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

/// Faces, each once.
class Forest::Collection {
 public:
  explicit Collection(Forest& forest) : forest_(&forest) {}
  Collection(const Collection&) = delete;
  Collection& operator=(const Collection&) = delete;
  ~Collection() {
    for (const FaceId f : faces_)
      forest_->faces_[f].collected = false;
  }

  /// @return whether it was new
  bool add(FaceId f) {
    if (std::exchange(forest_->faces_[f].collected, true)) return false;
    faces_.push_back(f);
    return true;
  }
  /// The faces of a level that share a vertex with f.
  void add_around(FaceId f) {
    for (const VertexId v : forest_->corners(f))
      forest_->for_each_made_at(forest_->face(f).level, v, [&](FaceId n) { add(n); });
  }
  [[nodiscard]] const std::vector<FaceId>& faces() const { return faces_; }
  [[nodiscard]] std::vector<FaceId> in_order() const {
    std::vector<FaceId> faces = faces_;
    forest_->sort(faces);
    return faces;
  }

 private:
  Forest* forest_;
  std::vector<FaceId> faces_;
};

/// What is split together with f.
template <class Visit>
void Forest::for_family(FaceId f, const Visit& visit) const {
  const FaceId parent = face(f).parent;
  if (unit_ == SplitUnit::faces || !parent.valid()) return visit(f);
  for (int i = 0; i < 4; ++i)
    visit(child(parent, i));
}

void Forest::request(FaceId f, Collection& wanted) const {
  for_family(f, [&](FaceId g) {
    if (!face(g).split && wanted.add(g)) request_around(g, wanted);
  });
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
void Forest::request_around(FaceId g, Collection& wanted) const {
  const FaceId parent = face(g).parent;
  if (!parent.valid()) return;
  for_each_made_around_child(parent, child_index(g), [&](FaceId n) {
    if (exists(n) && !face(n).split) request(n, wanted);
  });
}

/// Some leaves and what must be split before them.
std::vector<FaceId> Forest::requested(std::span<const FaceId> leaves) {
  Collection wanted(*this);
  for (const FaceId f : leaves) {
    LIMES_ASSERT(exists(f) && !face(f).split);
    if (face(f).level == max_level)
      throw InputError(
          "face {} has a face on level {}, which cannot be split; {} levels are the most",
          face(f).root.value, max_level, max_level);
    request(f, wanted);
  }
  return wanted.faces();
}

int Forest::refine(std::span<const FaceId> leaves) {
  Levels levels;
  int num_split = 0;
  for (const FaceId f : requested(leaves)) {
    faces_of_level(levels, face(f).level).push_back(f);
    ++num_split;
  }
  for (const std::vector<FaceId>& faces : levels) {
    check_interrupt();  // between levels the forest is balanced
    make_children(faces);
    for (const FaceId f : faces)
      faces_[f].split = true;
  }
  return num_split;
}

void Forest::sort(std::vector<FaceId>& faces) const {
  const auto in_order = [&](FaceId a, FaceId b) { return before(a, b); };
  if (std::is_sorted(faces.begin(), faces.end(), in_order)) return;
  // By number first: that needs no look at the faces, and is nearly always enough.
  std::sort(faces.begin(), faces.end());
  if (!std::is_sorted(faces.begin(), faces.end(), in_order))
    std::sort(faces.begin(), faces.end(), in_order);
}

bool Forest::touches_curve(FaceId f) const {
  const auto v = corners(f);
  return std::any_of(v.begin(), v.end(), [&](VertexId x) { return nodes_.on_curve(x); });
}

/// The faces whose children lie around some faces of a level: those around it as a child of its parent, or
/// at all corners of the parent where two rings are needed.
std::vector<FaceId> Forest::parents_around(std::span<const FaceId> faces) {
  Collection around(*this);
  for (const FaceId f : faces) {
    const FaceId parent = face(f).parent;
    if (!parent.valid()) continue;
    const auto add = [&](FaceId n) { around.add(n); };
    for_each_made_around_child(parent, child_index(f), add);
    if (!touches_curve(f)) continue;
    for (const VertexId v : corners(parent))
      for_each_made_at(face(parent).level, v, add);
  }
  return around.in_order();
}

/// What the children of some faces of a level depend on.
std::vector<FaceId> Forest::patch_around(std::span<const FaceId> faces) {
  Collection patch(*this);
  const auto needs_two_rings = [&](FaceId f) { return face(f).level == 0 || touches_curve(f); };
  for (const FaceId f : faces)
    if (needs_two_rings(f)) patch.add(f);
  std::size_t begin = 0;
  for (int ring = 0; ring < 2; ++ring)
    for (const std::size_t end = patch.faces().size(); begin < end; ++begin)
      patch.add_around(patch.faces()[begin]);
  for (const FaceId f : faces)
    patch.add(f);
  for (const FaceId f : faces)
    if (!needs_two_rings(f)) patch.add_around(f);
  return patch.in_order();
}

/// Makes the children of faces of one level that have none yet. What they depend on is made first:
/// usually it exists already, by balance. The patch is ordered like uniform refinement, so that rings
/// start where they do there: that makes positions equal bitwise.
void Forest::make_children(std::vector<FaceId> faces) {
  const auto has_children = [&](FaceId f) { return face(f).first_child.valid(); };
  faces.erase(std::remove_if(faces.begin(), faces.end(), has_children), faces.end());
  if (faces.empty()) return;
  sort(faces);
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
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
  for (std::size_t k = 0; k < faces.size(); ++k)
    add_children(faces[k], made[k]);
}

void Forest::add_children(FaceId f, const ChildNodes& made) {
  const Face parent = face(f);
  const int first = faces_.size();
  faces_[f].first_child = FaceId(first);
  const std::array<FaceCorners, 4> children = corners_of_children(parent.corners, made);
  for (std::size_t i = 0; i < 4; ++i) {
    Face child;
    child.corners = children[i];
    child.path = 4 * parent.path + static_cast<std::int64_t>(i);
    child.root = parent.root;
    child.parent = f;
    child.level = parent.level + 1;
    faces_.push_back(child);
  }
  const std::size_t num_nodes = as_index(nodes_.size());
  if (last_face_at_.capacity() < num_nodes) last_face_at_.reserve(with_room(num_nodes));
  if (last_face_at_.size() < num_nodes) last_face_at_.resize(num_nodes);
  for (int i = 0; i < 4; ++i) {
    const FaceId id(first + i);
    std::array<FaceId, 4>& before = face_before_.emplace_back();
    const auto v = corners(id);
    for (std::size_t c = 0; c < v.size(); ++c)
      before[c] = std::exchange(last_face_at_[as_index(v[c].value)], id);
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
  for (const FaceId f : faces)
    faces_of_level(levels, face(f).level).push_back(f);
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
    faces_of_level(parents, face(parent).level).push_back(parent);
  }
  int merged = 0;
  // From the finest level on; what is merged on one level does not block others of that level.
  for (auto level = parents.rbegin(); level != parents.rend(); ++level)
    for (const FaceId f : *level) {
      if (!face(f).split) continue;  // merged with its family
      bool fits = true;
      for_family(f, [&](FaceId g) {
        const auto at = marked.find(g.value);
        fits = fits && at != marked.end() && at->second == 4 && can_merge(g);
      });
      if (!fits) continue;
      for_family(f, [&](FaceId g) {
        faces_[g].split = false;
        ++merged;
      });
    }
  return merged;
}

}  // namespace limes
