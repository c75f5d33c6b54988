#include "limes/space/extended_mesh.h"

#include <algorithm>
#include <utility>

#include "limes/space/boundary_types.h"
#include "limes/subdiv/crease.h"

namespace limes {
namespace {

using Sources = std::vector<std::pair<VertexId, double>>;

/// Adds the ghost ring to a control mesh.
class GhostRing {
 public:
  GhostRing(const Adjacency& control, const Features& features, std::span<const Vec3> points)
      : control_(control),
        features_(features),
        types_(control, Sharpness(control, features), points),
        ghost_(types_.vertices().size()) {}

  ExtendedMesh build() {
    for (int i = 0; i < num_boundary(); ++i)
      if (at(i).type != GhostType::reentrant) add_ghosts(i);
    share_at_reentrant_corners();
    add_faces();
    ExtendedMesh out;
    out.num_control_vertices = control_.topology().num_vertices();
    out.num_control_faces = control_.topology().num_faces();
    for (Sources& s : sources_)
      out.ghosts.push_back({std::move(s)});
    for (const BoundaryVertex& b : types_.vertices())
      if (b.type == GhostType::standard) out.standard_vertices.push_back(b.vertex);
    out.topology = topology();
    const Adjacency extended(out.topology);
    out.features = resolve_tags(extended, tags(), BoundaryRule::edges);
    return out;
  }

 private:
  /// Ghosts of one boundary vertex: beyond the edge that comes in, beyond the edge that goes out
  /// (the same but for corners), and diagonally beyond a corner.
  struct Ghosts {
    VertexId before, after, diagonal;
  };

  [[nodiscard]] int num_boundary() const { return static_cast<int>(types_.vertices().size()); }
  [[nodiscard]] const BoundaryVertex& at(int i) const {
    return types_.vertices()[static_cast<std::size_t>(i)];
  }
  Ghosts& ghost(int i) { return ghost_[static_cast<std::size_t>(i)]; }

  VertexId new_ghost(Sources sources) {
    sources_.push_back(std::move(sources));
    return VertexId(control_.topology().num_vertices() +
                    static_cast<std::int64_t>(sources_.size()) - 1);
  }

  void add_ghosts(int i) {
    const BoundaryVertex& b = at(i);
    const VertexId v = b.vertex;
    if (b.type == GhostType::corner) {
      const VertexId previous = control_.from(b.in);
      const VertexId next = control_.to(b.out);
      const VertexId far = control_.to(control_.next(b.out));
      ghost(i) = {new_ghost({{v, 2.0}, {next, -1.0}}), new_ghost({{v, 2.0}, {previous, -1.0}}),
                  new_ghost({{v, 4.0}, {previous, -2.0}, {next, -2.0}, {far, 1.0}})};
      return;
    }
    // The inner neighbour; a standard vertex may have none or several, its ghost does not matter.
    const HalfedgeId inner = control_.ring_next(b.out);
    const VertexId g =
        inner.valid() ? new_ghost({{v, 2.0}, {control_.to(inner), -1.0}}) : new_ghost({{v, 1.0}});
    ghost(i) = {g, g, {}};
  }

  /// The ghost beyond the vertex before a re-entrant corner is the one beyond the vertex after it.
  void share_at_reentrant_corners() {
    for (int i = 0; i < num_boundary(); ++i) {
      if (at(i).type != GhostType::reentrant) continue;
      const int a = types_.previous(i);
      const int b = types_.next(i);
      const VertexId kept = std::min(ghost(a).after, ghost(b).before);
      const VertexId dropped = std::max(ghost(a).after, ghost(b).before);
      if (kept != dropped) replace(dropped, kept);
    }
    renumber();
  }

  void replace(VertexId old, VertexId by) {
    for (Ghosts& g : ghost_)
      for (VertexId* v : {&g.before, &g.after, &g.diagonal})
        if (*v == old) *v = by;
  }

  /// Closes the gaps that sharing left.
  void renumber() {
    const int first = control_.topology().num_vertices();
    std::vector<bool> used(sources_.size(), false);
    for (const Ghosts& g : ghost_)
      for (const VertexId v : {g.before, g.after, g.diagonal})
        if (v.valid()) used[static_cast<std::size_t>(v.value - first)] = true;
    std::vector<Sources> kept;
    std::vector<VertexId> number(sources_.size());
    for (std::size_t k = 0; k < sources_.size(); ++k) {
      if (!used[k]) continue;
      number[k] = VertexId(first + static_cast<std::int64_t>(kept.size()));
      kept.push_back(std::move(sources_[k]));
    }
    for (Ghosts& g : ghost_)
      for (VertexId* v : {&g.before, &g.after, &g.diagonal})
        if (v->valid()) *v = number[static_cast<std::size_t>(v->value - first)];
    sources_ = std::move(kept);
  }

  void add_faces() {
    for (int i = 0; i < num_boundary(); ++i) {
      const int j = types_.next(i);
      const VertexId v = at(i).vertex;
      if (at(i).type == GhostType::corner)
        add_quad(v, ghost(i).before, ghost(i).diagonal, ghost(i).after);
      if (at(i).type == GhostType::reentrant)
        add_quad(at(j).vertex, v, at(types_.previous(i)).vertex, ghost(j).before);
      if (at(i).type != GhostType::reentrant && at(j).type != GhostType::reentrant)
        add_quad(at(j).vertex, v, ghost(i).after, ghost(j).before);
    }
  }
  void add_quad(VertexId a, VertexId b, VertexId c, VertexId d) {
    ghost_corners_.insert(ghost_corners_.end(), {a, b, c, d});
  }

  [[nodiscard]] Topology topology() const {
    const Topology& t = control_.topology();
    std::vector<int> offsets{0};
    std::vector<VertexId> corners(t.corners().begin(), t.corners().end());
    for (int f = 0; f < t.num_faces(); ++f)
      offsets.push_back(offsets.back() + t.face_size(FaceId(f)));
    for (std::size_t k = 0; k < ghost_corners_.size(); k += 4)
      offsets.push_back(offsets.back() + 4);
    corners.insert(corners.end(), ghost_corners_.begin(), ghost_corners_.end());
    return {t.num_vertices() + static_cast<int>(sources_.size()), std::move(offsets),
            std::move(corners)};
  }

  /// Sharpness of the field: inside as given; along the boundary where functions stay standard;
  /// across it where a crease runs out.
  [[nodiscard]] Tags tags() const {
    Tags tags = tags_of(control_.topology(), features_);
    std::vector<bool> regular(static_cast<std::size_t>(control_.topology().num_vertices()), false);
    for (int i = 0; i < num_boundary(); ++i) {
      const BoundaryVertex& b = at(i);
      if (types_.crease_after(i))
        tags.creases.push_back({b.vertex, at(types_.next(i)).vertex, infinite_sharpness});
      if (types_.fully_standard(i)) continue;
      regular[static_cast<std::size_t>(b.vertex.value)] = true;
      if (b.type == GhostType::crease_end)
        tags.creases.push_back(
            {b.vertex, ghost_[static_cast<std::size_t>(i)].after, infinite_sharpness});
    }
    std::erase_if(tags.corners, [&](const CornerTag& t) {
      return regular[static_cast<std::size_t>(t.vertex.value)];
    });
    return tags;
  }

  const Adjacency& control_;
  const Features& features_;
  BoundaryTypes types_;
  std::vector<Ghosts> ghost_;
  std::vector<Sources> sources_;
  std::vector<VertexId> ghost_corners_;
};

}  // namespace

std::vector<Vec3> ExtendedMesh::continued(std::span<const Vec3> control) const {
  std::vector<Vec3> out(control.begin(), control.end());
  for (const Continuation& g : ghosts) {
    Vec3 x = Vec3::Zero();
    for (const auto& [v, weight] : g.sources)
      x += weight * control[static_cast<std::size_t>(v.value)];
    out.push_back(x);
  }
  return out;
}

ExtendedMesh without_ghosts(const Adjacency& control, const Features& features) {
  ExtendedMesh out;
  out.topology = control.topology();
  out.features = features;
  out.num_control_vertices = control.topology().num_vertices();
  out.num_control_faces = control.topology().num_faces();
  return out;
}

ExtendedMesh with_ghosts(const Adjacency& control, const Features& features,
                         std::span<const Vec3> points) {
  return GhostRing(control, features, points).build();
}

}  // namespace limes
