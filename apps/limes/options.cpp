#include "options.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "limes/core/error.h"
#include "limes/core/text.h"
#include "limes/subdiv/schemes.h"

namespace limes::app {

void add_run_options(CLI::App& command, RunOptions& options) {
  command.add_option("--threads", options.threads, "Number of threads [all cores]")
      ->option_text("T")
      ->group(run_group);
  command
      .add_option("--memory-limit", options.memory_limit,
                  "Refuse work that needs more memory, as 500M or 8G\n[what the machine has free]")
      ->option_text("SIZE")
      ->group(run_group);
  command
      .add_flag("--json", options.json, "Print one JSON object on standard output, nothing else")
      ->group(run_group);
}

void add_mesh_options(CLI::App& command, MeshOptions& options) {
  command.add_option("MESH", options.file, "Mesh to read: .obj, .off, .ply or .stl")
      ->required()
      ->option_text(" ");
  command
      .add_flag("--repair", options.repair,
                "Mend what can be mended before the work and say what was done")
      ->group(files_group);
}

void add_output_option(CLI::App& command, std::filesystem::path& file, const std::string& help) {
  command.add_option("-o,--output", file, help)
      ->required()
      ->option_text("FILE (required)")
      ->group(files_group);
}

void add_scheme_options(CLI::App& command, SchemeOptions& options) {
  command.add_option("--scheme", options.scheme, "Subdivision scheme, see 'limes schemes'")
      ->required()
      ->option_text("NAME (required)")
      ->group(scheme_group);
  command
      .add_option(
          "--boundary", options.boundary,
          "catmull-clark, loop: what happens at the boundary [the file's tag, else edges]\n"
          "  none               boundary faces shape the others and are dropped\n"
          "  edges              the boundary is a smooth curve\n"
          "  edges-and-corners  and vertices with one face stay where they are\n"
          "  biermann           the same, by weights that follow the angle of the surface\n"
          "                     and do not fold at concave corners (refine, catmull-clark)\n"
          "quasi-four-eight: how boundary vertices move [curve-normal]\n"
          "  curve-normal       like curve, but along the surface normal only\n"
          "  curve              along a smooth curve\n"
          "  fixed              not at all")
      ->option_text("RULE")
      ->group(scheme_group);
  command
      .add_option("--tags", options.tags,
                  "quasi-four-eight: what sharp edges and vertices do [held]\n"
                  "  held               they are not smoothed: edges stay straight\n"
                  "  curves             edges are creases, with darts and corners")
      ->option_text("RULE")
      ->group(scheme_group);
  command
      .add_option("--split", options.split,
                  "quasi-four-eight: which edges a level splits [longest]\n"
                  "  longest            the longest edges, one of every face\n"
                  "  interleaved        edges of valence 8, on a regular 4-8 mesh\n"
                  "  normal             all edges, on a regular 4-8 mesh: two steps a level")
      ->option_text("RULE")
      ->group(scheme_group);
  add_weights_option(command, options.weights);
  add_tension_options(command, options);
  // Hidden as long as no scheme has it; known, so that the message can say so.
  command.add_option("--ring-pull", options.ring_pull)->group("");
}

void add_weights_option(CLI::App& command, std::string& weights) {
  command
      .add_option("--weights", weights,
                  "at smooth extraordinary vertices [standard]\n"
                  "  quarters           catmull-clark: 1/4, 1/2, 1/4 at every valence\n"
                  "  warren             loop: 3/(8n), and 3/16 at valence 3")
      ->option_text("NAME")
      ->group(scheme_group);
}

void add_tension_options(CLI::App& command, SchemeOptions& options) {
  command
      .add_option("--tension", options.tension,
                  "kobbelt: 16 omega, from 0 to 2 (sqrt 5 - 1) [1]\n"
                  "0 is bilinear, 1 reproduces cubics")
      ->option_text("W")
      ->group(scheme_group);
  command
      .add_option("--corners", options.corners,
                  "kobbelt: where boundaries and creases break [auto]\n"
                  "  auto  where they turn by more than 30 degrees\n"
                  "  none  only at corner tags and where three curves meet\n"
                  "  all   at vertices with one face")
      ->option_text("RULE")
      ->group(scheme_group);
}

namespace {

/// Whether there is a choice of BoundaryRule.
bool has_boundary_rules(const Scheme& scheme) {
  return scheme.boundary == Boundary::creases;
}

}  // namespace

std::vector<std::string> options_of(const Scheme& scheme) {
  if (has_boundary_rules(scheme)) return {"--boundary", "--weights"};
  if (scheme.boundary == Boundary::quasi) return {"--boundary", "--tags", "--split"};
  if (has_tension(scheme)) return {"--tension", "--corners"};
  return {};
}

bool has_tension(const Scheme& scheme) {
  return scheme.boundary == Boundary::open_net;
}

BoundaryRule SchemeChoice::boundary_for(const Mesh& mesh) const {
  if (!has_boundary_rules(*scheme)) return BoundaryRule::edges;
  if (boundary) return *boundary;
  return mesh.tags.boundary.value_or(BoundaryRule::edges);
}

RefineOptions SchemeChoice::options_for(const Mesh& mesh, int levels) const {
  RefineOptions options;
  options.levels = levels;
  options.boundary = boundary_for(mesh);
  options.sector_stencils = sector_stencils;
  options.quasi = quasi;
  options.corners = corners;
  options.tension = tension;
  options.weights = weights;
  return options;
}

namespace {

void refuse_option(const Scheme& scheme, const std::string& value, const char* option) {
  const auto known = options_of(scheme);
  if (!value.empty() && std::find(known.begin(), known.end(), option) == known.end())
    throw UsageError("{}: {} has no such option", option, scheme.name);
}

/// A name of an option's value and what it means.
template <class Value>
struct Named {
  const char* name;
  Value value;
};
template <class Value, std::size_t n>
Value parse_name(const char* option, const std::string& name, const Named<Value> (&known)[n]) {
  std::string names;
  for (const Named<Value>& k : known) {
    if (name == k.name) return k.value;
    names += names.empty() ? "" : ", ";
    names += k.name;
  }
  throw UsageError("{}: there is no rule {}; known are {}", option, quote(name), names);
}

QuasiOptions parse_quasi(const SchemeOptions& typed) {
  QuasiOptions quasi;
  if (!typed.boundary.empty())
    quasi.rules.boundary = parse_name<QuasiBoundary>("--boundary", typed.boundary,
                                                     {{"curve-normal", QuasiBoundary::curve_normal},
                                                      {"curve", QuasiBoundary::curve},
                                                      {"fixed", QuasiBoundary::fixed}});
  if (!typed.tags.empty())
    quasi.rules.tags = parse_name<QuasiTags>(
        "--tags", typed.tags, {{"held", QuasiTags::held}, {"curves", QuasiTags::curves}});
  if (!typed.split.empty())
    quasi.split = parse_name<QuasiSplit>("--split", typed.split,
                                         {{"longest", QuasiSplit::longest},
                                          {"interleaved", QuasiSplit::interleaved},
                                          {"normal", QuasiSplit::normal}});
  return quasi;
}

/// catmull-clark and loop; the last is catmull-clark's alone.
void parse_boundary(const std::string& name, SchemeChoice& choice) {
  choice.sector_stencils = name == "biermann" && choice.scheme->name == "catmull-clark";
  if (choice.sector_stencils) {
    choice.boundary = BoundaryRule::edges_and_corners;
    return;
  }
  choice.boundary =
      parse_name<BoundaryRule>("--boundary", name,
                               {{"none", BoundaryRule::none},
                                {"edges", BoundaryRule::edges},
                                {"edges-and-corners", BoundaryRule::edges_and_corners}});
}

}  // namespace

SchemeChoice choose_scheme(const SchemeOptions& options) {
  SchemeChoice choice{&find_scheme(options.scheme), {}};
  const Scheme& scheme = *choice.scheme;
  refuse_option(scheme, options.boundary, "--boundary");
  refuse_option(scheme, options.tags, "--tags");
  refuse_option(scheme, options.split, "--split");
  choice.weights = parse_weights(scheme, options.weights);
  refuse_option(scheme, options.tension, "--tension");
  refuse_option(scheme, options.corners, "--corners");
  refuse_option(scheme, options.ring_pull, "--ring-pull");
  if (scheme.boundary == Boundary::quasi) {
    choice.quasi = parse_quasi(options);
    return choice;
  }
  if (!options.boundary.empty()) parse_boundary(options.boundary, choice);
  if (!options.corners.empty())
    choice.corners = parse_name<CornerRule>(
        "--corners", options.corners,
        {{"auto", CornerRule::by_angle}, {"none", CornerRule::none}, {"all", CornerRule::all}});
  if (!options.tension.empty()) choice.tension = parse_tension(options.tension);
  return choice;
}

void require_limit(const SchemeChoice& choice) {
  if (choice.sector_stencils)
    throw UsageError("--boundary: limits with rule biermann are not evaluated, only refined");
}

ExtraordinaryWeights parse_weights(const Scheme& scheme, const std::string& text) {
  using enum ExtraordinaryWeights;
  if (text.empty()) return standard;
  refuse_option(scheme, text, "--weights");
  if (scheme.name == "loop")
    return parse_name<ExtraordinaryWeights>("--weights", text,
                                            {{"standard", standard}, {"warren", warren}});
  return parse_name<ExtraordinaryWeights>("--weights", text,
                                          {{"standard", standard}, {"quarters", quarters}});
}

double parse_tension(const std::string& text) {
  const double most = 2.0 * (std::sqrt(5.0) - 1.0);
  const auto number = parse_real(text);
  if (!number || !(*number >= 0.0 && *number <= most))
    throw UsageError("--tension: {} is no number from 0 to {:.6g}, 2 (sqrt 5 - 1)", quote(text),
                     most);
  return *number;
}

double parse_any_tension(const Scheme& scheme, const std::string& text) {
  if (text.empty()) return RuleOptions{}.tension;
  const auto tension = parse_real(text);
  if (!tension) throw UsageError("--tension: {} is no number", quote(text));
  if (!has_tension(scheme)) throw UsageError("--tension: {} has no such option", scheme.name);
  return *tension;
}

int parse_whole_number(const char* option, const std::string& text, int least) {
  const auto number = parse_integer(text);
  constexpr int most = std::numeric_limits<int>::max();
  const bool has_sign = text.starts_with('-') || text.starts_with('+');
  const std::string digits = text.substr(has_sign ? 1 : 0);
  if (digits.empty() || digits.find_first_not_of("0123456789") != std::string::npos)
    throw UsageError("{}: {} is no whole number; {}, {} and so on are", option, quote(text), least,
                     least + 1);
  if (!number || *number < least || *number > most)
    throw UsageError("{}: {} is out of range; {} to {} is right", option, quote(text), least, most);
  return static_cast<int>(*number);
}

double parse_positive(const char* option, const std::string& text) {
  const auto number = parse_real(text);
  if (!number || *number <= 0)
    throw UsageError("{}: {} is no number greater than 0", option, quote(text));
  return *number;
}

}  // namespace limes::app
