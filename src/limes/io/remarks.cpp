#include "limes/io/remarks.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace limes {
namespace {
constexpr std::size_t most_kinds = 20;
constexpr std::size_t most_lines = 4;
}  // namespace

void Remarks::add(std::int64_t line, std::string_view what) {
  auto kind = std::find_if(kinds_.begin(), kinds_.end(),
                           [&](const Kind& other) { return other.what == what; });
  if (kind == kinds_.end()) {
    if (kinds_.size() == most_kinds) {
      ++left_out_;
      return;
    }
    kinds_.push_back({std::string(what), {}, 0, 0});
    kind = kinds_.end() - 1;
  }
  if (line > 0 && kind->last_line == line) return;  // one mention for each line
  kind->last_line = line;
  ++kind->count;
  if (kind->lines.size() < most_lines) kind->lines.push_back(line);
}

std::string Remarks::sentence(const Kind& kind) const {
  const std::int64_t first = kind.lines.front();
  if (first == 0)
    return fmt::format("{}: {}{}", file_, kind.what,
                       kind.count > 1 ? fmt::format(" ({} times)", kind.count) : "");
  const std::string start = fmt::format("{}:{}: {}", file_, first, kind.what);
  if (kind.lines.size() == 1) return start;
  const std::string others =
      fmt::format("{}", fmt::join(kind.lines.begin() + 1, kind.lines.end(), ", "));
  const std::int64_t more = kind.count - static_cast<std::int64_t>(kind.lines.size());
  if (more > 0) return fmt::format("{} (also lines {} and {} more)", start, others, more);
  return fmt::format("{} (also {} {})", start, kind.lines.size() == 2 ? "line" : "lines", others);
}

std::vector<std::string> Remarks::sentences() const {
  std::vector<std::string> result;
  for (const Kind& kind : kinds_)
    result.push_back(sentence(kind));
  if (left_out_ > 0) result.push_back(fmt::format("{}: {} more remarks", file_, left_out_));
  return result;
}

}  // namespace limes
