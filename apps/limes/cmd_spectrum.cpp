#include <fmt/format.h>

#include <cmath>
#include <complex>
#include <memory>
#include <nlohmann/json.hpp>

#include "commands.h"
#include "files.h"
#include "limes/core/error.h"
#include "limes/core/text.h"
#include "limes/report/canvas.h"
#include "limes/spectrum/characteristic_picture.h"
#include "limes/subdiv/schemes.h"
#include "mask_table.h"
#include "pattern_table.h"
#include "run.h"
#include "table.h"
#include "terminal.h"

namespace limes::app {
namespace {

struct SpectrumCommand {
  std::string scheme, valences, tension, weights;
  std::filesystem::path picture;
  RunOptions run;

  void operator()() const;
};

/// "5" or "3..12".
std::pair<int, int> parse_range(const std::string& text) {
  const std::size_t dots = text.find("..");
  if (dots == std::string::npos) {
    const int valence = parse_whole_number("--valence", text, 1);
    return {valence, valence};
  }
  const int first = parse_whole_number("--valence", text.substr(0, dots), 1);
  return {first, parse_whole_number("--valence", text.substr(dots + 2), first)};
}

/// A range passes over valences that the scheme does not have, but must not begin or end far from those
/// that it has.
std::vector<int> possible_valences(const Scheme& scheme, int first, int last) {
  if (first == last) require_valence(scheme, first);
  for (const int end : {first, last})
    if (!has_valence(scheme, end - 1) && !has_valence(scheme, end + 1))
      require_valence(scheme, end);
  std::vector<int> valences;
  for (int valence = first; valence <= last; ++valence)
    if (has_valence(scheme, valence)) valences.push_back(valence);
  return valences;
}

std::string name_of(std::complex<double> value) {
  if (value.imag() == 0) return fmt::format("{:.6f}", value.real());
  return fmt::format("{:.6f}{:+.6f}i", value.real(), value.imag());
}

/// The largest eigenvalues with their blocks, equal ones together.
std::string first_eigenvalues(const Spectrum& s, std::size_t most) {
  std::string text;
  std::size_t shown = 0;
  for (std::size_t i = 0; i < s.eigenvalues.size() && shown < most; ++shown) {
    const std::string value = name_of(s.eigenvalues[i].value);
    std::string blocks;
    for (; i < s.eigenvalues.size() && name_of(s.eigenvalues[i].value) == value; ++i)
      blocks += fmt::format("{}{}", blocks.empty() ? "" : ",", s.eigenvalues[i].block);
    text += fmt::format("{}{} [{}]", text.empty() ? "" : "  ", value, blocks);
  }
  return text;
}

void print_table(const std::vector<Analysis>& results) {
  std::vector<std::vector<std::string>> rows{
      {"VALENCE", "SUBDOMINANT", "CURVATURE RATIO", "C1", "LARGEST EIGENVALUES [BLOCKS]"}};
  for (const Analysis& a : results) {
    const Spectrum& s = a.spectrum;
    rows.push_back({fmt::format("{}", s.valence), fmt::format("{:.9f}", s.subdominant),
                    fmt::format("{:.6f}", s.curvature_ratio), s.c1 ? "yes" : "no",
                    first_eigenvalues(s, 4)});
  }
  print(format_table(rows));
  for (const Analysis& a : results)
    if (!a.spectrum.c1)
      print(fmt::format("valence {}: {}\n", a.spectrum.valence, a.spectrum.reason));
}

nlohmann::ordered_json to_json(const Spectrum& s) {
  nlohmann::ordered_json eigenvalues = nlohmann::ordered_json::array();
  for (const BlockEigenvalue& e : s.eigenvalues) {
    nlohmann::ordered_json entry{{"block", e.block}, {"value", e.value.real()}};
    if (e.value.imag() != 0) entry["imaginary"] = e.value.imag();
    eigenvalues.push_back(std::move(entry));
  }
  nlohmann::ordered_json result{{"valence", s.valence},
                                {"steps", s.num_steps},
                                {"eigenvalues", std::move(eigenvalues)},
                                {"subdominant", s.subdominant},
                                {"c1", s.c1},
                                {"curvature_ratio", s.curvature_ratio}};
  if (!s.c1) result["reason"] = s.reason;
  if (s.map)
    result["characteristic_map"] = {{"least_jacobian", s.map->least_jacobian},
                                    {"winding_number", s.map->winding_number}};
  nlohmann::ordered_json masks = nlohmann::ordered_json::array();
  for (std::size_t p = 0; p < s.places.size() && s.limit_mask; ++p) {
    const auto i = static_cast<Eigen::Index>(p);
    nlohmann::ordered_json entry{{"ring", s.places[p].ring},
                                 {"place", s.places[p].place},
                                 {"sector", s.places[p].sector},
                                 {"limit", (*s.limit_mask)[i]}};
    if (s.tangent_masks) entry["tangents"] = {(*s.tangent_masks)(i, 0), (*s.tangent_masks)(i, 1)};
    masks.push_back(std::move(entry));
  }
  result["masks"] = std::move(masks);
  return result;
}

void SpectrumCommand::operator()() const {
  const Run current(run);
  const Scheme& chosen = find_scheme(scheme);
  const RuleOptions options{.weights = parse_weights(chosen, weights),
                            .tension = parse_any_tension(chosen, tension)};
  const auto [first, last] = parse_range(valences);
  const std::vector<int> possible = possible_valences(chosen, first, last);
  if (!picture.empty()) check_output(picture, run, {".svg", ".png"});
  std::vector<Analysis> results;
  for (const int valence : possible)
    results.push_back(analyse(chosen, valence, options));
  std::vector<ControlPattern> patterns;  // of the scheme whose splits depend on positions
  if (chosen.needs_positions) patterns = control_patterns(first, last);

  if (!picture.empty()) write_drawing(picture, characteristic_picture(chosen, results));
  if (run.json) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Analysis& a : results)
      list.push_back(to_json(a.spectrum));
    nlohmann::ordered_json object{{"scheme", chosen.name}, {"results", std::move(list)}};
    if (!patterns.empty()) object["patterns"] = to_json(patterns);
    print_object(object);
    return;
  }
  print_table(results);
  if (!patterns.empty()) print("\n" + to_text(patterns));
  if (results.size() != 1) return;
  const std::string masks = mask_table(results[0].spectrum, results[0].local->num_sectors());
  if (!masks.empty()) print("\n" + masks);
}

}  // namespace

void add_spectrum(CLI::App& program) {
  const auto command = std::make_shared<SpectrumCommand>();
  CLI::App& app = *program.add_subcommand("spectrum", "Eigenvalues of a scheme around vertices");
  app.add_option("--scheme", command->scheme, "Subdivision scheme, see 'limes schemes'")
      ->required()
      ->option_text("NAME (required)")
      ->group(scheme_group);
  app.add_option("--tension", command->tension, "Of schemes that have one; any value [1]")
      ->option_text("W")
      ->group(scheme_group);
  add_weights_option(app, command->weights);
  app.add_option(
         "--valence", command->valences,
         "Number of edges at the vertex, as 5 or 3..12; of dual schemes (doo-sabin): corners of "
         "the face")
      ->required()
      ->option_text("N or N..M (required)")
      ->group(work_group);
  app.add_option("-o,--output", command->picture,
                 "Picture of the characteristic maps: .svg or .png")
      ->option_text("FILE")
      ->group(files_group);
  add_run_options(app, command->run);
  app.footer(
      "Eigenvalues belong to blocks: in block k an eigenvector turns by k/n of a full turn from\n"
      "sector to sector. With a single valence the masks of the limit point and of the tangents\n"
      "follow. quasi-four-eight also says after which pass the pattern of edges around a control\n"
      "vertex repeats: among the triangles of a polygon alone, and with further ones around "
      "them.\n\n"
      "  limes spectrum --scheme catmull-clark --valence 3..12 -o maps.svg\n"
      "  limes spectrum --scheme loop --valence 7 --json");
  app.final_callback([command] { (*command)(); });
}

}  // namespace limes::app
