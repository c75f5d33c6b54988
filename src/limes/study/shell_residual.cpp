#include "limes/study/shell_residual.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "limes/core/parallel.h"
#include "limes/fem/resultant_norm.h"
#include "limes/study/shell_loads.h"
#include "limes/study/shell_supports.h"

namespace limes {
namespace {

const double gauss = 1 / std::sqrt(3.0);
constexpr std::size_t side_points = 2;

/// Force and moment per length, or what they lack, or stiffness against them.
template <class T>
struct Pair {
  T force, moment;
};

/// What a face has at one point of one of its sides.
struct SidePoint {
  Vec3 x;
  Pair<Vec3> traction;   ///< through the side, from beyond it on the face
  Pair<Mat3> stiffness;  ///< of the face
  Mat3 free_border;      ///< against moments, where all rotations are free
};

/// A side of an element, or half of one in which a node hangs: what the element shares with one neighbour.
struct SidePart {
  HalfedgeId h;        ///< of the face
  int side;            ///< of the quad
  double first, last;  ///< where it begins and ends on the side, whose corners are at -1 and 1
  /// Parameters of a point from -1 to 1 along the part.
  [[nodiscard]] Vec2 at(double s) const {
    const double along = ((1 - s) * first + (1 + s) * last) / 2;
    switch (side) {
      case 0:
        return {along, -1};
      case 1:
        return {1, along};
      case 2:
        return {-along, 1};
      default:
        return {-1, -along};
    }
  }
  /// Part of the side.
  [[nodiscard]] double share() const { return (last - first) / 2; }
};

std::vector<SidePart> side_parts(const ShellModel& model, FaceId f) {
  std::vector<SidePart> out;
  for (int k = 0; k < 4; ++k) {
    const HalfedgeId start = model.corner(f, k), middle = model.faces.inside(f, k);
    out.push_back({start, k, -1, middle.valid() ? 0.0 : 1.0});
    if (middle.valid()) out.push_back({middle, k, 0, 1});
  }
  return out;
}

/// The director between those of the corners.
Vec3 director_at(const ShellQuad& quad, const Vec2& rs) {
  const double r = rs.x(), s = rs.y();
  return ((1 - r) * (1 - s) * quad.director[0] + (1 + r) * (1 - s) * quad.director[1] +
          (1 + r) * (1 + s) * quad.director[2] + (1 - r) * (1 + s) * quad.director[3])
      .normalized();
}

/// Stiffness of a section for elements of the size h.
class SectionStiffness {
 public:
  SectionStiffness(const ShellSection& s, double h) {
    const double t = s.thickness, shear = s.young / (2 * (1 + s.poisson));
    along_ = s.young * t / (1 - s.poisson * s.poisson);
    across_ = shear * t;
    bending_ = t * t / 12;
    const double x = h / 6 * std::sqrt(s.shear_factor / bending_);
    layer_ = x / std::tanh(x);
    transverse_ = 1 / (1 / (s.shear_factor * shear * t) + h * h / (60 * bending_ * along_));
  }

  /// Against changes along nu at a point with the director V: of forces in space and of moments as axes in
  /// space, V x (M nu).
  [[nodiscard]] Pair<Mat3> on_side(const Vec3& nu, const Vec3& V) const {
    const Vec3 tau = V.cross(nu);
    const Mat3 n = nu * nu.transpose(), m = tau * tau.transpose();
    return {along_ * n + across_ * m + transverse_ * V * V.transpose(),
            bending_ * (along_ * m + across_ * n)};
  }
  /// Against moments on a free border: twisting ones are taken up in a layer as wide as the shell is thick.
  [[nodiscard]] Mat3 on_free_border(const Vec3& nu, const Vec3& V) const {
    const Vec3 tau = V.cross(nu);
    return bending_ * (along_ * tau * tau.transpose() + layer_ * across_ * nu * nu.transpose());
  }
  /// The mean of two directions, as factors in the surface, along V, and of moments.
  [[nodiscard]] double in_surface() const { return (along_ + across_) / 2; }
  [[nodiscard]] double transverse() const { return transverse_; }
  [[nodiscard]] double moment() const { return bending_ * in_surface(); }

 private:
  double along_, across_, bending_, transverse_, layer_;
};

/// r . A^-1 r with what A has no stiffness against left out.
double weighted_square(const Vec3& r, const Mat3& A) {
  const Eigen::SelfAdjointEigenSolver<Mat3> eigen(A);
  double sum = 0;
  for (int i = 0; i < 3; ++i)
    if (eigen.eigenvalues()(i) > 1e-9 * eigen.eigenvalues()(2)) {
      const double part = eigen.eigenvectors().col(i).dot(r);
      sum += part * part / eigen.eigenvalues()(i);
    }
  return sum;
}

/// Takes out the parts of a vector along some directions.
class Projector {
 public:
  void hold(const std::vector<Vec3>& directions) {
    for (const Vec3& d : directions) {
      const Vec3 rest = P_ * d;
      if (rest.norm() > 1e-6 * d.norm()) P_ -= rest * rest.transpose() / rest.squaredNorm();
    }
  }
  [[nodiscard]] Vec3 free_part(const Vec3& v) const { return P_ * v; }

 private:
  Mat3 P_ = Mat3::Identity();
};

class ShellResiduals {
 public:
  ShellResiduals(const ShellModel& model, const ShellSolution& solution)
      : model_(model),
        solution_(solution),
        load_(shell_load_density(model)),
        held_(held_along_sides(model)),
        area_(static_cast<std::size_t>(model.mesh->topology.num_faces()), 0.0),
        points_(side_points * static_cast<std::size_t>(model.mesh->topology.num_corners())),
        side_square_(static_cast<std::size_t>(model.mesh->topology.num_corners()), 0.0) {}

  std::vector<double> squares() {
    const Topology& t = model_.mesh->topology;
    for_each_index(t.num_faces(), [&](std::int64_t f) { measure(FaceId(f)); });
    balance_sides();
    const std::vector<Vec3> p = loads_in_faces();
    std::vector<double> out(static_cast<std::size_t>(t.num_faces()), 0.0);
    for_each_index(t.num_faces(), [&](std::int64_t i) {
      double sum = inner_square(FaceId(i), &p[static_cast<std::size_t>(4 * i)]);
      for (const SidePart& part : side_parts(model_, FaceId(i)))
        sum += part.share() * side_square_[part.h];
      out[static_cast<std::size_t>(i)] = sum;
    });
    return out;
  }

 private:
  void measure(FaceId f) {
    const ShellQuad quad = model_.quad(f);
    double area = 0;
    for (const Vec2& rs : inner_points())
      area += quad.area_normal(rs).norm();
    area_[f] = area;
    for (const SidePart& part : side_parts(model_, f))
      measure(f, quad, part);
  }

  /// Direction and directors are those between the ends of the part: on half a side those of the element
  /// beyond it, however the side is curved.
  void measure(FaceId f, const ShellQuad& quad, const SidePart& part) {
    const auto k = static_cast<std::size_t>(part.side);
    const double length = (quad.x[(k + 1) % 4] - quad.x[k]).norm();
    const SectionStiffness stiffness(model_.section(f), area_[f] / length);
    const Adjacency& adjacency = *model_.adjacency;
    const Vec3 tau =
        model_.mesh->points[adjacency.to(part.h)] - model_.mesh->points[adjacency.from(part.h)];
    const Vec3 &first = model_.director[part.h], &last = model_.director[adjacency.next(part.h)];
    for (std::size_t q = 0; q < side_points; ++q) {
      const double s = q == 0 ? -gauss : gauss;
      const Vec3 V = ((1 - s) * first + (1 + s) * last).normalized();
      const ShellResultants here = turned(resultants_at(model_, solution_, f, part.at(s)), V);
      const Vec3 nu = tau.cross(V).normalized();  // outward
      at(part.h, q) = {
          quad.position(part.at(s)),
          {here.membrane * nu + here.shear.dot(nu) * V, V.cross(Vec3(here.bending * nu))},
          stiffness.on_side(nu, V),
          stiffness.on_free_border(nu, V)};
    }
  }

  SidePoint& at(HalfedgeId h, std::size_t q) {
    return points_[side_points * static_cast<std::size_t>(h.value) + q];
  }

  /// Sides, or halves of them, that lie on each other have the same nodes.
  [[nodiscard]] std::vector<std::vector<HalfedgeId>> meeting_sides() const {
    std::map<std::array<VertexId, 2>, std::vector<HalfedgeId>> groups;
    for (int h = 0; h < model_.mesh->topology.num_corners(); ++h) {
      VertexId a = model_.node[model_.adjacency->from(HalfedgeId(h))],
               b = model_.node[model_.adjacency->to(HalfedgeId(h))];
      if (b < a) std::swap(a, b);
      groups[{a, b}].push_back(HalfedgeId(h));
    }
    std::vector<std::vector<HalfedgeId>> out;
    for (auto& group : groups)
      out.push_back(std::move(group.second));
    return out;
  }

  /// One after the other, as the loads ask.
  void balance_sides() {
    for (const std::vector<HalfedgeId>& sides : meeting_sides()) {
      Pair<Projector> free;
      for (const HalfedgeId h : sides) {
        free.force.hold(held_[h].displacement);
        free.moment.hold(held_[h].rotation);
      }
      for (std::size_t q = 0; q < side_points; ++q)
        balance(sides, q, free);
    }
  }

  /// @param q  point of the first of the sides
  void balance(const std::vector<HalfedgeId>& sides, std::size_t q, const Pair<Projector>& free) {
    const double share = 1 / static_cast<double>(sides.size());
    const VertexId start = model_.node[model_.adjacency->from(sides[0])];
    const bool free_border = sides.size() == 1 && held_[sides[0]].rotation.empty();
    Pair<Vec3> lack{Vec3::Zero(), Vec3::Zero()};
    Pair<Mat3> A{Mat3::Zero(), Mat3::Zero()};
    for (const HalfedgeId h : sides) {
      const bool along = model_.node[model_.adjacency->from(h)] == start;
      const SidePoint& point = at(h, along ? q : side_points - 1 - q);
      lack.force += load_.on_side(h, point.x) - point.traction.force;
      lack.moment -= point.traction.moment;
      A.force += share * point.stiffness.force;
      A.moment += share * (free_border ? point.free_border : point.stiffness.moment);
    }
    const double square = weighted_square(share * free.force.free_part(lack.force), A.force) +
                          weighted_square(share * free.moment.free_part(lack.moment), A.moment);
    for (const HalfedgeId h : sides)
      side_square_[h] += area_[model_.adjacency->face(h)] / (6 * side_points) * square;
  }

  static std::array<Vec2, 4> inner_points() {
    return {Vec2(-gauss, -gauss), Vec2(gauss, -gauss), Vec2(gauss, gauss), Vec2(-gauss, gauss)};
  }

  /// Four of each face. One after the other, as the loads ask.
  [[nodiscard]] std::vector<Vec3> loads_in_faces() const {
    std::vector<Vec3> out;
    for (int f = 0; f < model_.mesh->topology.num_faces(); ++f) {
      const ShellQuad quad = model_.quad(FaceId(f));
      for (const Vec2& rs : inner_points())
        out.push_back(
            load_.on_face(FaceId(f), quad.position(rs), quad.area_normal(rs).normalized()));
    }
    return out;
  }

  /// Resultants are taken as bilinear in the parameters between four inner points.
  /// @param p  loads at the Gauss points
  [[nodiscard]] double inner_square(FaceId f, const Vec3* p) const {
    const ShellQuad quad = model_.quad(f);
    std::array<ShellResultants, 4> states;
    std::array<Mat3, 4> T, M;
    const auto points = inner_points();
    for (std::size_t i = 0; i < 4; ++i) {
      states[i] =
          turned(resultants_at(model_, solution_, f, points[i]), director_at(quad, points[i]));
      T[i] = states[i].membrane + states[i].normal * states[i].shear.transpose();
      M[i] = states[i].bending;
    }
    Pair<std::array<Vec3, 4>> lack;
    Pair<Vec3> mean{Vec3::Zero(), Vec3::Zero()};
    std::array<double, 4> weight{};
    for (std::size_t i = 0; i < 4; ++i) {
      const ShellResultants& here = states[i];
      const Eigen::Matrix<double, 3, 2> dual = dual_base(quad, points[i]);
      weight[i] = quad.area_normal(points[i]).norm();
      lack.force[i] = divergence(T, points[i], dual) + p[i];
      const Vec3 moment = divergence(M, points[i], dual) - here.shear;
      lack.moment[i] = moment - moment.dot(here.normal) * here.normal;
      mean.force += weight[i] / area_[f] * lack.force[i];
      mean.moment += weight[i] / area_[f] * lack.moment[i];
    }
    const SectionStiffness stiffness(model_.section(f), std::sqrt(area_[f]));
    double sum = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const Vec3 force = lack.force[i] - mean.force, moment = lack.moment[i] - mean.moment;
      const double along = force.dot(states[i].normal);
      sum += weight[i] *
             ((force.squaredNorm() - along * along) / stiffness.in_surface() +
              along * along / stiffness.transverse() + moment.squaredNorm() / stiffness.moment());
    }
    return area_[f] / 24 * sum;
  }

  /// Gradients of r and s along the surface.
  static Eigen::Matrix<double, 3, 2> dual_base(const ShellQuad& quad, const Vec2& rs) {
    const Vec3 x_r =
        ((1 - rs.y()) * (quad.x[1] - quad.x[0]) + (1 + rs.y()) * (quad.x[2] - quad.x[3])) / 4;
    const Vec3 x_s =
        ((1 - rs.x()) * (quad.x[3] - quad.x[0]) + (1 + rs.x()) * (quad.x[2] - quad.x[1])) / 4;
    Eigen::Matrix<double, 3, 2> base;
    base << x_r, x_s;
    return base * (base.transpose() * base).inverse();
  }

  /// Of a tensor that is bilinear between the inner points.
  static Vec3 divergence(const std::array<Mat3, 4>& T, const Vec2& rs,
                         const Eigen::Matrix<double, 3, 2>& dual) {
    const double r = rs.x() / gauss, s = rs.y() / gauss;
    const Mat3 T_r = ((1 - s) * (T[1] - T[0]) + (1 + s) * (T[2] - T[3])) / (4 * gauss);
    const Mat3 T_s = ((1 - r) * (T[3] - T[0]) + (1 + r) * (T[2] - T[1])) / (4 * gauss);
    return T_r * dual.col(0) + T_s * dual.col(1);
  }

  const ShellModel& model_;
  const ShellSolution& solution_;
  ShellLoadDensity load_;
  IdArray<HalfedgeId, HeldDirections> held_;
  IdArray<FaceId, double> area_;
  std::vector<SidePoint> points_;            // by halfedge, along it
  IdArray<HalfedgeId, double> side_square_;  // as if each were a whole side
};

}  // namespace

std::vector<double> residual_estimate(const ShellModel& model, const ShellSolution& solution) {
  return ShellResiduals(model, solution).squares();
}

}  // namespace limes
