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

/// Whether corners of a sector are all those of an inner vertex, joined all around.
bool closes(const Adjacency& adjacency, const std::vector<HalfedgeId>& corners,
            const JoinsFaces& joined) {
  return adjacency.ring_next(corners.back()) == corners.front() &&
         joined(adjacency.prev(corners.back()));
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
      patch.inner = patch.faces.size() >= enough_faces && closes(adjacency, patch.corners, joined);
      for (std::size_t last = 0; patch.faces.size() < enough_faces && last != patch.faces.size();) {
        last = patch.faces.size();
        add_joined(adjacency, joined, patch.faces);
      }
      out.push_back(std::move(patch));
    }
  }
  return out;
}

std::vector<std::vector<int>> recovering_patches(const Adjacency& adjacency,
                                                 const std::vector<RecoveryPatch>& patches) {
  IdArray<HalfedgeId, int> patch_of(static_cast<std::size_t>(adjacency.topology().num_corners()));
  for (std::size_t i = 0; i < patches.size(); ++i)
    for (const HalfedgeId h : patches[i].corners)
      patch_of[h] = static_cast<int>(i);
  std::vector<std::vector<int>> out(patches.size());
  for (std::size_t i = 0; i < patches.size(); ++i) {
    std::vector<int>& sources = out[i];
    if (!patches[i].inner)
      for (const HalfedgeId corner : patches[i].corners)
        for (HalfedgeId h = adjacency.next(corner); h != corner; h = adjacency.next(h)) {
          const int other = patch_of[h];
          if (patches[static_cast<std::size_t>(other)].inner &&
              std::find(sources.begin(), sources.end(), other) == sources.end())
            sources.push_back(other);
        }
    if (sources.empty()) sources.push_back(static_cast<int>(i));
  }
  return out;
}

LinearFit linear_fit(const Eigen::Matrix<double, Eigen::Dynamic, 2>& at, const MatrixX& values) {
  LinearFit out;
  out.middle = at.colwise().mean();
  out.value = values.colwise().mean();
  Eigen::CompleteOrthogonalDecomposition<MatrixX> fit;
  fit.setThreshold(1e-6);  // places on one line say nothing across it
  fit.compute(at.rowwise() - out.middle);
  out.slope = fit.solve(MatrixX(values.rowwise() - out.value));
  return out;
}

}  // namespace limes
