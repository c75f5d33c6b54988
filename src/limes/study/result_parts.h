#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "limes/study/checks.h"

namespace limes {

// What result.json has of every kind of problem.

[[nodiscard]] nlohmann::ordered_json checks_json(const std::vector<SolutionCheck>& checks);

/// Seconds by phase, and bytes.
void add_cost(const std::vector<std::pair<std::string, double>>& timings, std::int64_t peak_memory,
              nlohmann::ordered_json& out);

}  // namespace limes
