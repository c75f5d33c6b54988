#pragma once

#include "limes/study/plane_solution.h"

namespace limes {

/// A property that a good solution has, and how well this one has it.
struct SolutionCheck {
  std::string name;
  double value;
  double limit;  ///< passed if value <= limit
  [[nodiscard]] bool passed() const { return value <= limit; }
};

/// Equilibrium, residual of the solver, consistency of averages, and the error of the quadrature.
[[nodiscard]] std::vector<SolutionCheck> check_solution(const PlaneModel& model,
                                                        const PlaneSolution& solution);

}  // namespace limes
