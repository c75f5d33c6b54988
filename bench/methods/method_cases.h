#pragma once

#include <functional>
#include <string>
#include <vector>

#include "limes/limit/bulk_evaluator.h"
#include "limit/local_refinement.h"

namespace bench {

/// A face to evaluate, with one feature at its corner 0 or along its side v = 0.
struct FaceCase {
  std::string name;
  limes::test::Model model;
  limes::FaceId face;
  enum class Kind { inner, boundary, corner } kind = Kind::inner;
};
[[nodiscard]] std::vector<FaceCase> face_cases();

/// Numerators and denominator of a point, for the method that needs them, and the point.
struct Place {
  std::int64_t u, v, denominator;
  limes::Vec2 uv;
};
/// n places, half of them anywhere and half close to the feature, down to 2^-20 of the face.
[[nodiscard]] std::vector<Place> sample_places(const FaceCase& c, int n);

/// A method made ready for one face. Derivatives that it does not have are NaN.
using Evaluate = std::function<limes::SurfaceJet(const Place&)>;
struct Method {
  std::string name;
  std::string applies_to;
  bool at_boundary_only;  ///< for regular faces at a boundary: Kind::boundary, Kind::corner
  /// Builds the tables. @throws limes::InputError where the method does not apply, with the reason
  std::function<Evaluate(const FaceCase&)> prepare;
};
[[nodiscard]] std::vector<Method> all_methods();

}  // namespace bench
