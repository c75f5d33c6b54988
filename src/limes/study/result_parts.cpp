#include "limes/study/result_parts.h"

namespace limes {

using Json = nlohmann::ordered_json;

Json checks_json(const std::vector<SolutionCheck>& checks) {
  Json out = Json::array();
  for (const SolutionCheck& c : checks)
    out.push_back(
        {{"name", c.name}, {"value", c.value}, {"limit", c.limit}, {"passed", c.passed()}});
  return out;
}

void add_cost(const std::vector<std::pair<std::string, double>>& timings, std::int64_t peak_memory,
              Json& out) {
  out["timings"] = Json::object();
  for (const auto& [phase, seconds] : timings)
    out["timings"][phase] = seconds;
  out["peak_memory"] = peak_memory;
}

}  // namespace limes
