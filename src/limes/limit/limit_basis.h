#pragma once

#include <array>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "limes/limit/basis.h"
#include "limes/limit/ring_kind.h"

namespace limes {

/// Parameters of the corners of a parameter square, in the order of a quad's corners.
inline const std::array<Vec2, 4> square_corners{Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)};
/// The same for a triangle.
inline const std::array<Vec2, 3> triangle_corners{Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)};

/// The limit functions of a mesh: which control vertices each face depends on, and with which
/// weights at (face, corner, u, v). No positions: the same basis carries geometry, displacements
/// and anything else.
///
/// Parameters: on a quad corner is 0, (0, 0) its first corner, u runs towards the second and v
/// towards the fourth. Any other face has one quadrant per corner: (0, 0) at that corner, u towards
/// the next corner, v towards the previous one, (1, 1) at the face's middle. Under a scheme of
/// triangles corner is 0, and u and v are the barycentric weights of the second and third corner.
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
  /// @param check  `edges` for functions without reach on quads in whose sides vertices hang
  /// @throws InputError if the scheme has no exact limit or does not fit the mesh
  LimitBasis(Topology topology, Features features, const Scheme& scheme,
             Adjacency::Check check = Adjacency::Check::surface);
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

  [[nodiscard]] const Scheme& scheme() const { return kinds_.scheme(); }
  /// Whether parameter domains are triangles, not squares.
  [[nodiscard]] bool on_triangles() const { return scheme().split == Split::triangles; }

  /// Number of parameter domains of a face: 1 for a quad, or a triangle under a scheme of triangles;
  /// one per corner otherwise.
  [[nodiscard]] int num_quadrants(FaceId f) const {
    const int n = topology_.face_size(f);
    return n == regular_face_size(scheme()) ? 1 : n;
  }

  /// The parameters of corner c of a face.
  struct FaceCorner {
    int quadrant;
    Vec2 uv;
  };
  [[nodiscard]] FaceCorner corner(FaceId f, int c) const;

  /// Basis functions of a face at a point, in the order of controls(f).
  /// @param corner  quadrant, 0 <= corner < num_quadrants(f)
  /// @param uv      in [0, 1]^2, or u, v >= 0 and u + v <= 1 under a scheme of triangles
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

/// For what works on parameter squares only.
/// @param what  begins the message: "closest points", say
/// @throws InputError if the parameter domains are triangles
void require_squares(const Scheme& scheme, std::string_view what);

}  // namespace limes
