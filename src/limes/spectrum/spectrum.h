#pragma once

#include <memory>
#include <optional>
#include <string>

#include "limes/spectrum/characteristic_map.h"

namespace limes {

/// What the eigenvalues of a scheme say about its surfaces around a vertex or face.
struct Spectrum {
  int valence = 0;    ///< edges at the vertex; corners of the face for dual schemes
  int num_steps = 1;  ///< the eigenvalues are those of so many steps
  std::vector<BlockEigenvalue> eigenvalues;  ///< without zeros, largest absolute value first
  double subdominant = 0;                    ///< absolute value of the second
  double curvature_ratio =
      0;  ///< absolute value of the fourth over the square of the second; curvature
          ///< is bounded up to 1, and goes to 0 below

  /// The conditions of [reif_1995], checked numerically, and what is wrong if they do not hold.
  bool c1 = false;
  std::string reason;

  std::vector<StarPlace> places;  ///< of the masks
  /// Weights of the limit point; if the scheme converges.
  std::optional<VectorX> limit_mask;
  /// Weights of the derivatives along the coordinates of the characteristic map, (places, 2); with a map.
  std::optional<Eigen::MatrixX2d> tangent_masks;
  /// If the subdominant eigenvalues are a pair of the blocks 1 and n - 1.
  std::optional<CharacteristicMap> map;
};

/// Everything about one valence, with the star that it was found on.
struct Analysis {
  std::unique_ptr<const LocalSubdivision> local;
  Spectrum spectrum;
};
/// @param options  tension and weights, of schemes that have them
/// @throws UsageError for a valence that the scheme does not have
[[nodiscard]] Analysis analyse(const Scheme& scheme, int valence, const RuleOptions& options = {});

}  // namespace limes
