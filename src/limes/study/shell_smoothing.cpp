#include "limes/study/shell_smoothing.h"

#include <algorithm>
#include <limits>

#include "limes/core/error.h"
#include "limes/study/exact_surface.h"

namespace limes {
namespace {

using Surfaces = std::vector<const GeometrySettings*>;

bool all_in(const Surfaces& some, const Surfaces& all) {
  return std::all_of(some.begin(), some.end(), [&](const GeometrySettings* s) {
    return std::find(all.begin(), all.end(), s) != all.end();
  });
}

/// Ends of borders, and borders that nothing but the part's surface holds.
IdArray<VertexId, char> staying_vertices(const Mesh& mesh, const std::vector<Surfaces>& surfaces,
                                         const IdArray<VertexId, VertexId>& node) {
  const Adjacency adjacency(mesh.topology);
  const auto at = [&](VertexId v) { return surfaces[static_cast<std::size_t>(v.value)]; };
  IdArray<VertexId, char> out(static_cast<std::size_t>(node.size()), 0);
  for (int h = 0; h < mesh.topology.num_corners(); ++h) {
    if (adjacency.twin(HalfedgeId(h)).valid()) continue;
    const VertexId a = adjacency.from(HalfedgeId(h)), b = adjacency.to(HalfedgeId(h));
    if (at(a).size() < 2 || !all_in(at(a), at(b))) out[node[a]] = 1;
    if (at(b).size() < 2 || !all_in(at(b), at(a))) out[node[b]] = 1;
  }
  return out;
}

/// Not a number if nothing is near, so that the step there is refused.
Vec3 nearest(const Surfaces& surfaces, const Vec3& x) {
  try {
    return surfaces.size() == 1 ? project(*surfaces.front(), x) : project(surfaces, x);
  } catch (const InputError&) {
    return Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
  }
}

}  // namespace

SmoothingResult improve_shapes(Mesh& mesh, const std::vector<double>& areas,
                               const std::vector<Surfaces>& surfaces,
                               const std::vector<TiedEdge>& tied, int sweeps) {
  const auto node = tied_nodes(mesh.topology.num_vertices(), tied);
  const auto stays = staying_vertices(mesh, surfaces, node);
  const auto of = [&](VertexId v) -> const Surfaces& {
    return surfaces[static_cast<std::size_t>(v.value)];
  };
  const Sliding sliding{[&](VertexId v, const Vec3& x) {
                          return stays[v] ? Eigen::Matrix<double, 3, Eigen::Dynamic>(3, 0)
                                          : directions_on(of(v), x);
                        },
                        [&](VertexId v, const Vec3& x) { return nearest(of(v), x); }};
  return improve_shapes(mesh, areas, node, sliding, sweeps);
}

}  // namespace limes
