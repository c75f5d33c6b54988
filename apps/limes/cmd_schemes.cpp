#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "commands.h"
#include "limes/curve/curve_scheme.h"
#include "limes/subdiv/schemes.h"
#include "options.h"
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
    list.push_back({{"name", s.name},
                    {"mask", s.mask.weights},
                    {"first", s.mask.first},
                    {"even_stencil", s.mask.stencil(0)},
                    {"odd_stencil", s.mask.stencil(1)},
                    {"summary", s.summary}});
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

}  // namespace

void add_schemes(CLI::App& program) {
  const auto json = std::make_shared<bool>(false);
  CLI::App& app = *program.add_subcommand("schemes", "List the subdivision schemes");
  app.add_flag("--json", *json, "Print one JSON object on standard output")->group(run_group);
  app.footer(
      "FACES is what a scheme can start from. LIMIT is what its surface is made of away from\n"
      "extraordinary vertices; 'none' cannot be evaluated exactly. Curve schemes refine the\n"
      "polylines (l) of .obj files; lane-riesenfeld:D has any degree D from 1 to 20.");
  app.final_callback([json] { *json ? print_json() : print_table(); });
}

}  // namespace limes::app
