#include "limes/study/shell_placement.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "limes/core/error.h"
#include "limes/mesh/measure.h"
#include "limes/study/control_mesh.h"
#include "limes/study/exact_surface.h"
#include "limes/study/selection.h"
#include "limes/study/shell_smoothing.h"
#include "limes/study/suggest.h"
#include "limes/subdiv/forest_seams.h"
#include "limes/subdiv/refine.h"
#include "limes/subdiv/schemes.h"
#include "limes/subdiv/split.h"

namespace limes {
namespace {

using Surfaces = std::vector<const GeometrySettings*>;

const FaceGroup& find_part(const Problem& problem, const Mesh& mesh, const std::string& name,
                           int line) {
  std::vector<std::string_view> names;
  for (const FaceGroup& part : mesh.parts) {
    if (part.name == name) return part;
    names.push_back(part.name);
  }
  if (names.empty())
    throw InputError("{}:{}: there is no part '{}': the mesh has no parts (OBJ 'o')",
                     problem.file.string(), line, name);
  throw InputError("{}:{}: there is no part '{}'; {}", problem.file.string(), line, name,
                   suggest(name, names));
}

void add_once(Surfaces& all, const GeometrySettings* one) {
  if (std::find(all.begin(), all.end(), one) == all.end()) all.push_back(one);
}

/// All in the order of the problem file, so that vertices that lie on the same come to the same bits.
void sort_as_stated(const Problem& problem, Surfaces& surfaces) {
  const auto rank = [&](const GeometrySettings* one) {
    std::size_t i = 0;
    if (problem.geometry && one == &*problem.geometry) return i;
    for (const GeometrySettings& g : problem.geometry_of_parts)
      if (++i, one == &g) return i;
    for (const CurveSettings& c : problem.curves)
      if (++i, one == &c.surface) return i;
    return i + 1;
  };
  std::sort(surfaces.begin(), surfaces.end(),
            [&](const auto* a, const auto* b) { return rank(a) < rank(b); });
}

/// What every vertex must lie on.
std::vector<Surfaces> surfaces_of_vertices(const Problem& problem, const Mesh& mesh,
                                           const std::vector<TiedEdge>& tied,
                                           const std::vector<std::vector<Edge>>& curves) {
  const Topology& t = mesh.topology;
  std::vector<Surfaces> out(static_cast<std::size_t>(t.num_vertices()));
  const auto at = [&](VertexId v) -> Surfaces& { return out[static_cast<std::size_t>(v.value)]; };
  const auto of_face = geometry_of_faces(problem, mesh);
  for (int f = 0; f < t.num_faces(); ++f)
    for (const VertexId v : t.face(FaceId(f)))
      add_once(at(v), of_face[static_cast<std::size_t>(f)]);
  for (std::size_t c = 0; c < curves.size(); ++c)
    for (const Edge& e : curves[c])
      for (const VertexId v : e)
        add_once(at(v), &problem.curves[c].surface);
  // Tied vertices share all they lie on.
  const auto node = tied_nodes(t.num_vertices(), tied);
  for (int v = t.num_vertices() - 1; v >= 0; --v)
    for (const GeometrySettings* s : Surfaces(at(VertexId(v))))
      add_once(at(node[VertexId(v)]), s);
  for (int v = 0; v < t.num_vertices(); ++v)
    if (node[VertexId(v)] == VertexId(v)) sort_as_stated(problem, at(VertexId(v)));
  for (int v = 0; v < t.num_vertices(); ++v)
    at(VertexId(v)) = at(node[VertexId(v)]);
  return out;
}

Vec3 placed(const Problem& problem, const Surfaces& surfaces, const Vec3& x) {
  if (surfaces.empty()) return x;  // no face uses it
  try {
    return surfaces.size() == 1 ? project(*surfaces.front(), x) : project(surfaces, x);
  } catch (const InputError& error) {
    throw InputError("{}:{}: {}", problem.file.string(), surfaces.back()->line, error.what());
  }
}

/// So that what finds tied edges after refinement finds these.
std::vector<TiedEdge> tied_to_themselves(const std::vector<Edge>& edges) {
  std::vector<TiedEdge> out;
  for (const Edge& e : edges)
    out.push_back({e, e});
  return out;
}

std::vector<Edge> ends_of(const std::vector<TiedEdge>& edges) {
  std::vector<Edge> out;
  for (const TiedEdge& e : edges)
    out.push_back(e.ends);
  return out;
}

void require_surfaces(const Problem& problem, const Mesh& mesh) {
  const auto of_face = geometry_of_faces(problem, mesh);
  const auto bare = std::find(of_face.begin(), of_face.end(), nullptr);
  if (bare != of_face.end())
    throw InputError("{}:{}: every part needs a [geometry] to place vertices on; face {} has none",
                     problem.file.string(), problem.mesh.line, bare - of_face.begin());
}

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

void require_quads(const Problem& problem, const Mesh& mesh) {
  for (int f = 0; f < mesh.topology.num_faces(); ++f)
    if (mesh.topology.face_size(FaceId(f)) != 4)
      throw InputError("{}:{}: smooth_start takes quads; face {} of {} has {} corners",
                       problem.file.string(), problem.mesh.line, f, mesh_path(problem).string(),
                       mesh.topology.face_size(FaceId(f)));
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
void place(const Problem& problem, const std::vector<Surfaces>& surfaces, int first, int last,
           Mesh& mesh) {
  for (int v = first; v < last; ++v)
    mesh.points[VertexId(v)] =
        placed(problem, surfaces[static_cast<std::size_t>(v)], mesh.points[VertexId(v)]);
}

/// Splits every face; new vertices start halfway between others. Edges that are tied or follow a curve
/// become their halves.
/// @return what every vertex lies on
std::vector<Surfaces> split_on_surfaces(const Problem& problem, std::vector<TiedEdge>& tied,
                                        std::vector<std::vector<Edge>>& curves, Mesh& mesh) {
  const Topology coarse = mesh.topology;
  const Adjacency adjacency(coarse);
  tied = split_edges(adjacency, std::span<const TiedEdge>(tied));
  for (auto& edges : curves)
    edges = split_edges(adjacency, std::span<const Edge>(edges));
  mesh = refine(mesh, find_scheme("linear"), {.levels = 1});
  auto surfaces = surfaces_of_vertices(problem, mesh, tied, curves);
  const int first_of_faces = coarse.num_vertices() + adjacency.num_edges();
  place(problem, surfaces, coarse.num_vertices(), first_of_faces, mesh);
  start_between_sides(adjacency, mesh);
  place(problem, surfaces, first_of_faces, mesh.points.size(), mesh);
  return surfaces;
}

}  // namespace

std::vector<const GeometrySettings*> geometry_of_faces(const Problem& problem, const Mesh& mesh) {
  std::vector<const GeometrySettings*> out(static_cast<std::size_t>(mesh.topology.num_faces()),
                                           problem.geometry ? &*problem.geometry : nullptr);
  for (const GeometrySettings& g : problem.geometry_of_parts)
    for (const FaceId f : find_part(problem, mesh, *g.part, g.line).faces)
      out[static_cast<std::size_t>(f.value)] = &g;
  return out;
}

std::vector<TiedEdge> seams_of(const Problem& problem, const Mesh& control) {
  std::vector<TiedEdge> out;
  if (problem.seams.empty()) return out;
  const Adjacency adjacency(control.topology);
  const double tolerance = 1e-9 * bounding_box(control).diagonal();
  for (const SeamSettings& seam : problem.seams) {
    std::vector<char> touches(seam.parts.size(), 0);
    for (std::size_t i = 0; i < seam.parts.size(); ++i)
      for (std::size_t j = i + 1; j < seam.parts.size(); ++j) {
        const FaceGroup& a = find_part(problem, control, seam.parts[i], seam.line);
        const FaceGroup& b = find_part(problem, control, seam.parts[j], seam.line);
        std::vector<TiedEdge> edges;
        try {
          edges = tie_parts(control, adjacency, a, b, tolerance);
        } catch (const InputError& error) {
          throw InputError("{}:{}: {}", problem.file.string(), seam.line, error.what());
        }
        if (!edges.empty()) touches[i] = touches[j] = 1;
        out.insert(out.end(), edges.begin(), edges.end());
      }
    for (std::size_t i = 0; i < seam.parts.size(); ++i)
      if (!touches[i])
        throw InputError(
            "{}:{}: part '{}' has no boundary edge with both ends on vertices of another "
            "part of the seam",
            problem.file.string(), seam.line, seam.parts[i]);
  }
  return out;
}

std::vector<TiedEdge> refined_seams(const Mesh& control, std::vector<TiedEdge> edges, int levels) {
  if (edges.empty()) return edges;
  Mesh mesh = control;
  for (int level = 0; level < levels; ++level) {
    edges = split_edges(Adjacency(mesh.topology), std::span<const TiedEdge>(edges));
    mesh = refine(mesh, find_scheme("linear"), {.levels = 1});
  }
  return edges;
}

std::vector<std::vector<Edge>> curve_edges(const Problem& problem, const Mesh& control,
                                           int levels) {
  const Adjacency adjacency(control.topology);
  std::vector<std::vector<Edge>> out;
  for (const CurveSettings& curve : problem.curves) {
    const Selection chosen(control, adjacency, control.points.span(), curve.where,
                           problem.file.string(), curve.where_line);
    out.emplace_back();
    for (const HalfedgeId h : chosen.boundary_edges())
      out.back().push_back({adjacency.from(h), adjacency.to(h)});
    if (out.back().empty())
      throw InputError(
          "{}:{}: '{}' selects no boundary edge of the control mesh; both ends of an "
          "edge must be selected",
          problem.file.string(), curve.where_line, curve.where);
  }
  for (auto& edges : out)
    edges = ends_of(refined_seams(control, tied_to_themselves(edges), levels));
  return out;
}

Mesh refined_on_surfaces(const Problem& problem, Mesh mesh, int levels) {
  require_surfaces(problem, mesh);
  std::vector<TiedEdge> tied = seams_of(problem, mesh);
  auto curves = curve_edges(problem, mesh, 0);
  auto surfaces = surfaces_of_vertices(problem, mesh, tied, curves);
  const auto smooth = [&](const std::vector<double>& areas, int sweeps) {
    if (sweeps == 0) return;
    require_quads(problem, mesh);
    improve_shapes(problem, mesh, areas, surfaces, tied, sweeps);
  };
  place(problem, surfaces, 0, mesh.points.size(), mesh);
  // What faces should have: equal parts of those of the control mesh.
  std::vector<double> areas = face_areas(mesh);
  smooth(areas, problem.mesh.smooth_start);
  for (int level = 0; level < levels; ++level) {
    areas = areas_of_children(mesh.topology, areas);
    surfaces = split_on_surfaces(problem, tied, curves, mesh);
    smooth(areas, problem.mesh.smoothing);
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
    out.push_back(ends_of(tied_edges(forest, mesh, tied_to_themselves(edges))));
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
                 surfaces_of_vertices(problem, mesh.mesh, tied, fine), tied,
                 problem.mesh.smoothing);
}

Placement exact_placement(const Problem& problem, const Mesh& control, int levels) {
  require_surfaces(problem, control);
  std::vector<TiedEdge> tied = seams_of(problem, control);
  auto curves = curve_edges(problem, control, 0);
  const auto refined = [&](const Mesh& mesh) {
    const Adjacency adjacency(mesh.topology);
    tied = split_edges(adjacency, std::span<const TiedEdge>(tied));
    for (auto& edges : curves)
      edges = split_edges(adjacency, std::span<const Edge>(edges));
    return refine(mesh, find_scheme("linear"), {.levels = 1});
  };
  Mesh coarse = control;
  for (int level = 0; level < levels; ++level)
    coarse = refined(coarse);
  // What the vertices in the middle of edges and faces lie on, so do all that are inside them.
  const Mesh fine = refined(coarse);
  const auto surfaces = surfaces_of_vertices(problem, fine, tied, curves);
  const Topology& t = coarse.topology;
  const Adjacency adjacency(t);
  const QuadrisectionIds ids = quadrisection_ids(adjacency);
  const auto at = [&](VertexId v) { return surfaces[static_cast<std::size_t>(v.value)]; };
  IdArray<HalfedgeId, Surfaces> of_edge(static_cast<std::size_t>(t.num_corners()));
  IdArray<FaceId, Surfaces> of_face(static_cast<std::size_t>(t.num_faces()));
  for (int h = 0; h < of_edge.size(); ++h)
    of_edge[HalfedgeId(h)] = at(ids.of_edge(adjacency.edge(HalfedgeId(h))));
  for (int f = 0; f < of_face.size(); ++f)
    of_face[FaceId(f)] = at(ids.of_face(FaceId(f)));
  return [&problem, of_edge = std::move(of_edge), of_face = std::move(of_face)](
             const Vec3& x, FaceId face, HalfedgeId edge) {
    return placed(problem, edge.valid() ? of_edge[edge] : of_face[face], x);
  };
}

void require_coincident(const Problem& problem, const Mesh& mesh,
                        const std::vector<TiedEdge>& edges, double diagonal) {
  for (const TiedEdge& e : edges)
    for (std::size_t i = 0; i < 2; ++i) {
      const double d = (mesh.points[e.ends[i]] - mesh.points[e.tied[i]]).norm();
      if (d > 1e-9 * diagonal)
        throw InputError(
            "{}:{}: after refinement the tied vertices {} and {} are {:.6g} apart; the boundary "
            "curves of the parts differ: tag the ends of the seam as corners",
            problem.file.string(), problem.seams.front().line, e.ends[i].value, e.tied[i].value, d);
    }
}

}  // namespace limes
