#include <Eigen/Eigenvalues>
#include <cmath>
#include <map>
#include <numeric>

#include "limes/core/error.h"
#include "limes/study/supports.h"

namespace limes {
namespace {

/// Sets of numbers that grow together.
class Pieces {
 public:
  explicit Pieces(int size) : parent_(static_cast<std::size_t>(size)) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  int find(int i) {
    while (parent(i) != i)
      i = parent(i) = parent(parent(i));
    return i;
  }
  void join(int i, int j) {
    const int a = find(i);
    const int b = find(j);
    parent(std::max(a, b)) = std::min(a, b);
  }

 private:
  int& parent(int i) { return parent_[static_cast<std::size_t>(i)]; }
  std::vector<int> parent_;
};

/// Pieces of the model, by dof.
Pieces connected_pieces(const SubdivisionSpace& space, const std::vector<ConstraintRow>& rows) {
  Pieces pieces(space.num_dofs());
  for (int e = 0; e < static_cast<int>(space.elements().size()); ++e)
    for (const int a : space.dofs(e))
      pieces.join(a, space.dofs(e)[0]);
  for (const ConstraintRow& row : rows)
    for (const auto& [unknown, weight] : row)
      pieces.join(unknown / 2, row.front().first / 2);
  return pieces;
}

/// Constraint rows applied to the three rigid motions of a piece about its centre.
struct Motions {
  Vec2 centre = Vec2::Zero();
  double size = 0;
  int num_dofs = 0;
  Mat3 gram = Mat3::Zero();  ///< of the rows, each scaled to length 1
};

std::string describe(const Vec3& motion, const Motions& piece) {
  const double turn = motion(2) / piece.size;
  const Vec2 shift = motion.head<2>();
  if (std::abs(motion(2)) < 1e-3) {
    if (std::abs(shift.y()) < 1e-3) return "move along x";
    if (std::abs(shift.x()) < 1e-3) return "move along y";
    return fmt::format("move along ({:.3g}, {:.3g})", shift.x(), shift.y());
  }
  // u = shift + turn (-(y - cy), x - cx) vanishes at the centre of rotation
  const Vec2 fixed = piece.centre + Vec2(-shift.y(), shift.x()) / turn;
  return fmt::format("turn about ({:.6g}, {:.6g})", fixed.x(), fixed.y());
}

}  // namespace

void require_no_rigid_motion(const PlaneModel& model, const std::vector<ConstraintRow>& rows) {
  const SubdivisionSpace& space = *model.space;
  const auto x = space.position_coefficients();
  Pieces pieces = connected_pieces(space, rows);
  std::map<int, Motions> motions;
  for (int a = 0; a < space.num_dofs(); ++a) {
    Motions& m = motions[pieces.find(a)];
    m.centre += x.row(a).head<2>().transpose();
    ++m.num_dofs;
  }
  for (auto& [piece, m] : motions)
    m.centre /= m.num_dofs;
  for (int a = 0; a < space.num_dofs(); ++a) {
    Motions& m = motions[pieces.find(a)];
    m.size = std::max(m.size, (x.row(a).head<2>().transpose() - m.centre).norm());
  }
  for (const ConstraintRow& row : rows) {
    Motions& m = motions[pieces.find(row.front().first / 2)];
    Vec3 value = Vec3::Zero();
    double scale = 0;
    for (const auto& [unknown, weight] : row) {
      const Vec2 d = (x.row(unknown / 2).head<2>().transpose() - m.centre) / m.size;
      value += weight * (unknown % 2 == 0 ? Vec3(1, 0, -d.y()) : Vec3(0, 1, d.x()));
      scale += weight * weight;
    }
    m.gram += value * value.transpose() / scale;
  }
  for (const auto& [piece, m] : motions) {
    const Eigen::SelfAdjointEigenSolver<Mat3> solver(m.gram);
    if (solver.eigenvalues()(0) > 1e-10) continue;
    throw InputError("{}: the model can still {}{}; hold it there with a [[support]]",
                     model.problem.file.string(), describe(solver.eigenvectors().col(0), m),
                     motions.size() > 1
                         ? fmt::format(" (the piece around ({:.6g}, {:.6g}), of {} pieces)",
                                       m.centre.x(), m.centre.y(), motions.size())
                         : "");
  }
}

}  // namespace limes
