#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "limes/curve/curve_scheme.h"
#include "limes/spectrum/rules.h"
#include "limes/subdiv/scheme.h"

namespace limes::app {

/// All about one scheme in numbers: stencils, masks and limit rows.
struct SchemeDescription {
  const Scheme* scheme;
  double tension;
  SchemeRules rules;
  std::vector<Analysis> analyses;  ///< the regular valence, then the one that was asked for
  std::vector<std::string> notes;  ///< what the weights do not say
};

/// @param valence  with rules of its own, or nothing
/// @throws UsageError for a valence that the scheme does not have
[[nodiscard]] SchemeDescription describe(const Scheme& scheme, double tension,
                                         std::optional<int> valence);

[[nodiscard]] std::string to_text(const SchemeDescription& description);
[[nodiscard]] nlohmann::ordered_json to_json(const SchemeDescription& description);

[[nodiscard]] std::string to_text(const CurveScheme& scheme);
[[nodiscard]] nlohmann::ordered_json to_json(const CurveScheme& scheme);

}  // namespace limes::app
