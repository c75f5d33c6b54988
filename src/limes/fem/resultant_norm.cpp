#include "limes/fem/resultant_norm.h"

namespace limes {

ShellResultants turned(const ShellResultants& r, const Vec3& normal) {
  const Mat3 R = Eigen::Quaterniond::FromTwoVectors(r.normal, normal).toRotationMatrix();
  return {R * r.membrane * R.transpose(), R * r.bending * R.transpose(), R * r.shear, normal};
}

double energy_between(const ShellResultants& a, const ShellResultants& b,
                      const ShellSection& section) {
  const double nu = section.poisson, t = section.thickness;
  const auto square = [&](const Mat3& d) {
    return (1 + nu) * d.squaredNorm() - nu * d.trace() * d.trace();
  };
  const double stretching = section.young * t;
  const double shearing = section.shear_factor * section.young / (2 * (1 + nu)) * t;
  return (square(a.membrane - b.membrane) + 12 / (t * t) * square(a.bending - b.bending)) /
             stretching +
         (a.shear - b.shear).squaredNorm() / shearing;
}

}  // namespace limes
