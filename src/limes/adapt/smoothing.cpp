#include "limes/adapt/smoothing.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "limes/mesh/measure.h"

namespace limes {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The sum that is made less, as a function of one vertex, to second order.
struct Objective {
  double value = 0;
  Vec3 gradient = Vec3::Zero();
  Mat3 hessian = Mat3::Zero();

  /// Adds f^3 / g, with f of Hessian c times identity, and g linear.
  void add(double f, const Vec3& df, double c, double g, const Vec3& dg) {
    if (!(g > 0)) {
      value = infinity;
      return;
    }
    const double q = f * f * f / g;
    const Vec3 log_f = df / f, log_g = dg / g, slope = 3 * log_f - log_g;  // of logarithms
    value += q;
    gradient += q * slope;
    hessian += q * (slope * slope.transpose() + 3 * c / f * Mat3::Identity() -
                    3 * log_f * log_f.transpose() + log_g * log_g.transpose());
  }
};

/// The corners of one face that its corner x is part of; o is the one opposite.
struct FacePart {
  Vec3 next, opposite, previous, normal;
  double size;  ///< square root of its area

  void add_to(Objective& sum, const Vec3& x) const {
    const Vec3 a = (next - x) / size, b = (previous - x) / size;
    const Vec3 c = (opposite - next) / size, d = (opposite - previous) / size;
    const double s = 1 / size;
    sum.add(a.squaredNorm() + b.squaredNorm(), -2 * s * (a + b), 4 * s * s,
            2 * normal.dot(a.cross(b)), 2 * s * normal.cross(b - a));
    sum.add(c.squaredNorm() + a.squaredNorm(), -2 * s * a, 2 * s * s, -2 * normal.dot(c.cross(a)),
            2 * s * normal.cross(c));
    sum.add(b.squaredNorm() + d.squaredNorm(), -2 * s * b, 2 * s * s, -2 * normal.dot(b.cross(d)),
            2 * s * d.cross(normal));
  }
};

/// Unit normal in the middle of a quad; the faces' own, whatever is beyond a kink.
Vec3 normal_of(const Mesh& mesh, FaceId f) {
  const auto corner = mesh.topology.face(f);
  return (mesh.points[corner[2]] - mesh.points[corner[0]])
      .cross(mesh.points[corner[3]] - mesh.points[corner[1]])
      .normalized();
}

using Corner = std::pair<FaceId, int>;

class Smoother {
 public:
  Smoother(Mesh& mesh, const std::vector<double>& areas, const IdArray<VertexId, VertexId>& node,
           const Sliding& sliding)
      : mesh_(mesh),
        areas_(areas),
        node_(node),
        sliding_(sliding),
        corners_(static_cast<std::size_t>(node.size())),
        vertices_(static_cast<std::size_t>(node.size())) {
    const Topology& t = mesh.topology;
    for (int f = 0; f < t.num_faces(); ++f)
      for (int i = 0; i < 4; ++i)
        corners_[node[t.face(FaceId(f))[static_cast<std::size_t>(i)]]].emplace_back(FaceId(f), i);
    for (int v = 0; v < node.size(); ++v)
      vertices_[node[VertexId(v)]].push_back(VertexId(v));
  }

  /// @return how far the vertices moved, relative to their longest sides, at most
  double sweep() {
    double largest = 0;
    for (int v = 0; v < node_.size(); ++v)
      if (!corners_[VertexId(v)].empty()) largest = std::max(largest, move(VertexId(v)));
    return largest;
  }

 private:
  [[nodiscard]] std::vector<FacePart> parts_of(VertexId v) const {
    std::vector<FacePart> out;
    for (const auto& [f, i] : corners_[v]) {
      const auto corner = mesh_.topology.face(f);
      const auto at = [&, i = i](int k) {
        return mesh_.points[corner[static_cast<std::size_t>((i + k) % 4)]];
      };
      out.push_back({at(1), at(2), at(3), normal_of(mesh_, f),
                     std::sqrt(areas_[static_cast<std::size_t>(f.value)])});
    }
    return out;
  }

  static Objective objective(const std::vector<FacePart>& parts, const Vec3& x) {
    Objective sum;
    for (const FacePart& part : parts)
      part.add_to(sum, x);
    return sum;
  }

  /// Downhill in the given directions: Newton's step with the absolute eigenvalues.
  static Vec3 step_of(const Objective& sum, const Eigen::Matrix<double, 3, Eigen::Dynamic>& T) {
    const Eigen::SelfAdjointEigenSolver<MatrixX> eigen(T.transpose() * sum.hessian * T);
    const VectorX size =
        eigen.eigenvalues().cwiseAbs().cwiseMax(1e-6 * eigen.eigenvalues().cwiseAbs().maxCoeff());
    const MatrixX& V = eigen.eigenvectors();
    return -(T * (V * (V.transpose() * (T.transpose() * sum.gradient)).cwiseQuotient(size)));
  }

  double move(VertexId v) {
    const Vec3 x = mesh_.points[v];
    const auto directions = sliding_.directions(v, x);
    if (directions.cols() == 0) return 0;
    const std::vector<FacePart> parts = parts_of(v);
    const Objective here = objective(parts, x);
    if (!std::isfinite(here.value)) return 0;
    double longest = 0;
    for (const FacePart& part : parts)
      longest = std::max({longest, (part.next - x).norm(), (part.previous - x).norm()});
    Vec3 step = step_of(here, directions);
    if (!step.allFinite()) return 0;
    if (step.norm() > 0.5 * longest) step *= 0.5 * longest / step.norm();
    constexpr double shortest = 1e-6;  // of the longest side
    for (; step.norm() > shortest * longest; step /= 2) {
      const Vec3 there = sliding_.placed(v, x + step);
      if (!(objective(parts, there).value < here.value)) continue;
      for (const VertexId w : vertices_[v])
        mesh_.points[w] = there;
      return (there - x).norm() / longest;
    }
    return 0;
  }

  Mesh& mesh_;
  const std::vector<double>& areas_;
  const IdArray<VertexId, VertexId>& node_;
  const Sliding& sliding_;
  IdArray<VertexId, std::vector<Corner>> corners_;     // of nodes
  IdArray<VertexId, std::vector<VertexId>> vertices_;  // of nodes
};

}  // namespace

double corner_distortion(const Vec3& a, const Vec3& b, const Vec3& normal) {
  const double g = 2 * normal.dot(a.cross(b));
  return g > 0 ? (a.squaredNorm() + b.squaredNorm()) / g : infinity;
}

double worst_distortion(const Mesh& quads) {
  double worst = 0;
  for (int f = 0; f < quads.topology.num_faces(); ++f) {
    const auto corner = quads.topology.face(FaceId(f));
    const Vec3 normal = normal_of(quads, FaceId(f));
    const auto at = [&](std::size_t k) { return quads.points[corner[k % 4]]; };
    for (std::size_t i = 0; i < 4; ++i)
      worst = std::max(worst, corner_distortion(at(i + 1) - at(i), at(i + 3) - at(i), normal));
  }
  return worst;
}

std::vector<double> face_areas(const Mesh& mesh) {
  std::vector<double> out;
  for (int f = 0; f < mesh.topology.num_faces(); ++f)
    out.push_back(face_area(mesh, FaceId(f)).area);
  return out;
}

SmoothingResult improve_shapes(Mesh& quads, const std::vector<double>& areas,
                               const IdArray<VertexId, VertexId>& node, const Sliding& sliding,
                               int sweeps) {
  constexpr double settled = 1e-3;
  SmoothingResult result;
  result.worst_before = worst_distortion(quads);
  Smoother smoother(quads, areas, node, sliding);
  while (result.sweeps < sweeps) {
    ++result.sweeps;
    if (smoother.sweep() < settled) break;
  }
  result.worst_after = worst_distortion(quads);
  return result;
}

}  // namespace limes
