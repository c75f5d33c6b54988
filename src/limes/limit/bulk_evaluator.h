#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "limes/limit/limit_basis.h"

namespace limes {

/// A point of a limit surface by its parameters, as LimitBasis counts them.
struct SurfaceLocation {
  FaceId face;
  int corner = 0;  ///< quadrant, 0 <= corner < LimitBasis::num_quadrants(face)
  Vec2 uv = Vec2::Zero();
};

/// Position and derivatives at one point with respect to u and v; see LimitBasis.
struct SurfaceJet {
  Vec3 x, xu, xv, xuu, xuv, xvv;
};

/// Positions and derivatives at many points: entry i of every array belongs to location i.
struct SurfaceValues {
  std::vector<Vec3> x;
  std::vector<Vec3> xu, xv;         ///< empty below order 1
  std::vector<Vec3> xuu, xuv, xvv;  ///< empty below order 2
  /// The locations that are extraordinary vertices, ascending: derivatives do not exist there, and
  /// their entries are NaN.
  std::vector<std::int64_t> extraordinary;
};

/// A limit surface at many points: the same values as LimitSurface, to rounding, much faster.
/// Results have the same bits for any number of threads and in any order of points.
class BulkEvaluator {
 public:
  /// Keeps a reference to the basis and a copy of the points.
  /// @param points  one per vertex of the basis
  BulkEvaluator(const LimitBasis& basis, std::span<const Vec3> points);

  [[nodiscard]] const LimitBasis& basis() const { return *basis_; }

  /// Values at many locations, in any order; several threads if there are many. `out` is resized
  /// and can be used again.
  /// @param order  highest derivative wanted, 0 to 2
  void evaluate(std::span<const SurfaceLocation> where, int order, SurfaceValues& out) const;

  /// One point. Entries of `out` beyond `order` are not written; derivatives that do not exist
  /// (extraordinary point) are NaN. May be called from several threads.
  LimitBasis::Point evaluate(const SurfaceLocation& where, int order, SurfaceJet& out) const;

  /// Moves the control points. Not while another thread evaluates.
  void update(std::span<const Vec3> points);

 private:
  const LimitBasis* basis_;
  std::vector<Vec3> points_;
};

}  // namespace limes
