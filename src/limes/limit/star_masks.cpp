#include "limes/limit/star_masks.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "limes/core/error.h"
#include "limes/limit/grid_block.h"
#include "limes/mesh/shapes.h"
#include "limes/subdiv/refinement_step.h"
#include "limes/subdiv/split.h"

namespace limes {

std::vector<VertexId> star_vertices(const Adjacency& mesh, HalfedgeId start) {
  const GridWalk walk(mesh);
  std::vector<VertexId> star{mesh.from(start)};
  for (HalfedgeId h = start;;) {
    const HalfedgeId right = walk.right(h), up = walk.up(h), both = walk.up(right);
    for (const VertexId v : {mesh.to(h), mesh.to(mesh.next(h)), mesh.to(mesh.next(up)),
                             mesh.to(right), mesh.to(mesh.next(right)), mesh.to(mesh.next(both))})
      star.push_back(v);
    h = mesh.ring_next(h);
    LIMES_ASSERT(h.valid());
    if (h == start) return star;
  }
}

namespace {

/// The rows of the vertex and of sector 0, (7, 6 n + 1); those of the other sectors are turned.
MatrixX first_rows(const Scheme& scheme, const RuleOptions& options, int valence) {
  const Mesh disk = shapes::disk(valence, 3);
  const Adjacency mesh(disk.topology);
  Features features;
  static_cast<RuleOptions&>(features) = options;
  const RefinementStep step(mesh, features, scheme);
  const SparseMatrix S = step.matrix();
  const Topology child = step.child_topology();
  const HalfedgeId start = mesh.ring_start(VertexId(0));
  const Adjacency child_mesh(child, Adjacency::Check::edges);
  const auto columns = star_vertices(mesh, start);
  const auto rows = star_vertices(child_mesh, child.halfedge(quadrisection_child(start), 0));
  MatrixX A(1 + star_sector_size, static_cast<Eigen::Index>(columns.size()));
  for (Eigen::Index i = 0; i < A.rows(); ++i)
    for (Eigen::Index j = 0; j < A.cols(); ++j)
      A(i, j) = S.coeff(rows[static_cast<std::size_t>(i)].value,
                        columns[static_cast<std::size_t>(j)].value);
  LIMES_ASSERT((A.rowwise().sum() - VectorX::Ones(A.rows())).cwiseAbs().maxCoeff() < 1e-12);
  return A;
}

}  // namespace

MatrixX star_matrix(const Scheme& scheme, const RuleOptions& options, int valence) {
  constexpr int s = star_sector_size;
  const MatrixX first = first_rows(scheme, options, valence);
  MatrixX A(first.cols(), first.cols());
  A.row(0) = first.row(0);
  for (int m = 0; m < valence; ++m) {
    A.block(1 + s * m, 0, s, 1) = first.block(1, 0, s, 1);
    for (int k = 0; k < valence; ++k)
      A.block(1 + s * m, 1 + s * ((m + k) % valence), s, s) = first.block(1, 1 + s * k, s, s);
  }
  return A;
}

namespace {

using Complex = std::complex<double>;
using Block = Eigen::MatrixXcd;

/// The matrix on vectors that turn by 2 pi k / n from sector to sector, without the middle vertex;
/// for k = 0 with it, as the first. A: the rows of the middle vertex and of sector 0.
Block fourier_block(const MatrixX& A, int n, int k) {
  constexpr int s = star_sector_size;
  const int middle = k == 0 ? 1 : 0;
  Block B = Block::Zero(s + middle, s + middle);
  for (int m = 0; m < n; ++m)
    B.bottomRightCorner(s, s) +=
        std::polar(1.0, 2.0 * std::numbers::pi * k * m / n) * A.block(1, 1 + s * m, s, s);
  if (middle == 0) return B;
  B(0, 0) = A(0, 0);
  B.topRightCorner(1, s).setZero();
  for (int m = 0; m < n; ++m)
    B.topRightCorner(1, s) += A.block(0, 1 + s * m, 1, s);
  B.bottomLeftCorner(s, 1) = A.block(1, 0, s, 1);
  return B;
}

/// The largest modulus among the eigenvalues of the blocks other than 1 and n - 1, the eigenvalue 1
/// left out.
double largest_of_other_blocks(const MatrixX& A, int n) {
  double largest = 0;
  for (int k = 0; k <= n / 2; ++k) {
    if (k == 1) continue;
    const Eigen::ComplexEigenSolver<Block> solver(fourier_block(A, n, k), false);
    for (const Complex& value : solver.eigenvalues())
      if (k > 0 || std::abs(value - 1.0) > 1e-9) largest = std::max(largest, std::abs(value));
  }
  return largest;
}

}  // namespace

std::optional<Eigen::Matrix<double, 2, Eigen::Dynamic>> star_tangents(const Scheme& scheme,
                                                                      const RuleOptions& options,
                                                                      int valence) {
  const int n = valence;
  if (n < 3) return {};
  const MatrixX A = first_rows(scheme, options, n);
  const Eigen::ComplexEigenSolver<Block> solver(fourier_block(A, n, 1).transpose());
  Eigen::Index at = 0;
  solver.eigenvalues().cwiseAbs().maxCoeff(&at);
  const Complex value = solver.eigenvalues()(at);
  double others = largest_of_other_blocks(A, n);
  for (Eigen::Index i = 0; i < solver.eigenvalues().size(); ++i)
    if (i != at) others = std::max(others, std::abs(solver.eigenvalues()(i)));
  if (std::abs(value.imag()) > 1e-9 || value.real() <= others * (1.0 + 1e-9)) return {};

  // Turned so that sector 0 begins with a positive weight: t0 points along edge 0.
  Eigen::VectorXcd v = solver.eigenvectors().col(at);
  v *= std::conj(v(0)) / std::norm(v(0));
  Eigen::Matrix<double, 2, Eigen::Dynamic> rows(2, A.cols());
  rows.col(0).setZero();
  for (int m = 0; m < n; ++m)
    for (int i = 0; i < star_sector_size; ++i) {
      const Complex w = std::conj(v(i)) * std::polar(1.0, 2.0 * std::numbers::pi * m / n);
      rows.col(1 + star_sector_size * m + i) << w.real(), w.imag();
    }
  return rows;
}

}  // namespace limes
