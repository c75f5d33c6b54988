#include "refined_ring.h"

#include "limes/core/error.h"
#include "limes/math/spline.h"
#include "limes/subdiv/refinement_step.h"
#include "limes/subdiv/split.h"

namespace bench {

using namespace limes;

RefinedRing refine_ring(const Ring& ring, const Scheme& scheme, int child) {
  const Adjacency adjacency(ring.topology, Adjacency::Check::edges);
  const RefinementStep step(adjacency, ring.features, scheme);
  const Topology fine = step.child_topology();
  const Features fine_features = step.child_features();
  const Adjacency fine_adjacency(fine, Adjacency::Check::edges);
  const Sharpness sharpness(fine_adjacency, fine_features);
  const FaceId face = quadrisection_child(ring.topology.halfedge(FaceId(0), child));
  RefinedRing out{gather_ring(fine_adjacency, fine_features, sharpness, scheme, face), {}};
  const SparseMatrix S = step.matrix();
  out.A = MatrixX::Zero(out.ring.num_controls, ring.num_controls);
  for (int row = 0; row < out.ring.num_controls; ++row) {
    for (SparseMatrix::InnerIterator it(S, out.ring.vertices[static_cast<std::size_t>(row)].value);
         it; ++it) {
      LIMES_ASSERT(it.col() < ring.num_controls);
      out.A(row, it.col()) = it.value();
    }
  }
  return out;
}

Vec2 turned(int child, const Vec2& uv) {
  switch (child) {
    case 0:
      return uv;
    case 1:
      return {uv.y(), 1 - uv.x()};
    case 2:
      return {1 - uv.x(), 1 - uv.y()};
    default:
      return {1 - uv.y(), uv.x()};
  }
}

Mat2 turn(int child) {
  Mat2 J;
  switch (child) {
    case 0:
      J << 1, 0, 0, 1;
      return J;
    case 1:
      J << 0, 1, -1, 0;
      return J;
    case 2:
      J << -1, 0, 0, -1;
      return J;
    default:
      J << 0, -1, 1, 0;
      return J;
  }
}

int quadrant_of(const Vec2& uv) {
  if (uv.x() > 0.5) return uv.y() > 0.5 ? 2 : 1;
  return uv.y() > 0.5 ? 3 : 0;
}

PatchWeights bicubic_weights(const Vec2& st, const Mat2& J) {
  const CubicBSpline s = cubic_bspline(st.x());
  const CubicBSpline t = cubic_bspline(st.y());
  PatchWeights w = PatchWeights::Zero();
  for (std::size_t j = 0; j < 4; ++j) {
    for (std::size_t i = 0; i < 4; ++i) {
      const auto k = static_cast<Eigen::Index>(4 * j + i);
      const Eigen::RowVector2d first(s.first[i] * t.value[j], s.value[i] * t.first[j]);
      Mat2 second;
      second << s.second[i] * t.value[j], s.first[i] * t.first[j], s.first[i] * t.first[j],
          s.value[i] * t.second[j];
      w(k, 0) = s.value[i] * t.value[j];
      w.block<1, 2>(k, 1) = first * J;
      const Mat2 chain = J.transpose() * second * J;
      w.block<1, 3>(k, 3) << chain(0, 0), chain(0, 1), chain(1, 1);
    }
  }
  return w;
}

SurfaceJet jet_of(const Eigen::Matrix<double, 6, 3>& rows) {
  return {rows.row(0), rows.row(1), rows.row(2), rows.row(3), rows.row(4), rows.row(5)};
}

Points controls_of(const Ring& ring, std::span<const Vec3> points) {
  Points out(ring.num_controls, 3);
  for (int k = 0; k < ring.num_controls; ++k)
    out.row(k) = points[static_cast<std::size_t>(ring.vertices[static_cast<std::size_t>(k)].value)];
  return out;
}

}  // namespace bench
