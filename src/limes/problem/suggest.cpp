#include "limes/problem/suggest.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "limes/core/text.h"

namespace limes {

int edit_distance(std::string_view word_a, std::string_view word_b) {
  const std::string a = to_lower(word_a);
  const std::string b = to_lower(word_b);
  const std::size_t n = b.size();
  // Rows i - 2, i - 1 and i of the table of distances between the beginnings of a and b.
  std::vector<int> before(n + 1), last(n + 1), row(n + 1);
  for (std::size_t j = 0; j <= n; ++j)
    row[j] = static_cast<int>(j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before.swap(last);
    last.swap(row);
    row[0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= n; ++j) {
      const int change = a[i - 1] == b[j - 1] ? 0 : 1;
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + change});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], before[j - 2] + 1);
    }
  }
  return row[n];
}

std::string suggest(std::string_view word, std::span<const std::string_view> known) {
  constexpr std::size_t longest_word = 100;  // nobody mistypes more, and the search stays short
  constexpr std::size_t longest_list = 16;
  if (known.empty()) return "there are none";
  struct Candidate {
    int distance;
    std::string_view name;
  };
  std::vector<Candidate> candidates;
  for (const std::string_view name : known)
    candidates.push_back(
        {edit_distance(word.substr(0, longest_word), name.substr(0, longest_word)), name});
  const auto closer = [](const Candidate& a, const Candidate& b) {
    return a.distance < b.distance;
  };
  const Candidate& best = *std::min_element(candidates.begin(), candidates.end(), closer);
  const auto length = static_cast<int>(std::min(best.name.size(), word.size()));
  if (best.distance <= std::max(1, length / 2)) return fmt::format("did you mean '{}'?", best.name);
  if (known.size() > longest_list) std::stable_sort(candidates.begin(), candidates.end(), closer);
  std::string list;
  for (std::size_t i = 0; i < std::min(candidates.size(), longest_list); ++i)
    list += fmt::format("{}{}", i ? ", " : "", candidates[i].name);
  return fmt::format("known are {}{}", list, known.size() > longest_list ? ", ..." : "");
}

}  // namespace limes
