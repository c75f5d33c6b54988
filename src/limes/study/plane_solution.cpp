#include "limes/study/plane_solution.h"

#include <cmath>

#include "limes/core/error.h"
#include "limes/core/interrupt.h"
#include "limes/solve/linear.h"
#include "limes/space/boundary_trace.h"
#include "limes/study/error_estimate.h"
#include "limes/study/periodic_cell.h"
#include "limes/study/plane_loads.h"
#include "limes/study/supports.h"

namespace limes {
namespace {

std::vector<ConstraintRow> joined(std::vector<ConstraintRow> rows,
                                  const std::vector<ConstraintRow>& more) {
  rows.insert(rows.end(), more.begin(), more.end());
  return rows;
}

/// The system after elimination.
struct Reduced {
  Elimination fix;
  DirectSolver solver;

  Reduced(const SparseMatrix& K, const std::vector<ConstraintRow>& rows)
      : fix(eliminate(static_cast<int>(K.rows()), rows)),
        solver(SparseMatrix(fix.T.transpose() * K * fix.T)) {}
};

/// Solves for several right-hand sides; also tells the residual.
MatrixX solve_reduced(const SparseMatrix& K, const std::vector<ConstraintRow>& rows,
                      const MatrixX& f, PlaneSolution& solution) {
  const Reduced system(K, rows);
  const MatrixX reduced = system.fix.T.transpose() * f;
  const MatrixX free = system.solver.solve(reduced);
  solution.num_unknowns = system.fix.num_free();
  solution.solver_residual = system.solver.relative_residual(free, reduced);
  solution.rounding_floor = system.solver.rounding_floor(free, reduced);
  return system.fix.T * free;
}

using Positions = Eigen::Matrix<double, Eigen::Dynamic, 3>;

/// Force and moment of nodal forces. Rigid motions are in the space, so these are exact.
PlaneResultant resultant_of(const VectorX& f, const Positions& x,
                            const Vec2& about = Vec2::Zero()) {
  PlaneResultant sum = PlaneResultant::Zero();
  for (Eigen::Index a = 0; a < x.rows(); ++a) {
    const Vec2 force = f.segment<2>(2 * a);
    const Vec2 arm = x.row(a).head<2>().transpose() - about;
    sum += PlaneResultant(force.x(), force.y(), arm.x() * force.y() - arm.y() * force.x());
  }
  return sum;
}

/// The rows of supports, each of length 1, on the unknowns that continuity leaves free.
SparseMatrix support_rows(const Constraints& constraints, const Elimination& continuous) {
  std::vector<Triplet> entries;
  for (std::size_t r = 0; r < constraints.rows.size(); ++r)
    for (const auto& [unknown, weight] : constraints.rows[r])
      for (SparseMatrix::InnerIterator it(continuous.T, unknown); it; ++it)
        entries.emplace_back(static_cast<int>(r), static_cast<int>(it.col()), weight * it.value());
  SparseMatrix C(static_cast<Eigen::Index>(constraints.rows.size()), continuous.T.cols());
  C.setFromTriplets(entries.begin(), entries.end());
  for (int r = 0; r < C.outerSize(); ++r) {
    const double length = std::sqrt(C.row(r).squaredNorm());
    if (length > 0) C.row(r) /= length;
  }
  return C;
}

/// Splits the residual K u - f = C^T lambda among the supports, and says what they leave of f. Forces
/// that only hold the regions of the space and hanging vertices in place are taken out before. Conditions that two supports
/// share are carried by both.
void set_reactions(const PlaneModel& model, const std::vector<ConstraintRow>& between_elements,
                   const Constraints& constraints, const VectorX& f, const VectorX& residual,
                   PlaneSolution& solution) {
  const Positions x = model.space->position_coefficients();
  solution.imbalance = resultant_of(f, x, model.centre);
  const Elimination continuous = eliminate(static_cast<int>(residual.size()), between_elements);
  const SparseMatrix C = support_rows(constraints, continuous);
  const VectorX lambda = DirectSolver(SparseMatrix(C * C.transpose()))
                             .solve(C * (continuous.T.transpose() * residual));
  for (const Constraints::Source& source : constraints.sources) {
    VectorX own = VectorX::Zero(residual.size());
    for (int r = source.first; r < source.last; ++r)
      for (SparseMatrix::InnerIterator it(C, r); it; ++it)
        own(continuous.unknown(static_cast<int>(it.col()))) += lambda(r) * it.value();
    solution.reactions.push_back({source.where, resultant_of(own, x)});
    solution.imbalance += resultant_of(own, x, model.centre);
  }
}

double thickness_of_cell(const PlaneModel& model) {
  const double t = model.problem.materials.front().thickness;
  for (const MaterialSettings& m : model.problem.materials)
    if (m.thickness != t)
      fail_at(culprit(m.origin.of("thickness"),
                      {model.problem.materials.front().origin.of("thickness")}),
              "a periodic cell has one thickness; here are {} and {}", t, m.thickness);
  return t;
}

void require_no_supports(const Problem& problem) {
  const auto fail = [&](const char* what, const Origin& origin) {
    fail_at(culprit(origin.table, {problem.periodic->origin.override_or_table()}),
            "a periodic cell is driven by its gradient alone; remove this [[{}]]", what);
  };
  if (!problem.supports.empty()) fail("support", problem.supports.front().origin);
  if (!problem.loads.empty()) fail("load", problem.loads.front().origin);
}

}  // namespace

PlaneSolution solve_supported(const PlaneModel& model) {
  PlaneSolution solution;
  const Constraints constraints = support_constraints(model);
  const std::vector<ConstraintRow> continuous = on_both_components(continuity(*model.space));
  require_no_rigid_motion(model, joined(continuous, constraints.rows));
  const std::vector<ConstraintRow> between_elements =
      joined(continuous, on_both_components(hanging_rows(model)));
  const std::vector<ConstraintRow> rows = joined(between_elements, constraints.rows);
  const VectorX f = assemble_loads(model);
  check_interrupt();
  const SparseMatrix K = elasticity_matrix(*model.space, model.C);
  check_interrupt();
  solution.u = solve_reduced(K, rows, f, solution);
  const VectorX internal = K * solution.u;
  solution.strain_energy = 0.5 * solution.u.dot(internal);
  solution.load_size = f.lpNorm<1>();
  solution.loads = resultant_of(f, model.space->position_coefficients());
  set_reactions(model, between_elements, constraints, f, internal - f, solution);
  return solution;
}

PlaneSolution solve_periodic(const PlaneModel& model) {
  require_no_supports(model.problem);
  PlaneSolution solution;
  const PeriodicCell cell = find_periodic_cell(model);
  const double volume = cell.area() * thickness_of_cell(model);
  const std::vector<ConstraintRow> rows =
      joined(on_both_components(continuity(*model.space)), periodic_constraints(model, cell));
  require_no_rigid_motion(model, rows);
  check_interrupt();
  const SparseMatrix K = elasticity_matrix(*model.space, model.C);
  const UnitStrainLoad unit = unit_strain_load(*model.space, model.C);
  check_interrupt();
  // Fluctuations for the three unit strains; the given gradient is a combination of them.
  const MatrixX chi = solve_reduced(K, rows, -unit.f, solution);

  PlaneSolution::Homogenised h;
  h.stiffness = (unit.integral_of_C + unit.f.transpose() * chi) / volume;
  h.width = cell.width;
  h.height = cell.height;
  solution.gradient = model.problem.periodic->gradient - Mat2::Identity();
  const Mat2& g = solution.gradient;
  h.strain = Vec3(g(0, 0), g(1, 1), g(0, 1) + g(1, 0));
  h.stress = h.stiffness * h.strain;
  solution.u = chi * h.strain;
  // Energy of the total strain, from the fields themselves.
  solution.strain_energy =
      0.5 * (h.strain.dot(unit.integral_of_C * h.strain) +
             2.0 * h.strain.dot(unit.f.transpose() * solution.u) + solution.u.dot(K * solution.u));
  solution.homogenised = h;
  return solution;
}

PlaneSolution solve_plane(const PlaneModel& model) {
  return model.problem.periodic ? solve_periodic(model) : solve_supported(model);
}

std::vector<PlaneState> states(const PlaneModel& model, const PlaneSolution& solution, int element,
                               const ElementTable& table) {
  ElementPoints points;
  to_physical(table, model.space->control_points(element), points);
  const auto u = element_field(*model.space, element, solution.u);
  const auto strain = strains(points, u);
  const Mat3 C = model.C[static_cast<std::size_t>(element)] / model.thickness(element);
  const Mat2& g = solution.gradient;
  const Vec3 macroscopic(g(0, 0), g(1, 1), g(0, 1) + g(1, 0));
  std::vector<PlaneState> out;
  for (Eigen::Index i = 0; i < strain.rows(); ++i) {
    PlaneState s;
    s.x = points.x.row(i).transpose();
    s.u = g * s.x.head<2>() + (table.N.row(i) * u).transpose();
    s.strain = macroscopic + strain.row(i).transpose();
    s.stress = C * s.strain;
    s.von_mises = von_mises(s.stress, model.material(element), model.assumption());
    out.push_back(s);
  }
  return out;
}

EnergyDensity energy_density(const PlaneModel& model, const PlaneSolution& solution) {
  return {[&](int e, const ElementTable& table) {
            ElementPoints points;
            to_physical(table, model.space->control_points(e), points);
            return MatrixX(strains(points, element_field(*model.space, e, solution.u)));
          },
          [&](int e) { return MatrixX(model.C[static_cast<std::size_t>(e)]); }};
}

std::vector<double> estimate_error(const PlaneModel& model, const PlaneSolution& solution) {
  return estimate_error(model, energy_density(model, solution));
}

}  // namespace limes
