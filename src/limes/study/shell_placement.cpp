#include "limes/study/shell_placement.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "limes/core/error.h"
#include "limes/mesh/measure.h"
#include "limes/study/control_mesh.h"
#include "limes/study/shell_smoothing.h"
#include "limes/subdiv/refine.h"
#include "limes/subdiv/schemes.h"
#include "limes/subdiv/split.h"

namespace limes {
namespace {

/// Equal parts for every corner's child.
std::vector<double> areas_of_children(const Topology& t, const std::vector<double>& areas) {
  std::vector<double> out;
  out.reserve(static_cast<std::size_t>(t.num_corners()));
  for (int f = 0; f < t.num_faces(); ++f)
    out.insert(out.end(), static_cast<std::size_t>(t.face_size(FaceId(f))),
               areas[static_cast<std::size_t>(f)] / t.face_size(FaceId(f)));
  return out;
}

/// Of the faces of a mesh of a forest: those of a leaf share its part of the control face.
std::vector<double> areas_in_forest(const Forest& forest, const ForestMesh& mesh,
                                    const std::vector<double>& areas) {
  std::vector<double> out;
  out.reserve(mesh.leaves.size());
  for (std::size_t first = 0; first < mesh.leaves.size();) {
    std::size_t last = first;
    while (last < mesh.leaves.size() && mesh.leaves[last] == mesh.leaves[first])
      ++last;
    const FaceAncestry a = forest.ancestry(mesh.leaves[first]);
    const double area = std::ldexp(areas[static_cast<std::size_t>(a.root.value)], -2 * a.level);
    out.insert(out.end(), last - first, area / static_cast<double>(last - first));
    first = last;
  }
  return out;
}

void require_quads(const Problem& problem, const char* key, const Mesh& mesh) {
  for (int f = 0; f < mesh.topology.num_faces(); ++f)
    if (mesh.topology.face_size(FaceId(f)) != 4)
      fail_at(problem.mesh.origin.of(key), "{} takes quads; face {} of {} has {} corners", key, f,
              mesh_path(problem).string(), mesh.topology.face_size(FaceId(f)));
}

/// Vertices of the quads of the coarse mesh, whose sides are placed.
void start_between_sides(const Adjacency& coarse, Mesh& mesh) {
  const QuadrisectionIds ids = quadrisection_ids(coarse);
  for (int f = 0; f < coarse.topology().num_faces(); ++f) {
    const auto face = coarse.topology().face(FaceId(f));
    if (face.size() != 4) continue;
    std::array<Vec3, 4> corners, middles;
    for (std::size_t i = 0; i < 4; ++i) {
      const HalfedgeId h = coarse.topology().halfedge(FaceId(f), static_cast<int>(i));
      corners[i] = mesh.points[face[i]];
      middles[i] = mesh.points[ids.of_edge(coarse.edge(h))];
    }
    mesh.points[ids.of_face(FaceId(f))] = between_sides(corners, middles);
  }
}

/// Vertices from `first` to before `last` on their surfaces.
void place(const std::vector<SurfaceList>& surfaces, int first, int last, Mesh& mesh) {
  for (int v = first; v < last; ++v)
    mesh.points[VertexId(v)] =
        placed(surfaces[static_cast<std::size_t>(v)], mesh.points[VertexId(v)]);
}

/// Splits every face; new vertices start halfway between others. Edges that are tied or follow a curve
/// become their halves.
/// @return what every vertex lies on
std::vector<SurfaceList> split_on_surfaces(const Problem& problem, std::vector<TiedEdge>& tied,
                                           std::vector<std::vector<Edge>>& curves, Mesh& mesh) {
  const Topology coarse = mesh.topology;
  const Adjacency adjacency(coarse);
  tied = split_edges(adjacency, std::span<const TiedEdge>(tied));
  for (auto& edges : curves)
    edges = split_edges(adjacency, std::span<const Edge>(edges));
  mesh = refine(mesh, find_scheme("linear"), {.levels = 1});
  auto surfaces = surfaces_of_vertices(problem, mesh, tied, curves);
  const int first_of_faces = coarse.num_vertices() + adjacency.num_edges();
  place(surfaces, coarse.num_vertices(), first_of_faces, mesh);
  start_between_sides(adjacency, mesh);
  place(surfaces, first_of_faces, mesh.points.size(), mesh);
  return surfaces;
}

}  // namespace

Mesh refined_on_surfaces(const Problem& problem, Mesh mesh, int levels) {
  require_surfaces(problem, mesh);
  std::vector<TiedEdge> tied = seams_of(problem, mesh);
  auto curves = curve_edges(problem, mesh, 0);
  auto surfaces = surfaces_of_vertices(problem, mesh, tied, curves);
  const auto smooth = [&](const char* key, const std::vector<double>& areas, int sweeps) {
    if (sweeps == 0) return;
    require_quads(problem, key, mesh);
    improve_shapes(problem, mesh, areas, surfaces, tied, sweeps);
  };
  place(surfaces, 0, mesh.points.size(), mesh);
  require_faces_with_area(mesh, geometry_of_faces(problem, mesh), [&](FaceId f) {
    return fmt::format("face {} of {}", f.value, mesh_path(problem).string());
  });
  // What faces should have: equal parts of those of the control mesh.
  std::vector<double> areas = face_areas(mesh);
  smooth("smooth_start", areas, problem.mesh.smooth_start);
  for (int level = 0; level < levels; ++level) {
    areas = areas_of_children(mesh.topology, areas);
    surfaces = split_on_surfaces(problem, tied, curves, mesh);
    smooth("smoothing", areas, problem.mesh.smoothing);
  }
  return mesh;
}

Mesh refined_on_surfaces(const Problem& problem, Mesh mesh, int levels, std::vector<TiedEdge> tied,
                         std::vector<std::vector<Edge>> curves) {
  for (int level = 0; level < levels; ++level)
    (void)split_on_surfaces(problem, tied, curves, mesh);
  return mesh;
}

std::vector<std::vector<Edge>> edges_in_forest(const Forest& forest, const ForestMesh& mesh,
                                               const std::vector<std::vector<Edge>>& control) {
  std::vector<std::vector<Edge>> out;
  for (const std::vector<Edge>& edges : control)
    out.push_back(parts_of_edges(forest, mesh, edges));
  return out;
}

std::vector<double> wanted_areas(const Mesh& control, int levels) {
  std::vector<double> areas = face_areas(control);
  if (levels == 0) return areas;
  areas = areas_of_children(control.topology, areas);
  for (int level = 1; level < levels; ++level) {
    std::vector<double> finer;
    for (const double area : areas)
      finer.insert(finer.end(), 4, area / 4);
    areas = std::move(finer);
  }
  return areas;
}

void smooth_on_surfaces(const Problem& problem, const Forest& forest,
                        const std::vector<double>& areas,
                        const std::vector<std::vector<Edge>>& curves,
                        const std::vector<TiedEdge>& tied, ForestMesh& mesh) {
  if (mesh.leaves.size() == areas.size()) return;
  const auto fine = edges_in_forest(forest, mesh, curves);
  improve_shapes(problem, mesh.mesh, areas_in_forest(forest, mesh, areas),
                 surfaces_of_vertices(problem, mesh.mesh, tied, fine), tied, problem.mesh.smoothing,
                 mesh.hanging);
}

void place_children(const ForestMesh& coarse, const std::vector<SurfaceList>& surfaces,
                    ForestMesh& split) {
  const VertexId last = *std::max_element(split.nodes.begin(), split.nodes.end());
  // By number in the forest; the coarse mesh has no others.
  IdArray<VertexId, VertexId> in_coarse(static_cast<std::size_t>(last.value) + 1);
  for (std::size_t v = 0; v < coarse.nodes.size(); ++v)
    in_coarse[coarse.nodes[v]] = VertexId(v);
  IdArray<VertexId, Vec3>& x = split.mesh.points;
  std::vector<char> stays(split.nodes.size(), 0);
  for (std::size_t v = 0; v < split.nodes.size(); ++v)
    if (const VertexId at = in_coarse[split.nodes[v]]; at.valid()) {
      x[VertexId(v)] = coarse.mesh.points[at];
      stays[v] = 1;
    }
  const auto put = [&](VertexId v, const Vec3& near) {
    const auto at = static_cast<std::size_t>(v.value);
    if (!stays[at]) x[v] = placed(surfaces[at], near);
  };
  for (int f = 0; f < coarse.mesh.topology.num_faces(); ++f) {
    std::array<Vec3, 4> corners, middles;
    const auto child = [&](std::size_t i) {
      return split.mesh.topology.face(FaceId(4 * f + static_cast<int>(i)));
    };
    for (std::size_t i = 0; i < 4; ++i)
      corners[i] = x[child(i)[0]];
    for (std::size_t i = 0; i < 4; ++i) {
      put(child(i)[1], (corners[i] + corners[(i + 1) % 4]) / 2);
      middles[i] = x[child(i)[1]];
    }
    put(child(0)[2], between_sides(corners, middles));
  }
}

void require_coincident(const Problem& problem, const Mesh& mesh,
                        const std::vector<TiedEdge>& edges, double diagonal) {
  for (const TiedEdge& e : edges)
    for (std::size_t i = 0; i < 2; ++i) {
      const double d = (mesh.points[e.ends[i]] - mesh.points[e.tied[i]]).norm();
      if (d > 1e-9 * diagonal)
        fail_at(
            problem.seams.empty() ? problem.mesh.origin.of("junctions")
                                  : problem.seams.front().origin.table,
            "after refinement the tied vertices {} and {} are {:.6g} apart; the boundary curves "
            "of the parts differ: tag the ends of the seam as corners",
            e.ends[i].value, e.tied[i].value, d);
    }
}

}  // namespace limes
