#include "eigenbasis.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <complex>

#include "limes/core/error.h"

namespace bench {

using namespace limes;

namespace {

constexpr double same_eigenvalue = 1e-4;
constexpr double zero_singular_value = 1e-11;

std::vector<double> real_eigenvalues(const MatrixX& A) {
  const Eigen::VectorXcd all = A.eigenvalues();
  std::vector<double> values;
  for (const std::complex<double>& z : all) {
    if (std::abs(z.imag()) > same_eigenvalue)
      throw InputError("eigenvalue {} + {}i is not real; no real eigenbasis", z.real(), z.imag());
    values.push_back(z.real());
  }
  std::sort(values.rbegin(), values.rend());
  return values;
}

/// Columns that span the kernel of A - lambda 1.
MatrixX kernel(const MatrixX& A, double lambda) {
  const MatrixX shifted = A - lambda * MatrixX::Identity(A.rows(), A.cols());
  const Eigen::JacobiSVD<MatrixX> svd(shifted, Eigen::ComputeFullV);
  const auto zeros =
      (svd.singularValues().array() < zero_singular_value * svd.singularValues()(0)).count();
  return svd.matrixV().rightCols(zeros);
}

}  // namespace

Eigenbasis eigenbasis(const MatrixX& A) {
  const std::vector<double> all = real_eigenvalues(A);
  Eigenbasis out;
  out.values.resize(A.rows());
  out.right.resize(A.rows(), 0);
  for (std::size_t begin = 0, end = 0; begin < all.size(); begin = end) {
    double sum = 0;
    for (end = begin; end < all.size() && all[begin] - all[end] < same_eigenvalue; ++end)
      sum += all[end];
    const auto multiplicity = static_cast<int>(end - begin);
    const double lambda = sum / multiplicity;
    const MatrixX vectors = kernel(A, lambda);
    if (vectors.cols() < multiplicity)
      out.defects.push_back({lambda, multiplicity, static_cast<int>(vectors.cols())});
    out.values.segment(static_cast<Eigen::Index>(begin), multiplicity).setConstant(lambda);
    const Eigen::Index known = out.right.cols();
    out.right.conservativeResize(Eigen::NoChange, known + vectors.cols());
    out.right.rightCols(vectors.cols()) = vectors;
  }
  if (out.defects.empty()) {
    LIMES_ASSERT(out.right.cols() == A.cols());
    out.left = out.right.inverse();
  }
  return out;
}

}  // namespace bench
