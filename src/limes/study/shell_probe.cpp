#include "limes/study/shell_probe.h"

#include <utility>

#include "limes/limit/closest_point.h"
#include "limes/mesh/adjacency.h"
#include "limes/subdiv/features.h"
#include "limes/subdiv/schemes.h"

namespace limes {
namespace {

/// The elements as a mesh of quads; if nodes hang in sides, each with corners of its own.
struct ElementQuads {
  Topology topology;
  std::vector<Vec3> points;

  explicit ElementQuads(const ShellModel& model)
      : topology(model.mesh->topology), points(model.mesh->points.vector()) {
    if (topology.uniform_face_size() == 4) return;
    points.clear();
    std::vector<VertexId> corners;
    for (int f = 0; f < model.mesh->topology.num_faces(); ++f)
      for (const Vec3& x : model.quad(FaceId(f)).x) {
        corners.emplace_back(static_cast<int>(points.size()));
        points.push_back(x);
      }
    topology = Topology(static_cast<int>(points.size()), 4, std::move(corners));
  }
};

}  // namespace

std::vector<ShellProbe> probe(const ShellModel& model, const ShellSolution& solution) {
  std::vector<ShellProbe> out;
  if (model.problem.probes.empty()) return out;
  const ElementQuads quads(model);
  const LimitBasis basis(quads.topology,
                         resolve_tags(Adjacency(quads.topology), Tags(), BoundaryRule::edges),
                         find_scheme("linear"));
  const SurfaceTree tree(basis, quads.points);
  for (const ProbeSettings& p : model.problem.probes) {
    const ClosestHit hit = closest_point(tree, p.at);
    const ShellVector u = model.unknowns(hit.face, solution.u);
    const double a = hit.uv.x(), b = hit.uv.y();
    const Eigen::Matrix<double, 6, 1> at =
        (1 - b) * ((1 - a) * u.segment<6>(0) + a * u.segment<6>(6)) +
        b * (a * u.segment<6>(12) + (1 - a) * u.segment<6>(18));
    out.push_back({p.name, p.at, hit.point, hit.distance, hit.face, at.head<3>(), at.tail<3>(),
                   state_at_centre(model, solution, hit.face)});
  }
  return out;
}

}  // namespace limes
