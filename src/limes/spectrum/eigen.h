#pragma once

#include <complex>
#include <vector>

#include "limes/spectrum/local_subdivision.h"

namespace limes {

/// Eigenvalue of one Fourier block of a subdivision matrix: its eigenvectors turn by block / n of a
/// full turn from sector to sector.
struct BlockEigenvalue {
  int block;
  std::complex<double> value;
};

/// A block: values of the first sector, from those of all sectors that turn with it. Complex, square; a
/// middle vertex counts in block 0 only.
[[nodiscard]] Eigen::MatrixXcd fourier_block(const LocalSubdivision& local, int block);

/// All eigenvalues of the invariant rings but those that are 0, largest absolute value first. Absolute
/// values that agree to seven digits are taken as equal: multiple eigenvalues may be defective.
[[nodiscard]] std::vector<BlockEigenvalue> block_eigenvalues(const LocalSubdivision& local);

/// Right and left eigenvector of all invariant places to a simple eigenvalue of a block. The right one
/// is scaled to 1 at the first place of ring 1 (of ring 0 around a face); then left^T right = 1.
struct Eigenvectors {
  Eigen::VectorXcd right, left;
};
[[nodiscard]] Eigenvectors block_eigenvectors(const LocalSubdivision& local,
                                              const BlockEigenvalue& eigenvalue);

}  // namespace limes
