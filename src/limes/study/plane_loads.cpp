#include "limes/study/plane_loads.h"

#include <cmath>

#include "limes/core/error.h"
#include "limes/fem/load.h"
#include "limes/problem/selection.h"
#include "limes/space/element_of_face.h"
#include "limes/study/supports.h"

namespace limes {
namespace {

class LoadAssembler {
 public:
  LoadAssembler(const PlaneModel& model, const LoadSettings& load)
      : model_(model), load_(load), chosen_(model.selection(load.where, load.origin.of("where"))) {}

  VectorX assemble() {
    if (load_.kind != LoadKind::pressure && !load_.value[2].is_zero())
      fail_at(place_of_value(load_), "plane models carry no load in z; make it 0");
    switch (load_.kind) {
      case LoadKind::moment:
      case LoadKind::source:
      case LoadKind::flux:
        break;  // refused by the reader of the file
      case LoadKind::force:
        return at_vertices();
      case LoadKind::force_per_length:
        return along_sides(
            [&](const Vec3& x, const Vec2&, double /*thickness*/) { return value(x); });
      case LoadKind::pressure:
        return along_sides([&](const Vec3& x, const Vec2& n, double thickness) -> Vec2 {
          return -component(0, x) * thickness * n;
        });
      case LoadKind::force_per_area:
        return on_faces([&](const Vec3& x, double /*thickness*/) { return value(x); });
      case LoadKind::force_per_volume:
        return on_faces(
            [&](const Vec3& x, double thickness) -> Vec2 { return thickness * value(x); });
    }
    return {};
  }

 private:
  [[nodiscard]] double component(std::size_t i, const Vec3& x) const {
    const double value = load_.value[i](x);
    if (!std::isfinite(value))
      fail_at(place_of_value(load_), "'{}' has no finite value at ({:.6g}, {:.6g})",
              load_.value[i].text(), x.x(), x.y());
    return value;
  }
  [[nodiscard]] Vec2 value(const Vec3& x) const { return {component(0, x), component(1, x)}; }

  VectorX at_vertices() {
    VectorX f = zero();
    for (std::size_t v = 0; v < chosen_.vertices().size(); ++v) {
      if (!chosen_.vertices()[v]) continue;
      const VertexId vertex(static_cast<std::int64_t>(v));
      if (!add_point_load(*model_.space, vertex, value(model_.limit_points[vertex]), f))
        fail_at(load_.origin.of("where"), "vertex {} belongs to holes only and carries no force",
                v);
    }
    return f;
  }

  [[nodiscard]] VectorX zero() const {
    return VectorX::Zero(2 * static_cast<Eigen::Index>(model_.space->num_dofs()));
  }

  /// @param p  force per length, of a point, the normal and the thickness
  template <class Traction>
  VectorX along_sides(const Traction& p) {
    const std::vector<HalfedgeId> sides = selected_sides(model_, chosen_);
    if (sides.empty())
      fail_at(load_.origin.of("where"),
              "'{}' selects no boundary edge; both ends of an edge must be selected", load_.where);
    const std::vector<int> element = element_of_face(*model_.space);
    VectorX f = zero();
    // One assembly per material: thicknesses differ.
    for (int m = 0; m < static_cast<int>(model_.problem.materials.size()); ++m) {
      std::vector<HalfedgeId> own;
      for (const HalfedgeId h : sides) {
        const int e = element[static_cast<std::size_t>(model_.adjacency().face(h).value)];
        if (model_.material_of_element[static_cast<std::size_t>(e)] == m) own.push_back(h);
      }
      if (own.empty()) continue;
      const double thickness = model_.problem.materials[static_cast<std::size_t>(m)].thickness;
      f += side_load(*model_.space, own,
                     [&](const Vec3& x, const Vec2& n) { return p(x, n, thickness); });
    }
    return f;
  }

  /// @param p  force per area, of a point and the thickness
  template <class Density>
  VectorX on_faces(const Density& p) {
    std::vector<bool> face(static_cast<std::size_t>(model_.mesh().topology.num_faces()), false);
    const std::vector<FaceId> faces = chosen_.faces();
    if (faces.empty())
      fail_at(load_.origin.of("where"),
              "'{}' selects no face; all vertices of a face must be selected", load_.where);
    for (const FaceId f : faces)
      face[static_cast<std::size_t>(f.value)] = true;
    // One assembly per material: thicknesses differ.
    VectorX f = zero();
    for (int m = 0; m < static_cast<int>(model_.problem.materials.size()); ++m) {
      std::vector<bool> chosen;
      for (std::size_t e = 0; e < model_.material_of_element.size(); ++e)
        chosen.push_back(model_.material_of_element[e] == m &&
                         face[static_cast<std::size_t>(model_.space->elements()[e].face.value)]);
      const double thickness = model_.problem.materials[static_cast<std::size_t>(m)].thickness;
      f += body_load(*model_.space, chosen, [&](const Vec3& x) { return p(x, thickness); });
    }
    return f;
  }

  const PlaneModel& model_;
  const LoadSettings& load_;
  Selection chosen_;
};

}  // namespace

VectorX assemble_loads(const PlaneModel& model) {
  VectorX f = VectorX::Zero(2 * static_cast<Eigen::Index>(model.space->num_dofs()));
  for (const LoadSettings& load : model.problem.loads)
    f += LoadAssembler(model, load).assemble();
  return f;
}

}  // namespace limes
