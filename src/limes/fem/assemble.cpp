#include "limes/fem/assemble.h"

#include <algorithm>

#include "limes/core/interrupt.h"
#include "limes/core/parallel.h"

namespace limes {
namespace {

/// Elements computed at the same time before their matrices are added in order.
constexpr int batch_size = 1024;

/// Dofs that share an element with each dof, ascending.
std::vector<std::vector<int>> neighbours(const SubdivisionSpace& space) {
  std::vector<std::vector<int>> out(static_cast<std::size_t>(space.num_dofs()));
  for (int e = 0; e < static_cast<int>(space.elements().size()); ++e)
    for (const int a : space.dofs(e)) {
      auto& row = out[static_cast<std::size_t>(a)];
      const auto dofs = space.dofs(e);
      row.insert(row.end(), dofs.begin(), dofs.end());
      if (row.size() > 512) {  // keep it short: most entries are repetitions
        std::sort(row.begin(), row.end());
        row.erase(std::unique(row.begin(), row.end()), row.end());
      }
    }
  for (auto& row : out) {
    std::sort(row.begin(), row.end());
    row.erase(std::unique(row.begin(), row.end()), row.end());
  }
  return out;
}

/// A matrix of zeros with the pattern of the space.
SparseMatrix empty_matrix(const std::vector<std::vector<int>>& neighbours, int c) {
  const int size = c * static_cast<int>(neighbours.size());
  SparseMatrix K(size, size);
  std::int64_t entries = 0;
  for (const auto& row : neighbours)
    entries += static_cast<std::int64_t>(row.size()) * c * c;
  K.reserve(entries);
  for (std::size_t a = 0; a < neighbours.size(); ++a)
    for (int i = 0; i < c; ++i) {
      const int row = c * static_cast<int>(a) + i;
      K.startVec(row);
      for (const int b : neighbours[a])
        for (int j = 0; j < c; ++j)
          K.insertBack(row, c * b + j) = 0.0;
    }
  K.finalize();
  return K;
}

/// Adds an element matrix. All c rows of a dof have the same columns, in blocks of c.
void scatter(std::span<const int> dofs, const std::vector<std::vector<int>>& neighbours, int c,
             const MatrixX& Ke, SparseMatrix& K) {
  for (std::size_t a = 0; a < dofs.size(); ++a) {
    const auto& row = neighbours[static_cast<std::size_t>(dofs[a])];
    for (std::size_t b = 0; b < dofs.size(); ++b) {
      const auto at = std::lower_bound(row.begin(), row.end(), dofs[b]) - row.begin();
      for (int i = 0; i < c; ++i) {
        double* values =
            K.valuePtr() + K.outerIndexPtr()[c * dofs[a] + i] + c * static_cast<int>(at);
        for (int j = 0; j < c; ++j)
          values[j] +=
              Ke(c * static_cast<Eigen::Index>(a) + i, c * static_cast<Eigen::Index>(b) + j);
      }
    }
  }
}

/// Computes element by element in parallel, hands the results over in order.
template <class Value, class Compute, class Use>
void in_order(int count, const Compute& compute, const Use& use) {
  std::vector<Value> values(static_cast<std::size_t>(std::min(count, batch_size)));
  for (int first = 0; first < count; first += batch_size) {
    check_interrupt();
    const int size = std::min(batch_size, count - first);
    for_each_block(size, 16, [&](std::int64_t begin, std::int64_t end) {
      for (std::int64_t i = begin; i < end; ++i)
        compute(first + static_cast<int>(i), values[static_cast<std::size_t>(i)]);
    });
    for (int i = 0; i < size; ++i)
      use(first + i, values[static_cast<std::size_t>(i)]);
  }
}

}  // namespace

SparseMatrix assemble(const SubdivisionSpace& space, int components,
                      const ElementMatrix& element_matrix) {
  const auto near = neighbours(space);
  SparseMatrix K = empty_matrix(near, components);
  in_order<MatrixX>(
      static_cast<int>(space.elements().size()), element_matrix,
      [&](int e, const MatrixX& Ke) { scatter(space.dofs(e), near, components, Ke, K); });
  return K;
}

VectorX assemble_vector(const SubdivisionSpace& space, int components,
                        const ElementVector& element_vector) {
  VectorX f = VectorX::Zero(static_cast<Eigen::Index>(components) * space.num_dofs());
  in_order<VectorX>(static_cast<int>(space.elements().size()), element_vector,
                    [&](int e, const VectorX& fe) {
                      const auto dofs = space.dofs(e);
                      for (std::size_t a = 0; a < dofs.size(); ++a)
                        f.segment(components * dofs[a], components) +=
                            fe.segment(components * static_cast<Eigen::Index>(a), components);
                    });
  return f;
}

}  // namespace limes
