#include "limes/study/shell_smoothing.h"

#include <algorithm>
#include <limits>

#include "limes/core/error.h"
#include "limes/problem/selection.h"
#include "limes/study/exact_surface.h"
#include "limes/subdiv/hanging_faces.h"

namespace limes {
namespace {

using Surfaces = std::vector<const GeometrySettings*>;

bool all_in(const Surfaces& some, const Surfaces& all) {
  return std::all_of(some.begin(), some.end(), [&](const GeometrySettings* s) {
    return std::find(all.begin(), all.end(), s) != all.end();
  });
}

/// Ends of borders and of selections, and borders that nothing but the part's surface holds.
IdArray<VertexId, char> staying_nodes(const Problem& problem, const Mesh& mesh,
                                      const std::vector<Surfaces>& surfaces,
                                      const IdArray<VertexId, VertexId>& node) {
  const Adjacency adjacency(mesh.topology);
  const auto at = [&](VertexId v) { return surfaces[static_cast<std::size_t>(v.value)]; };
  IdArray<VertexId, char> out(static_cast<std::size_t>(node.size()), 0);
  const IdArray<VertexId, char> held = held_by_selections(problem, mesh);
  for (int v = 0; v < node.size(); ++v)
    if (held[VertexId(v)]) out[node[VertexId(v)]] = 1;
  for (int h = 0; h < mesh.topology.num_corners(); ++h) {
    if (adjacency.twin(HalfedgeId(h)).valid()) continue;
    const VertexId a = adjacency.from(HalfedgeId(h)), b = adjacency.to(HalfedgeId(h));
    if (at(a).size() < 2 || !all_in(at(a), at(b))) out[node[a]] = 1;
    if (at(b).size() < 2 || !all_in(at(b), at(a))) out[node[b]] = 1;
  }
  return out;
}

/// Every `where` that is looked up in the refined mesh, with its place.
std::vector<std::pair<std::string, Place>> selections_of(const Problem& problem) {
  std::vector<std::pair<std::string, Place>> out;
  for (const MaterialSettings& m : problem.materials)
    if (m.where) out.emplace_back(*m.where, m.origin.of("where"));
  for (const SupportSettings& s : problem.supports)
    out.emplace_back(s.where, s.origin.of("where"));
  for (const LoadSettings& l : problem.loads)
    out.emplace_back(l.where, l.origin.of("where"));
  return out;
}

/// Empty if there are none, as may be on a coarse mesh.
std::vector<bool> chosen_vertices(const Mesh& mesh, const Adjacency& adjacency,
                                  const std::string& where, const Place& place) {
  try {
    return Selection(mesh, adjacency, mesh.points.span(), where, place).vertices();
  } catch (const InputError&) {
    return {};
  } catch (const UsageError&) {  // of an override
    return {};
  }
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

IdArray<VertexId, char> held_by_selections(const Problem& problem, const Mesh& mesh) {
  const Adjacency adjacency(mesh.topology);
  IdArray<VertexId, char> out(static_cast<std::size_t>(mesh.topology.num_vertices()), 0);
  for (const auto& [where, place] : selections_of(problem)) {
    const std::vector<bool> chosen = chosen_vertices(mesh, adjacency, where, place);
    if (chosen.empty()) continue;
    const auto in = [&](VertexId v) { return chosen[static_cast<std::size_t>(v.value)]; };
    for (int i = 0; i < mesh.topology.num_corners(); ++i) {
      const HalfedgeId h(i);
      const VertexId a = adjacency.from(h), b = adjacency.to(h);
      if (in(a) == in(b)) continue;
      const VertexId end = in(a) ? a : b;
      if (!adjacency.is_boundary(end) || !adjacency.twin(h).valid()) out[end] = 1;
    }
  }
  return out;
}

SmoothingResult improve_shapes(const Problem& problem, Mesh& mesh, const std::vector<double>& areas,
                               const std::vector<Surfaces>& surfaces,
                               const std::vector<TiedEdge>& tied, int sweeps,
                               std::span<const HangingVertex> hanging) {
  const auto node = tied_nodes(mesh.topology.num_vertices(), tied);
  Mesh closed;
  if (!hanging.empty()) {
    closed = mesh;
    closed.topology = hanging_faces(mesh.topology, hanging).topology;
  }
  IdArray<VertexId, char> stays =
      staying_nodes(problem, hanging.empty() ? mesh : closed, surfaces, node);
  for (const HangingVertex& h : hanging)  // it stays if the ends of its side do
    for (const VertexId end : h.ends)
      if (stays[h.vertex]) stays[node[end]] = 1;
  const auto of = [&](VertexId v) -> const Surfaces& {
    return surfaces[static_cast<std::size_t>(v.value)];
  };
  const Sliding sliding{[&](VertexId v, const Vec3& x) {
                          return stays[v] ? Eigen::Matrix<double, 3, Eigen::Dynamic>(3, 0)
                                          : directions_on(of(v), x);
                        },
                        [&](VertexId v, const Vec3& x) { return nearest(of(v), x); }};
  return improve_shapes(mesh, areas, node, sliding, sweeps, hanging);
}

}  // namespace limes
