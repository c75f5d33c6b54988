#include <cmath>
#include <limits>
#include <span>

#include "limes/mesh/defect_list.h"
#include "limes/mesh/measure.h"

namespace limes {
namespace {

/// Faces whose vector area is this small against the square of their size have no area: rounding of
/// the coordinates may leave that much.
constexpr double flat = 1e-13;

bool is_finite(const Vec3& x) {
  return x.allFinite();
}

void add_not_finite(const Mesh& mesh, DefectList& out) {
  for (int v = 0; v < mesh.points.size(); ++v)
    if (!is_finite(mesh.points[VertexId(v)]))
      out.add(DefectKind::not_finite, {}, {VertexId(v)},
              fmt::format("vertex {} has a coordinate that is no finite number", v));
}

/// Whether four times the squared length, which bounds the squared distance of any two points that
/// pass, is too large for a double.
bool square_overflows(const Vec3& x) {
  return !std::isfinite(4.0 * x.squaredNorm());
}

void add_extreme_coordinates(const Mesh& mesh, const Bounds& bounds, DefectList& out) {
  std::vector<VertexId> large;
  for (int v = 0; v < mesh.points.size(); ++v) {
    const Vec3& x = mesh.points[VertexId(v)];
    if (is_finite(x) && square_overflows(x)) large.emplace_back(v);
  }
  if (!large.empty()) {
    std::string message =
        fmt::format("squared lengths overflow at {} vertices ({}); scale the model down",
                    large.size(), list_ids(large));
    out.add(DefectKind::coordinates, {}, std::move(large), std::move(message));
    return;
  }
  const double diagonal = bounds.diagonal();
  if (diagonal > 0 && diagonal * diagonal < std::numeric_limits<double>::min())
    out.add(DefectKind::coordinates, {}, {},
            fmt::format("the model is {:.3g} in size and squared lengths vanish; scale it up",
                        diagonal));
}

void add_flat_faces(const Mesh& mesh, DefectList& out) {
  for (int f = 0; f < mesh.topology.num_faces(); ++f) {
    const FaceId face(f);
    if (mesh.topology.face_size(face) < 3) continue;
    const ScaledArea area = face_area(mesh, face);
    if (!(area.relative <= flat)) continue;
    const bool room = out.has_room(DefectKind::zero_area);
    out.add(
        DefectKind::zero_area, {face}, {},
        room ? fmt::format("face {} has no area: its corners lie on a line or its sides cross", f)
             : "");
  }
}

}  // namespace

void add_geometric_defects(const Mesh& mesh, DefectList& out) {
  add_not_finite(mesh, out);
  const Bounds bounds = bounding_box(mesh);
  add_extreme_coordinates(mesh, bounds, out);
  if (mesh.topology.num_faces() > 0 && bounds.diagonal() == 0) {
    out.add(DefectKind::one_point, {}, {}, "all vertices lie in one point");
    return;
  }
  add_flat_faces(mesh, out);
}

}  // namespace limes
