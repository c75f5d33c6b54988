#include "limes/study/plane_model.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "limes/core/error.h"
#include "limes/limit/limit_surface.h"
#include "limes/mesh/defects.h"
#include "limes/mesh/face_error.h"
#include "limes/study/materials.h"
#include "limes/study/poisson_conditions.h"
#include "limes/study/refine_control.h"
#include "limes/subdiv/drop_faces.h"
#include "limes/subdiv/schemes.h"

namespace limes {
namespace {

/// BoundaryRule::none: the faces that refinement would leave out only shape the others, as holes do.
void drop_boundary_faces(PlaneModel& model) {
  const Topology& t = model.control.topology;
  const std::vector<bool> drop = unsupported_faces(Adjacency(t), model.control.tags);
  std::vector<FaceId>& holes = model.control.tags.holes;
  for (int f = 0; f < t.num_faces(); ++f)
    if (drop[static_cast<std::size_t>(f)]) holes.emplace_back(f);
  std::sort(holes.begin(), holes.end());
  holes.erase(std::unique(holes.begin(), holes.end()), holes.end());
  model.boundary = BoundaryRule::edges;
}

/// Limit points of the vertices, and the size of the box around them; all in one plane z = const.
void set_limit_points(const Mesh& mesh, const LimitBasis& basis, PlaneModel& model) {
  model.limit_points = limit_positions(LimitSurface(basis, mesh.points.span()), mesh.points.span());
  Eigen::AlignedBox3d box;
  int first = -1;
  for (int v = 0; v < mesh.points.size(); ++v) {
    if (!basis.adjacency().ring_start(VertexId(v)).valid()) continue;
    if (first < 0) first = v;
    box.extend(model.limit_points[VertexId(v)]);
  }
  model.diagonal = box.diagonal().norm();
  model.centre = box.center().head<2>();
  const double z = model.limit_points[VertexId(first)].z();
  model.z = z;
  for (int v = 0; v < mesh.points.size(); ++v) {
    const bool used = basis.adjacency().ring_start(VertexId(v)).valid();
    const double dz = model.limit_points[VertexId(v)].z() - z;
    if (used && std::abs(dz) > 1e-9 * model.diagonal)
      throw InputError(
          "{}: the mesh is not plane: z is {} at vertex {} and {} at vertex {}; plane models need "
          "one z",
          mesh_path(model.problem).string(), z, first, z + dz, v);
  }
}

/// Elements are squares on which the limit is known exactly.
const Scheme& element_scheme(const Problem& problem) {
  const Scheme& scheme = find_scheme(problem.mesh.scheme);
  if (!has_exact_limit(scheme) || scheme.split == Split::triangles)
    fail_at(culprit(problem.mesh.origin.of("scheme"), {problem.model.origin.of("kind")}),
            "there are no plane elements of the scheme \"{}\"; right is \"catmull-clark\" or "
            "\"linear\"",
            scheme.name);
  return scheme;
}

void require_unfolded(const PlaneModel& model) {
  const std::optional<Fold> fold = find_fold(*model.space);
  if (!fold) return;
  const FaceId face = model.control_face(fold->face);
  throw InputError(
      "{}: face {}: the surface is folded or degenerate near ({:.6g}, {:.6g}); the faces must "
      "cover the plane once",
      place_of(model.control, face, mesh_path(model.problem).string()), face.value, fold->x.x(),
      fold->x.y());
}

}  // namespace

ClosedMesh::ClosedMesh(Mesh quads, std::span<const HangingVertex> vertices)
    : faces(hanging_faces(quads.topology, vertices)),
      mesh(std::move(quads)),
      adjacency(faces.topology) {
  mesh.topology = faces.topology;
  std::vector<bool> in_hole(static_cast<std::size_t>(mesh.points.size()), false);
  for (const FaceId hole : mesh.tags.holes)
    for (int i = 0; i < 4; ++i)
      if (const HalfedgeId h = faces.inside(hole, i); h.valid())
        in_hole[static_cast<std::size_t>(faces.topology.corner(h).value)] = true;
  for (const HangingVertex& h : vertices)
    if (!in_hole[static_cast<std::size_t>(h.vertex.value)]) hanging.push_back(h);
}

Selection PlaneModel::selection(const std::string& where, const Place& place) const {
  return {closed ? closed->mesh : mesh(), neighbours(), limit_points.span(), where, place};
}

FaceId PlaneModel::control_face(FaceId face) const {
  int id = face.value;  // see subdiv/split.h
  for (int level = problem.mesh.levels; level > 1; --level)
    id /= 4;
  return problem.mesh.levels > 0 ? Adjacency(control.topology).face(HalfedgeId(id)) : face;
}

PlaneAssumption PlaneModel::assumption() const {
  return problem.model.kind == ModelKind::plane_strain ? PlaneAssumption::strain
                                                       : PlaneAssumption::stress;
}

Isotropic PlaneModel::material(int element) const {
  const int m = material_of_element[static_cast<std::size_t>(element)];
  const MaterialSettings& settings = problem.materials[static_cast<std::size_t>(m)];
  return {settings.young, settings.poisson};
}

double PlaneModel::thickness(int element) const {
  const int m = material_of_element[static_cast<std::size_t>(element)];
  return problem.materials[static_cast<std::size_t>(m)].thickness;
}

double PlaneModel::conductivity(int element) const {
  const int m = material_of_element[static_cast<std::size_t>(element)];
  return problem.materials[static_cast<std::size_t>(m)].conductivity;
}

JoinsFaces PlaneModel::same_material() const {
  std::vector<int> of_face(static_cast<std::size_t>(mesh().topology.num_faces()), -1);
  for (std::size_t e = 0; e < material_of_element.size(); ++e)
    of_face[static_cast<std::size_t>(space->elements()[e].face.value)] = material_of_element[e];
  return [this, of_face = std::move(of_face)](HalfedgeId h) {
    const Adjacency& a = neighbours();
    return of_face[static_cast<std::size_t>(a.face(h).value)] ==
           of_face[static_cast<std::size_t>(a.face(a.twin(h)).value)];
  };
}

PlaneModel build_model(const Problem& problem, Mesh control,
                       std::span<const HangingVertex> hanging) {
  const Scheme& scheme = element_scheme(problem);
  PlaneModel model;
  if (hanging.empty())
    require_refinable(control, mesh_path(problem).string());
  else {
    // Bilinear functions kink at every edge, and tags name edges that hanging vertices cut.
    control.tags.creases.clear();
    control.tags.corners.clear();
    model.closed = std::make_unique<ClosedMesh>(control, hanging);
  }
  const auto check = model.closed ? Adjacency::Check::edges : Adjacency::Check::surface;
  model.problem = problem;
  model.boundary = control.tags.boundary.value_or(BoundaryRule::edges);
  model.control = std::move(control);
  if (model.boundary == BoundaryRule::none) drop_boundary_faces(model);
  Mesh mesh = model.closed
                  ? model.control
                  : refine_control(problem, model.control,
                                   {.levels = problem.mesh.levels, .boundary = model.boundary});
  const Adjacency adjacency(mesh.topology, check);
  const LimitBasis basis(mesh.topology, resolve_tags(adjacency, mesh.tags, model.boundary), scheme,
                         check);
  set_limit_points(mesh, basis, model);

  const std::vector<int> material = materials_of_faces(
      problem, model.closed ? model.closed->mesh : mesh,
      model.closed ? model.closed->adjacency : adjacency, model.limit_points.span());
  std::vector<int> regions;
  // bilinear functions kink at every edge
  if (problem.model.kinks && problem.model.kind != ModelKind::poisson && !model.closed)
    for (const int m : material)
      regions.push_back(std::max(m, 0));
  model.space = std::make_unique<SubdivisionSpace>(
      std::move(mesh), scheme, model.boundary, std::move(regions),
      SpaceOptions{problem.model.boundary == FieldBoundary::free,
                   {problem.model.quadrature_points, problem.model.quadrature_depth},
                   check});
  require_unfolded(model);
  for (const Element& e : model.space->elements()) {
    const int m = material[static_cast<std::size_t>(e.face.value)];
    if (m < 0) fail_no_material(problem, e.face);
    model.material_of_element.push_back(m);
  }
  if (problem.model.kind == ModelKind::poisson) return model;
  for (int e = 0; e < static_cast<int>(model.space->elements().size()); ++e)
    model.C.push_back(model.thickness(e) *
                      plane_elasticity_matrix(model.material(e), model.assumption()));
  return model;
}

std::vector<ConstraintRow> hanging_rows(const PlaneModel& model) {
  std::vector<ConstraintRow> out;
  if (!model.closed) return out;
  const auto dof = [&](VertexId v) { return dof_of_vertex(*model.space, v); };
  for (const HangingVertex& h : model.closed->hanging)
    if (dof(h.vertex) >= 0)  // else what is split beyond the side are holes
      out.push_back({{dof(h.vertex), -1.0}, {dof(h.ends[0]), 0.5}, {dof(h.ends[1]), 0.5}});
  return out;
}

PlaneModel read_model(const Problem& problem, const ModelOptions& options) {
  MeshFile file = read_control_mesh(problem, options);
  PlaneModel model = build_model(problem, std::move(file.mesh));
  model.remarks = std::move(file.remarks);
  return model;
}

}  // namespace limes
