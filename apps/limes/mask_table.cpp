#include "mask_table.h"

#include <fmt/format.h>

#include <cmath>
#include <complex>

#include "limes/math/fraction.h"
#include "table.h"

namespace limes::app {

std::string weight_text(double weight) {
  const auto fraction = as_fraction(weight);
  if (!fraction) return fmt::format("{:.12f}", weight);
  if (fraction->denominator == 1) return fmt::format("{}", fraction->numerator);
  return fmt::format("{}/{}", fraction->numerator, fraction->denominator);
}

std::string mask_table(const Spectrum& s, int num_sectors) {
  if (!s.limit_mask) return {};
  std::vector<std::vector<std::string>> rows{{"RING", "PLACE", "LIMIT", "TANGENT", "PHASE"}};
  for (std::size_t p = 0; p < s.places.size(); ++p) {
    if (s.places[p].sector != 0) continue;
    const auto i = static_cast<Eigen::Index>(p);
    std::string amplitude = "-", phase = "-";
    if (s.tangent_masks) {
      const std::complex<double> t((*s.tangent_masks)(i, 0), (*s.tangent_masks)(i, 1));
      amplitude = fmt::format("{:.9f}", std::abs(t));
      phase = fmt::format("{:.6f}", std::abs(t) < 1e-12 ? 0.0 : std::arg(t));
    }
    rows.push_back({fmt::format("{}", s.places[p].ring), fmt::format("{}", s.places[p].place),
                    fmt::format("{:.9f}", (*s.limit_mask)[i]), amplitude, phase});
  }
  return fmt::format("masks, per vertex of {} sectors:\n", num_sectors) + format_table(rows);
}

}  // namespace limes::app
