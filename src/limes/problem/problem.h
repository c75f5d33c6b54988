#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "limes/adapt/marking.h"
#include "limes/core/types.h"
#include "limes/problem/expression.h"
#include "limes/problem/place.h"
#include "limes/problem/surface_settings.h"
#include "limes/subdiv/closure.h"

namespace limes {

// A problem as its file states it: values checked one by one, nothing computed yet. `origin` says where
// its table and values come from, for messages of later checks.

struct MeshSettings {
  std::filesystem::path file;  ///< relative names are meant from the problem file's folder
  std::string scheme = "catmull-clark";
  int levels = 0;
  bool exact = false;  ///< vertices are placed on [geometry], see GeometrySettings
  /// Sweeps in which the shapes of elements are optimised (shells only): of the control mesh on
  /// [geometry], and after each refinement.
  int smooth_start = 0, smoothing = 0;
  Origin origin = {};
};

struct MaterialSettings {
  std::optional<std::string> where;  ///< a selection; nothing: wherever no other material is
  double young = 0;                  ///< > 0
  double poisson = 0;                ///< in (-1, 0.5)
  double thickness = 1;              ///< > 0
  double conductivity = 1;           ///< of Poisson's equation, > 0
  Origin origin = {};
};

enum class ModelKind { plane_stress, plane_strain, poisson, mitc4 };

/// How the field continues beyond the boundary of the mesh, see space/extended_mesh.h.
enum class FieldBoundary { free, phantom };

struct ModelSettings {
  ModelKind kind = ModelKind::plane_stress;
  FieldBoundary boundary = FieldBoundary::free;
  bool kinks = true;                ///< the field may kink where materials meet
  int quadrature_points = 3;        ///< Gauss points per direction and tile, 2 to 8
  int quadrature_depth = 4;         ///< rings of tiles around an extraordinary vertex, 0 to 30
  double shear_factor = 5.0 / 6.0;  ///< of shells, > 0
  double kink_angle = 20;           ///< of shells, in degrees
  bool assumed_membrane = false;    ///< of shells: membrane strains are tied, see fem/mitc4.h
  double drilling = 0;              ///< of shells: factor at kinks, in [0, 1], see fem/drilling.h
  Origin origin = {};
};

/// A periodic cell driven by a macroscopic deformation gradient F.
struct PeriodicSettings {
  Mat2 gradient = Mat2::Identity();
  Origin origin = {};
};

/// Usual supports of shells, see shell_supports.h.
enum class SupportKind { listed, clamped, supported, symmetry, diaphragm, value };

struct SupportSettings {
  std::string where;
  SupportKind kind = SupportKind::listed;
  bool hard = false;          ///< the rotation of the director along the edge is held as well
  std::array<bool, 6> fix{};  ///< ux, uy, uz, rx, ry, rz; of SupportKind::listed
  Expression value;           ///< of SupportKind::value
  Origin origin = {};
};

enum class LoadKind {
  force,
  force_per_length,
  force_per_area,
  force_per_volume,
  pressure,
  moment,
  source,  ///< of Poisson's equation, like the next
  flux
};

struct LoadSettings {
  std::string where;
  LoadKind kind = LoadKind::force_per_area;
  /// Components (pressure, source, flux: the first only); each a number or an expression in x, y, z.
  std::array<Expression, 3> value;
  Origin origin = {};
};

/// Unknowns of a vertex that is no kink.
[[nodiscard]] constexpr int unknowns_per_vertex(ModelKind kind) {
  return kind == ModelKind::poisson ? 1 : kind == ModelKind::mitc4 ? 5 : 2;
}

/// Of what a load's formulas say: "force", "flux".
[[nodiscard]] const Place& place_of_value(const LoadSettings& load);

struct ProbeSettings {
  std::string name;
  Vec3 at = Vec3::Zero();
  Origin origin = {};
};

enum class EstimatorKind { zienkiewicz_zhu, residual };

/// Refinement where the error is.
struct AdaptSettings {
  EstimatorKind estimator = EstimatorKind::zienkiewicz_zhu;
  Closure closure = Closure::conforming;  ///< or hanging
  MarkingKind mark = MarkingKind::doerfler;
  double share = 0.5;                      ///< of the marking, in (0, 1]
  std::optional<double> target_error;      ///< relative to the energy norm, in (0, 1)
  int max_dofs = 10'000;                   ///< >= 1
  int max_steps = 30;                      ///< >= 1
  std::optional<double> max_seconds;       ///< > 0
  std::optional<double> reference_energy;  ///< of the exact solution, > 0
  int reference_levels = 0;                ///< of a finer solution to compare with, 0 to 4; 0: none
  Origin origin = {};
  // Not of the problem file, see adapt_state.h.
  std::filesystem::path state;  ///< file; empty: none
  bool resume = false;          ///< go on from there
};

/// Names of the user's units, for reports only.
struct UnitSettings {
  std::string length, force;
};

struct Problem : SurfaceSettings {
  std::string title;
  UnitSettings units;
  MeshSettings mesh;
  std::vector<MaterialSettings> materials;  ///< at least one
  ModelSettings model;
  std::optional<PeriodicSettings> periodic;
  std::vector<SupportSettings> supports;
  std::vector<LoadSettings> loads;
  std::vector<ProbeSettings> probes;
  std::optional<AdaptSettings> adapt;
  /// All that the file and overrides say, one by one: "load.0.flux = 3".
  std::vector<std::string> values;
};

/// Of the supports together: an override among them, else the file.
[[nodiscard]] Place place_of_supports(const Problem& problem);

/// Reads a problem file; `overrides` are "dotted.path=value" with array entries by index, the value
/// in TOML or, if it is none, a bare string.
/// @throws InputError "FILE:LINE: ..." for what the file says wrong (an unknown key with the nearest
///         known one), UsageError "--set PATH: ..." for an override whose path does not exist or
///         whose value does not fit
[[nodiscard]] Problem read_problem(const std::filesystem::path& file,
                                   std::span<const std::string> overrides = {});
[[nodiscard]] Problem parse_problem(std::string_view text, const std::filesystem::path& file,
                                    std::span<const std::string> overrides = {});

}  // namespace limes
