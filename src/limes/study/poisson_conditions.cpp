#include "limes/study/poisson_conditions.h"

#include <cmath>

#include "limes/core/error.h"
#include "limes/fem/load.h"
#include "limes/mesh/face_error.h"
#include "limes/mesh/pieces.h"
#include "limes/problem/selection.h"
#include "limes/study/supports.h"

namespace limes {
namespace {

double finite(const Expression& formula, const Vec3& x, const Place& place) {
  const double value = formula(x);
  if (!std::isfinite(value))
    fail_at(place, "'{}' has no finite value at ({:.6g}, {:.6g})", formula.text(), x.x(), x.y());
  return value;
}

void require_quads(const PlaneModel& model) {
  const Topology& t = model.mesh().topology;
  for (int f = 0; f < t.num_faces(); ++f)
    if (t.face_size(FaceId(f)) != 4)
      throw InputError(
          "{}: face {} has {} corners; bilinear elements have 4, [mesh] levels = 1 makes them",
          place_of(model.control, FaceId(f), mesh_path(model.problem).string()), f,
          t.face_size(FaceId(f)));
}

/// With other values 2 (E - E_h) is no squared error: the energy may lie on either side.
void require_zero(const PlaneModel& model, const SupportSettings& support, double value,
                  const Vec3& x) {
  const auto& adapt = model.problem.adapt;
  if (!adapt || !adapt->reference_energy || value == 0) return;
  const Place& held = support.origin.of("value");
  fail_at(culprit(adapt->origin.of("reference_energy"), {held}),
          "the support of {} gives the value {} at ({:.6g}, {:.6g}), but a reference_energy says "
          "what the error is only where all supports have the value 0; remove it",
          spoken(held), value, x.x(), x.y());
}

/// Faces are joined by common vertices. A piece in which no vertex is held has many solutions.
void require_held_pieces(const PlaneModel& model, const std::vector<int>& held_at) {
  const SubdivisionSpace& space = *model.space;
  DisjointSets sets(space.num_dofs());
  for (int e = 0; e < static_cast<int>(space.elements().size()); ++e)
    for (const int a : space.dofs(e))
      sets.join(a, space.dofs(e)[0]);
  std::vector<bool> held(held_at.size(), false);
  for (std::size_t a = 0; a < held_at.size(); ++a)
    if (held_at[a] >= 0) held[static_cast<std::size_t>(sets.find(static_cast<int>(a)))] = true;
  for (int e = 0; e < static_cast<int>(space.elements().size()); ++e) {
    if (held[static_cast<std::size_t>(sets.find(space.dofs(e)[0]))]) continue;
    const Vec3 x = space.control_points(e).row(0).transpose();
    fail_at(
        place_of_supports(model.problem),
        "no [[support]] gives a value in the piece of the mesh at ({:.6g}, {:.6g}); the solution "
        "is known there but for a constant",
        x.x(), x.y());
  }
}

/// Component 0 of the load of a vector field.
VectorX scalar(const VectorX& f) {
  return Eigen::Map<const VectorX, 0, Eigen::InnerStride<2>>(f.data(), f.size() / 2);
}

VectorX source_load(const PlaneModel& model, const LoadSettings& load, const Selection& chosen) {
  std::vector<bool> face(static_cast<std::size_t>(model.mesh().topology.num_faces()), false);
  const std::vector<FaceId> faces = chosen.faces();
  if (faces.empty())
    fail_at(load.origin.of("where"),
            "'{}' selects no face; all vertices of a face must be selected", load.where);
  for (const FaceId f : faces)
    face[static_cast<std::size_t>(f.value)] = true;
  std::vector<bool> element;
  for (const Element& e : model.space->elements())
    element.push_back(face[static_cast<std::size_t>(e.face.value)]);
  return scalar(body_load(*model.space, element, [&](const Vec3& x) {
    return Vec2(finite(load.value[0], x, place_of_value(load)), 0);
  }));
}

VectorX flux_load(const PlaneModel& model, const LoadSettings& load, const Selection& chosen) {
  const std::vector<HalfedgeId> sides = selected_sides(model, chosen);
  if (sides.empty())
    fail_at(load.origin.of("where"),
            "'{}' selects no boundary edge; both ends of an edge must be selected", load.where);
  return scalar(side_load(*model.space, sides, [&](const Vec3& x, const Vec2& /*normal*/) {
    return Vec2(finite(load.value[0], x, place_of_value(load)), 0);
  }));
}

}  // namespace

int dof_of_vertex(const SubdivisionSpace& space, VertexId v) {
  for (const auto& [dof, weight] : value_at_vertex(space, v))
    if (weight > 0.5) return dof;
  return -1;
}

std::vector<HeldVertex> held_vertices(const PlaneModel& model) {
  require_quads(model);
  std::vector<HeldVertex> out;
  std::vector<bool> hangs(static_cast<std::size_t>(model.mesh().points.size()), false);
  if (model.closed)
    for (const HangingVertex& h : model.closed->hanging)
      hangs[static_cast<std::size_t>(h.vertex.value)] = true;
  std::vector<int> held_at(static_cast<std::size_t>(model.space->num_dofs()), -1);
  for (int s = 0; s < static_cast<int>(model.problem.supports.size()); ++s) {
    const SupportSettings& support = model.problem.supports[static_cast<std::size_t>(s)];
    const Selection chosen = model.selection(support.where, support.origin.of("where"));
    for (std::size_t v = 0; v < chosen.vertices().size(); ++v) {
      const VertexId vertex(static_cast<std::int64_t>(v));
      const bool held = chosen.vertices()[v] && !hangs[v];  // else its ends say what it has
      const int dof = held ? dof_of_vertex(*model.space, vertex) : -1;
      if (dof < 0) continue;
      const Vec3& x = model.limit_points[vertex];
      const double value = finite(support.value, x, support.origin.of("value"));
      require_zero(model, support, value, x);
      int& at = held_at[static_cast<std::size_t>(dof)];
      if (at < 0) {
        at = static_cast<int>(out.size());
        out.push_back({dof, value, s});
        continue;
      }
      const double other = out[static_cast<std::size_t>(at)].value;
      const SupportSettings& other_support =
          model.problem
              .supports[static_cast<std::size_t>(out[static_cast<std::size_t>(at)].support)];
      if (std::abs(value - other) > 1e-9 * (1 + std::abs(value)))
        fail_at(culprit(support.origin.of("value"),
                        {support.origin.of("where"), other_support.origin.override_or_table()}),
                "the vertex at ({:.6g}, {:.6g}) has the value {}, and {} by another support; make "
                "them agree",
                x.x(), x.y(), value, other);
    }
  }
  require_held_pieces(model, held_at);
  return out;
}

VectorX poisson_loads(const PlaneModel& model) {
  VectorX f = VectorX::Zero(model.space->num_dofs());
  for (const LoadSettings& load : model.problem.loads) {
    const Selection chosen = model.selection(load.where, load.origin.of("where"));
    f += load.kind == LoadKind::source ? source_load(model, load, chosen)
                                       : flux_load(model, load, chosen);
  }
  return f;
}

}  // namespace limes
