#include "limes/study/poisson_solution.h"

#include <cmath>

#include "limes/core/error.h"
#include "limes/core/interrupt.h"
#include "limes/fem/assemble.h"
#include "limes/solve/linear.h"
#include "limes/space/constraints.h"
#include "limes/study/error_estimate.h"
#include "limes/study/poisson_conditions.h"

namespace limes {
namespace {

VectorX element_values(const PlaneModel& model, int element, const VectorX& u) {
  const auto dofs = model.space->dofs(element);
  VectorX out(static_cast<Eigen::Index>(dofs.size()));
  for (std::size_t a = 0; a < dofs.size(); ++a)
    out(static_cast<Eigen::Index>(a)) = u(dofs[a]);
  return out;
}

SparseMatrix poisson_matrix(const PlaneModel& model) {
  return assemble(*model.space, 1, [&](int e, MatrixX& K) {
    const ElementTable& table =
        model.space->table(model.space->elements()[static_cast<std::size_t>(e)].shape);
    ElementPoints p;
    to_physical(table, model.space->control_points(e), p);
    const VectorX k = model.conductivity(e) * p.J.cwiseAbs().cwiseProduct(table.weight);
    K = p.Nx.transpose() * k.asDiagonal() * p.Nx + p.Ny.transpose() * k.asDiagonal() * p.Ny;
  });
}

/// Values of supports, as far as they reach, and the rows that fix them and the hanging vertices.
struct Held {
  VectorX values;
  std::vector<ConstraintRow> rows;
};

Held held(const PlaneModel& model, const std::vector<HeldVertex>& vertices,
          const std::vector<ConstraintRow>& hanging) {
  Held out{VectorX::Zero(model.space->num_dofs()), hanging};
  for (const HeldVertex& v : vertices) {
    out.values(v.dof) = v.value;
    out.rows.push_back({{v.dof, 1.0}});
  }
  for (const ConstraintRow& row : hanging)
    for (std::size_t k = 1; k < row.size(); ++k)
      out.values(row[0].first) += row[k].second * out.values(row[k].first);
  return out;
}

/// Forces at hanging vertices go to the ends of their sides.
VectorX carried_to_ends(VectorX f, const std::vector<ConstraintRow>& hanging) {
  for (const ConstraintRow& row : hanging)
    for (std::size_t k = 1; k < row.size(); ++k)
      f(row[k].first) += row[k].second * f(row[0].first);
  return f;
}

void set_reactions(const PlaneModel& model, const std::vector<HeldVertex>& vertices,
                   const VectorX& residual, PoissonSolution& solution) {
  for (const SupportSettings& s : model.problem.supports)
    solution.reactions.push_back({s.where, 0});
  solution.imbalance = solution.load;
  for (const HeldVertex& v : vertices) {
    solution.reactions[static_cast<std::size_t>(v.support)].flux += residual(v.dof);
    solution.reaction_size += std::abs(residual(v.dof));
    solution.imbalance += residual(v.dof);
  }
}

MatrixX gradients(const PlaneModel& model, const PoissonSolution& solution, int element,
                  const ElementTable& table) {
  ElementPoints points;
  to_physical(table, model.space->control_points(element), points);
  const VectorX u = element_values(model, element, solution.u);
  MatrixX out(points.J.size(), 2);
  out << points.Nx * u, points.Ny * u;
  return out;
}

}  // namespace

PoissonSolution solve_poisson(const PlaneModel& model) {
  PoissonSolution solution;
  const std::vector<HeldVertex> vertices = held_vertices(model);
  const std::vector<ConstraintRow> hanging = hanging_rows(model);
  const Held fixed = held(model, vertices, hanging);
  const VectorX f = poisson_loads(model);
  check_interrupt();
  const SparseMatrix K = poisson_matrix(model);
  const Elimination free = eliminate(model.space->num_dofs(), fixed.rows);
  check_interrupt();
  if (free.num_free() == 0)
    fail_at(culprit(place_of_supports(model.problem), {model.problem.mesh.origin.of("levels")}),
            "supports hold all vertices; refine the mesh, [mesh] levels = 1");
  const VectorX load = free.T.transpose() * (f - K * fixed.values);
  const DirectSolver solver(SparseMatrix(free.T.transpose() * K * free.T));
  const MatrixX x = solver.solve(load);
  solution.num_unknowns = free.num_free();
  solution.solver_residual = solver.relative_residual(x, load);
  solution.rounding_floor = solver.rounding_floor(x, load);
  solution.u = fixed.values + free.T * x;
  const VectorX internal = K * solution.u;
  solution.strain_energy = 0.5 * solution.u.dot(internal);
  solution.load = f.sum();
  solution.load_size = f.lpNorm<1>();
  set_reactions(model, vertices, carried_to_ends(internal - f, hanging), solution);
  return solution;
}

std::vector<PoissonState> states(const PlaneModel& model, const PoissonSolution& solution,
                                 int element, const ElementTable& table) {
  const Eigen::Matrix<double, Eigen::Dynamic, 3> x = table.G * model.space->control_points(element);
  const VectorX u = table.N * element_values(model, element, solution.u);
  const MatrixX gradient = gradients(model, solution, element, table);
  std::vector<PoissonState> out;
  for (Eigen::Index i = 0; i < u.size(); ++i)
    out.push_back({x.row(i).transpose(), u(i), gradient.row(i).transpose()});
  return out;
}

std::vector<PoissonProbe> probe(const PlaneModel& model, const PoissonSolution& solution) {
  std::vector<PoissonProbe> out;
  for (ProbePlace& place : probe_places(model)) {
    const int shape = model.space->elements()[static_cast<std::size_t>(place.element)].shape;
    const PoissonState state =
        states(model, solution, place.element, model.space->sample(shape, {place.uv})).front();
    out.push_back({std::move(place), state});
  }
  return out;
}

std::vector<SolutionCheck> check_solution(const PlaneModel& /*model*/,
                                          const PoissonSolution& solution) {
  const double size = solution.load_size + solution.reaction_size;
  return {{"residual of the linear solver", solution.solver_residual,
           std::max(1e-9, solution.rounding_floor)},
          {"balance of fluxes", std::abs(solution.imbalance) / (size > 0 ? size : 1.0),
           std::max(1e-8, solution.rounding_floor)}};
}

EnergyDensity energy_density(const PlaneModel& model, const PoissonSolution& solution) {
  return {[&](int e, const ElementTable& table) { return gradients(model, solution, e, table); },
          [&](int e) { return MatrixX(model.conductivity(e) * MatrixX::Identity(2, 2)); }};
}

std::vector<double> estimate_error(const PlaneModel& model, const PoissonSolution& solution) {
  return estimate_error(model, energy_density(model, solution));
}

}  // namespace limes
