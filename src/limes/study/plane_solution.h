#pragma once

#include <optional>

#include "limes/adapt/zienkiewicz_zhu.h"
#include "limes/study/plane_model.h"

namespace limes {

/// Resultant of forces: fx, fy, moment about z; about the origin unless another point is named.
using PlaneResultant = Vec3;

/// The solution of a plane problem.
struct PlaneSolution {
  VectorX u;                     ///< coefficients, unknown 2 a + i
  Mat2 gradient = Mat2::Zero();  ///< displacement = gradient x + field u (periodic cells: F - 1)

  int num_unknowns = 0;        ///< after elimination
  double strain_energy = 0;    ///< of the modelled part
  double solver_residual = 0;  ///< relative
  double rounding_floor = 0;   ///< what rounding alone may leave of it
  PlaneResultant loads = PlaneResultant::Zero();
  double load_size = 0;  ///< sum of the magnitudes of all nodal loads
  /// Of loads and reactions together, about the model's centre: zero but for rounding.
  PlaneResultant imbalance = PlaneResultant::Zero();
  struct Reaction {
    std::string where;  ///< of the support
    PlaneResultant force;
  };
  std::vector<Reaction> reactions;

  /// Of a periodic cell, holes counting as zero stress; Voigt order xx, yy, xy.
  struct Homogenised {
    Mat3 stiffness;       ///< average stress per macroscopic strain
    Vec3 strain, stress;  ///< macroscopic
    double width, height;
  };
  std::optional<Homogenised> homogenised;
};

/// Solves a problem that is held by supports.
/// @throws InputError for a rigid motion left free, SolverError if the factorisation fails
[[nodiscard]] PlaneSolution solve_supported(const PlaneModel& model);

/// Solves a periodic cell for its macroscopic deformation gradient, and for unit strains.
/// @throws InputError if boundaries do not match or a piece floats
[[nodiscard]] PlaneSolution solve_periodic(const PlaneModel& model);

/// Either, as the problem asks.
[[nodiscard]] PlaneSolution solve_plane(const PlaneModel& model);

/// Displacement, strain and stress at one point.
struct PlaneState {
  Vec3 x;
  Vec2 u;
  Vec3 strain, stress;  ///< Voigt order xx, yy, xy
  double von_mises;
};

/// States at the points of a table.
/// @param table  of the element's shape: quadrature or samples
[[nodiscard]] std::vector<PlaneState> states(const PlaneModel& model, const PlaneSolution& solution,
                                             int element, const ElementTable& table);

/// The energy of a solution. Both arguments must outlive it.
[[nodiscard]] EnergyDensity energy_density(const PlaneModel& model, const PlaneSolution& solution);

/// Squared errors of the faces, see error_estimate.h. Precondition: the scheme is `linear`, on quads.
[[nodiscard]] std::vector<double> estimate_error(const PlaneModel& model,
                                                 const PlaneSolution& solution);

}  // namespace limes
