#include "limes/study/shell_loads.h"

#include <cmath>
#include <memory>
#include <set>
#include <utility>
#include <vector>

#include "limes/core/error.h"
#include "limes/problem/selection.h"

namespace limes {
namespace {

/// Length of a side over that of its chord: of the cubic that meets both directors at right angles, to
/// first order. Sides that bend in the surface's plane, as rims of holes do, keep their chord.
double arc_over_chord(const ShellQuad& quad, int side) {
  const auto a = static_cast<std::size_t>(side), b = (a + 1) % 4;
  const Vec3 chord = (quad.x[b] - quad.x[a]).normalized();
  const auto slope = [&](std::size_t i) -> Vec3 {
    return -chord.dot(quad.director[i]) * quad.director[i];
  };
  const Vec3 m = slope(a), n = slope(b);
  return 1 + (2 * m.dot(m) - m.dot(n) + 2 * n.dot(n)) / 30;
}

class ShellLoad {
 public:
  ShellLoad(const ShellModel& model, const LoadSettings& load)
      : model_(model),
        load_(load),
        chosen_(*model.mesh, *model.adjacency, model.mesh->points.span(), load.where,
                load.origin.of("where")) {}

  void add_to(VectorX& f) const {
    switch (load_.kind) {
      case LoadKind::force:
      case LoadKind::moment:
        return at_vertices(f);
      case LoadKind::force_per_length:
        return along_edges(f);
      case LoadKind::force_per_area:
      case LoadKind::force_per_volume:
      case LoadKind::pressure:
        return on_faces(f);
      case LoadKind::source:
      case LoadKind::flux:
        break;  // refused by the reader of the file
    }
  }

  /// That a force per length acts on.
  [[nodiscard]] std::vector<HalfedgeId> edges() const {
    if (load_.kind != LoadKind::force_per_length) return {};
    const std::vector<HalfedgeId> chosen = chosen_.boundary_edges();
    if (chosen.empty())
      fail_at(load_.origin.of("where"),
              "'{}' selects no boundary edge; both ends of an edge must be selected", load_.where);
    std::vector<HalfedgeId> out;
    std::set<std::pair<VertexId, VertexId>> loaded;  // tied edges once
    for (const HalfedgeId h : chosen) {
      const VertexId a = model_.node[model_.adjacency->from(h)],
                     b = model_.node[model_.adjacency->to(h)];
      if (loaded.insert(std::minmax(a, b)).second) out.push_back(h);
    }
    return out;
  }
  /// That a force per area or volume, or a pressure acts on.
  [[nodiscard]] std::vector<FaceId> faces() const {
    if (load_.kind != LoadKind::force_per_area && load_.kind != LoadKind::force_per_volume &&
        load_.kind != LoadKind::pressure)
      return {};
    std::vector<FaceId> out = chosen_.faces();
    if (out.empty())
      fail_at(load_.origin.of("where"),
              "'{}' selects no face; all vertices of a face must be selected", load_.where);
    return out;
  }
  [[nodiscard]] Vec3 per_length(HalfedgeId side, const Vec3& x) const {
    const FaceId face = model_.adjacency->face(side);
    const double longer = model_.problem.mesh.exact
                              ? arc_over_chord(model_.quad(face), model_.faces.side(face, side))
                              : 1;
    return longer * value(x);
  }
  [[nodiscard]] Vec3 per_area(FaceId face, const Vec3& x, const Vec3& normal) const {
    if (load_.kind == LoadKind::pressure) return -component(0, x) * normal;
    const double factor =
        load_.kind == LoadKind::force_per_volume ? model_.section(face).thickness : 1;
    return factor * value(x);
  }

 private:
  [[nodiscard]] double component(std::size_t i, const Vec3& x) const {
    const double value = load_.value[i](x);
    if (!std::isfinite(value))
      fail_at(place_of_value(load_), "'{}' has no finite value at ({:.6g}, {:.6g}, {:.6g})",
              load_.value[i].text(), x.x(), x.y(), x.z());
    return value;
  }
  [[nodiscard]] Vec3 value(const Vec3& x) const {
    return {component(0, x), component(1, x), component(2, x)};
  }

  void require_carried(VertexId v, const Vec3& moment) const {
    if (!model_.smooth[v]) return;
    const double about = moment.dot(model_.director[model_.adjacency->ring_start(v)]);
    if (std::abs(about) > 1e-9 * moment.norm())
      fail_at(
          place_of_value(load_),
          "the moment at vertex {} has the part {:.6g} about the shell's normal, which a smooth "
          "shell does not carry; take it out",
          v.value, about);
  }

  void at_vertices(VectorX& f) const {
    const bool moment = load_.kind == LoadKind::moment;
    std::vector<char> loaded(chosen_.vertices().size(), 0);  // tied vertices once
    for (int v = 0; v < model_.mesh->points.size(); ++v) {
      const int node = model_.node[VertexId(v)].value;
      if (!chosen_.vertices()[static_cast<std::size_t>(v)]) continue;
      if (std::exchange(loaded[static_cast<std::size_t>(node)], 1)) continue;
      const Vec3 p = value(model_.mesh->points[VertexId(v)]);
      if (moment) require_carried(VertexId(v), p);
      f.segment<3>(6 * node + (moment ? 3 : 0)) += p;
    }
  }

  void along_edges(VectorX& f) const {
    for (const HalfedgeId h : edges()) {
      const FaceId face = model_.adjacency->face(h);
      model_.scatter(face,
                     shell_side_load(model_.quad(face), model_.faces.side(face, h),
                                     [&](const Vec3& x) { return per_length(h, x); }),
                     f);
    }
  }

  void on_faces(VectorX& f) const {
    for (const FaceId face : faces())
      model_.scatter(face,
                     shell_area_load(model_.quad(face),
                                     [&](const Vec3& x, const Vec3& normal) {
                                       return per_area(face, x, normal);
                                     }),
                     f);
  }

  const ShellModel& model_;
  const LoadSettings& load_;
  Selection chosen_;
};

/// A load, and which faces and sides it acts on.
struct PlacedLoad {
  ShellLoad load;
  IdArray<FaceId, char> faces;
  IdArray<HalfedgeId, char> sides;

  PlacedLoad(const ShellModel& model, const LoadSettings& settings)
      : load(model, settings),
        faces(static_cast<std::size_t>(model.mesh->topology.num_faces()), 0),
        sides(static_cast<std::size_t>(model.mesh->topology.num_corners()), 0) {
    for (const FaceId f : load.faces())
      faces[f] = 1;
    for (const HalfedgeId h : load.edges())
      sides[h] = 1;
  }
};

}  // namespace

VectorX assemble_shell_loads(const ShellModel& model) {
  VectorX f = VectorX::Zero(model.num_unknowns());
  for (const LoadSettings& load : model.problem.loads)
    ShellLoad(model, load).add_to(f);
  return f;
}

ShellLoadDensity shell_load_density(const ShellModel& model) {
  auto loads = std::make_shared<std::vector<PlacedLoad>>();
  for (const LoadSettings& load : model.problem.loads)
    loads->emplace_back(model, load);
  return {[loads](FaceId face, const Vec3& x, const Vec3& normal) {
            Vec3 sum = Vec3::Zero();
            for (const PlacedLoad& one : *loads)
              if (one.faces[face]) sum += one.load.per_area(face, x, normal);
            return sum;
          },
          [loads](HalfedgeId side, const Vec3& x) {
            Vec3 sum = Vec3::Zero();
            for (const PlacedLoad& one : *loads)
              if (one.sides[side]) sum += one.load.per_length(side, x);
            return sum;
          }};
}

}  // namespace limes
