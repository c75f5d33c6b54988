#include "limes/study/adaptive.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "limes/core/error.h"
#include "limes/core/text.h"
#include "limes/limit/forest_limits.h"
#include "limes/report/pictures.h"
#include "limes/report/plot.h"
#include "limes/report/ticks.h"
#include "limes/study/adapt_state.h"
#include "limes/study/control_mesh.h"
#include "limes/subdiv/schemes.h"

namespace limes {
namespace {

using Json = nlohmann::ordered_json;

/// Of leaves to be solved on. Those of finer solutions with hanging nodes are leaves too; other closures
/// have their mesh refined.
int deepest_level(const AdaptSettings& adapt) {
  return Forest::max_level - (adapt.closure == Closure::hanging ? adapt.reference_levels : 0);
}

AdaptTargets targets_of(const Problem& problem) {
  const AdaptSettings& adapt = *problem.adapt;
  return {.mark = adapt.mark,
          .share = adapt.share,
          .closure = adapt.closure,
          .deepest_level = deepest_level(adapt),
          .error = adapt.target_error,
          .max_dofs = adapt.max_dofs,
          .dofs_per_vertex = unknowns_per_vertex(problem.model.kind),
          .max_steps = adapt.max_steps,
          .max_seconds = adapt.max_seconds,
          .reference_energy = adapt.reference_energy};
}

std::string percent(double part) {
  return format_readable(100 * part, 3) + " %";
}

}  // namespace

SplitUnit split_unit(const Problem& problem) {
  return problem.adapt && problem.adapt->closure == Closure::hanging ? SplitUnit::faces
                                                                     : SplitUnit::families;
}

Problem step_problem(const Problem& problem) {
  Problem out = problem;
  out.mesh.levels = 0;
  return out;
}

Forest plane_forest(const Problem& problem, const Mesh& start, const Scheme& scheme) {
  const Topology& t = start.topology;
  for (int f = 0; f < t.num_faces(); ++f)
    if (t.face_size(FaceId(f)) != 4)
      fail_at(problem.adapt->origin.table,
              "[adapt] refines quads, but face {} of {} has {} corners; [mesh] levels = 1 makes "
              "quads",
              f, mesh_path(problem).string(), t.face_size(FaceId(f)));
  return {start,
          scheme,
          {.levels = 0},
          split_unit(problem),
          scheme.interpolatory ? LimitsOf{} : forest_limits(scheme)};
}

AdaptiveRun run_adaptively(const Problem& problem, Forest& forest, std::span<const TiedEdge> seams,
                           const std::function<StepSolution(const ForestMesh&)>& solve) {
  AdaptTargets targets = targets_of(problem);
  keep_state(problem, forest, targets);
  AdaptiveRun run;
  const auto solve_step = [&](const ForestMesh& mesh) {
    StepSolution step = solve(mesh);
    run.squares = step.squares;
    run.finer_squares = step.finer_squares;
    return step;
  };
  run.history = solve_adaptively(forest, targets, solve_step, seams);
  run.start = forest.control();
  run.deepest_level = targets.deepest_level;
  return run;
}

Json steps_json(const AdaptiveRun& run) {
  Json out = Json::array();
  for (const AdaptStep& s : run.history.steps) {
    Json step{{"dofs", s.dofs},
              {"elements", s.elements},
              {"strain_energy", s.strain_energy},
              {"error_estimate", s.error_estimate},
              {"relative_error_estimate", s.relative_error}};
    if (s.true_error) step["error"] = *s.true_error;
    if (s.effectivity) step["effectivity"] = *s.effectivity;
    if (s.finer_error) step["error_against_finer"] = *s.finer_error;
    if (s.finer_effectivity) step["effectivity_against_finer"] = *s.finer_effectivity;
    out.push_back(std::move(step));
  }
  return out;
}

std::string how_refined(const AdaptSettings& settings) {
  const char* const marking = settings.mark == MarkingKind::maximum    ? "maximum"
                              : settings.mark == MarkingKind::fraction ? "fraction"
                                                                       : "doerfler";
  std::string text = fmt::format(
      "Errors are estimated by {}, elements marked by {} with the share {}, and where finer "
      "elements meet coarser ones {}.",
      settings.estimator == EstimatorKind::residual ? "residuals" : "recovery (Zienkiewicz-Zhu)",
      marking, format_readable(settings.share, 3),
      settings.closure == Closure::hanging ? "vertices hang in sides" : "the coarser ones are cut");
  if (settings.reference_levels > 0)
    text +=
        fmt::format(" The finer solution has every element split {}.",
                    counted(static_cast<std::size_t>(settings.reference_levels), "time", "times"));
  return text;
}

std::string end_of(const AdaptiveRun& run) {
  const std::string& end = run.history.end;
  if (end == "target_error") return "The loop ended because target_error was reached.";
  if (end == "max_dofs") return "The loop ended before a mesh with more than max_dofs.";
  if (end == "max_steps") return "The loop ended after max_steps.";
  if (end == "max_seconds") return "The loop ended after max_seconds.";
  if (end == "max_level")
    return fmt::format(
        "The loop ended because a face to be refined was on level {}, the deepest{}.",
        run.deepest_level,
        run.deepest_level < Forest::max_level ? " that reference_levels leaves" : "");
  return "The loop ended because no error was left to be seen.";
}

Table steps_table(const AdaptiveRun& run) {
  const bool reference = run.history.steps.front().true_error.has_value();
  Table table{"Error in the energy norm, and how much it is of the norm of the solution",
              {"step", "unknowns", "elements", "energy", "estimated error", "of the norm"},
              {}};
  if (reference) table.header.insert(table.header.end(), {"error by energy", "effectivity"});
  const bool finer = run.history.steps.front().finer_error.has_value();
  if (finer)
    table.header.insert(table.header.end(), {"error against finer", "effectivity with it"});
  const auto effectivity = [](const std::optional<double>& value) {
    return value ? fmt::format("{:.2f}", *value) : "";
  };
  int number = 0;
  for (const AdaptStep& s : run.history.steps) {
    table.rows.push_back({std::to_string(number++), std::to_string(s.dofs),
                          std::to_string(s.elements), format_readable(s.strain_energy, 8),
                          format_readable(s.error_estimate, 4), percent(s.relative_error)});
    std::vector<std::string>& row = table.rows.back();
    if (reference)
      row.insert(row.end(), {format_readable(*s.true_error, 4), effectivity(s.effectivity)});
    if (finer)
      row.insert(row.end(), {format_readable(*s.finer_error, 4), effectivity(s.finer_effectivity)});
  }
  return table;
}

std::optional<Drawing> steps_drawing(const AdaptiveRun& run) {
  Series estimate{.name = "estimated", .points = {}};
  Series error{.name = "by energy", .points = {}, .dashed = true};
  Series finer{.name = "against finer", .points = {}, .dashed = true};
  for (const AdaptStep& s : run.history.steps) {
    estimate.points.emplace_back(s.dofs, s.error_estimate);
    if (s.true_error) error.points.emplace_back(s.dofs, *s.true_error);
    if (s.finer_error) finer.points.emplace_back(s.dofs, *s.finer_error);
  }
  const auto shown = [](const Series& s) {  // one point is no curve
    return std::count_if(s.points.begin(), s.points.end(),
                         [](const Vec2& point) { return point.y() > 0; }) > 1;
  };
  if (!shown(estimate) && !shown(error) && !shown(finer)) return std::nullopt;
  std::vector<Series> series{std::move(estimate)};
  for (Series* const more : {&error, &finer})
    if (!more->points.empty()) series.push_back(std::move(*more));
  return drawing(convergence_plot("Adaptive refinement", "unknowns", "error in the energy norm",
                                  std::move(series), {{-0.5}}));
}

Figure error_figure(const AdaptiveRun& run, const Mesh& mesh,
                    const std::optional<Vec3>& direction) {
  constexpr double lowest_shown = 0.01;
  double largest = 0;
  for (const double square : run.squares)
    largest = std::max(largest, std::sqrt(square));
  std::vector<double> colours;
  for (int f = 0; f < mesh.topology.num_faces(); ++f) {
    const double part = std::sqrt(run.squares[static_cast<std::size_t>(f)]) / largest;
    const double colour = part > lowest_shown ? std::log10(part) : std::log10(lowest_shown);
    colours.insert(colours.end(), static_cast<std::size_t>(mesh.topology.face_size(FaceId(f))),
                   colour);
  }
  FieldPicture field =
      corner_field(mesh.topology, mesh.points.span(), std::move(colours), mesh.tags.holes);
  field.quantity = "log_{10} η / η_{max}";
  field.scale = ColourScale{.low = std::log10(lowest_shown), .high = 0};
  if (mesh.topology.num_faces() < most_faces_with_sides) {
    field.mesh_lines = edge_lines(mesh.topology, mesh.points.span(), mesh.tags.holes);
    field.mesh_lines.width = 0.35;
  }
  return field_figure(
      field, {.title = "Mesh and error of the last step",
              .caption = fmt::format("η: estimated error of an element in the energy norm, at most "
                                     "η_{{max}} = {}. Below a hundredth of that: the lowest "
                                     "colour.",
                                     format_readable(largest)),
              .direction = direction,
              .axes = true});
}

}  // namespace limes
