#include "limes/adapt/residual.h"

#include <array>
#include <cmath>
#include <optional>

#include "limes/core/parallel.h"
#include "limes/fem/element_points.h"
#include "limes/math/quadrature.h"
#include "limes/space/element_of_face.h"

namespace limes {
namespace {

constexpr int side_points = 2;
constexpr int first_half = 4 * side_points;  ///< in the table of points_on_sides()

/// The gradient (strain) of a field that changes along n only is this times the change, (c, d).
MatrixX gradient_along(const Vec2& n, Eigen::Index c) {
  if (c == 2) return n;
  MatrixX out(3, 2);
  out << n.x(), 0, 0, n.y(), n.y(), n.x();
  return out;
}

/// Stiffness against such a change, (d, d).
MatrixX stiffness_along(const Vec2& n, const MatrixX& D) {
  const MatrixX B = gradient_along(n, D.rows());
  return B.transpose() * D * B;
}

double weighted_square(const VectorX& r, const MatrixX& A) {
  return r.dot(A.llt().solve(r));
}

/// Adds points of a rule on the sides of the parameter square, side by side, along each as its face turns.
/// @param pieces  into which each side is cut, each with points of its own
void add_points_on_sides(const QuadratureRule& rule, int pieces, std::vector<Vec2>& out) {
  constexpr std::array<std::array<double, 2>, 4> corner{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  for (std::size_t k = 0; k < 4; ++k)
    for (int piece = 0; piece < pieces; ++piece)
      for (const double point : rule.point) {
        const auto &a = corner[k], &b = corner[(k + 1) % 4];
        const double s = (piece + point) / pieces;
        out.emplace_back((1 - s) * a[0] + s * b[0], (1 - s) * a[1] + s * b[1]);
      }
}

/// Whole sides, and after them halves.
std::vector<Vec2> points_on_sides(const QuadratureRule& rule) {
  std::vector<Vec2> out;
  add_points_on_sides(rule, 1, out);
  add_points_on_sides(rule, 2, out);
  return out;
}

/// A side of an element, or half of one in which a vertex hangs: what it has in common with one neighbour.
struct Piece {
  int side;
  Eigen::Index first;  ///< of its points in the table of points_on_sides()
  /// Of the side's length.
  [[nodiscard]] double share() const { return first < first_half ? 1 : 0.5; }
};

/// What a face brings to its sides, piece by piece.
struct FaceSides {
  std::vector<Piece> pieces;
  std::vector<Vec2> normal;   ///< outward, of length 1
  std::vector<Vec3> x;        ///< points
  std::vector<VectorX> flux;  ///< through the sides, there
  std::vector<MatrixX> A;     ///< stiffness along the normals
  double area = 0;
  std::vector<VectorX> load;   ///< per area, at the points of the element's table
  std::vector<VectorX> given;  ///< what the flux on the border should be, there; elsewhere unused
};

class ResidualEstimate {
 public:
  ResidualEstimate(const SubdivisionSpace& space, const EnergyDensity& energy,
                   const LoadDensity& load, const HangingFaces* hanging)
      : space_(space),
        energy_(energy),
        load_(load),
        hanging_(hanging),
        rule_(gauss_rule(side_points)),
        element_of_face_(element_of_face(space)),
        sides_(space.elements().size()) {
    if (hanging) closed_.emplace(hanging->topology);
    for (int s = 0; s < space.num_shapes(); ++s) {
      on_sides_.push_back(space.sample(s, points_on_sides(rule_)));
      inside_.push_back(space.sample(
          s, {Vec2(0.25, 0.25), Vec2(0.75, 0.25), Vec2(0.75, 0.75), Vec2(0.25, 0.75)}));
    }
  }

  std::vector<double> squares() {
    const auto n = static_cast<std::int64_t>(space_.elements().size());
    for_each_index(n, [&](std::int64_t i) { measure(static_cast<int>(i)); });
    for (int e = 0; e < static_cast<int>(n); ++e)
      evaluate_loads(e);
    std::vector<double> out(element_of_face_.size(), 0.0);
    for_each_index(n, [&](std::int64_t i) {
      const int e = static_cast<int>(i);
      double sum = inner_square(e);
      for (int k = 0; k < static_cast<int>(sides(e).pieces.size()); ++k)
        sum += side_square(e, k);
      out[static_cast<std::size_t>(element(e).face.value)] = sum;
    });
    return out;
  }

 private:
  [[nodiscard]] const Element& element(int e) const {
    return space_.elements()[static_cast<std::size_t>(e)];
  }
  [[nodiscard]] const FaceSides& sides(int e) const { return sides_[static_cast<std::size_t>(e)]; }
  [[nodiscard]] const Adjacency& neighbours() const {
    return closed_ ? *closed_ : space_.geometry().adjacency();
  }

  /// In the order of the halfedges of neighbours().
  [[nodiscard]] std::vector<Piece> pieces_of(FaceId face) const {
    std::vector<Piece> out;
    for (int k = 0; k < 4; ++k)
      if (!hanging_ || !hanging_->inside(face, k).valid())
        out.push_back({k, side_points * k});
      else
        for (const int half : {0, 1})
          out.push_back({k, first_half + side_points * (2 * k + half)});
    return out;
  }

  void measure(int e) {
    FaceSides& out = sides_[static_cast<std::size_t>(e)];
    const auto shape = static_cast<std::size_t>(element(e).shape);
    const auto P = space_.control_points(e);
    const ElementTable& inside = space_.table(element(e).shape);
    ElementPoints points;
    to_physical(inside, P, points);
    out.area = points.J.cwiseAbs().dot(inside.weight);
    const double turn = points.J(0) > 0 ? 1 : -1;
    const MatrixX D = energy_.stiffness(e);
    const ElementTable& table = on_sides_[shape];
    const MatrixX flux = energy_.gradient(e, table) * D;
    to_physical(table, P, points);
    const auto corners = space_.mesh().topology.face(element(e).face);
    out.pieces = pieces_of(element(e).face);
    for (const Piece& piece : out.pieces) {
      const auto at = static_cast<std::size_t>(piece.side);
      const Vec2 t =
          (space_.mesh().points[corners[(at + 1) % 4]] - space_.mesh().points[corners[at]])
              .head<2>();
      out.normal.emplace_back(turn / t.norm() * Vec2(t.y(), -t.x()));
      out.A.push_back(stiffness_along(out.normal.back(), D));
      const MatrixX B = gradient_along(out.normal.back(), D.rows());
      for (Eigen::Index i = piece.first; i < piece.first + side_points; ++i) {
        out.x.emplace_back(points.x.row(i).transpose());
        out.flux.emplace_back(B.transpose() * flux.row(i).transpose());
      }
    }
  }

  /// Of elements one after the other, as LoadDensity asks.
  void evaluate_loads(int e) {
    FaceSides& out = sides_[static_cast<std::size_t>(e)];
    ElementPoints points;
    to_physical(space_.table(element(e).shape), space_.control_points(e), points);
    for (Eigen::Index i = 0; i < points.J.size(); ++i)
      out.load.push_back(load_.on_element(e, points.x.row(i).transpose()));
    out.given.resize(out.flux.size());
    for (int k = 0; k < static_cast<int>(out.pieces.size()); ++k) {
      if (neighbour(halfedge(e, k)) >= 0) continue;
      const HalfedgeId h = space_.mesh().topology.halfedge(
          element(e).face, out.pieces[static_cast<std::size_t>(k)].side);
      for (int i = side_points * k; i < side_points * (k + 1); ++i) {
        const auto at = static_cast<std::size_t>(i);
        VectorX& g = out.given[at];
        g = load_.on_side(h, out.x[at], out.normal[static_cast<std::size_t>(k)]);
        for (int c = 0; c < static_cast<int>(g.size()); ++c)
          if (load_.held(h, c)) g(c) = out.flux[at](c);
      }
    }
  }

  /// Of neighbours().
  [[nodiscard]] HalfedgeId halfedge(int e, int piece) const {
    return neighbours().topology().halfedge(element(e).face, piece);
  }
  /// The element on the other side; -1 if there is none.
  [[nodiscard]] int neighbour(HalfedgeId h) const {
    const HalfedgeId twin = neighbours().twin(h);
    return twin.valid() ? element_of_face_[static_cast<std::size_t>(neighbours().face(twin).value)]
                        : -1;
  }

  /// The flux is taken as bilinear in the parameters between four inner points, which is exact in
  /// parallelograms.
  [[nodiscard]] double inner_square(int e) const {
    const ElementTable& table = space_.table(element(e).shape);
    const auto P = space_.control_points(e);
    ElementPoints points;
    to_physical(table, P, points);
    const Eigen::Matrix<double, Eigen::Dynamic, 2> xu = table.Gu * P.leftCols<2>(),
                                                   xv = table.Gv * P.leftCols<2>();
    const MatrixX D = energy_.stiffness(e);
    const MatrixX q = energy_.gradient(e, inside_[static_cast<std::size_t>(element(e).shape)]) * D;
    const MatrixX Bx = gradient_along(Vec2::UnitX(), D.rows()),
                  By = gradient_along(Vec2::UnitY(), D.rows());
    const MatrixX A = 0.5 * (stiffness_along(Vec2::UnitX(), D) + stiffness_along(Vec2::UnitY(), D));
    const VectorX weight = points.J.cwiseAbs().cwiseProduct(table.weight);
    MatrixX r(points.J.size(), A.rows());
    for (Eigen::Index i = 0; i < points.J.size(); ++i) {
      const double s = 2 * table.uv(i, 0) - 0.5, t = 2 * table.uv(i, 1) - 0.5;
      const VectorX qu = 2 * ((1 - t) * (q.row(1) - q.row(0)) + t * (q.row(2) - q.row(3)));
      const VectorX qv = 2 * ((1 - s) * (q.row(3) - q.row(0)) + s * (q.row(2) - q.row(1)));
      const VectorX qx = (xv(i, 1) * qu - xu(i, 1) * qv) / points.J(i);
      const VectorX qy = (xu(i, 0) * qv - xv(i, 0) * qu) / points.J(i);
      r.row(i) =
          (sides(e).load[static_cast<std::size_t>(i)] + Bx.transpose() * qx + By.transpose() * qy)
              .transpose();
    }
    const VectorX mean = r.transpose() * weight / weight.sum();
    double sum = 0;
    for (Eigen::Index i = 0; i < weight.size(); ++i)
      sum += weight(i) * weighted_square(r.row(i).transpose() - mean, A);
    return sides(e).area / 24 * sum;
  }

  [[nodiscard]] double side_square(int e, int k) const {
    const FaceSides& own = sides(e);
    const HalfedgeId h = halfedge(e, k);
    const int other = neighbour(h);
    const int l = other < 0 ? 0 : neighbours().corner_index(neighbours().twin(h));
    MatrixX A = own.A[static_cast<std::size_t>(k)];
    if (other >= 0) A = 0.5 * (A + sides(other).A[static_cast<std::size_t>(l)]);
    double sum = 0;
    for (int i = 0; i < side_points; ++i) {
      const auto at = static_cast<std::size_t>(side_points * k + i);
      VectorX j;
      if (other >= 0) {
        const auto opposite = static_cast<std::size_t>(side_points * (l + 1) - 1 - i);
        j = 0.5 * (own.flux[at] + sides(other).flux[opposite]);
      } else {
        j = own.given[at] - own.flux[at];
      }
      sum += rule_.weight[static_cast<std::size_t>(i)] * weighted_square(j, A);
    }
    return own.area / 6 * own.pieces[static_cast<std::size_t>(k)].share() * sum;
  }

  const SubdivisionSpace& space_;
  const EnergyDensity& energy_;
  const LoadDensity& load_;
  const HangingFaces* hanging_;
  std::optional<Adjacency> closed_;  // of its faces
  QuadratureRule rule_;
  std::vector<ElementTable> on_sides_, inside_;  // by shape
  std::vector<int> element_of_face_;
  std::vector<FaceSides> sides_;  // by element
};

}  // namespace

std::vector<double> residual_estimate(const SubdivisionSpace& space, const EnergyDensity& energy,
                                      const LoadDensity& load, const HangingFaces* hanging) {
  return ResidualEstimate(space, energy, load, hanging).squares();
}

}  // namespace limes
