#include "boundary_tree.h"

#include "limes/core/error.h"

namespace bench {

using namespace limes;

namespace {

MatrixX kronecker(const MatrixX& v, const MatrixX& u) {
  MatrixX out(v.rows() * u.rows(), v.cols() * u.cols());
  for (Eigen::Index i = 0; i < v.rows(); ++i)
    for (Eigen::Index j = 0; j < v.cols(); ++j)
      out.block(i * u.rows(), j * u.cols(), u.rows(), u.cols()) = v(i, j) * u;
  return out;
}

/// Where a point is on its way down: whether 0 is an end in each direction, and its parameters.
struct Place {
  bool end_u, end_v;
  Vec2 uv;

  [[nodiscard]] bool regular() const { return !end_u && !end_v; }
  [[nodiscard]] int half_u() const { return uv.x() > 0.5 ? 1 : 0; }
  [[nodiscard]] int half_v() const { return uv.y() > 0.5 ? 1 : 0; }
  [[nodiscard]] Place below() const {
    return {end_u && half_u() == 0, end_v && half_v() == 0, 2 * uv - Vec2(half_u(), half_v())};
  }
};

Place start(BoundaryTree::Face face, const Vec2& uv) {
  const bool corner = face == BoundaryTree::Face::corner;
  if (!(uv.y() > 0) || (corner && !(uv.x() > 0)))
    throw InputError("({}, {}) is on the boundary, which lies in no regular part of the tree",
                     uv.x(), uv.y());
  return {corner, true, uv};
}

std::size_t step_index(bool end_u, bool end_v, int half_u, int half_v) {
  return (end_u ? 8U : 0U) + (end_v ? 4U : 0U) + static_cast<std::size_t>(2 * half_u + half_v);
}

}  // namespace

MatrixX BoundaryTree::half_step(bool end, int half) {
  Eigen::Matrix<double, 5, 4> all;  // rows: edge, vertex, edge, vertex, edge
  all << 4, 4, 0, 0, 1, 6, 1, 0, 0, 4, 4, 0, 0, 1, 6, 1, 0, 0, 4, 4;
  all /= 8.0;
  if (!end) return all.middleRows(half, 4);
  // Without the first control: its vertex stays, and the rows below are the same.
  Eigen::Matrix<double, 4, 3> from_end = all.bottomRightCorner(4, 3);
  from_end.row(0) << 1, 0, 0;
  return from_end.topRows(half == 0 ? 3 : 4);
}

MatrixX BoundaryTree::left_step() {
  return kronecker(half_step(true, 0), half_step(false, 0));
}

MatrixX BoundaryTree::right_step() {
  return kronecker(half_step(true, 0), half_step(false, 1));
}

BoundaryTree::BoundaryTree(Face face) : face_(face) {
  for (const bool end_u : {false, true})
    for (const bool end_v : {false, true})
      for (const int half_u : {0, 1})
        for (const int half_v : {0, 1})
          steps_[step_index(end_u, end_v, half_u, half_v)] =
              kronecker(half_step(end_v, half_v), half_step(end_u, half_u));
}

SurfaceJet BoundaryTree::evaluate(const Points& controls, const Vec2& uv) const {
  Points points = controls;
  Place at = start(face_, uv);
  double scale = 1;
  for (; !at.regular(); at = at.below(), scale *= 2)
    points = steps_[step_index(at.end_u, at.end_v, at.half_u(), at.half_v())] * points;
  return jet_of(bicubic_weights(at.uv, scale * Mat2::Identity()).transpose() * points);
}

int BoundaryTree::depth(const Vec2& uv) const {
  int levels = 0;
  for (Place at = start(face_, uv); !at.regular(); at = at.below())
    ++levels;
  return levels;
}

std::size_t BoundaryTree::memory() const {
  Eigen::Index numbers = 0;
  for (const MatrixX& step : steps_)
    numbers += step.size();
  return static_cast<std::size_t>(numbers) * sizeof(double);
}

MatrixX phantom_matrix(BoundaryTree::Face face) {
  MatrixX end(4, 3);
  end << 2, -1, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1;
  if (face == BoundaryTree::Face::boundary) return kronecker(end, MatrixX::Identity(4, 4));
  return kronecker(end, end);
}

}  // namespace bench
