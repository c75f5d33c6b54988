#include "limes/math/box_spline.h"

#include <array>
#include <span>

namespace limes {
namespace {

/// Powers 0 to 4 of a barycentric coordinate.
std::array<double, 5> powers(double x) {
  return {1.0, x, x * x, x * x * x, x * x * x * x};
}

/// Bernstein polynomials of degree up to 4 at one point.
class BernsteinAt {
 public:
  explicit BernsteinAt(const Vec2& uv)
      : u_(powers(uv.x())), v_(powers(uv.y())), w_(powers(1.0 - uv.x() - uv.y())) {}

  /// Of a degree; 0 where an exponent is negative.
  [[nodiscard]] double operator()(int degree, int i, int j) const {
    constexpr std::array<double, 5> factorial{1, 1, 2, 6, 24};
    const int k = degree - i - j;
    if (i < 0 || j < 0 || k < 0) return 0.0;
    const auto at = [](const std::array<double, 5>& a, int n) {
      return a[static_cast<std::size_t>(n)];
    };
    return at(factorial, degree) / (at(factorial, i) * at(factorial, j) * at(factorial, k)) *
           (at(u_, i) * at(v_, j) * at(w_, k));
  }

 private:
  std::array<double, 5> u_, v_, w_;
};

/// Where a control point of the triangulation lies, seen from the triangle.
enum class Place {
  corner,  ///< corner p itself
  across,  ///< beyond the side between corners p and q
  beside   ///< a neighbour of corner p alone, on the side of corner q
};
struct Control {
  Place place;
  int p, q;
};

/// In the order of box_spline_index.
constexpr std::array<Control, 12> controls{{{Place::beside, 0, 1},
                                            {Place::across, 0, 1},
                                            {Place::beside, 1, 0},
                                            {Place::beside, 0, 2},
                                            {Place::corner, 0, 1},
                                            {Place::corner, 1, 2},
                                            {Place::beside, 1, 2},
                                            {Place::across, 0, 2},
                                            {Place::corner, 2, 0},
                                            {Place::across, 1, 2},
                                            {Place::beside, 2, 0},
                                            {Place::beside, 2, 1}}};

/// 24 times a Bernstein coefficient: exponents of the coordinates of corners p, q and the third.
struct Term {
  int a, b, c, value;
};
constexpr std::array corner_terms{
    Term{4, 0, 0, 12}, Term{3, 1, 0, 12}, Term{3, 0, 1, 12}, Term{2, 2, 0, 8}, Term{2, 1, 1, 10},
    Term{2, 0, 2, 8},  Term{1, 3, 0, 4},  Term{1, 2, 1, 6},  Term{1, 1, 2, 6}, Term{1, 0, 3, 4},
    Term{0, 4, 0, 2},  Term{0, 3, 1, 3},  Term{0, 2, 2, 4},  Term{0, 1, 3, 3}, Term{0, 0, 4, 2}};
constexpr std::array across_terms{Term{4, 0, 0, 2}, Term{3, 1, 0, 3}, Term{2, 2, 0, 4},
                                  Term{1, 3, 0, 3}, Term{0, 4, 0, 2}, Term{3, 0, 1, 1},
                                  Term{2, 1, 1, 1}, Term{1, 2, 1, 1}, Term{0, 3, 1, 1}};
constexpr std::array beside_terms{Term{4, 0, 0, 2}, Term{3, 1, 0, 1}};

std::span<const Term> terms_of(Place place) {
  switch (place) {
    case Place::corner:
      return corner_terms;
    case Place::across:
      return across_terms;
    default:
      return beside_terms;
  }
}

Eigen::Matrix<double, 12, 15> make_coefficients() {
  Eigen::Matrix<double, 12, 15> C = Eigen::Matrix<double, 12, 15>::Zero();
  for (int row = 0; row < 12; ++row) {
    const Control& control = controls[static_cast<std::size_t>(row)];
    for (const Term& t : terms_of(control.place)) {
      std::array<int, 3> exponent{};  // of w, u, v: corners 0, 1, 2
      exponent[static_cast<std::size_t>(control.p)] = t.a;
      exponent[static_cast<std::size_t>(control.q)] = t.b;
      exponent[static_cast<std::size_t>(3 - control.p - control.q)] = t.c;
      C(row, triangle_index(exponent[1], exponent[2])) = t.value / 24.0;
    }
  }
  return C;
}

}  // namespace

Eigen::Matrix<double, 15, 6> quartic_bernstein(const Vec2& uv) {
  const BernsteinAt b(uv);
  Eigen::Matrix<double, 15, 6> B;
  for (int j = 0; j <= 4; ++j) {
    for (int i = 0; i + j <= 4; ++i) {
      // Derivatives are differences of polynomials of lower degree.
      B.row(triangle_index(i, j)) << b(4, i, j), 4.0 * (b(3, i - 1, j) - b(3, i, j)),
          4.0 * (b(3, i, j - 1) - b(3, i, j)),
          12.0 * (b(2, i - 2, j) - 2.0 * b(2, i - 1, j) + b(2, i, j)),
          12.0 * (b(2, i - 1, j - 1) - b(2, i - 1, j) - b(2, i, j - 1) + b(2, i, j)),
          12.0 * (b(2, i, j - 2) - 2.0 * b(2, i, j - 1) + b(2, i, j));
    }
  }
  return B;
}

const Eigen::Matrix<double, 12, 15>& box_spline_coefficients() {
  static const Eigen::Matrix<double, 12, 15> coefficients = make_coefficients();
  return coefficients;
}

}  // namespace limes
