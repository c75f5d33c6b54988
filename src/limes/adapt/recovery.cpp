#include "limes/adapt/recovery.h"

#include <algorithm>
#include <cmath>

namespace limes {
namespace {

constexpr std::size_t enough_faces = 3;

/// The corners of a vertex in the order of its ring, cut where faces are not joined.
std::vector<std::vector<HalfedgeId>> sectors(const Adjacency& adjacency, VertexId v,
                                             const JoinsFaces& joined) {
  std::vector<std::vector<HalfedgeId>> out;
  const HalfedgeId start = adjacency.ring_start(v);
  HalfedgeId h = start;
  bool continued = false;
  do {
    if (!continued) out.emplace_back();
    out.back().push_back(h);
    const HalfedgeId next = adjacency.ring_next(h);
    continued = next.valid() && joined(adjacency.prev(h));
    h = next;
  } while (h.valid() && h != start);
  if (h.valid() && continued && out.size() > 1) {  // around the start
    out.back().insert(out.back().end(), out.front().begin(), out.front().end());
    out.front() = std::move(out.back());
    out.pop_back();
  }
  return out;
}

void add_joined(const Adjacency& adjacency, const JoinsFaces& joined, std::vector<FaceId>& faces) {
  const std::size_t before = faces.size();
  for (std::size_t i = 0; i < before; ++i) {
    const int size = adjacency.topology().face_size(faces[i]);
    for (int k = 0; k < size; ++k) {
      const HalfedgeId h = adjacency.topology().halfedge(faces[i], k);
      if (!adjacency.twin(h).valid() || !joined(h)) continue;
      const FaceId beyond = adjacency.face(adjacency.twin(h));
      if (std::find(faces.begin(), faces.end(), beyond) == faces.end()) faces.push_back(beyond);
    }
  }
}

}  // namespace

std::vector<RecoveryPatch> recovery_patches(const Adjacency& adjacency, const JoinsFaces& joined) {
  std::vector<RecoveryPatch> out;
  for (int v = 0; v < adjacency.topology().num_vertices(); ++v) {
    if (!adjacency.ring_start(VertexId(v)).valid()) continue;
    for (std::vector<HalfedgeId>& corners : sectors(adjacency, VertexId(v), joined)) {
      RecoveryPatch patch{VertexId(v), std::move(corners), {}};
      for (const HalfedgeId h : patch.corners)
        patch.faces.push_back(adjacency.face(h));
      for (std::size_t last = 0; patch.faces.size() < enough_faces && last != patch.faces.size();) {
        last = patch.faces.size();
        add_joined(adjacency, joined, patch.faces);
      }
      out.push_back(std::move(patch));
    }
  }
  return out;
}

VectorX fitted_at_origin(const Eigen::Matrix<double, Eigen::Dynamic, 2>& at,
                         const MatrixX& values) {
  const Eigen::RowVector2d middle = at.colwise().mean();
  const Eigen::RowVectorXd mean = values.colwise().mean();
  Eigen::CompleteOrthogonalDecomposition<MatrixX> fit;
  fit.setThreshold(1e-6);  // places on one line say nothing across it
  fit.compute(at.rowwise() - middle);
  const MatrixX slope = fit.solve(MatrixX(values.rowwise() - mean));
  return (mean - middle * slope).transpose();
}

}  // namespace limes
