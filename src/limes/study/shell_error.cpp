#include "limes/study/shell_error.h"

#include <cmath>

#include "limes/adapt/recovery.h"
#include "limes/core/parallel.h"
#include "limes/fem/resultant_norm.h"
#include "limes/study/shell_pieces.h"
#include "limes/study/shell_residual.h"

namespace limes {
namespace {

/// Components of membrane and bending (11, 22, 12 each) and shear (1, 2) in two axes of a plane.
using PlaneResultants = Eigen::Matrix<double, 8, 1>;
using Axes = Eigen::Matrix<double, 3, 2>;

Axes axes_across(const Vec3& normal) {
  Axes out;
  out.col(0) = normal.unitOrthogonal();
  out.col(1) = normal.cross(out.col(0));
  return out;
}

PlaneResultants in_plane(const ShellResultants& r, const Axes& axes) {
  const Mat2 n = axes.transpose() * r.membrane * axes, m = axes.transpose() * r.bending * axes;
  const Vec2 q = axes.transpose() * r.shear;
  PlaneResultants out;
  out << n(0, 0), n(1, 1), n(0, 1), m(0, 0), m(1, 1), m(0, 1), q(0), q(1);
  return out;
}

ShellResultants in_space(const PlaneResultants& p, const Axes& axes, const Vec3& normal) {
  Mat2 n, m;
  n << p(0), p(2), p(2), p(1);
  m << p(3), p(5), p(5), p(4);
  return {axes * n * axes.transpose(), axes * m * axes.transpose(), axes * p.tail<2>(), normal};
}

/// Resultants around a node, linear in its tangent plane.
struct PatchFit {
  Vec3 x, director;
  Axes axes;
  LinearFit fit;

  [[nodiscard]] ShellResultants at(const Vec3& point) const {
    return in_space(fit.at(axes.transpose() * (point - x)), axes, director);
  }
};

PatchFit fit_in(const ShellModel& model, const RecoveryPatch& patch,
                const IdArray<FaceId, ShellResultants>& centre) {
  PatchFit out{.x = model.mesh->points[patch.vertex],
               .director = model.director[patch.corners.front()],
               .axes = {},
               .fit = {}};
  out.axes = axes_across(out.director);
  const auto m = static_cast<Eigen::Index>(patch.faces.size());
  Eigen::Matrix<double, Eigen::Dynamic, 2> at(m, 2);
  MatrixX values(m, 8);
  for (Eigen::Index k = 0; k < m; ++k) {
    const FaceId f = patch.faces[static_cast<std::size_t>(k)];
    at.row(k) = (model.quad(f).position(Vec2::Zero()) - out.x).transpose() * out.axes;
    values.row(k) = in_plane(turned(centre[f], out.director), out.axes).transpose();
  }
  out.fit = linear_fit(at, values);
  return out;
}

/// Mean of what some fits say at a point, in the plane normal to a director.
ShellResultants mean_at(const Vec3& point, const Vec3& director, const std::vector<int>& from,
                        const std::vector<PatchFit>& fits) {
  ShellResultants out{Mat3::Zero(), Mat3::Zero(), Vec3::Zero(), director};
  for (const int k : from) {
    const ShellResultants one = turned(fits[static_cast<std::size_t>(k)].at(point), director);
    const double share = 1 / static_cast<double>(from.size());
    out.membrane += share * one.membrane;
    out.bending += share * one.bending;
    out.shear += share * one.shear;
  }
  return out;
}

/// At every corner of every face, in the plane normal to its director.
IdArray<HalfedgeId, ShellResultants> recovered(const ShellModel& model,
                                               const ShellSolution& solution) {
  const int n = model.mesh->topology.num_faces();
  IdArray<FaceId, ShellResultants> centre(static_cast<std::size_t>(n));
  for_each_index(n, [&](std::int64_t f) {
    centre[FaceId(f)] = resultants_at(model, solution, FaceId(f), Vec2::Zero());
  });
  const auto patches =
      recovery_patches(*model.adjacency, [&](HalfedgeId h) { return is_smooth_across(model, h); });
  const auto sources = recovering_patches(*model.adjacency, patches);
  std::vector<PatchFit> fits(patches.size());
  for_each_index(static_cast<std::int64_t>(patches.size()), [&](std::int64_t i) {
    const auto at = static_cast<std::size_t>(i);
    fits[at] = fit_in(model, patches[at], centre);
  });
  IdArray<HalfedgeId, ShellResultants> out(
      static_cast<std::size_t>(model.mesh->topology.num_corners()));
  for_each_index(static_cast<std::int64_t>(patches.size()), [&](std::int64_t i) {
    const auto at = static_cast<std::size_t>(i);
    const ShellResultants value = mean_at(fits[at].x, fits[at].director, sources[at], fits);
    for (const HalfedgeId h : patches[at].corners)
      out[h] = value;
  });
  return out;
}

/// Bilinear between recovered corners, each turned to a normal.
ShellResultants interpolated(const std::array<ShellResultants, 4>& corner, const Vec2& rs,
                             const Vec3& normal) {
  const double r = rs.x(), s = rs.y();
  const std::array<double, 4> N{(1 - r) * (1 - s) / 4, (1 + r) * (1 - s) / 4, (1 + r) * (1 + s) / 4,
                                (1 - r) * (1 + s) / 4};
  ShellResultants out{Mat3::Zero(), Mat3::Zero(), Vec3::Zero(), normal};
  for (std::size_t k = 0; k < 4; ++k) {
    const ShellResultants here = turned(corner[k], normal);
    out.membrane += N[k] * here.membrane;
    out.bending += N[k] * here.bending;
    out.shear += N[k] * here.shear;
  }
  return out;
}

}  // namespace

std::vector<double> estimate_error(const ShellModel& model, const ShellSolution& solution) {
  if (model.problem.adapt && model.problem.adapt->estimator == EstimatorKind::residual)
    return residual_estimate(model, solution);
  const Topology& t = model.mesh->topology;
  const IdArray<HalfedgeId, ShellResultants> at_corner = recovered(model, solution);
  std::vector<double> out(static_cast<std::size_t>(t.num_faces()), 0.0);
  for_each_index(t.num_faces(), [&](std::int64_t i) {
    const FaceId f(i);
    const ShellQuad quad = model.quad(f);
    std::array<ShellResultants, 4> corner;
    for (int k = 0; k < 4; ++k)
      corner[static_cast<std::size_t>(k)] = at_corner[model.corner(f, k)];
    const double gauss = 1 / std::sqrt(3.0);
    for (const double r : {-gauss, gauss})
      for (const double s : {-gauss, gauss}) {
        const Vec2 rs(r, s);
        const ShellResultants here = resultants_at(model, solution, f, rs);
        out[static_cast<std::size_t>(i)] +=
            quad.area_normal(rs).norm() *
            energy_between(interpolated(corner, rs, here.normal), here, model.section(f));
      }
  });
  return out;
}

}  // namespace limes
