#include "limes/space/boundary_trace.h"

#include <Eigen/SVD>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "limes/core/error.h"

namespace limes {
namespace {

/// Adds weight * row to a row.
void add_to(ConstraintRow& row, const ConstraintRow& other, double weight) {
  for (const auto& [dof, w] : other)
    row.emplace_back(dof, weight * w);
}

/// Weights by control vertex of a face as a row over dofs, without zeros.
template <class Weights>
ConstraintRow row_of(const std::vector<int>& dofs, const Weights& weights) {
  ConstraintRow row;
  for (std::size_t i = 0; i < dofs.size(); ++i) {
    const double w = weights(static_cast<Eigen::Index>(i));
    if (w != 0 && dofs[i] >= 0) row.emplace_back(dofs[i], w);
  }
  return row;
}

/// Control values of the cubic B-spline on side c of a regular patch, in the side's direction.
std::array<Eigen::RowVectorXd, 4> spline_of_side(const PatchGrid& D, int c) {
  std::array<Eigen::RowVectorXd, 4> out;
  for (int k = 0; k < 4; ++k) {
    // (across, along) -> row of the grid; across 0, 1, 2 from outside to inside
    const auto row = [&](int across) {
      switch (c) {
        case 0:
          return 4 * across + k;
        case 1:
          return 4 * k + (3 - across);
        case 2:
          return 4 * (3 - across) + (3 - k);
        default:
          return 4 * (3 - k) + across;
      }
    };
    out[static_cast<std::size_t>(k)] = (D.row(row(0)) + 4.0 * D.row(row(1)) + D.row(row(2))) / 6.0;
  }
  return out;
}

/// The spline of a side, if the face is one regular patch.
std::optional<std::vector<ConstraintRow>> regular_side(const SubdivisionSpace& space, HalfedgeId h,
                                                       int region) {
  const LimitBasis& field = space.field();
  const FaceId f = field.adjacency().face(h);
  const auto& patch = field.kinds()[field.kind(f)].patch;
  if (!patch) return {};
  std::vector<ConstraintRow> rows;
  const std::vector<int> dofs = space.face_dofs(f, region);
  for (const Eigen::RowVectorXd& w : spline_of_side(*patch, field.adjacency().corner_index(h)))
    rows.push_back(row_of(dofs, w));
  return rows;
}

int region_of(const SubdivisionSpace& space, HalfedgeId h) {
  return space.region(space.field().adjacency().face(h));
}

ConstraintRow value_at_side(const SubdivisionSpace& space, HalfedgeId h, double s, int region) {
  const LimitBasis& field = space.field();
  const FaceId f = field.adjacency().face(h);
  const SidePoint p = side_point(field, h, s);
  BasisAt basis;
  field.evaluate(f, p.corner, p.uv, 0, basis);
  return row_of(space.face_dofs(f, region), basis.N);
}

/// Enough points to determine a function that is cubic on the pieces of a side: pieces shrink
/// towards both ends and towards the middle, where the quadrants of an n-gon meet.
std::vector<double> points_of_side() {
  constexpr int depth = 6;  // all modes are seen on the outer pieces already
  std::vector<double> points{0.0, 0.5, 1.0};
  for (int k = 2; k < depth; ++k)
    for (int i = 0; i < 4; ++i) {
      const double d = std::ldexp(1.0 + (i + 0.5) / 4.0, -k - 1);
      points.insert(points.end(), {d, 0.5 - d, 0.5 + d, 1.0 - d});
    }
  return points;
}

/// Independent rows with the same null space.
std::vector<ConstraintRow> independent(const std::vector<ConstraintRow>& rows) {
  std::map<int, Eigen::Index> column;
  for (const ConstraintRow& row : rows)
    for (const auto& [dof, w] : row)
      column.emplace(dof, 0);
  std::vector<int> dofs;
  for (auto& [dof, index] : column) {
    index = static_cast<Eigen::Index>(dofs.size());
    dofs.push_back(dof);
  }
  MatrixX M =
      MatrixX::Zero(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(dofs.size()));
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (const auto& [dof, w] : rows[i])
      M(static_cast<Eigen::Index>(i), column[dof]) += w;
  // True singular values go down to 1e-7 of the largest, rounding begins at 1e-15.
  const Eigen::JacobiSVD<MatrixX> svd(M, Eigen::ComputeThinV);
  std::vector<ConstraintRow> out;
  for (Eigen::Index k = 0; k < svd.singularValues().size(); ++k) {
    if (!(svd.singularValues()(k) > 1e-10 * svd.singularValues()(0))) break;
    ConstraintRow row;
    for (Eigen::Index j = 0; j < svd.matrixV().rows(); ++j)
      if (std::abs(svd.matrixV()(j, k)) > 1e-14)
        row.emplace_back(dofs[static_cast<std::size_t>(j)], svd.matrixV()(j, k));
    out.push_back(std::move(row));
  }
  return out;
}

/// Functionals that vanish together if and only if those of all points of a side do.
/// @param row_at  functional at s in [0, 1]
template <class RowAt>
std::vector<ConstraintRow> sampled(const RowAt& row_at) {
  std::vector<ConstraintRow> rows;
  for (const double s : points_of_side())
    rows.push_back(row_at(s));
  return independent(rows);
}

/// The trace of the difference between the copies of two regions: that of h and another.
std::vector<ConstraintRow> difference_on_side(const SubdivisionSpace& space, HalfedgeId h,
                                              int other) {
  const FaceId f = space.field().adjacency().face(h);
  const std::vector<int> own = space.face_dofs(f);
  const std::vector<int> theirs = space.face_dofs(f, other);
  std::map<int, int> copy;
  for (std::size_t a = 0; a < own.size(); ++a)
    if (own[a] >= 0) copy[own[a]] = theirs[a];
  std::vector<ConstraintRow> rows = trace_of_side(space, h);
  for (ConstraintRow& row : rows) {
    const ConstraintRow trace = row;
    for (const auto& [dof, weight] : trace)
      if (copy[dof] >= 0) row.emplace_back(copy[dof], -weight);
  }
  return rows;
}

}  // namespace

SidePoint side_point(const LimitBasis& basis, HalfedgeId h, double s) {
  const Adjacency& a = basis.adjacency();
  const int c = a.corner_index(h);
  const int n = basis.topology().face_size(a.face(h));
  if (n != 4) {
    if (s <= 0.5) return {c, {2 * s, 0}, {2, 0}};
    return {(c + 1) % n, {0, 2 - 2 * s}, {0, -2}};
  }
  switch (c) {
    case 0:
      return {0, {s, 0}, {1, 0}};
    case 1:
      return {0, {1, s}, {0, 1}};
    case 2:
      return {0, {1 - s, 1}, {-1, 0}};
    default:
      return {0, {0, 1 - s}, {0, -1}};
  }
}

std::vector<ConstraintRow> trace_of_side(const SubdivisionSpace& space, HalfedgeId h) {
  const int region = region_of(space, h);
  if (auto rows = regular_side(space, h, region)) return *rows;
  return sampled([&](double s) { return value_at_side(space, h, s, region); });
}

std::vector<ConstraintRow> tie_of_sides(const SubdivisionSpace& space, HalfedgeId a, HalfedgeId b) {
  auto rows = regular_side(space, a, region_of(space, a));
  const auto other = regular_side(space, b, region_of(space, b));
  if (rows && other) {
    for (std::size_t k = 0; k < 4; ++k)
      add_to((*rows)[k], (*other)[3 - k], -1.0);
    return *rows;
  }
  return sampled([&](double s) {
    ConstraintRow row = value_at_side(space, a, s, region_of(space, a));
    add_to(row, value_at_side(space, b, 1.0 - s, region_of(space, b)), -1.0);
    return row;
  });
}

std::vector<ConstraintRow> continuity(const SubdivisionSpace& space) {
  const Adjacency& adjacency = space.geometry().adjacency();
  const auto side = [&](HalfedgeId h) { return h.valid() && space.has_element(adjacency.face(h)); };
  std::vector<ConstraintRow> rows;
  for (int e = 0; e < adjacency.num_edges(); ++e) {
    const HalfedgeId h = adjacency.halfedge(EdgeId(e));
    const HalfedgeId twin = adjacency.twin(h);
    if (!side(h) || !side(twin) || region_of(space, h) == region_of(space, twin)) continue;
    for (ConstraintRow& row : difference_on_side(space, h, region_of(space, twin)))
      rows.push_back(std::move(row));
  }
  return rows;
}

ConstraintRow value_at_vertex(const SubdivisionSpace& space, VertexId v) {
  // On the control mesh's own ring: its halfedges are those of the field's mesh.
  const Adjacency& adjacency = space.geometry().adjacency();
  const HalfedgeId start = adjacency.ring_start(v);
  for (HalfedgeId h = start; h.valid();) {
    if (space.has_element(adjacency.face(h)))
      return value_at_side(space, h, 0.0, region_of(space, h));
    h = adjacency.ring_next(h);
    if (h == start) break;
  }
  // Where vertices hang the ring may be one of several fans that meet in the vertex. It has one value there, which
  // any corner of an element knows: the functions are bilinear.
  if (start.valid() && space.geometry().scheme().patch == LimitPatch::bilinear)
    for (int i = 0; i < adjacency.topology().num_corners(); ++i) {
      const HalfedgeId h(i);
      if (adjacency.from(h) == v && space.has_element(adjacency.face(h)))
        return value_at_side(space, h, 0.0, region_of(space, h));
    }
  return {};
}

std::vector<HalfedgeId> domain_sides(const SubdivisionSpace& space) {
  const Adjacency& adjacency = space.geometry().adjacency();
  std::vector<HalfedgeId> sides;
  for (int i = 0; i < adjacency.topology().num_corners(); ++i) {
    const HalfedgeId h(i);
    const HalfedgeId twin = adjacency.twin(h);
    if (space.has_element(adjacency.face(h)) &&
        !(twin.valid() && space.has_element(adjacency.face(twin))))
      sides.push_back(h);
  }
  return sides;
}

}  // namespace limes
