#include "limes/fem/mitc4.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace limes {
namespace {

const double gauss = 1.0 / std::sqrt(3.0);
constexpr std::array<double, 4> corner_r{-1, 1, 1, -1};
constexpr std::array<double, 4> corner_s{-1, -1, 1, 1};

/// Bilinear functions and their derivatives by r and s.
struct Shape {
  std::array<double, 4> N, Nr, Ns;
  explicit Shape(const Vec2& rs) {
    for (std::size_t a = 0; a < 4; ++a) {
      const double r = 1 + corner_r[a] * rs.x(), s = 1 + corner_s[a] * rs.y();
      N[a] = r * s / 4;
      Nr[a] = corner_r[a] * s / 4;
      Ns[a] = corner_s[a] * r / 4;
    }
  }
};

/// Covariant base vectors of x(r, s, t) = sum N_a (x_a + t h/2 V_a).
struct Base {
  Vec3 gr = Vec3::Zero(), gs = Vec3::Zero(), gt = Vec3::Zero();
  Base(const ShellQuad& quad, const Shape& shape, double half, double t) {
    for (std::size_t a = 0; a < 4; ++a) {
      const Vec3 y = quad.x[a] + t * half * quad.director[a];
      gr += shape.Nr[a] * y;
      gs += shape.Ns[a] * y;
      gt += shape.N[a] * half * quad.director[a];
    }
  }
};

using Row = Eigen::Matrix<double, 1, 24>;
using Strains = Eigen::Matrix<double, 5, 24>;

/// The row of g . v for v = sum N_a (a u_a + b theta_a x V_a).
Row project(const ShellQuad& quad, const std::array<double, 4>& N, const Vec3& g, double a,
            double b) {
  Row row;
  for (std::size_t n = 0; n < 4; ++n) {
    const auto first = static_cast<Eigen::Index>(6 * n);
    row.segment<3>(first) = N[n] * a * g.transpose();
    row.segment<3>(first + 3) = N[n] * b * quad.director[n].cross(g).transpose();
  }
  return row;
}

/// 2 e_rt at a point of the middle surface.
Row shear_rt(const ShellQuad& quad, double half, const Vec2& rs) {
  const Shape shape(rs);
  const Base g(quad, shape, half, 0);
  return project(quad, shape.N, g.gr, 0, half) + project(quad, shape.Nr, g.gt, 1, 0);
}

Row shear_st(const ShellQuad& quad, double half, const Vec2& rs) {
  const Shape shape(rs);
  const Base g(quad, shape, half, 0);
  return project(quad, shape.N, g.gs, 0, half) + project(quad, shape.Ns, g.gt, 1, 0);
}

using InPlane = Eigen::Matrix<double, 3, 24>;

/// rr, ss, 2 rs from displacements, at t half = z.
InPlane in_plane(const ShellQuad& quad, const Shape& shape, const Base& g, double z) {
  InPlane B;
  B.row(0) = project(quad, shape.Nr, g.gr, 1, z);
  B.row(1) = project(quad, shape.Ns, g.gs, 1, z);
  B.row(2) = project(quad, shape.Nr, g.gs, 1, z) + project(quad, shape.Ns, g.gr, 1, z);
  return B;
}

InPlane membrane(const ShellQuad& quad, const Vec2& rs) {
  const Shape shape(rs);
  return in_plane(quad, shape, Base(quad, shape, 0, 0), 0);
}

/// From the components rr, ss, 2 rs of a strain in one base to those in the base F times it.
Mat3 change_of_base(const Mat2& F) {
  Mat3 T;
  for (int i = 0; i < 2; ++i)
    T.row(i) << F(i, 0) * F(i, 0), F(i, 1) * F(i, 1), F(i, 0) * F(i, 1);
  T.row(2) << 2 * F(0, 0) * F(1, 0), 2 * F(0, 1) * F(1, 1), F(0, 0) * F(1, 1) + F(0, 1) * F(1, 0);
  return T;
}

/// Assumed membrane strains. With x = x_0 + r x_r + s x_s + r s x_d, and u alike, they are tied to rr
/// at (0, +-1), ss at (+-1, 0) and rs at the centre, [ko_2017b]. What displacements give has besides
/// only x_d . u_d, which in a flat element follows from these five; so it is taken to follow in all.
/// Shear in the base of the centre is constant: in-plane bending has none.
class AssumedMembrane {
 public:
  explicit AssumedMembrane(const ShellQuad& quad) : c_(twist_in_plane(quad)) {
    const Row top = membrane(quad, {0, 1}).row(0), bottom = membrane(quad, {0, -1}).row(0);
    const Row right = membrane(quad, {1, 0}).row(1), left = membrane(quad, {-1, 0}).row(1);
    rr_ = (top + bottom) / 2;
    rr_s_ = (top - bottom) / 2;
    ss_ = (right + left) / 2;
    ss_r_ = (right - left) / 2;
    rs2_ = membrane(quad, {0, 0}).row(2);
    const double cr = c_.x(), cs = c_.y();
    dd_ = (cr * rr_s_ + cs * ss_r_ - cr * cr * rr_ - cs * cs * ss_ - cr * cs * rs2_) /
          (1 - c_.squaredNorm());
  }

  [[nodiscard]] InPlane at(const Vec2& rs) const {
    const double r = rs.x(), s = rs.y();
    InPlane B;
    B.row(0) = rr_ + s * rr_s_ + (s * s - 1) * dd_;
    B.row(1) = ss_ + r * ss_r_ + (r * r - 1) * dd_;
    B.row(2) = rs2_ + r * rr_s_ + s * ss_r_ + 2 * r * s * dd_;
    Mat2 F;  // the base at (r, s) in terms of that at the centre, along the plane of the latter
    F << 1 + s * c_.x(), s * c_.y(), r * c_.x(), 1 + r * c_.y();
    const Row shear = change_of_base(F.inverse()).row(2) * B;
    return B + change_of_base(F).col(2) * (rs2_ - shear);
  }

 private:
  /// c_r and c_s of x_d = c_r x_r + c_s x_s + what is normal to both; |c_r| + |c_s| < 1 if the element,
  /// seen along that normal, is convex.
  static Vec2 twist_in_plane(const ShellQuad& quad) {
    Eigen::Matrix<double, 3, 2> base = Eigen::Matrix<double, 3, 2>::Zero();
    Vec3 twist = Vec3::Zero();
    for (std::size_t a = 0; a < 4; ++a) {
      base.col(0) += corner_r[a] / 4 * quad.x[a];
      base.col(1) += corner_s[a] / 4 * quad.x[a];
      twist += corner_r[a] * corner_s[a] / 4 * quad.x[a];
    }
    return (base.transpose() * base).inverse() * (base.transpose() * twist);
  }

  Vec2 c_;
  Row rr_, rr_s_, ss_, ss_r_, rs2_, dd_;
};

/// Covariant strains rr, ss, 2 rs, 2 rt, 2 st of one element; what is tied is found once.
class CovariantStrains {
 public:
  CovariantStrains(const ShellQuad& quad, const ShellSection& section)
      : quad_(quad),
        half_(section.thickness / 2),
        rt_{shear_rt(quad, half_, {0, 1}), shear_rt(quad, half_, {0, -1})},
        st_{shear_st(quad, half_, {1, 0}), shear_st(quad, half_, {-1, 0})} {
    if (section.membrane == MembraneStrain::assumed) membrane_.emplace(quad);
  }

  /// rt and st are tied to their values at the middles of the sides, [dvorkin_1984].
  [[nodiscard]] Strains at(const Vec2& rs, double t) const {
    const Shape shape(rs);
    Strains B;
    B.topRows<3>() = in_plane(quad_, shape, Base(quad_, shape, half_, t), t * half_);
    if (membrane_) B.topRows<3>() += membrane_->at(rs) - membrane(quad_, rs);
    B.row(3) = (1 + rs.y()) / 2 * rt_[0] + (1 - rs.y()) / 2 * rt_[1];
    B.row(4) = (1 + rs.x()) / 2 * st_[0] + (1 - rs.x()) / 2 * st_[1];
    return B;
  }

 private:
  const ShellQuad& quad_;
  double half_;
  std::array<Row, 2> rt_, st_;
  std::optional<AssumedMembrane> membrane_;
};

/// Unit vectors along g_r, across it, and normal to the lamina of constant t.
Mat3 local_axes(const Base& g) {
  Mat3 e;
  e.col(2) = g.gr.cross(g.gs).normalized();
  e.col(0) = g.gr.normalized();
  e.col(1) = e.col(2).cross(e.col(0));
  return e;
}

/// From covariant strains (rr, ss, 2rs, 2rt, 2st) to local ones (11, 22, 2 12, 2 13, 2 23).
Eigen::Matrix<double, 5, 5> to_local(const Base& g, const Mat3& e) {
  Mat3 G;
  G << g.gr, g.gs, g.gt;
  const Mat3 q = G.inverse() * e;  // q(i, k) = g^i . e_k
  constexpr std::array<std::array<int, 2>, 5> pair{{{0, 0}, {1, 1}, {0, 1}, {0, 2}, {1, 2}}};
  Eigen::Matrix<double, 5, 5> T;
  for (int row = 0; row < 5; ++row) {
    const auto [k, l] = pair[static_cast<std::size_t>(row)];
    const double engineering = k == l ? 1 : 2;
    for (int col = 0; col < 5; ++col) {
      const auto [i, j] = pair[static_cast<std::size_t>(col)];
      T(row, col) = engineering * (q(i, k) * q(j, l) + q(j, k) * q(i, l)) / 2;
    }
  }
  return T;
}

/// Plane stress in the lamina, transverse shear with its factor.
Eigen::Matrix<double, 5, 5> elasticity(const ShellSection& s) {
  const double c = s.young / (1 - s.poisson * s.poisson);
  const double shear = s.young / (2 * (1 + s.poisson));
  Eigen::Matrix<double, 5, 5> C = Eigen::Matrix<double, 5, 5>::Zero();
  C(0, 0) = C(1, 1) = c;
  C(0, 1) = C(1, 0) = c * s.poisson;
  C(2, 2) = shear;
  C(3, 3) = C(4, 4) = s.shear_factor * shear;
  return C;
}

}  // namespace

Vec3 ShellQuad::position(const Vec2& rs) const {
  const Shape shape(rs);
  Vec3 out = Vec3::Zero();
  for (std::size_t a = 0; a < 4; ++a)
    out += shape.N[a] * x[a];
  return out;
}

Vec3 ShellQuad::area_normal(const Vec2& rs) const {
  const Base g(*this, Shape(rs), 0, 0);
  return g.gr.cross(g.gs);
}

ShellMatrix mitc4_stiffness(const ShellQuad& quad, const ShellSection& section) {
  const double half = section.thickness / 2;
  const Eigen::Matrix<double, 5, 5> C = elasticity(section);
  const CovariantStrains strains(quad, section);
  ShellMatrix K = ShellMatrix::Zero();
  for (const double r : {-gauss, gauss})
    for (const double s : {-gauss, gauss})
      for (const double t : {-gauss, gauss}) {
        const Base g(quad, Shape({r, s}), half, t);
        const Strains B = to_local(g, local_axes(g)) * strains.at({r, s}, t);
        const double dV = std::abs(g.gr.cross(g.gs).dot(g.gt));
        K += dV * (B.transpose() * C * B);
      }
  return (K + K.transpose()) / 2;
}

ShellResultants mitc4_resultants(const ShellQuad& quad, const ShellSection& section,
                                 const ShellVector& u, const Vec2& rs) {
  const double half = section.thickness / 2;
  const CovariantStrains strains(quad, section);
  ShellResultants out{Mat3::Zero(), Mat3::Zero(), Vec3::Zero(), Vec3::Zero()};
  for (const double t : {-gauss, gauss}) {
    const Base g(quad, Shape(rs), half, t);
    const Mat3 e = local_axes(g);
    const Eigen::Matrix<double, 5, 1> stress =
        elasticity(section) * (to_local(g, e) * (strains.at(rs, t) * u));
    Mat2 plane;
    plane << stress(0), stress(2), stress(2), stress(1);
    const Mat3 tensor = e.leftCols<2>() * plane * e.leftCols<2>().transpose();
    out.membrane += half * tensor;
    out.bending += half * half * t * tensor;
    out.shear += half * (e.leftCols<2>() * stress.tail<2>());
  }
  out.normal = quad.area_normal(rs).normalized();
  return out;
}

double shell_von_mises(const ShellResultants& resultants, double thickness, double z) {
  const Mat3 stress = resultants.membrane / thickness +
                      resultants.bending * (12 * z / (thickness * thickness * thickness));
  const double trace = stress.trace();
  return std::sqrt(std::max(0.0, 1.5 * stress.squaredNorm() - 0.5 * trace * trace));
}

ShellVector shell_area_load(const ShellQuad& quad, const ShellDensity& p) {
  ShellVector f = ShellVector::Zero();
  for (const double r : {-gauss, gauss})
    for (const double s : {-gauss, gauss}) {
      const Vec3 n = quad.area_normal({r, s});
      const Vec3 force = n.norm() * p(quad.position({r, s}), n.normalized());
      const Shape shape({r, s});
      for (std::size_t a = 0; a < 4; ++a)
        f.segment<3>(static_cast<Eigen::Index>(6 * a)) += shape.N[a] * force;
    }
  return f;
}

ShellVector shell_side_load(const ShellQuad& quad, int side,
                            const std::function<Vec3(const Vec3& x)>& p) {
  const auto a = static_cast<std::size_t>(side), b = (a + 1) % 4;
  const double length = (quad.x[b] - quad.x[a]).norm();
  ShellVector f = ShellVector::Zero();
  for (const double r : {-gauss, gauss}) {
    const double w = (1 + r) / 2;
    const Vec3 force = length / 2 * p((1 - w) * quad.x[a] + w * quad.x[b]);
    f.segment<3>(static_cast<Eigen::Index>(6 * a)) += (1 - w) * force;
    f.segment<3>(static_cast<Eigen::Index>(6 * b)) += w * force;
  }
  return f;
}

}  // namespace limes
