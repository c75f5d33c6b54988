#include "limes/subdiv/coarsen_positions.h"

#include <Eigen/SparseCholesky>

#include "limes/core/error.h"
#include "limes/core/interrupt.h"
#include "limes/subdiv/crease.h"
#include "limes/subdiv/refinement_step.h"
#include "limes/subdiv/schemes.h"
#include "limes/subdiv/split.h"

namespace limes {
namespace {

using Points = Eigen::Matrix<double, Eigen::Dynamic, 3>;

/// The fine vertex of every row of S.
std::vector<VertexId> rows_of(const Adjacency& fine, const Unsplit& coarse,
                              const Adjacency& adjacency) {
  std::vector<VertexId> rows = coarse.old_vertex;
  for (int e = 0; e < adjacency.num_edges(); ++e)
    rows.push_back(fine.to(coarse.half[adjacency.halfedge(EdgeId(e))]));
  rows.insert(rows.end(), coarse.face_point.begin(), coarse.face_point.end());
  return rows;
}

/// Solves S x = y by normal equations, then takes their squared condition back out: two or three
/// corrections by the residual of S itself reach the accuracy of an orthogonal method.
Points least_squares(const SparseMatrix& S, const Points& y, bool unique) {
  constexpr int corrections = 3;
  Eigen::SparseMatrix<double> A = S.transpose() * S;
  if (!unique) A.coeffRef(0, 0) += 1.0;  // picks one of the solutions: the first vertex near 0
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(A);
  if (factor.info() != Eigen::Success)
    throw SolverError("coarsening: the equations for the old vertices cannot be solved");
  Points x = factor.solve(S.transpose() * y);
  for (int i = 0; i < corrections; ++i) {
    check_interrupt();
    const Points residual = y - S * x;
    x += factor.solve(S.transpose() * residual);
  }
  return x;
}

/// Whether the ends of all edges can have opposite signs. Precondition: connected.
bool is_bipartite(const Adjacency& adjacency) {
  const Topology& topology = adjacency.topology();
  IdArray<VertexId, int> sign(static_cast<std::size_t>(topology.num_vertices()), 0);
  std::vector<VertexId> queue{topology.corner(HalfedgeId(0))};
  sign[queue.front()] = 1;
  for (std::size_t next = 0; next < queue.size(); ++next) {
    const VertexId v = queue[next];
    const HalfedgeId start = adjacency.ring_start(v);
    for (HalfedgeId h = start; h.valid();) {
      const VertexId w = adjacency.to(h);
      if (sign[w] == sign[v]) return false;
      if (sign[w] == 0) queue.push_back(w);
      sign[w] = -sign[v];
      h = adjacency.ring_next(h);
      if (h == start) break;
    }
  }
  return true;
}

}  // namespace

bool has_unique_positions(const Adjacency& adjacency, const Features& features) {
  const int num_vertices = adjacency.topology().num_vertices();
  IdArray<VertexId, int> sharp_edges(static_cast<std::size_t>(num_vertices), 0);
  for (const SharpEdge& e : features.edges) {
    ++sharp_edges[adjacency.from(e.halfedge)];
    ++sharp_edges[adjacency.to(e.halfedge)];
  }
  if (!features.vertices.empty()) return true;
  for (int v = 0; v < num_vertices; ++v)
    if (adjacency.is_boundary(VertexId(v)) || adjacency.valence(VertexId(v)) != 3 ||
        sharp_edges[VertexId(v)] >= 2)
      return true;
  return !is_bipartite(adjacency);
}

CoarsePositions solve_positions(const Adjacency& fine, const Unsplit& coarse,
                                const Adjacency& adjacency, const Features& features,
                                const Scheme& scheme, std::span<const Vec3> fine_points) {
  const RefinementStep step(adjacency, features, scheme);
  const SparseMatrix S = step.matrix();
  const std::vector<VertexId> rows = rows_of(fine, coarse, adjacency);
  LIMES_ASSERT(static_cast<Eigen::Index>(rows.size()) == S.rows());
  const auto point = [&](VertexId v) { return fine_points[static_cast<std::size_t>(v.value)]; };
  // Rows of S sum to 1: a shift of the origin is exact, and far from it no digits are lost.
  const Vec3 origin = point(rows[0]);
  Points y(S.rows(), 3);
  for (Eigen::Index i = 0; i < y.rows(); ++i)
    y.row(i) = (point(rows[static_cast<std::size_t>(i)]) - origin).transpose();

  CoarsePositions out;
  // Loop forgets nothing: the vertex rule keeps more than half of a vertex, see theory/coarsen.md.
  out.unique = scheme.split != Split::quads || has_unique_positions(adjacency, features);
  const Points x = least_squares(S, y, out.unique);
  for (Eigen::Index i = 0; i < x.rows(); ++i)
    out.points.emplace_back(x.row(i).transpose() + origin);
  Eigen::Index worst = 0;
  out.residual = (y - S * x).rowwise().norm().maxCoeff(&worst);
  out.worst = rows[static_cast<std::size_t>(worst)];
  return out;
}

CoarsePositions kept_positions(const Adjacency& fine, const Unsplit& coarse,
                               const Adjacency& adjacency, const Features& features,
                               const Scheme& scheme, std::span<const Vec3> fine_points) {
  const auto point = [&](VertexId v) { return fine_points[static_cast<std::size_t>(v.value)]; };
  CoarsePositions out{{}, 0.0, {}, true};
  for (const VertexId v : coarse.old_vertex)
    out.points.push_back(point(v));
  const RefinementStep step(adjacency, features, scheme);
  std::vector<Vec3> refined(static_cast<std::size_t>(step.num_child_vertices()));
  step.apply(out.points, refined);
  const std::vector<VertexId> rows = rows_of(fine, coarse, adjacency);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double distance = (refined[i] - point(rows[i])).norm();
    if (i > 0 && distance <= out.residual) continue;
    out.residual = distance;
    out.worst = rows[i];
  }
  return out;
}

}  // namespace limes
