#include "pattern_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "limes/mesh/shapes.h"
#include "table.h"

namespace limes::app {

std::vector<ControlPattern> control_patterns(int first, int last) {
  std::vector<ControlPattern> patterns;
  for (int valence = std::max(first, 3); valence <= last; ++valence) {
    const auto add = [&](const char* name, int rings) {
      patterns.push_back({valence, name, quasi_pattern(shapes::triangle_star(valence, rings))});
    };
    add("polygon", 1);
    add("star", PatternOptions{}.kept_rings);
  }
  return patterns;
}

std::string to_text(const std::vector<ControlPattern>& patterns) {
  const PatternOptions looked_at;
  std::vector<std::vector<std::string>> rows{
      {"CONTROL VALENCE", "MESH", "REPEATS AFTER PASS", "PERIOD", "VALENCE THEN", "REGULAR 4-8"}};
  for (const auto& [valence, mesh, pattern] : patterns)
    rows.push_back({fmt::format("{}", valence), mesh,
                    pattern.repeats_after ? fmt::format("{}", *pattern.repeats_after) : "-",
                    pattern.repeats_after ? fmt::format("{}", pattern.period) : "-",
                    fmt::format("{}", pattern.valence), pattern.regular ? "yes" : "no"});
  return fmt::format("patterns of {} rings around a control vertex, {} passes:\n", looked_at.rings,
                     looked_at.num_passes) +
         format_table(rows);
}

nlohmann::ordered_json to_json(const std::vector<ControlPattern>& patterns) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const auto& [valence, mesh, pattern] : patterns) {
    nlohmann::ordered_json entry{
        {"control_valence", valence}, {"mesh", mesh}, {"repeats_after", nullptr}};
    if (pattern.repeats_after) {
      entry["repeats_after"] = *pattern.repeats_after;
      entry["period"] = pattern.period;
    }
    entry["valence"] = pattern.valence;
    entry["regular"] = pattern.regular;
    list.push_back(std::move(entry));
  }
  return {{"rings", PatternOptions{}.rings},
          {"passes", PatternOptions{}.num_passes},
          {"around", std::move(list)}};
}

}  // namespace limes::app
