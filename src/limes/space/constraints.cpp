#include "limes/space/constraints.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace limes {
namespace {

/// Determined dofs as combinations of others. A combination may use dofs that were determined
/// later; it is resolved when it is read.
class Substitution {
 public:
  explicit Substitution(int num_dofs) : rule_(static_cast<std::size_t>(num_dofs)) {}

  [[nodiscard]] bool determined(int dof) const {
    return rule_[static_cast<std::size_t>(dof)].has_value();
  }

  /// The row in terms of undetermined dofs only.
  [[nodiscard]] std::map<int, double> resolved(const ConstraintRow& row) const {
    std::map<int, double> out;
    ConstraintRow open = row;
    while (!open.empty()) {
      const auto [dof, weight] = open.back();
      open.pop_back();
      const auto& rule = rule_[static_cast<std::size_t>(dof)];
      if (!rule) {
        out[dof] += weight;
        continue;
      }
      for (const auto& [source, factor] : *rule)
        open.emplace_back(source, weight * factor);
    }
    return out;
  }

  void determine(int dof, ConstraintRow by) {
    rule_[static_cast<std::size_t>(dof)] = std::move(by);
  }

 private:
  std::vector<std::optional<ConstraintRow>> rule_;
};

double largest_weight(const ConstraintRow& row) {
  double largest = 0;
  for (const auto& [dof, weight] : row)
    largest = std::max(largest, std::abs(weight));
  return largest;
}

void use_row(const ConstraintRow& row, double tolerance, Substitution& substitution) {
  const double smallest = tolerance * largest_weight(row);
  const std::map<int, double> left = substitution.resolved(row);
  auto pivot = left.end();
  for (auto it = left.begin(); it != left.end(); ++it)
    if (std::abs(it->second) > smallest &&
        (pivot == left.end() || std::abs(it->second) > 1.0000001 * std::abs(pivot->second)))
      pivot = it;
  if (pivot == left.end()) return;  // follows from the others
  ConstraintRow by;
  for (const auto& [dof, weight] : left)
    if (dof != pivot->first && std::abs(weight) > 1e-14 * std::abs(pivot->second))
      by.emplace_back(dof, -weight / pivot->second);
  substitution.determine(pivot->first, std::move(by));
}

}  // namespace

Elimination eliminate(int num_dofs, const std::vector<ConstraintRow>& rows, double tolerance) {
  Substitution substitution(num_dofs);
  for (const ConstraintRow& row : rows)
    use_row(row, tolerance, substitution);
  Elimination out;
  for (int i = 0; i < num_dofs; ++i) {
    const bool free = !substitution.determined(i);
    out.free_number.push_back(free ? static_cast<int>(out.dof_of_free.size()) : -1);
    if (free) out.dof_of_free.push_back(i);
  }
  std::vector<Triplet> entries;
  for (int i = 0; i < num_dofs; ++i)
    for (const auto& [dof, weight] : substitution.resolved({{i, 1.0}}))
      entries.emplace_back(i, out.free_number[static_cast<std::size_t>(dof)], weight);
  out.T.resize(num_dofs, static_cast<Eigen::Index>(out.dof_of_free.size()));
  out.T.setFromTriplets(entries.begin(), entries.end());
  return out;
}

}  // namespace limes
