#include "stam.h"

#include <cmath>
#include <limits>

#include "limes/core/error.h"

namespace bench {

using namespace limes;

StamTable::StamTable(const Ring& ring, const Scheme& scheme) {
  const RefinedRing same = refine_ring(ring, scheme, 0);
  if (ring.topology.face_size(FaceId(0)) != 4 || ring_key(same.ring) != ring_key(ring))
    throw InputError(
        "the ring of child 0 differs from the ring; refine first, so that one "
        "extraordinary vertex is left, at corner 0");
  eigen_ = eigenbasis(same.A);
  if (!eigen_.defects.empty()) {
    const Eigenbasis::Defect& d = eigen_.defects.front();
    throw InputError("eigenvalue {:.6g} has {} eigenvectors but multiplicity {}: no eigenbasis",
                     d.eigenvalue, d.num_vectors, d.multiplicity);
  }
  for (int k = 1; k < 4; ++k) {
    const RefinedRing child = refine_ring(ring, scheme, k);
    const auto patch = regular_patch(child.ring, scheme.patch);
    if (!patch) throw InputError("child {} is no regular patch", k);
    patches_[static_cast<std::size_t>(k)] = *patch * child.A * eigen_.right;
  }
}

SurfaceJet StamTable::evaluate(const Points& projected, const Vec2& uv) const {
  const double m = uv.maxCoeff();
  if (m == 0) {  // only the eigenvalue 1 is left, whose eigenvector is constant
    const Vec3 x = eigen_.right(0, 0) * projected.row(0);
    const Vec3 none = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
    return {x, none, none, none, none, none};
  }
  // The first level n >= 1 with m > 2^-n; [barendrecht_2013] prints ceil(-log2 m), 0 at m = 1.
  int n = 1;
  while (m <= std::ldexp(1.0, -n))
    ++n;
  const Vec2 scaled = std::ldexp(1.0, n - 1) * uv;
  const int child = quadrant_of(scaled);
  const Mat2 J = std::ldexp(1.0, n) * turn(child);
  const PatchWeights w = bicubic_weights(2 * turned(child, scaled), J);
  Eigen::Matrix<double, 6, Eigen::Dynamic> rows =
      w.transpose() * patches_[static_cast<std::size_t>(child)];
  rows.array().rowwise() *= eigen_.values.array().pow(n - 1).transpose();
  // The constant has no derivatives: exactly, where rounding would grow with 2^n.
  rows.block<5, 1>(1, 0).setZero();
  return jet_of(rows * projected);
}

std::size_t StamTable::memory() const {
  Eigen::Index numbers = eigen_.values.size() + eigen_.left.size();
  for (const MatrixX& patch : patches_)
    numbers += patch.size();
  return static_cast<std::size_t>(numbers) * sizeof(double);
}

}  // namespace bench
