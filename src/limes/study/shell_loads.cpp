#include "limes/study/shell_loads.h"

#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "limes/core/error.h"
#include "limes/study/selection.h"

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
                model.problem.file.string(), load.where_line) {}

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

 private:
  [[nodiscard]] InputError error(const std::string& what) const {
    return InputError("{}:{}: {}", model_.problem.file.string(), load_.line, what);
  }
  [[nodiscard]] double component(std::size_t i, const Vec3& x) const {
    const double value = load_.value[i](x);
    if (!std::isfinite(value))
      throw error(fmt::format("'{}' has no finite value at ({:.6g}, {:.6g}, {:.6g})",
                              load_.value[i].text(), x.x(), x.y(), x.z()));
    return value;
  }
  [[nodiscard]] Vec3 value(const Vec3& x) const {
    return {component(0, x), component(1, x), component(2, x)};
  }

  void require_carried(VertexId v, const Vec3& moment) const {
    if (!model_.smooth[v]) return;
    const double about = moment.dot(model_.director[model_.adjacency->ring_start(v)]);
    if (std::abs(about) > 1e-9 * moment.norm())
      throw error(
          fmt::format("the moment at vertex {} has the part {:.6g} about the shell's normal, "
                      "which a smooth shell does not carry; take it out",
                      v.value, about));
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
    const std::vector<HalfedgeId> edges = chosen_.boundary_edges();
    if (edges.empty())
      throw error(fmt::format(
          "'{}' selects no boundary edge; both ends of an edge must be selected", load_.where));
    std::set<std::pair<VertexId, VertexId>> loaded;  // tied edges once
    for (const HalfedgeId h : edges) {
      if (!loaded
               .insert(std::minmax(model_.node[model_.adjacency->from(h)],
                                   model_.node[model_.adjacency->to(h)]))
               .second)
        continue;
      const FaceId face = model_.adjacency->face(h);
      const ShellQuad quad = model_.quad(face);
      const int side = model_.adjacency->corner_index(h);
      const double longer = model_.problem.mesh.exact ? arc_over_chord(quad, side) : 1;
      model_.scatter(
          face,
          shell_side_load(quad, side, [&](const Vec3& x) -> Vec3 { return longer * value(x); }), f);
    }
  }

  void on_faces(VectorX& f) const {
    const std::vector<FaceId> faces = chosen_.faces();
    if (faces.empty())
      throw error(fmt::format("'{}' selects no face; all vertices of a face must be selected",
                              load_.where));
    for (const FaceId face : faces) {
      const double factor =
          load_.kind == LoadKind::force_per_volume ? model_.section(face).thickness : 1;
      model_.scatter(face,
                     shell_area_load(model_.quad(face),
                                     [&](const Vec3& x, const Vec3& normal) -> Vec3 {
                                       if (load_.kind == LoadKind::pressure)
                                         return -component(0, x) * normal;
                                       return factor * value(x);
                                     }),
                     f);
    }
  }

  const ShellModel& model_;
  const LoadSettings& load_;
  Selection chosen_;
};

}  // namespace

VectorX assemble_shell_loads(const ShellModel& model) {
  VectorX f = VectorX::Zero(model.num_unknowns());
  for (const LoadSettings& load : model.problem.loads)
    ShellLoad(model, load).add_to(f);
  return f;
}

}  // namespace limes
