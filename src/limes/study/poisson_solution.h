#pragma once

#include "limes/adapt/loop.h"
#include "limes/adapt/zienkiewicz_zhu.h"
#include "limes/study/checks.h"
#include "limes/study/probes.h"

namespace limes {

/// The solution of -div(k grad u) = source with bilinear elements.
struct PoissonSolution {
  VectorX u;  ///< one coefficient per dof of the space

  int num_unknowns = 0;        ///< after elimination
  double strain_energy = 0;    ///< integral of k |grad u|^2 / 2
  double solver_residual = 0;  ///< relative
  double rounding_floor = 0;   ///< what rounding alone may leave of it
  double load = 0;             ///< all sources and fluxes together
  double load_size = 0;        ///< the sum of their magnitudes at the vertices
  struct Reaction {
    std::string where;  ///< of the support
    double flux;        ///< through it into the body
  };
  std::vector<Reaction> reactions;
  double reaction_size = 0;  ///< the sum of the magnitudes at the vertices
  double imbalance = 0;      ///< of load and reactions: zero but for rounding
};

/// Supports give values at all selected vertices.
/// @throws InputError for a face that is no quad, a piece of the mesh without a support, a vertex with
///         two values, and selections that meet nothing; SolverError if the factorisation fails
[[nodiscard]] PoissonSolution solve_poisson(const PlaneModel& model);

/// What is at a point.
struct PoissonState {
  Vec3 x;
  double value;
  Vec2 gradient;
};
/// States at the points of a table of the element's shape.
[[nodiscard]] std::vector<PoissonState> states(const PlaneModel& model,
                                               const PoissonSolution& solution, int element,
                                               const ElementTable& table);

struct PoissonProbe : ProbePlace {
  PoissonState state;
};
[[nodiscard]] std::vector<PoissonProbe> probe(const PlaneModel& model,
                                              const PoissonSolution& solution);

[[nodiscard]] std::vector<SolutionCheck> check_solution(const PlaneModel& model,
                                                        const PoissonSolution& solution);

/// The energy of a solution. Both arguments must outlive it.
[[nodiscard]] EnergyDensity energy_density(const PlaneModel& model,
                                           const PoissonSolution& solution);

/// Squared errors of the faces, see error_estimate.h.
[[nodiscard]] std::vector<double> estimate_error(const PlaneModel& model,
                                                 const PoissonSolution& solution);

}  // namespace limes
