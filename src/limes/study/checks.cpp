#include "limes/study/checks.h"

#include <algorithm>
#include <cmath>

namespace limes {
namespace {

double relative(double value, double scale) {
  return scale > 0 ? value / scale : value;
}

/// Area of the model with the space's own quadrature, and the stress resultants over it.
struct Integrals {
  double area = 0;
  Vec3 stress = Vec3::Zero();  ///< integral of stress times thickness
};

Integrals integrate(const PlaneModel& model, const PlaneSolution& solution) {
  Integrals out;
  const SubdivisionSpace& space = *model.space;
  for (int e = 0; e < static_cast<int>(space.elements().size()); ++e) {
    const ElementTable& table = space.table(space.elements()[static_cast<std::size_t>(e)].shape);
    ElementPoints p;
    to_physical(table, space.control_points(e), p);
    const auto state = states(model, solution, e, table);
    for (Eigen::Index i = 0; i < p.J.size(); ++i) {
      const double dA = std::abs(p.J(i)) * table.weight(i);
      out.area += dA;
      out.stress += dA * model.thickness(e) * state[static_cast<std::size_t>(i)].stress;
    }
  }
  return out;
}

/// The area with rings of tiles twice as deep around extraordinary vertices.
double deeper_area(const PlaneModel& model) {
  const SubdivisionSpace& space = *model.space;
  const ModelSettings& settings = model.problem.model;
  std::vector<ElementTable> tables;
  for (int s = 0; s < space.num_shapes(); ++s)
    tables.push_back(
        space.quadrature(s, {settings.quadrature_points + 1, 2 * settings.quadrature_depth + 4}));
  double area = 0;
  ElementPoints p;
  for (int e = 0; e < static_cast<int>(space.elements().size()); ++e) {
    const ElementTable& table =
        tables[static_cast<std::size_t>(space.elements()[static_cast<std::size_t>(e)].shape)];
    to_physical(table, space.control_points(e), p);
    area += p.J.cwiseAbs().dot(table.weight);
  }
  return area;
}

/// Forces relative to the sum of what acts, moments about the model's centre to that times its size.
void add_equilibrium(const PlaneModel& model, const PlaneSolution& solution,
                     std::vector<SolutionCheck>& checks) {
  const PlaneResultant& sum = solution.imbalance;
  const double scale = solution.load_size > 0 ? solution.load_size : 1.0;
  const double limit = std::max(1e-8, solution.rounding_floor);
  checks.push_back({"equilibrium of forces", sum.head<2>().norm() / scale, limit});
  checks.push_back({"equilibrium of moments", std::abs(sum(2)) / (scale * model.diagonal), limit});
}

}  // namespace

std::vector<SolutionCheck> check_solution(const PlaneModel& model, const PlaneSolution& solution) {
  std::vector<SolutionCheck> checks;
  const Integrals integrals = integrate(model, solution);
  checks.push_back({"residual of the linear solver", solution.solver_residual,
                    std::max(1e-9, solution.rounding_floor)});
  if (solution.homogenised) {
    const PlaneSolution::Homogenised& h = *solution.homogenised;
    const double volume = h.width * h.height * model.problem.materials.front().thickness;
    const Vec3 average = integrals.stress / volume;
    const double scale = h.stiffness.norm() * h.strain.norm();  // a cell may carry nothing at all
    checks.push_back({"average stress = stiffness x strain",
                      relative((average - h.stress).norm(), scale), 1e-8});
    const double work = 0.5 * volume * h.stress.dot(h.strain);
    checks.push_back(
        {"macroscopic work = strain energy",
         relative(std::abs(work - solution.strain_energy), volume * scale * h.strain.norm()),
         1e-8});
    checks.push_back({"symmetry of the stiffness",
                      (h.stiffness - h.stiffness.transpose()).norm() / h.stiffness.norm(), 1e-8});
  } else {
    add_equilibrium(model, solution, checks);
  }
  const double deep = deeper_area(model);
  checks.push_back(
      {"quadrature: area against a deeper rule", std::abs(integrals.area - deep) / deep, 1e-4});
  return checks;
}

}  // namespace limes
