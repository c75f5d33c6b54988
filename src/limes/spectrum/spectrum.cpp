#include "limes/spectrum/spectrum.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace limes {
namespace {

/// Eigenvalues nearer than this are equal: defective ones come out no better.
constexpr double equal = 1e-6;
/// Rings of the stars: three periods and more. Fewer where the matrix is read off impulses.
int num_rings(const Scheme& scheme) {
  return scheme.needs_positions ? 14 : 27;
}

/// What forbids a limit, or nothing.
std::string obstacle_to_convergence(const std::vector<BlockEigenvalue>& e) {
  if (e.empty() || std::abs(e[0].value - 1.0) > equal || e[0].block != 0)
    return "the largest eigenvalue is not 1";
  if (e.size() > 1 && std::abs(e[1].value) > 1 - equal) return "the eigenvalue 1 is not simple";
  return {};
}

/// What forbids a tangent plane, or nothing.
std::string obstacle_to_pair(const std::vector<BlockEigenvalue>& e, int num_sectors) {
  if (e.size() < 3) return "there is no subdominant pair";
  const auto size = [&](std::size_t i) { return std::abs(e[i].value); };
  if (e.size() > 3 && size(3) > size(1) - equal)
    return fmt::format("the subdominant eigenvalues are more than two: blocks {}, {}, {}",
                       e[1].block, e[2].block, e[3].block);
  const auto [low, high] = std::minmax(e[1].block, e[2].block);
  if (low != 1 || high != num_sectors - 1 || std::abs(e[1].value - e[2].value) > equal)
    return fmt::format("the subdominant eigenvalues are no pair of blocks 1 and {}: blocks {}, {}",
                       num_sectors - 1, e[1].block, e[2].block);
  if (e[1].value.imag() != 0 || e[1].value.real() < 0)
    return "the subdominant eigenvalues are not positive";
  return {};
}

std::string obstacle_to_map(const CharacteristicMap& map) {
  if (!(map.least_jacobian > 0)) return "the characteristic map is not regular";
  if (map.winding_number != 1)
    return fmt::format("the characteristic map winds {} times around", map.winding_number);
  return {};
}

VectorX limit_mask(const LocalSubdivision& local) {
  const VectorX left = block_eigenvectors(local, {0, 1.0}).left.real();
  return left / left.sum();
}

/// Biorthogonal to the coordinates of the map.
Eigen::MatrixX2d tangent_masks(const LocalSubdivision& local, double eigenvalue) {
  const Eigen::VectorXcd left = 2.0 * block_eigenvectors(local, {1, eigenvalue}).left;
  Eigen::MatrixX2d masks(left.size(), 2);
  masks.col(0) = left.real();
  masks.col(1) = -left.imag();
  return masks;
}

}  // namespace

Analysis analyse(const Scheme& scheme, int valence, const RuleOptions& options) {
  Analysis result{
      std::make_unique<const LocalSubdivision>(scheme, valence, options, num_rings(scheme)), {}};
  const LocalSubdivision& local = *result.local;
  Spectrum& s = result.spectrum;
  s.valence = valence;
  s.num_steps = local.num_steps();
  s.eigenvalues = block_eigenvalues(local);
  s.places.assign(local.places().begin(), local.places().begin() + local.num_invariant_places());
  const auto size = [&](std::size_t i) {
    return i < s.eigenvalues.size() ? std::abs(s.eigenvalues[i].value) : 0.0;
  };
  s.subdominant = size(1);
  s.curvature_ratio = size(3) / (size(1) * size(1));

  s.reason = obstacle_to_convergence(s.eigenvalues);
  if (!s.reason.empty()) return result;
  s.limit_mask = limit_mask(local);
  s.reason = obstacle_to_pair(s.eigenvalues, local.num_sectors());
  if (!s.reason.empty()) return result;
  const double pair = s.eigenvalues[1].value.real();
  s.map = characteristic_map(local, scheme, pair);
  s.tangent_masks = tangent_masks(local, pair);
  s.reason = obstacle_to_map(*s.map);
  if (s.reason.empty() && kink_factor(local, scheme) > 0.999)
    s.reason = "the surface has kinks beside the vertex";
  s.c1 = s.reason.empty();
  return result;
}

}  // namespace limes
