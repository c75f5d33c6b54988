#pragma once

#include <CLI/CLI.hpp>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "limes/mesh/mesh.h"
#include "limes/subdiv/quasi_four_eight.h"
#include "limes/subdiv/refine.h"

namespace limes::app {

// The options that several commands share. add_*() declares them on a command; their values are
// there when the command's callback runs.

/// Titles of the groups in the help.
constexpr const char* files_group = "Files";
constexpr const char* scheme_group = "Scheme";
constexpr const char* work_group = "What to do";
constexpr const char* run_group = "Running";

/// How a command runs, whatever it does.
struct RunOptions {
  std::string threads;       ///< number, empty: all cores
  std::string memory_limit;  ///< size, empty: what the machine has free
  bool json = false;
};
void add_run_options(CLI::App& command, RunOptions& options);

/// The mesh a command works on.
struct MeshOptions {
  std::filesystem::path file;
  bool repair = false;
};
void add_mesh_options(CLI::App& command, MeshOptions& options);
void add_output_option(CLI::App& command, std::filesystem::path& file, const std::string& help);

/// A scheme with its own options, as typed; empty: not given.
struct SchemeOptions {
  std::string scheme;
  std::string boundary;
  std::string tension, corners, ring_pull;
  std::string tags, split, weights;
};
void add_scheme_options(CLI::App& command, SchemeOptions& options);

/// Those of an interpolatory scheme only.
void add_tension_options(CLI::App& command, SchemeOptions& options);

/// A scheme and the options it is used with.
struct SchemeChoice {
  const Scheme* scheme;
  std::optional<BoundaryRule> boundary;  ///< the user's; the file's comes second
  bool sector_stencils = false;          ///< --boundary biermann; for refinement only
  QuasiOptions quasi = {};               ///< of quasi-four-eight
  CornerRule corners = CornerRule::by_angle;
  double tension = 1.0;
  ExtraordinaryWeights weights = ExtraordinaryWeights::standard;

  /// The rule for a mesh: the user's, else the file's, else creases along the boundary.
  [[nodiscard]] BoundaryRule boundary_for(const Mesh& mesh) const;
  [[nodiscard]] RefineOptions options_for(const Mesh& mesh, int levels) const;
};

/// @throws UsageError for unknown names, for options that the scheme does not have and for values that
///         they do not take
[[nodiscard]] SchemeChoice choose_scheme(const SchemeOptions& options);

/// @throws UsageError for what refines but has no limit that can be evaluated
void require_limit(const SchemeChoice& choice);

/// The options that a scheme has, as they are typed.
[[nodiscard]] std::vector<std::string> options_of(const Scheme& scheme);
/// Whether the scheme has a tension and corner rules.
[[nodiscard]] bool has_tension(const Scheme& scheme);

void add_weights_option(CLI::App& command, std::string& weights);
/// Empty: standard.
/// @throws UsageError also for a scheme without a choice
[[nodiscard]] ExtraordinaryWeights parse_weights(const Scheme& scheme, const std::string& text);

/// 0 to 2 (sqrt 5 - 1): up to omega = (sqrt 5 - 1) / 8 the four-point curves are smooth, [dyn_1987].
/// @throws UsageError
[[nodiscard]] double parse_tension(const std::string& text);
/// Any number, for looking at a scheme only; empty: the default.
/// @throws UsageError, also if the scheme has no tension
[[nodiscard]] double parse_any_tension(const Scheme& scheme, const std::string& text);

/// A decimal whole number, at least `least`.
/// @throws UsageError that names the option
[[nodiscard]] int parse_whole_number(const char* option, const std::string& text, int least);
/// A number greater than 0. @throws UsageError that names the option
[[nodiscard]] double parse_positive(const char* option, const std::string& text);

}  // namespace limes::app
