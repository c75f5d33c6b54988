#include "limes/space/constraints.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <map>

#include "limes/core/interrupt.h"

namespace limes {
namespace {

/// A condition whose pivot is smaller than this, where rows have largest weight 1, follows from the
/// others. Rounding leaves 1e-8 and less, independent conditions have 1e-5 and more.
constexpr double smallest_pivot = 1e-6;
/// Smaller weights of rules are rounding.
constexpr double smallest_weight = 1e-14;

using Qr = Eigen::ColPivHouseholderQR<MatrixX>;

/// The order in which rows are met by breadth-first search: rows that share dofs are close together.
std::vector<int> breadth_first(int num_dofs, const std::vector<ConstraintRow>& rows) {
  std::vector<std::vector<int>> rows_of(static_cast<std::size_t>(num_dofs));
  for (std::size_t r = 0; r < rows.size(); ++r)
    for (const auto& [dof, weight] : rows[r])
      rows_of[static_cast<std::size_t>(dof)].push_back(static_cast<int>(r));
  std::vector<int> order;
  std::vector<bool> met(rows.size(), false);
  const auto meet = [&](int r) {
    if (!met[static_cast<std::size_t>(r)]) order.push_back(r);
    met[static_cast<std::size_t>(r)] = true;
  };
  std::size_t next = 0;
  for (std::size_t start = 0; start < rows.size(); ++start) {
    meet(static_cast<int>(start));
    for (; next < order.size(); ++next)
      for (const auto& [dof, weight] : rows[static_cast<std::size_t>(order[next])]) {
        std::vector<int>& others = rows_of[static_cast<std::size_t>(dof)];
        std::for_each(others.begin(), others.end(), meet);
        others.clear();  // all of them are met
      }
  }
  return order;
}

/// Frontal elimination by QR. Rows enter block after block. Dofs that no later row has are complete;
/// column pivoting determines some of them, and they leave together with as many rows. What is left
/// waits for the next block. Only orthogonal transformations act on waiting rows, so rounding in them
/// does not grow, and the last block decides like one QR of all rows.
class Front {
 public:
  explicit Front(int num_dofs)
      : last_row_(static_cast<std::size_t>(num_dofs), -1),
        rule_(static_cast<std::size_t>(num_dofs)),
        determined_(static_cast<std::size_t>(num_dofs), false) {}

  void eliminate(const std::vector<ConstraintRow>& rows, int block) {
    const std::vector<int> order = breadth_first(static_cast<int>(rule_.size()), rows);
    const auto row = [&](int k) -> const ConstraintRow& {
      return rows[static_cast<std::size_t>(order[static_cast<std::size_t>(k)])];
    };
    const int n = static_cast<int>(order.size());
    for (int k = 0; k < n; ++k)
      for (const auto& [dof, weight] : row(k))
        last_row_[static_cast<std::size_t>(dof)] = k;
    int entered = 0;  // dofs of this block
    for (int k = 0; k < n; ++k) {
      entered += enter(row(k));
      if (entered < block && k + 1 < n) continue;
      check_interrupt();
      reduce(k);
      entered = 0;
    }
    substitute();
  }

  [[nodiscard]] bool determines(int dof) const {
    return determined_[static_cast<std::size_t>(dof)];
  }
  [[nodiscard]] const ConstraintRow& rule(int dof) const {
    return rule_[static_cast<std::size_t>(dof)];
  }

 private:
  /// Columns of a matrix.
  using Dofs = std::vector<int>;

  /// @return number of dofs that were not there before
  int enter(const ConstraintRow& row) {
    double largest = 0;
    for (const auto& [dof, weight] : row)
      largest = std::max(largest, std::abs(weight));
    if (largest == 0) return 0;
    const std::size_t before = column_.size();
    rows_.emplace_back();
    for (const auto& [dof, weight] : row) {
      column_.emplace(dof, 0);
      rows_.back().emplace_back(dof, weight / largest);
    }
    return static_cast<int>(column_.size() - before);
  }

  /// Determines dofs that no row after k has, keeps what is left of the rows.
  void reduce(int k) {
    Dofs dofs;
    for (const auto& [dof, column] : column_)
      dofs.push_back(dof);
    const Eigen::Index num_complete =
        std::stable_partition(
            dofs.begin(), dofs.end(),
            [&](int dof) { return last_row_[static_cast<std::size_t>(dof)] <= k; }) -
        dofs.begin();
    if (num_complete == 0) return;  // all rows wait
    MatrixX M = matrix_of_rows(dofs);
    const Qr qr(M.leftCols(num_complete));
    const auto& order = qr.colsPermutation().indices();
    const Dofs complete(dofs.begin(), dofs.begin() + num_complete);
    for (Eigen::Index j = 0; j < num_complete; ++j)
      dofs[static_cast<std::size_t>(j)] = complete[static_cast<std::size_t>(order(j))];
    M.leftCols(num_complete) = qr.matrixR().triangularView<Eigen::Upper>();
    M.rightCols(M.cols() - num_complete).applyOnTheLeft(qr.householderQ().adjoint());
    const Eigen::Index rank = acceptable(M, std::min(M.rows(), num_complete));
    determine(M.topRows(rank), dofs);
    wait(M.bottomRightCorner(M.rows() - rank, M.cols() - rank), {dofs.begin() + rank, dofs.end()});
  }

  /// The rows as a matrix with these columns.
  MatrixX matrix_of_rows(const Dofs& dofs) {
    for (std::size_t j = 0; j < dofs.size(); ++j)
      column_[dofs[j]] = static_cast<Eigen::Index>(j);
    MatrixX M = MatrixX::Zero(static_cast<Eigen::Index>(rows_.size()),
                              static_cast<Eigen::Index>(dofs.size()));
    for (std::size_t i = 0; i < rows_.size(); ++i)
      for (const auto& [dof, weight] : rows_[i])
        M(static_cast<Eigen::Index>(i), column_[dof]) += weight;
    return M;
  }

  /// Number of leading pivots that are the largest weights of their rows (but for rounding), so that
  /// rules have no large weights. The others wait for open dofs to become complete.
  static Eigen::Index acceptable(const MatrixX& R, Eigen::Index most) {
    Eigen::Index rank = 0;
    for (; rank < most; ++rank) {
      const double pivot = std::abs(R(rank, rank));
      if (!(pivot > smallest_pivot)) break;
      if (R.row(rank).cwiseAbs().maxCoeff() > 1.0001 * pivot) break;
    }
    return rank;
  }

  void determine(const MatrixX& R, const Dofs& dofs) {
    const Eigen::Index rank = R.rows();
    MatrixX by = -R.rightCols(R.cols() - rank);
    if (by.size() > 0) R.leftCols(rank).triangularView<Eigen::Upper>().solveInPlace(by);
    for (Eigen::Index i = 0; i < rank; ++i) {
      const int dof = dofs[static_cast<std::size_t>(i)];
      determined_[static_cast<std::size_t>(dof)] = true;
      sequence_.push_back(dof);
      for (Eigen::Index j = 0; j < by.cols(); ++j)
        if (std::abs(by(i, j)) > smallest_weight)
          rule_[static_cast<std::size_t>(dof)].emplace_back(
              dofs[static_cast<std::size_t>(rank + j)], by(i, j));
    }
  }

  /// Independent rows among those left.
  void wait(const MatrixX& left, const Dofs& dofs) {
    rows_.clear();
    column_.clear();
    if (left.size() == 0) return;
    const Qr qr(left);
    const auto& R = qr.matrixR();
    for (Eigen::Index i = 0; i < std::min(R.rows(), R.cols()); ++i) {
      if (!(std::abs(R(i, i)) > smallest_pivot)) break;
      rows_.emplace_back();
      for (Eigen::Index j = i; j < R.cols(); ++j) {
        if (!(std::abs(R(i, j)) > smallest_weight)) continue;
        const int dof = dofs[static_cast<std::size_t>(qr.colsPermutation().indices()(j))];
        column_.emplace(dof, 0);
        rows_.back().emplace_back(dof, R(i, j));
      }
    }
  }

  /// Makes all rules use free dofs only: those made last do so already.
  void substitute() {
    for (auto it = sequence_.rbegin(); it != sequence_.rend(); ++it) {
      ConstraintRow& own = rule_[static_cast<std::size_t>(*it)];
      std::map<int, double> sum;
      for (const auto& [dof, weight] : own) {
        if (!determines(dof)) sum[dof] += weight;
        for (const auto& [source, factor] : rule(dof))
          sum[source] += weight * factor;
      }
      std::erase_if(sum, [](const auto& s) { return std::abs(s.second) <= smallest_weight; });
      own.assign(sum.begin(), sum.end());
    }
  }

  std::vector<int> last_row_;  // of each dof, in the order in which rows enter
  std::vector<ConstraintRow> rows_;
  std::map<int, Eigen::Index> column_;  // of the dofs of these rows
  std::vector<ConstraintRow> rule_;     // a determined dof as a combination of others
  std::vector<bool> determined_;
  std::vector<int> sequence_;  // in which dofs were determined
};

}  // namespace

Elimination eliminate(int num_dofs, const std::vector<ConstraintRow>& rows, int block) {
  Front front(num_dofs);
  front.eliminate(rows, block);
  Elimination out;
  for (int i = 0; i < num_dofs; ++i) {
    const bool free = !front.determines(i);
    out.free_number.push_back(free ? static_cast<int>(out.dof_of_free.size()) : -1);
    if (free) out.dof_of_free.push_back(i);
  }
  std::vector<Triplet> entries;
  for (int i = 0; i < num_dofs; ++i) {
    const int number = out.free_number[static_cast<std::size_t>(i)];
    if (number >= 0) entries.emplace_back(i, number, 1.0);
    for (const auto& [dof, weight] : front.rule(i))
      entries.emplace_back(i, out.free_number[static_cast<std::size_t>(dof)], weight);
  }
  out.T.resize(num_dofs, static_cast<Eigen::Index>(out.dof_of_free.size()));
  out.T.setFromTriplets(entries.begin(), entries.end());
  return out;
}

}  // namespace limes
