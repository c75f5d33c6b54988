#include "rule_layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "limes/math/fraction.h"
#include "mask_table.h"
#include "table.h"

namespace limes::app {
namespace {

constexpr double equal = 1e-9;  // of coordinates and of weights in one line

void sort_unique(std::vector<double>& values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end(),
                           [](double a, double b) { return std::abs(a - b) < equal; }),
               values.end());
}

std::size_t index_of(const std::vector<double>& values, double x) {
  const auto at = std::lower_bound(values.begin(), values.end(), x - equal);
  return static_cast<std::size_t>(at - values.begin());
}

/// All cells to the right, columns of equal width.
std::string aligned(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths(rows.front().size(), 0);
  for (const auto& row : rows)
    for (std::size_t i = 0; i < row.size(); ++i)
      widths[i] = std::max(widths[i], row[i].size());
  std::string text;
  for (const auto& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i)
      text += fmt::format("  {:>{}}", row[i], widths[i]);
    text += "\n";
  }
  return text;
}

}  // namespace

std::string lattice_layout(const std::vector<RuleWeight>& weights) {
  std::vector<double> xs, ys, values;
  for (const RuleWeight& w : weights) {
    xs.push_back(w.at.x());
    ys.push_back(w.at.y());
    values.push_back(w.weight);
  }
  sort_unique(xs);
  sort_unique(ys);
  const auto denominator = common_denominator(values);
  const auto cell = [&](double weight) {
    return denominator ? fmt::format("{}", std::llround(weight * static_cast<double>(*denominator)))
                       : fmt::format("{:.9f}", weight);
  };
  std::vector<std::vector<std::string>> rows(ys.size() + 1);
  rows[0] = {"y \\ x"};
  for (const double x : xs)
    rows[0].push_back(weight_text(x));
  for (std::size_t j = 0; j < ys.size(); ++j) {
    rows[ys.size() - j] = {weight_text(ys[j])};
    rows[ys.size() - j].resize(xs.size() + 1, ".");
  }
  for (const RuleWeight& w : weights)
    rows[ys.size() - index_of(ys, w.at.y())][index_of(xs, w.at.x()) + 1] = cell(w.weight);
  const std::string scale =
      denominator && *denominator > 1 ? fmt::format("1/{} of\n", *denominator) : "";
  return scale + aligned(rows);
}

std::string star_layout(const std::vector<RuleWeight>& weights, int num_sectors) {
  std::map<std::pair<int, int>, std::vector<const RuleWeight*>> orbits;
  for (const RuleWeight& w : weights)
    orbits[{w.place.ring, w.place.place}].push_back(&w);
  std::vector<std::vector<std::string>> rows{{"RING", "PLACE", "SECTORS", "WEIGHT"}};
  for (const auto& [orbit, members] : orbits) {
    std::vector<bool> done(members.size(), false);
    for (std::size_t i = 0; i < members.size(); ++i) {
      if (done[i]) continue;
      std::string sectors;
      int count = 0;
      for (std::size_t k = i; k < members.size(); ++k) {
        if (done[k] || std::abs(members[k]->weight - members[i]->weight) >= equal) continue;
        done[k] = true;
        sectors += fmt::format("{}{}", sectors.empty() ? "" : ",", members[k]->place.sector);
        ++count;
      }
      if (count == num_sectors) sectors = "every";
      rows.push_back({fmt::format("{}", orbit.first), fmt::format("{}", orbit.second), sectors,
                      weight_text(members[i]->weight)});
    }
  }
  return format_table(rows);
}

}  // namespace limes::app
