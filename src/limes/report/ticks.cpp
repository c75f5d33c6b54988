#include "limes/report/ticks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "limes/core/error.h"

namespace limes {
namespace {

constexpr std::string_view minus = "\u2212";

std::string with_minus(const std::string& number) {
  return number.starts_with('-') ? fmt::format("{}{}", minus, number.substr(1)) : number;
}

std::string power_of_ten(int exponent) {
  return fmt::format("10^{{{}}}", with_minus(std::to_string(exponent)));
}

/// 10^exponent, exact where doubles are: the nearest double to a negative power, too.
double pow10(int exponent) {
  return exponent >= 0 ? std::pow(10.0, exponent) : 1 / std::pow(10.0, -exponent);
}

/// Distance of ticks as digit * 10^exponent.
struct Step {
  int digit = 1;
  int exponent = 0;
  [[nodiscard]] double multiple(double k) const {
    const double scaled = k * digit;
    return exponent >= 0 ? scaled * pow10(exponent) : scaled / pow10(-exponent);
  }
  [[nodiscard]] double size() const { return multiple(1); }
};

/// The smallest nice step that needs no more than `most` ticks.
Step nice_step(double low, double high, int most) {
  const double wanted = (high - low) / most;
  Step step{1, static_cast<int>(std::floor(std::log10(wanted))) - 1};
  const auto too_many = [&] {
    const double slack = 1e-9 * (high - low) / step.size();
    return std::floor(high / step.size() + slack) - std::ceil(low / step.size() - slack) + 1 > most;
  };
  while (too_many()) {
    if (step.digit == 5) {
      step = {1, step.exponent + 1};
    } else {
      step.digit = step.digit == 1 ? 2 : 5;
    }
  }
  return step;
}

/// digit * 10^exponent as "0.2" or as "2·10^{-1}".
std::string log_label(int digit, int exponent, bool plain) {
  if (plain) return fmt::format("{:.{}f}", digit * pow10(exponent), std::max(0, -exponent));
  return digit == 1 ? power_of_ten(exponent) : fmt::format("{}·{}", digit, power_of_ten(exponent));
}

/// Plain numbers only if none is long.
void add_log_ticks(Ticks& ticks, double low, double high, std::initializer_list<int> digits,
                   int every) {
  constexpr double slack = 1e-9;
  const bool plain = low > 0.9e-3 && high < 1.1e5;
  const int first = static_cast<int>(std::floor(std::log10(low)));
  const int last = static_cast<int>(std::ceil(std::log10(high)));
  for (int e = first; e <= last; ++e) {
    if (e % every != 0) continue;
    for (const int digit : digits) {
      const double value = digit * pow10(e);
      if (value < low * (1 - slack) || value > high * (1 + slack)) continue;
      ticks.values.push_back(value);
      ticks.labels.push_back(log_label(digit, e, plain));
    }
  }
}

}  // namespace

std::string Ticks::factor() const {
  return exponent == 0 ? "" : "×" + power_of_ten(exponent);
}

Ticks linear_ticks(double low, double high, int most) {
  LIMES_ASSERT(most >= 2 && std::isfinite(low) && std::isfinite(high) && low <= high);
  if (!(high - low > 1e-12 * std::max(std::abs(low), std::abs(high))))
    return {{low}, {format_readable(low)}, 0};
  const Step step = nice_step(low, high, most);
  const double slack = 1e-9 * (high - low) / step.size();
  Ticks ticks;
  for (double k = std::ceil(low / step.size() - slack); k <= high / step.size() + slack; ++k)
    ticks.values.push_back(step.multiple(k == 0 ? 0.0 : k));
  const double magnitude = std::max(std::abs(low), std::abs(high));
  const int order = static_cast<int>(std::floor(std::log10(magnitude)));
  // powers of a thousand, as in engineering, and only where plain numbers would be long
  if (order >= 5 || order < -3) ticks.exponent = static_cast<int>(std::floor(order / 3.0)) * 3;
  const int decimals = std::max(0, ticks.exponent - step.exponent);
  for (const double value : ticks.values) {
    const double scaled = value / pow10(ticks.exponent);
    ticks.labels.push_back(with_minus(fmt::format("{:.{}f}", scaled, decimals)));
  }
  return ticks;
}

Ticks log_ticks(double low, double high, int most) {
  LIMES_ASSERT(most >= 2 && low > 0 && std::isfinite(high) && low <= high);
  const double decades = std::log10(high / low);
  Ticks ticks;
  if (decades < 2) {
    add_log_ticks(ticks, low, high, {1, 2, 5}, 1);
    if (ticks.values.size() >= 2 && static_cast<int>(ticks.values.size()) <= most) return ticks;
    ticks = {};
    if (decades < 0.5) return linear_ticks(low, high, most);
  }
  const int every = std::max(1, static_cast<int>(std::ceil((decades + 1) / most)));
  add_log_ticks(ticks, low, high, {1}, every);
  return ticks.values.empty() ? linear_ticks(low, high, most) : ticks;
}

std::string format_readable(double value, int digits) {
  if (value == 0) return "0";
  if (!std::isfinite(value)) return with_minus(fmt::format("{}", value));
  const double magnitude = std::abs(value);
  if (magnitude >= 1e-3 && magnitude < 1e6) {
    const std::string plain = fmt::format("{:.{}g}", value, digits);
    if (plain.find('e') == std::string::npos) return with_minus(plain);
    return with_minus(fmt::format("{:.0f}", value));
  }
  const std::string text = fmt::format("{:.{}e}", value, digits - 1);
  const std::size_t e = text.find('e');
  std::string mantissa = text.substr(0, e);
  if (mantissa.find('.') != std::string::npos) {
    mantissa.erase(mantissa.find_last_not_of('0') + 1);
    if (mantissa.ends_with('.')) mantissa.pop_back();
  }
  return fmt::format("{}×{}", with_minus(mantissa), power_of_ten(std::stoi(text.substr(e + 1))));
}

}  // namespace limes
