#include "limes/study/approximation_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "limes/core/error.h"
#include "limes/core/text.h"
#include "limes/study/toml_keys.h"

namespace limes {
namespace {

using Surface = ApproximationStudy::Surface;

/// Tables 1 and 2 of [kobbelt_1996].
const std::vector<double> graph_mean{3.11e-4, 1.95e-5, 1.22e-6, 7.57e-8};
const std::vector<double> graph_max{5.64e-4, 3.59e-5, 2.26e-6, 1.41e-7};
const std::vector<double> sphere_regular{1.64e-3, 1.22e-4, 8.09e-6, 4.88e-7};
const std::vector<double> sphere_total{5.36e-3, 4.02e-4, 3.12e-5, 2.46e-6};

}  // namespace

ApproximationStudy read_approximation_study(const toml::table& document,
                                            const std::filesystem::path& file) {
  TomlKeys top(document, "", file.string());
  ApproximationStudy study;
  study.title = top.text("title", "");
  const toml::node* const node = top.take("approximation");
  top.require_no_others();
  if (!node)
    throw InputError("{}: [approximation] is missing: what the study is about", file.string());
  if (!node->is_table()) top.fail(*node, "[approximation] must be a table");

  TomlKeys keys(*node->as_table(), "[approximation] ", file.string());
  const toml::node* const surface = keys.take("surface");
  const std::string name = keys.text("surface", "");
  if (name != "graph" && name != "sphere")
    keys.fail(surface ? *surface : *node,
              "[approximation] surface must be \"graph\" or \"sphere\"");
  study.surface = name == "graph" ? Surface::graph : Surface::sphere;
  study.options.tension = keys.number("tension", 1.0, 0.0, 2.0 * (std::sqrt(5.0) - 1.0));
  study.options.levels = keys.integer("levels", 3, 1, 5);
  study.rows = keys.integer("rows", 4, 1, 5);
  keys.require_no_others();
  return study;
}

ErrorTable run(const ApproximationStudy& study) {
  // The paper measured tension 1, and four rows.
  const auto printed = [&](std::vector<double> values) {
    if (study.options.tension != 1.0) values.clear();
    if (values.size() > static_cast<std::size_t>(study.rows))
      values.resize(static_cast<std::size_t>(study.rows));
    return values;
  };
  ErrorTable table;
  if (study.surface == Surface::graph) {
    table.columns = {{"mean", {}, printed(graph_mean)}, {"max", {}, printed(graph_max)}};
    for (int row = 0; row < study.rows; ++row) {
      const GraphError e = graph_error(1 << row, study.options);
      table.h.push_back(e.h);
      table.columns[0].values.push_back(e.mean);
      table.columns[1].values.push_back(e.max);
    }
    return table;
  }
  table.columns = {{"regular", {}, printed(sphere_regular)}, {"total", {}, printed(sphere_total)}};
  for (int row = 0; row < study.rows; ++row) {
    const SphereError e = sphere_error(2 + row, study.options);
    table.h.push_back(e.h);
    table.columns[0].values.push_back(e.regular);
    table.columns[1].values.push_back(e.total);
  }
  return table;
}

std::string to_csv(const ErrorTable& table) {
  std::string text = "h";
  for (const ErrorColumn& c : table.columns)
    text += fmt::format(",{0},{0}_ratio,{0}_printed,{0}_printed_ratio", c.name);
  text += '\n';
  for (std::size_t i = 0; i < table.h.size(); ++i) {
    text += fmt::format("{}", table.h[i]);
    for (const ErrorColumn& c : table.columns)
      for (const auto* errors : {&c.values, &c.printed}) {
        const bool there = i < errors->size();
        text += there ? fmt::format(",{}", (*errors)[i]) : ",";
        text += there && i > 0 ? fmt::format(",{}", ErrorColumn::ratio(*errors, i)) : ",";
      }
    text += '\n';
  }
  return text;
}

}  // namespace limes
