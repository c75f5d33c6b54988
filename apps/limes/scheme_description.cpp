#include "scheme_description.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "limes/subdiv/breakpoints.h"
#include "mask_table.h"
#include "rule_layout.h"
#include "symbol_text.h"

namespace limes::app {
namespace {

using Kind = ChildVertex::Kind;

std::string name_of(Rule::Place place) {
  switch (place) {
    case Rule::Place::regular:
      return "regular";
    case Rule::Place::star:
      return "valence";
    case Rule::Place::face:
      return "face";
    case Rule::Place::boundary:
      return "boundary";
    case Rule::Place::corner:
      return "corner";
    case Rule::Place::crease:
      return "crease";
    case Rule::Place::dart:
      return "dart";
    case Rule::Place::semi_sharp:
      return "semi-sharp";
    case Rule::Place::sharp_vertex:
      return "sharp-vertex";
  }
  return {};
}

/// Where the lattice has its sharp lines.
std::string lines_of(Rule::Place place) {
  switch (place) {
    case Rule::Place::boundary:
      return " (y = 0)";
    case Rule::Place::corner:
      return " (0, 0 of x, y >= 0)";
    case Rule::Place::crease:
      return " (y = 0)";
    case Rule::Place::dart:
      return " (y = 0, x >= 0)";
    case Rule::Place::semi_sharp:
      return " (y = 0, sharpness 1/2)";
    case Rule::Place::sharp_vertex:
      return " (0, 0)";
    default:
      return {};
  }
}

std::string name_of(Kind kind) {
  switch (kind) {
    case Kind::vertex:
      return "vertex";
    case Kind::edge:
      return "edge";
    case Kind::face:
      return "face";
    case Kind::corner:
      return "corner";
  }
  return {};
}

std::vector<std::string> notes_of(const Scheme& scheme) {
  if (scheme.needs_positions)
    return {
        "the edges to split are chosen by their lengths, which no weights can say",
        "weights are those of a binary step (split and smoothing) where the pattern repeats: the "
        "split edges lie opposite the newest vertices",
        "interleaved steps of other edges, boundaries and creases depend on positions and have no "
        "rows here"};
  std::vector<std::string> notes;
  if (scheme.boundary == Boundary::shrinks)
    notes.emplace_back("no rules at boundaries: the surface ends before its boundary");
  if (!scheme.creases) notes.emplace_back("no rules at creases and corners: they are refused");
  if (scheme.boundary == Boundary::creases)
    notes.emplace_back("creases of finite sharpness below 1 blend the rules of crease and surface");
  if (scheme.boundary == Boundary::open_net)
    notes.push_back(fmt::format("boundary vertices that turn by more than {:g} degrees are corners",
                                breakpoint_angle));
  return notes;
}

nlohmann::ordered_json optional_json(const std::optional<std::string>& text) {
  if (text) return *text;
  return nullptr;
}

nlohmann::ordered_json to_json(const RuleWeight& w, bool on_lattice) {
  nlohmann::ordered_json entry;
  if (on_lattice)
    entry["at"] = {w.at.x(), w.at.y()};
  else
    entry = {{"ring", w.place.ring}, {"place", w.place.place}, {"sector", w.place.sector}};
  entry["weight"] = w.weight;
  entry["fraction"] = optional_json(weight_fraction(w.weight));
  return entry;
}

nlohmann::ordered_json to_json(const std::vector<RuleWeight>& weights, bool on_lattice) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const RuleWeight& w : weights)
    list.push_back(to_json(w, on_lattice));
  return list;
}

nlohmann::ordered_json to_json(const Rule& rule) {
  nlohmann::ordered_json entry{
      {"where", name_of(rule.place)}, {"kind", name_of(rule.kind)}, {"steps", rule.steps}};
  if (rule.on_lattice()) {
    entry["element"] = nlohmann::ordered_json::array();
    for (const Vec2& x : rule.element)
      entry["element"].push_back({x.x(), x.y()});
  }
  entry["weights"] = to_json(rule.weights, rule.on_lattice());
  return entry;
}

nlohmann::ordered_json limit_json(const Spectrum& s) {
  nlohmann::ordered_json weights = nlohmann::ordered_json::array();
  for (std::size_t p = 0; p < s.places.size() && s.limit_mask; ++p) {
    const auto i = static_cast<Eigen::Index>(p);
    nlohmann::ordered_json entry =
        to_json(RuleWeight{Vec2::Zero(), s.places[p], (*s.limit_mask)[i]}, false);
    entry["fraction"] = optional_json(limit_fraction((*s.limit_mask)[i]));
    if (s.tangent_masks) entry["tangents"] = {(*s.tangent_masks)(i, 0), (*s.tangent_masks)(i, 1)};
    weights.push_back(std::move(entry));
  }
  return {{"valence", s.valence}, {"weights", std::move(weights)}};
}

/// "step 2", "steps 1 and 3"; nothing where all steps are alike.
std::string steps_text(const Scheme& scheme, const std::vector<int>& steps) {
  const int all = num_different_steps(scheme);
  if (static_cast<int>(steps.size()) == all) return {};
  std::string text;
  for (const int step : steps)
    text += fmt::format("{}{}", text.empty() ? "" : " and ", step);
  return fmt::format(", {} {}", steps.size() == 1 ? "step" : "steps", text);
}

std::string element_text(const Rule& rule) {
  std::string text;
  for (const Vec2& x : rule.element)
    text += fmt::format("{}({}, {})", text.empty() ? " of " : " ", weight_text(x.x()),
                        weight_text(x.y()));
  return text;
}

std::string to_text(const SchemeDescription& d, const Rule& rule) {
  const int valence = d.analyses.back().spectrum.valence;
  const int sectors = d.analyses.back().local->num_sectors();
  std::string where = name_of(rule.place) + lines_of(rule.place);
  if (!rule.on_lattice()) where = fmt::format("{} {}", where, valence);
  return fmt::format(
      "\n{}{}: {} point{}\n{}", where, steps_text(*d.scheme, rule.steps), name_of(rule.kind),
      element_text(rule),
      rule.on_lattice() ? lattice_layout(rule.weights) : star_layout(rule.weights, sectors));
}

}  // namespace

SchemeDescription describe(const Scheme& scheme, double tension, std::optional<int> valence) {
  if (valence) require_valence(scheme, *valence);
  SchemeDescription d{&scheme, tension, {}, {}, notes_of(scheme)};
  d.analyses.push_back(analyse(scheme, regular_valence(scheme), {.tension = tension}));
  if (valence && *valence != regular_valence(scheme))
    d.analyses.push_back(analyse(scheme, *valence, {.tension = tension}));
  d.rules = scheme_rules(scheme, tension,
                         d.analyses.size() > 1 ? d.analyses.back().local.get() : nullptr);
  return d;
}

std::string to_text(const SchemeDescription& d) {
  std::string text = fmt::format("{}: {}\n", d.scheme->name, d.scheme->summary);
  for (const std::string& note : d.notes)
    text += fmt::format("note: {}\n", note);
  text += "\nSTENCILS: weights of old vertices in a new one; other places where they differ\n";
  for (const Rule& rule : d.rules.rules)
    text += to_text(d, rule);
  text +=
      "\nMASK: weights of an old vertex at (0, 0) in the new ones, regular; their sum is the "
      "number of new vertices per old one\n";
  for (const RegularMask& mask : d.rules.masks)
    text += fmt::format("\nmask{}\n{}", steps_text(*d.scheme, mask.steps),
                        lattice_layout(mask.weights));
  text += "\nLIMIT ROWS: weights of control vertices in the limit and its tangents\n";
  for (const Analysis& a : d.analyses) {
    const std::string table = mask_table(a.spectrum, a.local->num_sectors());
    text += fmt::format("\nvalence {}: {}", a.spectrum.valence,
                        table.empty() ? "no limit, " + a.spectrum.reason + "\n" : table);
  }
  return text;
}

nlohmann::ordered_json to_json(const SchemeDescription& d) {
  nlohmann::ordered_json rules = nlohmann::ordered_json::array();
  for (const Rule& rule : d.rules.rules)
    rules.push_back(to_json(rule));
  nlohmann::ordered_json masks = nlohmann::ordered_json::array();
  for (const RegularMask& mask : d.rules.masks)
    masks.push_back({{"steps", mask.steps}, {"weights", to_json(mask.weights, true)}});
  nlohmann::ordered_json limits = nlohmann::ordered_json::array();
  for (const Analysis& a : d.analyses)
    limits.push_back(limit_json(a.spectrum));
  return {{"scheme", d.scheme->name},
          {"tension", d.tension},
          {"valence", d.analyses.back().spectrum.valence},
          {"regular_valence", d.analyses.front().spectrum.valence},
          {"rules", std::move(rules)},
          {"masks", std::move(masks)},
          {"limits", std::move(limits)},
          {"notes", d.notes}};
}

std::string to_text(const CurveScheme& scheme) {
  const auto list = [](const std::vector<double>& weights) {
    std::string text;
    for (const double w : weights)
      text += fmt::format(" {}", weight_text(w));
    return text;
  };
  return fmt::format("{}: {}\n\nmask, from {}:{}\nsymbol: {}\neven stencil:{}\nodd stencil:{}\n",
                     scheme.name, scheme.summary, scheme.mask.first, list(scheme.mask.weights),
                     symbol_text(scheme.mask), list(scheme.mask.stencil(0)),
                     list(scheme.mask.stencil(1)));
}

nlohmann::ordered_json to_json(const CurveScheme& s) {
  return {{"name", s.name},
          {"mask", s.mask.weights},
          {"first", s.mask.first},
          {"symbol", symbol_text(s.mask)},
          {"even_stencil", s.mask.stencil(0)},
          {"odd_stencil", s.mask.stencil(1)},
          {"summary", s.summary}};
}

}  // namespace limes::app
