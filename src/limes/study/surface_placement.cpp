#include "limes/study/surface_placement.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

#include "limes/core/error.h"
#include "limes/mesh/junctions.h"
#include "limes/mesh/measure.h"
#include "limes/problem/selection.h"
#include "limes/problem/suggest.h"
#include "limes/study/exact_surface.h"
#include "limes/subdiv/forest_seams.h"
#include "limes/subdiv/refine.h"
#include "limes/subdiv/schemes.h"
#include "limes/subdiv/split.h"

namespace limes {
namespace {

const FaceGroup& find_part(const Mesh& mesh, const std::string& name, const Place& place) {
  std::vector<std::string_view> names;
  for (const FaceGroup& part : mesh.parts) {
    if (part.name == name) return part;
    names.push_back(part.name);
  }
  if (names.empty()) fail_at(place, "there is no part '{}': the mesh has no parts (OBJ 'o')", name);
  fail_at(place, "there is no part '{}'; {}", name, suggest(name, names));
}

void add_once(SurfaceList& all, const GeometrySettings* one) {
  if (std::find(all.begin(), all.end(), one) == all.end()) all.push_back(one);
}

/// All in the order of the problem file, so that vertices that lie on the same come to the same bits.
void sort_as_stated(const SurfaceSettings& settings, SurfaceList& surfaces) {
  const auto rank = [&](const GeometrySettings* one) {
    std::size_t i = 0;
    if (settings.geometry && one == &*settings.geometry) return i;
    for (const GeometrySettings& g : settings.geometry_of_parts)
      if (++i, one == &g) return i;
    for (const CurveSettings& c : settings.curves)
      if (++i, one == &c.surface) return i;
    return i + 1;
  };
  std::sort(surfaces.begin(), surfaces.end(),
            [&](const auto* a, const auto* b) { return rank(a) < rank(b); });
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

}  // namespace

std::vector<const GeometrySettings*> geometry_of_faces(const SurfaceSettings& settings,
                                                       const Mesh& mesh) {
  std::vector<const GeometrySettings*> out(static_cast<std::size_t>(mesh.topology.num_faces()),
                                           settings.geometry ? &*settings.geometry : nullptr);
  for (const GeometrySettings& g : settings.geometry_of_parts)
    for (const FaceId f : find_part(mesh, *g.part, g.origin.of("part")).faces)
      out[static_cast<std::size_t>(f.value)] = &g;
  return out;
}

std::vector<TiedEdge> seams_of(const SurfaceSettings& settings, const Mesh& control) {
  if (settings.seams.empty() && !settings.junctions) return {};
  const Adjacency adjacency(control.topology);
  std::vector<TiedEdge> out;
  if (settings.junctions) out = junction_edges(control, adjacency);
  const double tolerance = 1e-9 * bounding_box(control).diagonal();
  for (const SeamSettings& seam : settings.seams) {
    const Place& place = seam.origin.of("parts");
    std::vector<char> touches(seam.parts.size(), 0);
    for (std::size_t i = 0; i < seam.parts.size(); ++i)
      for (std::size_t j = i + 1; j < seam.parts.size(); ++j) {
        const FaceGroup& a = find_part(control, seam.parts[i], place);
        const FaceGroup& b = find_part(control, seam.parts[j], place);
        std::vector<TiedEdge> edges;
        try {
          edges = tie_parts(control, adjacency, a, b, tolerance);
        } catch (const InputError& error) {
          fail_at(place, "{}", error.what());
        }
        if (!edges.empty()) touches[i] = touches[j] = 1;
        out.insert(out.end(), edges.begin(), edges.end());
      }
    for (std::size_t i = 0; i < seam.parts.size(); ++i)
      if (!touches[i])
        fail_at(place,
                "part '{}' has no boundary edge with both ends on vertices of another part of the "
                "seam",
                seam.parts[i]);
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

std::vector<std::vector<Edge>> curve_edges(const SurfaceSettings& settings, const Mesh& control,
                                           int levels) {
  const Adjacency adjacency(control.topology);
  std::vector<std::vector<Edge>> out;
  for (const CurveSettings& curve : settings.curves) {
    const Selection chosen(control, adjacency, control.points.span(), curve.where,
                           curve.origin.of("where"));
    out.emplace_back();
    for (const HalfedgeId h : chosen.boundary_edges())
      out.back().push_back({adjacency.from(h), adjacency.to(h)});
    if (out.back().empty())
      fail_at(curve.origin.of("where"),
              "'{}' selects no boundary edge of the control mesh; both ends of an edge must be "
              "selected",
              curve.where);
  }
  for (auto& edges : out)
    edges = ends_of(refined_seams(control, tied_to_themselves(edges), levels));
  return out;
}

std::vector<Edge> parts_of_edges(const Forest& forest, const ForestMesh& mesh,
                                 const std::vector<Edge>& edges) {
  return ends_of(tied_edges(forest, mesh, tied_to_themselves(edges)));
}

void require_surfaces(const SurfaceSettings& settings, const Mesh& mesh) {
  const auto of_face = geometry_of_faces(settings, mesh);
  const auto bare = std::find(of_face.begin(), of_face.end(), nullptr);
  if (bare != of_face.end())
    fail_at(settings.geometry_of_parts.front().origin.of("part"),
            "every part needs a [geometry] to place vertices on; face {} has none",
            bare - of_face.begin());
}

std::vector<SurfaceList> surfaces_of_vertices(const SurfaceSettings& settings, const Mesh& mesh,
                                              const std::vector<TiedEdge>& tied,
                                              const std::vector<std::vector<Edge>>& curves) {
  const Topology& t = mesh.topology;
  std::vector<SurfaceList> out(static_cast<std::size_t>(t.num_vertices()));
  const auto at = [&](VertexId v) -> SurfaceList& {
    return out[static_cast<std::size_t>(v.value)];
  };
  const auto of_face = geometry_of_faces(settings, mesh);
  for (int f = 0; f < t.num_faces(); ++f)
    for (const VertexId v : t.face(FaceId(f)))
      add_once(at(v), of_face[static_cast<std::size_t>(f)]);
  for (std::size_t c = 0; c < curves.size(); ++c)
    for (const Edge& e : curves[c])
      for (const VertexId v : e)
        add_once(at(v), &settings.curves[c].surface);
  // Tied vertices share all they lie on.
  const auto node = tied_nodes(t.num_vertices(), tied);
  for (int v = t.num_vertices() - 1; v >= 0; --v)
    for (const GeometrySettings* s : SurfaceList(at(VertexId(v))))
      add_once(at(node[VertexId(v)]), s);
  for (int v = 0; v < t.num_vertices(); ++v)
    if (node[VertexId(v)] == VertexId(v)) sort_as_stated(settings, at(VertexId(v)));
  for (int v = 0; v < t.num_vertices(); ++v)
    at(VertexId(v)) = at(node[VertexId(v)]);
  return out;
}

Vec3 placed(const SurfaceList& surfaces, const Vec3& x) {
  if (surfaces.empty()) return x;  // no face uses it
  const Place& place = surfaces.back()->origin.override_or_table();
  Vec3 y;
  try {
    y = surfaces.size() == 1 ? project(*surfaces.front(), x) : project(surfaces, x);
  } catch (const InputError& error) {
    fail_at(place, "{}", error.what());
  }
  if (!y.allFinite())
    fail_at(place, "the vertex at ({:.6g}, {:.6g}, {:.6g}) has no finite place on this surface",
            x.x(), x.y(), x.z());
  return y;
}

namespace {

/// Whether the corners of a face came to one point or onto one line, but for rounding.
bool has_no_area(const Mesh& mesh, FaceId face) {
  constexpr double flat = 1e-12, one_point = 1e-14;
  Eigen::AlignedBox3d box;
  for (const VertexId v : mesh.topology.face(face))
    box.extend(mesh.points[v]);
  const Eigen::Array3d far = box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).array();
  return (box.sizes().array() <= one_point * far).all() || face_area(mesh, face).relative <= flat;
}

}  // namespace

void require_faces_with_area(const Mesh& mesh, std::span<const GeometrySettings* const> geometry,
                             const std::function<std::string(FaceId)>& name) {
  for (int f = 0; f < mesh.topology.num_faces(); ++f) {
    const FaceId face(f);
    if (!has_no_area(mesh, face)) continue;
    const Vec3& x = mesh.points[mesh.topology.face(face)[0]];
    fail_at(geometry[static_cast<std::size_t>(f)]->origin.override_or_table(),
            "{} has no area on this surface: its vertices come to one point or line at ({:.6g}, "
            "{:.6g}, {:.6g}); move the surface to the mesh",
            name(face), x.x(), x.y(), x.z());
  }
}

void place_control(const SurfaceSettings& settings, Mesh& control) {
  require_surfaces(settings, control);
  const auto surfaces = surfaces_of_vertices(settings, control, seams_of(settings, control),
                                             curve_edges(settings, control, 0));
  for (int v = 0; v < control.points.size(); ++v)
    control.points[VertexId(v)] =
        placed(surfaces[static_cast<std::size_t>(v)], control.points[VertexId(v)]);
  require_faces_with_area(control, geometry_of_faces(settings, control),
                          [](FaceId f) { return fmt::format("face {}", f.value); });
}

Placement exact_placement(const SurfaceSettings& settings, const Mesh& control, int levels) {
  require_surfaces(settings, control);
  std::vector<TiedEdge> tied = seams_of(settings, control);
  auto curves = curve_edges(settings, control, 0);
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
  const auto surfaces = surfaces_of_vertices(settings, fine, tied, curves);
  const Topology& t = coarse.topology;
  const Adjacency adjacency(t);
  const QuadrisectionIds ids = quadrisection_ids(adjacency);
  const auto at = [&](VertexId v) { return surfaces[static_cast<std::size_t>(v.value)]; };
  IdArray<HalfedgeId, SurfaceList> of_edge(static_cast<std::size_t>(t.num_corners()));
  IdArray<FaceId, SurfaceList> of_face(static_cast<std::size_t>(t.num_faces()));
  for (int h = 0; h < of_edge.size(); ++h)
    of_edge[HalfedgeId(h)] = at(ids.of_edge(adjacency.edge(HalfedgeId(h))));
  for (int f = 0; f < of_face.size(); ++f)
    of_face[FaceId(f)] = at(ids.of_face(FaceId(f)));
  return [of_edge = std::move(of_edge), of_face = std::move(of_face)](const Vec3& x, FaceId face,
                                                                      HalfedgeId edge) {
    return placed(edge.valid() ? of_edge[edge] : of_face[face], x);
  };
}

}  // namespace limes
