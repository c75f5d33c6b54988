#include "forest_size.h"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "limes/core/error.h"
#include "size_plan.h"

namespace limes::app {
namespace {

// Bytes at the peak per leaf, at most what `limes adapt --where all --json` reports: 280 for linear and
// 411 for catmull-clark (0.8 to 1.6 million quads), 232 for linear and 290 for loop (0.5 and 2.1 million
// triangles), 214 with --bisect (3.1 million).
double bytes_of_leaf(const Topology& control, const Scheme& scheme, bool bisect) {
  if (bisect) return 214;
  const bool triangles = control.num_faces() > 0 && control.face_size(FaceId(0)) == 3;
  const bool limits = has_exact_limit(scheme) && scheme.patch != LimitPatch::bilinear;
  return triangles ? (limits ? 290 : 232) : (limits ? 411 : 280);
}

/// Faces which, doubled by every round, give the leaves: bisection cuts what is no triangle at each corner
/// first.
double doubled_faces(const Topology& control) {
  double count = 0;
  for (int f = 0; f < control.num_faces(); ++f)
    count += control.face_size(FaceId(f)) == 3 ? 1 : 0.5 * control.face_size(FaceId(f));
  return count;
}

}  // namespace

ForestSize::ForestSize(const Topology& control, const Scheme& scheme, bool bisect,
                       std::int64_t memory_limit)
    : bisect_(bisect),
      bytes_per_leaf_(bytes_of_leaf(control, scheme, bisect)),
      first_leaves_(bisect ? doubled_faces(control) : control.num_faces()),
      memory_limit_(memory_limit) {}

void ForestSize::require(int round, std::int64_t leaves) const {
  // Faces that were split keep their numbers: a third of the leaves, or as many when halved.
  const std::int64_t faces = bisect_ ? 2 * leaves : leaves + leaves / 3;
  const std::string reason =
      obstacle(4 * faces, faces, bytes_per_leaf_ * static_cast<double>(leaves), memory_limit_);
  if (reason.empty()) return;
  throw InputError("round {} would have {} faces or more: {}; --levels {} is possible", round,
                   leaves, reason, round - 1);
}

void ForestSize::require_round(int round, std::int64_t leaves, std::int64_t marked) const {
  require(round, leaves + (bisect_ ? 1 : 3) * marked);
}

void ForestSize::require_all(int rounds) const {
  const double factor = bisect_ ? 2 : 4;
  for (int round = 1; round <= rounds; ++round)
    require(round, static_cast<std::int64_t>(first_leaves_ * std::pow(factor, round)));
}

}  // namespace limes::app
