#include "limes/spectrum/eigen.h"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "limes/core/error.h"

namespace limes {
namespace {

std::complex<double> turned(int block, int sector, int num_sectors) {
  return std::polar(1.0, 2 * std::numbers::pi * ((block * sector) % num_sectors) / num_sectors);
}

/// The first places of the orbits that a block sees: those with a vertex in every sector, in block 0 also
/// a middle vertex.
std::vector<int> orbits_of(const LocalSubdivision& local, int block) {
  std::vector<int> orbits;
  for (int p = 0; p < local.num_invariant_places();) {
    const bool middle = p == 0 && !local.star().around_face;
    if (!middle || block == 0) orbits.push_back(p);
    p += middle ? 1 : local.num_sectors();
  }
  return orbits;
}

/// The matrix on its range, and so on until it is regular: what is left out has eigenvalues 0 only, which
/// would come out as roots of the rounding error.
Eigen::MatrixXcd without_kernel(Eigen::MatrixXcd block) {
  while (block.rows() > 0) {
    Eigen::ColPivHouseholderQR<Eigen::MatrixXcd> qr(block);
    qr.setThreshold(1e-11);
    if (qr.rank() == block.rows()) break;
    const Eigen::MatrixXcd range =
        qr.householderQ() * Eigen::MatrixXcd::Identity(block.rows(), qr.rank());
    block = (range.adjoint() * block * range).eval();
  }
  return block;
}

/// A real number where rounding and defects alone can have made it complex.
std::complex<double> cleaned(std::complex<double> value) {
  return std::abs(value.imag()) < 1e-6 ? value.real() : value;
}

}  // namespace

Eigen::MatrixXcd fourier_block(const LocalSubdivision& local, int block) {
  const std::vector<int> orbits = orbits_of(local, block);
  std::vector<int> column(static_cast<std::size_t>(local.num_invariant_places()), -1);
  for (std::size_t o = 0; o < orbits.size(); ++o) {
    const bool middle = orbits[o] == 0 && !local.star().around_face;
    for (int s = 0; s < (middle ? 1 : local.num_sectors()); ++s)
      column[static_cast<std::size_t>(orbits[o] + s)] = static_cast<int>(o);
  }
  const auto size = static_cast<Eigen::Index>(orbits.size());
  Eigen::MatrixXcd result = Eigen::MatrixXcd::Zero(size, size);
  for (Eigen::Index o = 0; o < size; ++o)
    for (SparseMatrix::InnerIterator entry(local.matrix(), orbits[static_cast<std::size_t>(o)]);
         entry; ++entry) {
      const auto place = static_cast<std::size_t>(entry.col());
      if (column[place] >= 0)
        result(o, column[place]) +=
            entry.value() * turned(block, local.places()[place].sector, local.num_sectors());
    }
  return result;
}

std::vector<BlockEigenvalue> block_eigenvalues(const LocalSubdivision& local) {
  const int n = local.num_sectors();
  std::vector<BlockEigenvalue> all;
  for (int k = 0; 2 * k <= n; ++k) {
    const Eigen::MatrixXcd block = without_kernel(fourier_block(local, k));
    if (block.rows() == 0) continue;
    const Eigen::VectorXcd values =
        Eigen::ComplexEigenSolver<Eigen::MatrixXcd>(block, false).eigenvalues();
    for (const std::complex<double>& value : values) {
      all.push_back({k, cleaned(value)});
      if (k > 0 && 2 * k < n) all.push_back({n - k, std::conj(cleaned(value))});
    }
  }
  const auto order = [](const BlockEigenvalue& e) {
    const double size = std::abs(e.value);
    return std::tuple(-std::llround(1e7 * size), e.block, -e.value.real(), -e.value.imag());
  };
  std::sort(all.begin(), all.end(), [&](const BlockEigenvalue& a, const BlockEigenvalue& b) {
    return order(a) < order(b);
  });
  return all;
}

Eigenvectors block_eigenvectors(const LocalSubdivision& local, const BlockEigenvalue& eigenvalue) {
  const int n = local.num_sectors();
  const std::vector<int> orbits = orbits_of(local, eigenvalue.block);
  Eigen::MatrixXcd shifted = fourier_block(local, eigenvalue.block);
  shifted.diagonal().array() -= eigenvalue.value;
  const Eigen::JacobiSVD<Eigen::MatrixXcd> svd(shifted, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::VectorXcd right = svd.matrixV().rightCols(1);
  const Eigen::VectorXcd left = svd.matrixU().rightCols(1).conjugate();

  Eigenvectors result{Eigen::VectorXcd::Zero(local.num_invariant_places()),
                      Eigen::VectorXcd::Zero(local.num_invariant_places())};
  for (std::size_t o = 0; o < orbits.size(); ++o) {
    const auto i = static_cast<Eigen::Index>(o);
    const bool middle = orbits[o] == 0 && !local.star().around_face;
    const int size = middle ? 1 : n;
    for (int s = 0; s < size; ++s) {
      const std::complex<double> turn = turned(eigenvalue.block, s, n);
      result.right[orbits[o] + s] = right[i] * turn;
      result.left[orbits[o] + s] = left[i] * std::conj(turn) / static_cast<double>(size);
    }
  }
  result.right /= result.right[local.first_place(local.star().around_face ? 0 : 1)];
  result.left /= (result.left.transpose() * result.right).value();
  return result;
}

}  // namespace limes
