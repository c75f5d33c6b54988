#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "commands.h"
#include "limes/core/error.h"
#include "limes/curve/curve_scheme.h"
#include "limes/subdiv/schemes.h"
#include "options.h"
#include "run.h"
#include "scheme_description.h"
#include "table.h"
#include "terminal.h"

namespace limes::app {
namespace {

std::string name_of(FaceKind faces) {
  switch (faces) {
    case FaceKind::polygons:
      return "polygons";
    case FaceKind::quads:
      return "quads";
    case FaceKind::triangles:
      return "triangles";
  }
  return {};
}

std::string limit_of(const Scheme& scheme) {
  switch (scheme.patch) {
    case LimitPatch::none:
      return "none";
    case LimitPatch::bilinear:
      return "bilinear";
    case LimitPatch::bicubic:
      return "bicubic";
    case LimitPatch::box_spline:
      return "box spline";
  }
  return {};
}

std::string mask_text(const CurveMask& mask) {
  std::string text;
  for (const double w : mask.weights)
    text += fmt::format("{}{}", text.empty() ? "" : " ", w);
  return text;
}

void print_curve_table() {
  std::vector<std::vector<std::string>> rows{{"CURVE SCHEME", "WHAT IT IS", "MASK"}};
  for (const CurveScheme& s : all_curve_schemes())
    rows.push_back({s.name, s.summary, mask_text(s.mask)});
  print("\n" + format_table(rows));
}

nlohmann::ordered_json curves_json() {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const CurveScheme& s : all_curve_schemes())
    list.push_back(to_json(s));
  return list;
}

void print_table() {
  std::vector<std::vector<std::string>> rows{{"SCHEME", "FACES", "LIMIT", "OPTIONS", "WHAT IT IS"}};
  for (const Scheme& s : all_schemes()) {
    std::string options;
    for (const std::string& option : options_of(s))
      options += (options.empty() ? "" : " ") + option;
    rows.push_back({std::string(s.name), name_of(s.faces), limit_of(s),
                    options.empty() ? "-" : options, std::string(s.summary)});
  }
  print(format_table(rows));
  print_curve_table();
}

void print_json() {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Scheme& s : all_schemes())
    list.push_back({{"name", s.name},
                    {"faces", name_of(s.faces)},
                    {"limit", limit_of(s)},
                    {"linear", s.linear},
                    {"options", options_of(s)},
                    {"summary", s.summary}});
  print_object({{"schemes", std::move(list)}, {"curves", curves_json()}});
}

struct SchemesCommand {
  std::string scheme, valence, tension;
  RunOptions run;

  void operator()() const;

 private:
  void describe_surface(const Scheme& chosen) const;
  void describe_curve() const;
};

void SchemesCommand::describe_surface(const Scheme& chosen) const {
  const double w = parse_any_tension(chosen, tension);
  std::optional<int> n;
  if (!valence.empty()) n = parse_whole_number("--valence", valence, 1);
  const SchemeDescription description = describe(chosen, w, n);
  run.json ? print_object(to_json(description)) : print(to_text(description));
}

void SchemesCommand::describe_curve() const {
  if (!valence.empty()) throw UsageError("--valence: {} has no such option", scheme);
  if (!tension.empty() && scheme != "four-point")
    throw UsageError("--tension: {} has no such option", scheme);
  const CurveScheme chosen =
      find_curve_scheme(scheme, tension.empty() ? 1.0 : parse_tension(tension));
  run.json ? print_object(to_json(chosen)) : print(to_text(chosen));
}

void SchemesCommand::operator()() const {
  const Run current(run);
  if (!scheme.empty())
    return is_curve_scheme(scheme) ? describe_curve() : describe_surface(find_scheme(scheme));
  if (!valence.empty()) throw UsageError("--valence needs a scheme: limes schemes NAME");
  if (!tension.empty()) throw UsageError("--tension needs a scheme: limes schemes NAME");
  run.json ? print_json() : print_table();
}

}  // namespace

void add_schemes(CLI::App& program) {
  const auto command = std::make_shared<SchemesCommand>();
  CLI::App& app = *program.add_subcommand(
      "schemes", "List the subdivision schemes, or the rules of one in numbers");
  app.add_option("SCHEME", command->scheme, "A scheme whose rules are printed")->option_text(" ");
  app.add_option("--valence", command->valence,
                 "Also the rules around a vertex with N edges; doo-sabin and mid-edge: around a "
                 "face with N corners")
      ->option_text("N")
      ->group(work_group);
  app.add_option("--tension", command->tension, "Of schemes that have one [1]")
      ->option_text("W")
      ->group(scheme_group);
  add_run_options(app, command->run);
  app.footer(
      "FACES is what a scheme can start from. LIMIT is what its surface is made of away from\n"
      "extraordinary vertices; 'none' cannot be evaluated exactly. Curve schemes refine the\n"
      "polylines (l) of .obj files; lane-riesenfeld:D has any degree D from 1 to 20.\n\n"
      "Of one scheme: the stencils of all rules, the mask of a regular mesh (the coefficients of\n"
      "the two-scale relation), and the rows of the limit and its tangents. Of a curve scheme: "
      "mask,\n"
      "symbol and both stencils.\n\n"
      "  limes schemes catmull-clark --valence 5\n"
      "  limes schemes four-point --json");
  app.final_callback([command] { (*command)(); });
}

}  // namespace limes::app
