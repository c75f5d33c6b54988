#include "limes/study/shell_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "limes/adapt/limit_sliding.h"
#include "limes/core/error.h"
#include "limes/limit/limit_surface.h"
#include "limes/mesh/defects.h"
#include "limes/mesh/face_error.h"
#include "limes/study/exact_surface.h"
#include "limes/study/materials.h"
#include "limes/study/refine_control.h"
#include "limes/study/shell_directors.h"
#include "limes/study/shell_placement.h"
#include "limes/study/shell_smoothing.h"
#include "limes/subdiv/refine.h"
#include "limes/subdiv/schemes.h"

namespace limes {
namespace {

void require_quads(const Mesh& mesh, const std::string& file) {
  const Topology& t = mesh.topology;
  for (int f = 0; f < t.num_faces(); ++f)
    if (t.face_size(FaceId(f)) != 4)
      throw InputError(
          "{}: face {} has {} corners; elements of kind \"mitc4\" have 4, levels = 1 makes them",
          place_of(mesh, FaceId(f), file), f, t.face_size(FaceId(f)));
}

/// Area vectors of the bilinear face at its corners; between them they are linear.
std::array<Vec3, 4> corner_areas(const ShellModel& model, FaceId f, const std::string& file) {
  const auto corner = [&](int k) {
    return model.mesh->points[model.mesh->topology.corner(model.corner(f, k % 4))];
  };
  std::array<Vec3, 4> out;
  for (int i = 0; i < 4; ++i) {
    const Vec3 a = corner(i + 1) - corner(i), b = corner(i + 3) - corner(i);
    const Vec3 n = a.cross(b);
    if (!(n.norm() > 1e-12 * a.norm() * b.norm()))
      throw InputError(
          "{}: face {} of the refined mesh has no normal at its corner {}: its sides "
          "there are parallel",
          file, f.value, i);
    out[static_cast<std::size_t>(i)] = n;
  }
  return out;
}

/// Normal of the bilinear face at each of its corners, and where nodes hang in its sides.
IdArray<HalfedgeId, Vec3> face_normals(const ShellModel& model, const std::string& file) {
  const Topology& t = model.mesh->topology;
  IdArray<HalfedgeId, Vec3> out(static_cast<std::size_t>(t.num_corners()));
  for (int f = 0; f < t.num_faces(); ++f) {
    const std::array<Vec3, 4> area = corner_areas(model, FaceId(f), file);
    for (int i = 0; i < 4; ++i) {
      const Vec3 &n = area[static_cast<std::size_t>(i)],
                 &next = area[static_cast<std::size_t>((i + 1) % 4)];
      out[model.corner(FaceId(f), i)] = n.normalized();
      const HalfedgeId between = model.faces.inside(FaceId(f), i);
      if (between.valid()) out[between] = (n + next).normalized();
    }
  }
  return out;
}

/// Like require_refinable(), but says what can be done with junctions.
void require_surface(const Mesh& mesh, const std::string& file) {
  for (const Defect& defect : find_defects(mesh)) {
    if (!blocks_refinement(defect.kind)) continue;
    if (defect.kind == DefectKind::non_manifold_edge)
      throw InputError("{}: {}; [mesh] junctions = \"tied\" makes it a junction of shells",
                       defect.line > 0 ? fmt::format("{}:{}", file, defect.line) : file,
                       defect.message);
    require_refinable(mesh, file);  // throws
  }
}

/// Optimises the shapes of elements; the vertices of the control mesh stay, others slide on the surface
/// of the interpolatory scheme.
void slide_on_limit(const Problem& problem, Mesh& mesh, const Scheme& scheme, BoundaryRule boundary,
                    int num_control) {
  constexpr int steps = 3;
  const Mesh fine = refine(mesh, scheme, {.levels = steps, .boundary = boundary});
  const auto node = tied_nodes(mesh.topology.num_vertices(), {});
  IdArray<VertexId, char> stays = held_by_selections(problem, mesh);
  std::fill_n(stays.begin(), num_control, 1);
  improve_shapes(mesh, face_areas(mesh), node,
                 sliding_on_refinement(mesh, fine, steps, std::move(stays)),
                 problem.mesh.smoothing);
}

/// Limit points become nodes; returns the limit surface's normal at each corner.
IdArray<HalfedgeId, Vec3> move_to_limit(Mesh& mesh, const Scheme& scheme, BoundaryRule boundary,
                                        const std::string& file) {
  const Adjacency adjacency(mesh.topology);
  const LimitBasis basis(mesh.topology, resolve_tags(adjacency, mesh.tags, boundary), scheme);
  const LimitSurface surface(basis, mesh.points.span());
  IdArray<HalfedgeId, Vec3> normal(static_cast<std::size_t>(mesh.topology.num_corners()));
  for (int f = 0; f < mesh.topology.num_faces(); ++f)
    for (int i = 0; i < 4; ++i) {
      constexpr std::array<std::array<double, 2>, 4> at{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
      const Vec2 uv(at[static_cast<std::size_t>(i)][0], at[static_cast<std::size_t>(i)][1]);
      SurfacePoint p = surface.evaluate(FaceId(f), 0, uv);
      // at a cusp the normal is that of the face nearby
      if (!p.normal) p = surface.evaluate(FaceId(f), 0, uv + 1e-3 * (Vec2(0.5, 0.5) - uv));
      if (!p.normal)
        throw InputError("{}: face {} of the refined mesh has no normal at its corner {}", file, f,
                         i);
      normal[mesh.topology.halfedge(FaceId(f), i)] = *p.normal;
    }
  mesh.points = limit_positions(surface, mesh.points.span());
  return normal;
}

/// Exact normals where there is an exact surface, on the side that faces say is up.
void set_exact_directors(ShellModel& model, const IdArray<HalfedgeId, Vec3>& corner_normal) {
  const Topology& t = model.mesh->topology;
  const auto geometry = geometry_of_faces(model.problem, *model.mesh);
  for (int f = 0; f < t.num_faces(); ++f) {
    const GeometrySettings* const surface = geometry[static_cast<std::size_t>(f)];
    for (int i = 0; surface && i < t.face_size(FaceId(f)); ++i) {
      const HalfedgeId h = t.halfedge(FaceId(f), i);
      try {
        const Vec3 n = outward_normal(*surface, model.mesh->points[t.corner(h)]);
        model.director[h] = n.dot(corner_normal[h]) < 0 ? Vec3(-n) : n;
      } catch (const InputError& error) {
        fail_at(surface->origin.override_or_table(), "{}", error.what());
      }
    }
  }
}

/// A node is smooth if all directors there are on one line, give or take the kink angle; sides with
/// opposite orientation are no kink. Where they differ by less than that, but more than by rounding,
/// tied parts take their mean.
void join_directors(ShellModel& model) {
  const Topology& t = model.mesh->topology;
  const double cosine = std::cos(model.problem.model.kink_angle * std::numbers::pi / 180);
  std::map<VertexId, std::vector<HalfedgeId>> corners;
  for (int h = 0; h < t.num_corners(); ++h)
    corners[model.node[t.corner(HalfedgeId(h))]].push_back(HalfedgeId(h));
  for (const auto& [node, around] : corners) {
    const Vec3 first = model.director[around.front()];
    Vec3 sum = Vec3::Zero();
    double least = 1;
    for (const HalfedgeId h : around) {
      const double along = model.director[h].dot(first);
      least = std::min(least, std::abs(along));
      sum += along < 0 ? Vec3(-model.director[h]) : model.director[h];
    }
    model.smooth[node] = least >= cosine;
    if (model.smooth[node] && least < 1 - 1e-12)
      for (const HalfedgeId h : around)
        model.director[h] = (model.director[h].dot(first) < 0 ? -1 : 1) * sum.normalized();
  }
  for (int v = 0; v < t.num_vertices(); ++v)
    model.smooth[VertexId(v)] = model.smooth[model.node[VertexId(v)]];
}

void set_directors(ShellModel& model, const IdArray<HalfedgeId, Vec3>& corner_normal,
                   bool is_tied) {
  const Problem& problem = model.problem;
  Directors directors = mean_directors(*model.adjacency, corner_normal, problem.model.kink_angle);
  model.director = std::move(directors.at_corner);
  model.smooth = std::move(directors.smooth);
  if (problem.geometry || !problem.geometry_of_parts.empty()) {
    set_exact_directors(model, corner_normal);
    model.smooth = IdArray<VertexId, char>(static_cast<std::size_t>(model.smooth.size()), 1);
  }
  if (!problem.geometry_of_parts.empty() || is_tied) join_directors(model);
}

void set_size(ShellModel& model) {
  Eigen::AlignedBox3d box;
  for (int v = 0; v < model.mesh->points.size(); ++v)
    if (model.adjacency->ring_start(VertexId(v)).valid())
      box.extend(model.mesh->points[VertexId(v)]);
  model.diagonal = box.diagonal().norm();
  model.centre = box.center();
}

void set_materials(ShellModel& model) {
  const Problem& problem = model.problem;
  model.material_of_face =
      materials_of_faces(problem, *model.mesh, *model.adjacency, model.mesh->points.span());
  for (std::size_t f = 0; f < model.material_of_face.size(); ++f)
    if (model.material_of_face[f] < 0)
      fail_no_material(problem, FaceId(static_cast<std::int64_t>(f)));
}

/// Makes hanging vertices corners of the faces in whose sides they are.
void set_mesh(ShellModel& model, Mesh mesh, std::span<const HangingVertex> hanging) {
  model.hangs = IdArray<VertexId, char>(static_cast<std::size_t>(mesh.points.size()), 0);
  for (const HangingVertex& h : hanging)
    model.hangs[h.vertex] = 1;
  model.faces = hanging_faces(mesh.topology, hanging);
  mesh.topology = model.faces.topology;
  model.mesh = std::make_unique<Mesh>(std::move(mesh));
}

/// @param normal  at each corner; empty: those of the faces
ShellModel model_on(const Problem& problem, Mesh mesh, const std::vector<TiedEdge>& tied,
                    const IdArray<HalfedgeId, Vec3>& normal,
                    std::span<const HangingVertex> hanging) {
  ShellModel model;
  model.problem = problem;
  set_mesh(model, std::move(mesh), hanging);
  const IdArray<HalfedgeId, Vec3> flat = face_normals(model, mesh_path(problem).string());
  model.adjacency = std::make_unique<Adjacency>(model.mesh->topology);
  set_size(model);
  require_coincident(problem, *model.mesh, tied, model.diagonal);
  model.node = tied_nodes(model.mesh->topology.num_vertices(), tied);
  set_directors(model, normal.empty() ? flat : normal, !tied.empty());
  set_materials(model);
  return model;
}

}  // namespace

ShellQuad ShellModel::quad(FaceId face) const {
  ShellQuad out;
  for (int i = 0; i < 4; ++i) {
    const HalfedgeId h = corner(face, i);
    out.x[static_cast<std::size_t>(i)] = mesh->points[mesh->topology.corner(h)];
    out.director[static_cast<std::size_t>(i)] = director[h];
  }
  return out;
}

ShellSection ShellModel::section(FaceId face) const {
  const auto m = static_cast<std::size_t>(material_of_face[static_cast<std::size_t>(face.value)]);
  const MaterialSettings& material = problem.materials[m];
  return {material.young, material.poisson, material.thickness, problem.model.shear_factor,
          problem.model.assumed_membrane ? MembraneStrain::assumed : MembraneStrain::displacement};
}

ShellVector ShellModel::unknowns(FaceId face, const VectorX& u) const {
  ShellVector out;
  for (int i = 0; i < 4; ++i)
    out.segment<6>(6 * i) = u.segment<6>(6 * node_at(face, i).value);
  return out;
}

void ShellModel::scatter(FaceId face, const ShellVector& element, VectorX& out) const {
  for (int i = 0; i < 4; ++i)
    out.segment<6>(6 * node_at(face, i).value) += element.segment<6>(6 * i);
}

void require_shell_control(const Problem& problem, const Mesh& control) {
  const std::string file = mesh_path(problem).string();
  require_surface(control, file);
  const Scheme& scheme = find_scheme(problem.mesh.scheme);
  if (scheme.split != Split::quads || !(has_exact_limit(scheme) || scheme.interpolatory))
    fail_at(culprit(problem.mesh.origin.of("scheme"), {problem.model.origin.of("kind")}),
            "scheme \"{}\" gives no quads with points on its surface; kind \"mitc4\" takes "
            "catmull-clark, kobbelt or linear",
            problem.mesh.scheme);
  if (!control.tags.holes.empty())
    throw InputError(
        "{}: face {} is a hole; kind \"mitc4\" knows no hole faces, leave them out of the mesh",
        place_of(control, control.tags.holes.front(), file), control.tags.holes.front().value);
}

ShellModel shell_model_on(const Problem& problem, Mesh mesh, const std::vector<TiedEdge>& tied,
                          std::span<const HangingVertex> hanging) {
  return model_on(problem, std::move(mesh), tied, {}, hanging);
}

ShellModel build_shell_model(const Problem& problem, Mesh control) {
  require_shell_control(problem, control);
  if (problem.mesh.smooth_start > 0 && !problem.mesh.exact)
    control = refined_on_surfaces(problem, std::move(control), 0);
  const int levels = problem.mesh.levels;
  const Scheme& scheme = find_scheme(problem.mesh.scheme);
  const BoundaryRule boundary = control.tags.boundary.value_or(BoundaryRule::edges);
  Mesh mesh = problem.mesh.exact
                  ? refined_on_surfaces(problem, control, levels)
                  : refine_control(problem, control, {.levels = levels, .boundary = boundary});
  const std::string file = mesh_path(problem).string();
  require_quads(mesh, file);
  if (problem.mesh.smoothing > 0 && !problem.mesh.exact)
    slide_on_limit(problem, mesh, scheme, boundary, control.topology.num_vertices());
  IdArray<HalfedgeId, Vec3> normal;
  if (scheme.patch == LimitPatch::bicubic && !problem.mesh.exact)
    normal = move_to_limit(mesh, scheme, boundary, file);
  const auto tied = refined_seams(control, seams_of(problem, control), levels);
  ShellModel model = model_on(problem, std::move(mesh), tied, normal, {});
  model.control = std::move(control);
  return model;
}

ShellModel read_shell_model(const Problem& problem, const ModelOptions& options) {
  MeshFile file = read_control_mesh(problem, options);
  ShellModel model = build_shell_model(problem, std::move(file.mesh));
  model.remarks = std::move(file.remarks);
  return model;
}

}  // namespace limes
