#include "limes/space/constraints.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <span>

#include "limes/core/interrupt.h"

namespace limes {
namespace {

/// Determined dofs as combinations of free ones; a free dof has no rule.
using Rules = std::map<int, ConstraintRow>;

/// More dofs than this that hang together are eliminated row by row.
constexpr std::size_t most_dense = 1200;
/// Below this, relative to the largest pivot, a row of a dense elimination follows from the others.
/// Rounding leaves 1e-10 and less, independent conditions have 1e-4 and more.
constexpr double dense_rank = 1e-8;
/// The same for a row after substitution, relative to its largest weight before.
constexpr double sparse_rank = 1e-6;

double largest_weight(const ConstraintRow& row) {
  double largest = 0;
  for (const auto& [dof, weight] : row)
    largest = std::max(largest, std::abs(weight));
  return largest;
}

/// QR with column pivoting: determines the dofs with the largest pivots by the others.
void eliminate_dense(std::span<const ConstraintRow* const> rows, const std::vector<int>& dofs,
                     Rules& rules) {
  MatrixX M =
      MatrixX::Zero(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(dofs.size()));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double scale = largest_weight(*rows[i]);
    for (const auto& [dof, weight] : *rows[i]) {
      const auto column = std::lower_bound(dofs.begin(), dofs.end(), dof) - dofs.begin();
      M(static_cast<Eigen::Index>(i), column) += weight / scale;
    }
  }
  Eigen::ColPivHouseholderQR<MatrixX> qr(M);
  qr.setThreshold(dense_rank);
  const Eigen::Index rank = qr.rank();
  const MatrixX R = qr.matrixR().topRows(rank);
  const MatrixX by =
      -R.leftCols(rank).triangularView<Eigen::Upper>().solve(R.rightCols(R.cols() - rank));
  const auto dof_at = [&](Eigen::Index column) {
    return dofs[static_cast<std::size_t>(qr.colsPermutation().indices()(column))];
  };
  for (Eigen::Index i = 0; i < rank; ++i) {
    ConstraintRow& rule = rules[dof_at(i)];
    for (Eigen::Index j = 0; j < by.cols(); ++j)
      if (std::abs(by(i, j)) > 1e-14) rule.emplace_back(dof_at(rank + j), by(i, j));
  }
}

/// Row after row, for components too large for a dense matrix. A rule uses dofs that were
/// undetermined when it was made; some of them may have been determined since.
class RowByRow {
 public:
  void use(const ConstraintRow& row) {
    const double smallest = sparse_rank * largest_weight(row);
    const std::map<int, double> left = resolved(row);
    auto pivot = left.end();
    for (auto it = left.begin(); it != left.end(); ++it)
      if (std::abs(it->second) > smallest &&
          (pivot == left.end() || std::abs(it->second) > std::abs(pivot->second)))
        pivot = it;
    if (pivot == left.end()) return;  // follows from the others
    const int dof = pivot->first;
    rank_[dof] = static_cast<int>(rank_.size());
    for (const auto& [source, weight] : left)
      if (source != dof && std::abs(weight) > smallest)
        rule_[dof].emplace_back(source, -weight / pivot->second);
  }

  void finish(Rules& rules) const {
    for (const auto& [dof, rank] : rank_) {
      ConstraintRow& rule = rules[dof];
      for (const auto& [source, weight] : resolved({{dof, 1.0}}))
        rule.emplace_back(source, weight);
    }
  }

 private:
  static constexpr int undetermined = std::numeric_limits<int>::max();
  [[nodiscard]] int rank(int dof) const {
    const auto it = rank_.find(dof);
    return it == rank_.end() ? undetermined : it->second;
  }

  /// The row in terms of undetermined dofs only. In the order in which dofs were determined, because
  /// a rule only leads to later ones: so each is expanded once, when all that leads to it has been.
  [[nodiscard]] std::map<int, double> resolved(const ConstraintRow& row) const {
    std::map<std::pair<int, int>, double> open;
    for (const auto& [dof, weight] : row)
      open[{rank(dof), dof}] += weight;
    while (!open.empty() && open.begin()->first.first != undetermined) {
      const auto [key, weight] = *open.begin();
      open.erase(open.begin());
      const auto rule = rule_.find(key.second);
      if (rule == rule_.end()) continue;  // determined to be 0
      for (const auto& [source, factor] : rule->second)
        open[{rank(source), source}] += weight * factor;
    }
    std::map<int, double> out;
    for (const auto& [key, weight] : open)
      out.emplace(key.second, weight);
    return out;
  }

  std::map<int, int> rank_;  // when a dof was determined
  std::map<int, ConstraintRow> rule_;
};

/// Rows that share dofs, directly or through others, in order of their first row.
std::vector<std::vector<const ConstraintRow*>> components(int num_dofs,
                                                          const std::vector<ConstraintRow>& rows) {
  std::vector<int> parent(static_cast<std::size_t>(num_dofs));
  std::iota(parent.begin(), parent.end(), 0);
  const auto find = [&](int i) {
    while (parent[static_cast<std::size_t>(i)] != i)
      i = parent[static_cast<std::size_t>(i)] =
          parent[static_cast<std::size_t>(parent[static_cast<std::size_t>(i)])];
    return i;
  };
  for (const ConstraintRow& row : rows)
    for (const auto& [dof, weight] : row)
      parent[static_cast<std::size_t>(find(dof))] = find(row.front().first);
  std::vector<std::vector<const ConstraintRow*>> out;
  std::map<int, std::size_t> index;
  for (const ConstraintRow& row : rows) {
    if (row.empty()) continue;
    const auto [it, added] = index.try_emplace(find(row.front().first), out.size());
    if (added) out.emplace_back();
    out[it->second].push_back(&row);
  }
  return out;
}

void eliminate_component(const std::vector<const ConstraintRow*>& rows, Rules& rules) {
  check_interrupt();
  std::set<int> dofs;
  for (const ConstraintRow* row : rows)
    for (const auto& [dof, weight] : *row)
      dofs.insert(dof);
  if (dofs.size() <= most_dense) {
    eliminate_dense(rows, {dofs.begin(), dofs.end()}, rules);
    return;
  }
  RowByRow elimination;
  for (const ConstraintRow* row : rows) {
    check_interrupt();
    elimination.use(*row);
  }
  elimination.finish(rules);
}

}  // namespace

Elimination eliminate(int num_dofs, const std::vector<ConstraintRow>& rows) {
  Rules rules;
  for (const auto& component : components(num_dofs, rows))
    eliminate_component(component, rules);

  Elimination out;
  for (int i = 0; i < num_dofs; ++i) {
    const bool free = !rules.contains(i);
    out.free_number.push_back(free ? static_cast<int>(out.dof_of_free.size()) : -1);
    if (free) out.dof_of_free.push_back(i);
  }
  std::vector<Triplet> entries;
  for (int i = 0; i < num_dofs; ++i) {
    const int number = out.free_number[static_cast<std::size_t>(i)];
    if (number >= 0) {
      entries.emplace_back(i, number, 1.0);
      continue;
    }
    for (const auto& [dof, weight] : rules[i])
      entries.emplace_back(i, out.free_number[static_cast<std::size_t>(dof)], weight);
  }
  out.T.resize(num_dofs, static_cast<Eigen::Index>(out.dof_of_free.size()));
  out.T.setFromTriplets(entries.begin(), entries.end());
  return out;
}

}  // namespace limes
