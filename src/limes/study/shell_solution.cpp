#include "limes/study/shell_solution.h"

#include <cmath>

#include "limes/core/error.h"
#include "limes/core/interrupt.h"
#include "limes/core/parallel.h"
#include "limes/fem/drilling.h"
#include "limes/solve/linear.h"
#include "limes/study/shell_hanging.h"
#include "limes/study/shell_loads.h"
#include "limes/study/shell_supports.h"

namespace limes {
namespace {

ShellResultant resultant_of(const ShellModel& model, const VectorX& f, const Vec3& about) {
  ShellResultant out;
  for (int v = 0; v < model.mesh->points.size(); ++v) {
    const Vec3 force = f.segment<3>(6 * v);
    out.force += force;
    out.moment += (model.mesh->points[VertexId(v)] - about).cross(force) + f.segment<3>(6 * v + 3);
  }
  return out;
}

/// Rows of length 1.
SparseMatrix row_matrix(const std::vector<ConstraintRow>& rows, int num_unknowns) {
  std::vector<Triplet> entries;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    double square = 0;
    for (const auto& entry : rows[r])
      square += entry.second * entry.second;
    for (const auto& [unknown, weight] : rows[r])
      entries.emplace_back(static_cast<int>(r), unknown, weight / std::sqrt(square));
  }
  SparseMatrix C(static_cast<Eigen::Index>(rows.size()), num_unknowns);
  C.setFromTriplets(entries.begin(), entries.end());
  return C;
}

/// Splits the residual H^T (K u - f) = C^T lambda, carried from hanging nodes, among the supports. Conditions that two supports share are
/// carried by both.
void set_reactions(const ShellModel& model, const ShellConstraints& supports, const VectorX& f,
                   const VectorX& residual, ShellSolution& solution) {
  const SparseMatrix C = row_matrix(supports.rows, model.num_unknowns());
  const VectorX lambda = DirectSolver(SparseMatrix(C * C.transpose())).solve(C * residual);
  solution.imbalance = resultant_of(model, f, model.centre);
  for (const ShellConstraints::Source& source : supports.sources) {
    VectorX own = VectorX::Zero(residual.size());
    for (int r = source.first; r < source.last; ++r)
      for (SparseMatrix::InnerIterator it(C, r); it; ++it)
        own(it.col()) += lambda(r) * it.value();
    solution.reactions.push_back({source.where, resultant_of(model, own, Vec3::Zero())});
    const ShellResultant part = resultant_of(model, own, model.centre);
    solution.imbalance.force += part.force;
    solution.imbalance.moment += part.moment;
  }
}

/// With x_d = c_r x_r + c_s x_s + ..., see docs/theory/mitc4.md, elements with |c_r| + |c_s| >= 1 are not
/// convex; they fold over at a Gauss point from sqrt(3) on, and assumed membrane strains ask for
/// c_r^2 + c_s^2 < 1 besides.
void require_nearly_convex(const ShellModel& model) {
  for (int f = 0; f < model.mesh->topology.num_faces(); ++f) {
    const ShellQuad quad = model.quad(FaceId(f));
    const Vec3 up = quad.area_normal({0, 0});
    const auto area = [&](double r, double s) {
      return quad.area_normal({r, s}).dot(up) / up.squaredNorm();
    };
    const double cr = (area(0, 1) - area(0, -1)) / 2, cs = (area(1, 0) - area(-1, 0)) / 2;
    if (std::abs(cr) + std::abs(cs) < std::sqrt(3.0) && cr * cr + cs * cs < 1) continue;
    const int corner = cr > 0 ? (cs > 0 ? 0 : 1) : (cs > 0 ? 3 : 2);
    throw InputError(
        "{}: face {} of the refined mesh is far from convex at its corner {}; membrane = "
        "\"assumed\" needs faces that are nearly so",
        mesh_path(model.problem).string(), f, corner);
  }
}

double load_size(const VectorX& f) {
  double sum = 0;
  for (Eigen::Index v = 0; v < f.size() / 6; ++v)
    sum += f.segment<3>(6 * v).norm();
  return sum;
}

/// With drilling stiffness at the nodes on kinks; the others have no rotation about their director.
ShellMatrix element_stiffness(const ShellModel& model, FaceId f) {
  const ShellMatrix K = mitc4_stiffness(model.quad(f), model.section(f));
  const double factor = model.problem.model.drilling;
  if (factor == 0) return K;
  std::array<bool, 4> on_kink{};
  for (std::size_t i = 0; i < 4; ++i)
    on_kink[i] = !model.smooth[model.mesh->topology.corner(model.corner(f, static_cast<int>(i)))];
  return K + drilling_stiffness(model.quad(f), model.section(f), on_kink, factor);
}

}  // namespace

ShellResultants resultants_at(const ShellModel& model, const ShellSolution& solution, FaceId face,
                              const Vec2& rs) {
  return mitc4_resultants(model.quad(face), model.section(face), model.unknowns(face, solution.u),
                          rs);
}

SparseMatrix shell_matrix(const ShellModel& model) {
  const Topology& t = model.mesh->topology;
  const int n = t.num_faces();
  std::vector<ShellMatrix> element(static_cast<std::size_t>(n));
  for_each_index(n, [&](std::int64_t f) {
    element[static_cast<std::size_t>(f)] = element_stiffness(model, FaceId(f));
  });
  std::vector<Triplet> entries;
  entries.reserve(static_cast<std::size_t>(n) * 576);
  for (int f = 0; f < n; ++f)
    for (int i = 0; i < 24; ++i)
      for (int j = 0; j < 24; ++j)
        entries.emplace_back(6 * model.node_at(FaceId(f), i / 6).value + i % 6,
                             6 * model.node_at(FaceId(f), j / 6).value + j % 6,
                             element[static_cast<std::size_t>(f)](i, j));
  SparseMatrix K(model.num_unknowns(), model.num_unknowns());
  K.setFromTriplets(entries.begin(), entries.end());
  return K;
}

ShellSolution solve_shell(const ShellModel& model) {
  if (model.problem.model.assumed_membrane) require_nearly_convex(model);
  ShellSolution solution;
  ShellConstraints supports = shell_support_constraints(model);
  require_no_rigid_motion(model, supports);
  const SparseMatrix H = hanging_transfer(model);
  supports.rows = carried(supports.rows, H);
  std::vector<ConstraintRow> rows = drilling_constraints(model);
  rows.insert(rows.end(), supports.rows.begin(), supports.rows.end());
  const VectorX f = assemble_shell_loads(model);
  check_interrupt();
  const SparseMatrix K = shell_matrix(model);
  const Elimination fix = eliminate(model.num_unknowns(), rows);
  check_interrupt();
  const SparseMatrix T = H * fix.T;
  const SparseMatrix reduced = T.transpose() * K * T;
  const VectorX load = T.transpose() * f;
  const DirectSolver solver(reduced);
  const MatrixX free = solver.solve(load);
  solution.num_unknowns = fix.num_free();
  for (int v = 0; v < model.smooth.size(); ++v)
    solution.num_kink_nodes += !model.smooth[VertexId(v)] && !model.hangs[VertexId(v)] &&
                               model.node[VertexId(v)] == VertexId(v);
  solution.solver_residual = solver.relative_residual(free, load);
  solution.rounding_floor = solver.rounding_floor(free, load);
  solution.u = T * free;
  const VectorX internal = K * solution.u;
  solution.strain_energy = 0.5 * solution.u.dot(internal);
  solution.load_size = load_size(f);
  solution.loads = resultant_of(model, f, Vec3::Zero());
  set_reactions(model, supports, f, H.transpose() * (internal - f), solution);
  for (int v = 0; v < model.node.size(); ++v)  // tied vertices show what their node does
    solution.u.segment<6>(6 * v) =
        VectorX(solution.u.segment<6>(6 * model.node[VertexId(v)].value));
  return solution;
}

std::vector<SolutionCheck> check_solution(const ShellModel& model, const ShellSolution& solution) {
  const double scale = solution.load_size > 0 ? solution.load_size : 1.0;
  const double limit = std::max(1e-8, solution.rounding_floor);
  return {{"residual of the linear solver", solution.solver_residual,
           std::max(1e-9, solution.rounding_floor)},
          {"equilibrium of forces", solution.imbalance.force.norm() / scale, limit},
          {"equilibrium of moments", solution.imbalance.moment.norm() / (scale * model.diagonal),
           limit}};
}

}  // namespace limes
