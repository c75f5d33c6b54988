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

/// A face that changes its shape when a vertex moves.
struct MovedFace {
  FaceId face;
  /// How far each corner goes when the vertex goes by 1: it itself 1, a vertex that hangs at half of a side
  /// of it 1/2, the others 0.
  std::array<double, 4> weight{};
};

/// Unit normal in the middle of a quad; the faces' own, whatever is beyond a kink.
Vec3 normal_of(const Mesh& mesh, FaceId f) {
  const auto corner = mesh.topology.face(f);
  return (mesh.points[corner[2]] - mesh.points[corner[0]])
      .cross(mesh.points[corner[3]] - mesh.points[corner[1]])
      .normalized();
}

/// The same at one time: what does not change while a step is looked for.
struct FacePart {
  MovedFace moved;
  Vec3 normal;
  double size;  ///< square root of the area it should have

  /// Of the corners whose sides change.
  void add_to(Objective& sum, const Mesh& mesh) const {
    const auto corner = mesh.topology.face(moved.face);
    const auto at = [&](std::size_t k) { return mesh.points[corner[k % 4]]; };
    const auto weight = [&](std::size_t k) { return moved.weight[k % 4]; };
    for (std::size_t k = 0; k < 4; ++k) {
      const double da = (weight(k + 1) - weight(k)) / size, db = (weight(k + 3) - weight(k)) / size;
      if (da == 0 && db == 0) continue;
      const Vec3 a = (at(k + 1) - at(k)) / size, b = (at(k + 3) - at(k)) / size;
      sum.add(a.squaredNorm() + b.squaredNorm(), 2 * (da * a + db * b), 2 * (da * da + db * db),
              2 * normal.dot(a.cross(b)), 2 * (da * b.cross(normal) + db * normal.cross(a)));
    }
  }
};

class Smoother {
 public:
  Smoother(Mesh& mesh, const std::vector<double>& areas, const IdArray<VertexId, VertexId>& node,
           const Sliding& sliding, std::span<const HangingVertex> hanging)
      : mesh_(mesh),
        areas_(areas),
        node_(node),
        sliding_(sliding),
        hangs_(static_cast<std::size_t>(node.size()), 0),
        followers_(static_cast<std::size_t>(node.size())),
        vertices_(static_cast<std::size_t>(node.size())),
        faces_(static_cast<std::size_t>(node.size())) {
    for (const HangingVertex& h : hanging) {
      hangs_[h.vertex] = 1;
      for (const VertexId end : h.ends)
        followers_[node[end]].push_back(h);
    }
    for (int v = 0; v < node.size(); ++v)
      vertices_[node[VertexId(v)]].push_back(VertexId(v));
    find_faces();
  }

  /// @return how far the vertices moved, relative to their longest sides, at most
  double sweep() {
    double largest = 0;
    for (int v = 0; v < node_.size(); ++v)
      if (!faces_[VertexId(v)].empty() && !hangs_[VertexId(v)])
        largest = std::max(largest, move(VertexId(v)));
    return largest;
  }

 private:
  void find_faces() {
    const Topology& t = mesh_.topology;
    for (int f = 0; f < t.num_faces(); ++f)
      for (std::size_t i = 0; i < 4; ++i)
        face_of(node_[t.face(FaceId(f))[i]], FaceId(f)).weight[i] = 1;
    for (int v = 0; v < node_.size(); ++v)
      for (const HangingVertex& h : followers_[VertexId(v)])
        for (const MovedFace& own : faces_[h.vertex])
          for (std::size_t i = 0; i < 4; ++i)
            if (own.weight[i] == 1) face_of(VertexId(v), own.face).weight[i] = 0.5;
  }
  MovedFace& face_of(VertexId v, FaceId f) {
    for (MovedFace& known : faces_[v])
      if (known.face == f) return known;
    return faces_[v].emplace_back(MovedFace{f, {}});
  }

  [[nodiscard]] std::vector<FacePart> parts_of(VertexId v) const {
    std::vector<FacePart> out;
    for (const MovedFace& moved : faces_[v])
      out.push_back({moved, normal_of(mesh_, moved.face),
                     std::sqrt(areas_[static_cast<std::size_t>(moved.face.value)])});
    return out;
  }

  [[nodiscard]] Objective objective(const std::vector<FacePart>& parts) const {
    Objective sum;
    for (const FacePart& part : parts)
      part.add_to(sum, mesh_);
    return sum;
  }

  /// The longest side at the vertex.
  [[nodiscard]] double longest_side(VertexId v) const {
    double longest = 0;
    for (const MovedFace& moved : faces_[v]) {
      const auto corner = mesh_.topology.face(moved.face);
      for (std::size_t i = 0; i < 4; ++i) {
        if (moved.weight[i] != 1) continue;
        for (const std::size_t k : {i + 1, i + 3})
          longest =
              std::max(longest, (mesh_.points[corner[k % 4]] - mesh_.points[corner[i]]).norm());
      }
    }
    return longest;
  }

  /// Downhill in the given directions: Newton's step with the absolute eigenvalues.
  static Vec3 step_of(const Objective& sum, const Eigen::Matrix<double, 3, Eigen::Dynamic>& T) {
    const Eigen::SelfAdjointEigenSolver<MatrixX> eigen(T.transpose() * sum.hessian * T);
    const VectorX size =
        eigen.eigenvalues().cwiseAbs().cwiseMax(1e-6 * eigen.eigenvalues().cwiseAbs().maxCoeff());
    const MatrixX& V = eigen.eigenvectors();
    return -(T * (V * (V.transpose() * (T.transpose() * sum.gradient)).cwiseQuotient(size)));
  }

  /// With what is tied to it, and what hangs in its sides.
  void put(VertexId v, const Vec3& x) {
    for (const VertexId w : vertices_[v])
      mesh_.points[w] = x;
    for (const HangingVertex& h : followers_[v])
      mesh_.points[h.vertex] =
          sliding_.placed(h.vertex, (mesh_.points[h.ends[0]] + mesh_.points[h.ends[1]]) / 2);
  }

  double move(VertexId v) {
    const Vec3 x = mesh_.points[v];
    const auto directions = sliding_.directions(v, x);
    if (directions.cols() == 0) return 0;
    const std::vector<FacePart> parts = parts_of(v);
    const Objective here = objective(parts);
    if (!std::isfinite(here.value)) return 0;
    const double longest = longest_side(v);
    Vec3 step = step_of(here, directions);
    if (!step.allFinite()) return 0;
    if (step.norm() > 0.5 * longest) step *= 0.5 * longest / step.norm();
    std::vector<Vec3> before;
    for (const HangingVertex& h : followers_[v])
      before.push_back(mesh_.points[h.vertex]);
    constexpr double shortest = 1e-6;  // of the longest side
    for (; step.norm() > shortest * longest; step /= 2) {
      const Vec3 there = sliding_.placed(v, x + step);
      put(v, there);
      if (objective(parts).value < here.value) return (there - x).norm() / longest;
    }
    for (const VertexId w : vertices_[v])
      mesh_.points[w] = x;
    for (std::size_t i = 0; i < before.size(); ++i)
      mesh_.points[followers_[v][i].vertex] = before[i];
    return 0;
  }

  Mesh& mesh_;
  const std::vector<double>& areas_;
  const IdArray<VertexId, VertexId>& node_;
  const Sliding& sliding_;
  IdArray<VertexId, char> hangs_;
  IdArray<VertexId, std::vector<HangingVertex>> followers_;  // of nodes: what hangs in their sides
  IdArray<VertexId, std::vector<VertexId>> vertices_;        // of nodes
  IdArray<VertexId, std::vector<MovedFace>> faces_;          // of nodes
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
                               int sweeps, std::span<const HangingVertex> hanging) {
  constexpr double settled = 1e-3;
  SmoothingResult result;
  result.worst_before = worst_distortion(quads);
  Smoother smoother(quads, areas, node, sliding, hanging);
  while (result.sweeps < sweeps) {
    ++result.sweeps;
    if (smoother.sweep() < settled) break;
  }
  result.worst_after = worst_distortion(quads);
  return result;
}

}  // namespace limes
