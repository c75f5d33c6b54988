#include "mask_table.h"

#include <fmt/format.h>

#include <cmath>
#include <complex>

#include "limes/math/fraction.h"
#include "table.h"

namespace limes::app {
namespace {

/// Of the eigenvectors.
constexpr double noise = 1e-12;

std::string decimal(double weight) {
  return fmt::format("{:.9f}", std::abs(weight) < noise ? 0.0 : weight);
}

std::string text_of(const Fraction& fraction) {
  if (fraction.denominator == 1) return fmt::format("{}", fraction.numerator);
  return fmt::format("{}/{}", fraction.numerator, fraction.denominator);
}

}  // namespace

std::optional<std::string> weight_fraction(double weight) {
  const auto fraction = as_fraction(weight);
  if (!fraction) return std::nullopt;
  return text_of(*fraction);
}

std::string weight_text(double weight) {
  return weight_fraction(weight).value_or(fmt::format("{:.12f}", weight));
}

std::optional<std::string> limit_fraction(double weight) {
  const auto fraction = as_fraction(weight, {.most_denominator = 4096, .tolerance = noise});
  if (!fraction) return std::nullopt;
  return text_of(*fraction);
}

std::string mask_table(const Spectrum& s, int num_sectors) {
  if (!s.limit_mask) return {};
  std::vector<std::vector<std::string>> rows{
      {"RING", "PLACE", "LIMIT", "FRACTION", "TANGENT", "PHASE"}};
  for (std::size_t p = 0; p < s.places.size(); ++p) {
    if (s.places[p].sector != 0) continue;
    const auto i = static_cast<Eigen::Index>(p);
    std::string amplitude = "-", phase = "-";
    if (s.tangent_masks) {
      const std::complex<double> t((*s.tangent_masks)(i, 0), (*s.tangent_masks)(i, 1));
      amplitude = fmt::format("{:.9f}", std::abs(t));
      const double angle = std::abs(t) < noise ? 0.0 : std::arg(t);
      phase = fmt::format("{:.6f}", std::abs(angle) < noise ? 0.0 : angle);
    }
    rows.push_back({fmt::format("{}", s.places[p].ring), fmt::format("{}", s.places[p].place),
                    decimal((*s.limit_mask)[i]), limit_fraction((*s.limit_mask)[i]).value_or("-"),
                    amplitude, phase});
  }
  return fmt::format("masks, per vertex of {} sectors:\n", num_sectors) + format_table(rows);
}

}  // namespace limes::app
