#pragma once

#include "limes/core/types.h"

namespace limes {

/// Basis functions at one point of one face, k functions.
/// N is (k); dN is (k, 2): d/du, d/dv; ddN is (k, 3): d2/du2, d2/dudv, d2/dv2.
/// What was not asked for or does not exist has no rows.
struct BasisAt {
  VectorX N;
  Eigen::Matrix<double, Eigen::Dynamic, 2> dN;
  Eigen::Matrix<double, Eigen::Dynamic, 3> ddN;
};

}  // namespace limes
