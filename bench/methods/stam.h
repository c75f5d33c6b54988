#pragma once

#include <array>

#include "eigenbasis.h"
#include "refined_ring.h"

namespace bench {

/// Evaluation with eigenvectors [stam_1998]: what the library does with powers of the refinement
/// matrix A, written as V Lambda^n V^-1. For a face with one extraordinary vertex, at corner 0.
///
/// A table belongs to a valence. Control points are taken into the eigenbasis once per face.
class StamTable {
 public:
  /// @param ring  of a face whose child 0 is of the same kind and whose other children are regular
  /// @throws limes::InputError if it is not, or if A has no eigenbasis, with the Jordan block
  StamTable(const limes::Ring& ring, const limes::Scheme& scheme);

  [[nodiscard]] const Eigenbasis& eigen() const { return eigen_; }

  /// Control points in the eigenbasis, V^-1 P: what evaluate() takes.
  [[nodiscard]] Points project(const Points& controls) const { return eigen_.left * controls; }

  /// Position and derivatives. At (0, 0) derivatives are NaN.
  /// @param uv  in [0, 1]^2; (0, 0) at the extraordinary vertex
  [[nodiscard]] limes::SurfaceJet evaluate(const Points& projected, const limes::Vec2& uv) const;

  [[nodiscard]] std::size_t memory() const;  ///< bytes

 private:
  Eigenbasis eigen_;
  /// B_k V: the patch of child k = 1, 2, 3 of the eigenvectors, (16, num_controls); [stam_1998] (17).
  std::array<limes::MatrixX, 4> patches_;
};

}  // namespace bench
