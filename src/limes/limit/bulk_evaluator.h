#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "limes/limit/limit_basis.h"
#include "limes/limit/tile_tree.h"

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
///
/// A face is cut into tiles where its limit is one bicubic polynomial (see TileTree), whose
/// coefficients are found when a point first falls on the face: 512 bytes a tile, one tile for a
/// regular face, about 24 for one with an extraordinary vertex.
class BulkEvaluator {
 public:
  /// Keeps a reference to the basis and a copy of the points.
  /// @param points  one per vertex of the basis
  /// @throws InputError for a scheme of triangles
  BulkEvaluator(const LimitBasis& basis, std::span<const Vec3> points);
  BulkEvaluator(const BulkEvaluator&) = delete;
  BulkEvaluator& operator=(const BulkEvaluator&) = delete;
  ~BulkEvaluator();

  [[nodiscard]] const LimitBasis& basis() const { return *basis_; }

  /// Values at many locations, in any order; several threads if there are many. `out` is resized
  /// and can be used again. May be called from several threads.
  /// @param order  highest derivative wanted, 0 to 2
  void evaluate(std::span<const SurfaceLocation> where, int order, SurfaceValues& out) const;

  /// One point. Entries of `out` beyond `order` are not written; derivatives that do not exist
  /// (extraordinary point) are NaN. May be called from several threads.
  LimitBasis::Point evaluate(const SurfaceLocation& where, int order, SurfaceJet& out) const;

  /// Moves the control points; tiles that exist are recomputed in place. Not while another thread
  /// evaluates.
  void update(std::span<const Vec3> points);

 private:
  class Block;
  /// What a face stores, from when it is first needed.
  struct Face {
    std::atomic<const TileTree*> tree = nullptr;  ///< null: the face is one tile
    std::atomic<double*> numbers = nullptr;
  };
  [[nodiscard]] const TileTree& tree_of(FaceId f) const;
  const double* make_face(FaceId f) const;

  const LimitBasis* basis_;
  std::vector<Vec3> points_;
  mutable std::vector<Face> faces_;
  mutable std::mutex mutex_;                                        // of trees_
  mutable std::vector<std::atomic<const TileTree*>> tree_of_kind_;  // of the faces' kinds
  mutable std::vector<std::unique_ptr<const TileTree>> trees_;
};

}  // namespace limes
