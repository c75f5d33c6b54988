#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "limes/limit/basis.h"
#include "limes/limit/ring_kind.h"

namespace limes {

/// Parameters of the corners of a parameter square, in the order of a quad's corners.
inline const std::array<Vec2, 4> square_corners{Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)};

/// The limit functions of a mesh: which control vertices each face depends on, and with which
/// weights at (face, corner, u, v). No positions: the same basis carries geometry, displacements
/// and anything else.
///
/// Parameters: on a quad corner is 0, (0, 0) its first corner, u runs towards the second and v
/// towards the fourth. Any other face has one quadrant per corner: (0, 0) at that corner, u towards
/// the next corner, v towards the previous one, (1, 1) at the face's middle.
class LimitBasis {
 public:
  /// How much exists at a point.
  enum class Point {
    ordinary,      ///< value and both derivatives
    extraordinary  ///< value; the derivatives in u and v do not exist
  };

  /// Beyond this many halvings a point is the extraordinary vertex itself: 2^-200 of a face.
  static constexpr int max_depth = 200;

  /// Keeps a copy of the topology and features.
  /// @throws InputError if the scheme has no exact limit or does not fit the mesh
  LimitBasis(Topology topology, Features features, const Scheme& scheme);
  LimitBasis(const LimitBasis&) = delete;
  LimitBasis& operator=(const LimitBasis&) = delete;
  ~LimitBasis();

  [[nodiscard]] const Topology& topology() const { return topology_; }
  [[nodiscard]] const Adjacency& adjacency() const { return adjacency_; }
  [[nodiscard]] const Features& features() const { return features_; }
  [[nodiscard]] const RingKinds& kinds() const { return kinds_; }
  [[nodiscard]] int kind(FaceId f) const { return kind_[f]; }

  /// Control vertices of a face, in the order of its basis functions.
  [[nodiscard]] std::span<const VertexId> controls(FaceId f) const;

  /// Number of parameter squares of a face: 1 for a quad, one per corner otherwise.
  [[nodiscard]] int num_quadrants(FaceId f) const {
    return topology_.face_size(f) == 4 ? 1 : topology_.face_size(f);
  }

  /// Basis functions of a face at a point, in the order of controls(f).
  /// @param corner  quadrant, 0 <= corner < num_quadrants(f)
  /// @param uv      in [0, 1]^2
  /// @param order   0: N; 1: also dN; 2: also ddN, with respect to exactly this u and v
  Point evaluate(FaceId f, int corner, const Vec2& uv, int order, BasisAt& out) const {
    return evaluate_kind(kind_[f], topology_.face_size(f), corner, uv, order, out);
  }
  /// The same by kind: what tables over kinds use.
  Point evaluate_kind(int kind, int face_size, int corner, const Vec2& uv, int order,
                      BasisAt& out) const;

  /// Rows that give two tangents at an extraordinary point, (2, k); none where no tangent plane
  /// exists. Precondition: evaluate() at this point is extraordinary.
  [[nodiscard]] std::optional<Eigen::Matrix<double, 2, Eigen::Dynamic>> tangent_rows(
      FaceId f, int corner, const Vec2& uv) const;

 private:
  void gather_kinds();

  Topology topology_;
  Adjacency adjacency_;
  Features features_;
  RingKinds kinds_;
  IdArray<FaceId, int> kind_;
  std::vector<std::int64_t> first_control_;
  std::vector<VertexId> controls_;
};

}  // namespace limes
