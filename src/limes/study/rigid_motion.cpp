#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "limes/core/error.h"
#include "limes/study/supports.h"

namespace limes {
namespace {

/// Sets of numbers that grow together.
class Sets {
 public:
  explicit Sets(int size) : parent_(static_cast<std::size_t>(size)) {
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

/// Elements that are joined along edges: the smallest things that move as one.
struct Body {
  Vec2 centre = Vec2::Zero();
  double size = 0;
  int num_dofs = 0;
};

/// A condition on the motions of bodies, (x, y, turn times size) for each.
using MotionRow = std::map<int, Vec3>;

class RigidMotions {
 public:
  RigidMotions(const PlaneModel& model, const std::vector<ConstraintRow>& rows)
      : model_(model),
        x_(model.space->position_coefficients()),
        bodies_of_dof_(static_cast<std::size_t>(model.space->num_dofs())) {
    find_bodies();
    for (int a = 0; a < model.space->num_dofs(); ++a)
      for (std::size_t k = 1; k < bodies_of(a).size(); ++k)
        add_joint(a, bodies_of(a)[k]);
    for (const ConstraintRow& row : rows)
      add_constraint(row);
  }

  void require_none() {
    Sets groups(static_cast<int>(bodies_.size()));
    for (const MotionRow& row : rows_)
      for (const auto& [body, value] : row)
        groups.join(body, row.begin()->first);
    std::map<int, std::vector<int>> members;
    for (int b = 0; b < static_cast<int>(bodies_.size()); ++b)
      members[groups.find(b)].push_back(b);
    for (const auto& [group, own] : members)
      require_none_in(own, groups, group);
  }

 private:
  std::vector<int>& bodies_of(int dof) { return bodies_of_dof_[static_cast<std::size_t>(dof)]; }
  [[nodiscard]] Vec2 position(int dof) const { return x_.row(dof).head<2>().transpose(); }

  void find_bodies() {
    const SubdivisionSpace& space = *model_.space;
    const Adjacency& adjacency = model_.neighbours();
    Sets faces(space.mesh().topology.num_faces());
    for (int e = 0; e < adjacency.num_edges(); ++e) {
      const HalfedgeId h = adjacency.halfedge(EdgeId(e));
      const HalfedgeId twin = adjacency.twin(h);
      if (twin.valid() && space.has_element(adjacency.face(h)) &&
          space.has_element(adjacency.face(twin)))
        faces.join(adjacency.face(h).value, adjacency.face(twin).value);
    }
    std::map<int, int> numbers;
    body_of_face_.assign(static_cast<std::size_t>(space.mesh().topology.num_faces()), -1);
    for (int e = 0; e < static_cast<int>(space.elements().size()); ++e) {
      const int root = faces.find(space.elements()[static_cast<std::size_t>(e)].face.value);
      const int body = numbers.emplace(root, static_cast<int>(numbers.size())).first->second;
      body_of_face_[static_cast<std::size_t>(
          space.elements()[static_cast<std::size_t>(e)].face.value)] = body;
      for (const int a : space.dofs(e))
        if (std::find(bodies_of(a).begin(), bodies_of(a).end(), body) == bodies_of(a).end())
          bodies_of(a).push_back(body);
    }
    bodies_.resize(numbers.size());
    measure_bodies();
  }

  void measure_bodies() {
    for (int a = 0; a < model_.space->num_dofs(); ++a)
      for (const int b : bodies_of(a)) {
        body(b).centre += position(a);
        ++body(b).num_dofs;
      }
    for (Body& b : bodies_)
      b.centre /= b.num_dofs;
    for (int a = 0; a < model_.space->num_dofs(); ++a)
      for (const int b : bodies_of(a))
        body(b).size = std::max(body(b).size, (position(a) - body(b).centre).norm());
  }
  Body& body(int b) { return bodies_[static_cast<std::size_t>(b)]; }

  /// The displacement of a dof in direction i, by the motion of a body.
  Vec3 displacement(int dof, int i, int b) {
    const Vec2 d = (position(dof) - body(b).centre) / body(b).size;
    return i == 0 ? Vec3(1, 0, -d.y()) : Vec3(0, 1, d.x());
  }

  /// A dof of two bodies moves with both.
  void add_joint(int dof, int other) {
    for (int i = 0; i < 2; ++i)
      rows_.push_back(
          {{bodies_of(dof)[0], displacement(dof, i, bodies_of(dof)[0]) / std::sqrt(2.0)},
           {other, -displacement(dof, i, other) / std::sqrt(2.0)}});
  }

  void add_constraint(const ConstraintRow& constraint) {
    MotionRow row;
    double square = 0;
    for (const auto& [unknown, weight] : constraint) {
      const int dof = unknown / 2;
      if (bodies_of(dof).empty()) continue;
      const int b = bodies_of(dof)[0];
      row.emplace(b, Vec3::Zero()).first->second += weight * displacement(dof, unknown % 2, b);
      square += weight * weight;
    }
    for (auto& [b, value] : row)
      value /= std::sqrt(square);
    if (!row.empty()) rows_.push_back(std::move(row));
  }

  void require_none_in(const std::vector<int>& own, Sets& groups, int group) {
    std::map<int, int> number;
    for (const int b : own)
      number.emplace(b, static_cast<int>(number.size()));
    std::vector<Triplet> entries;
    for (const MotionRow& row : rows_) {
      if (groups.find(row.begin()->first) != group) continue;
      for (const auto& [b, v] : row)
        for (const auto& [c, w] : row)
          for (int i = 0; i < 9; ++i)
            entries.emplace_back(3 * number[b] + i / 3, 3 * number[c] + i % 3, v(i / 3) * w(i % 3));
    }
    SparseMatrix gram(static_cast<Eigen::Index>(3 * own.size()),
                      static_cast<Eigen::Index>(3 * own.size()));
    gram.setFromTriplets(entries.begin(), entries.end());
    const VectorX motion = free_motion(gram);
    if (motion.size() == 0) return;
    std::size_t most = 0;  // the body that moves most
    for (std::size_t k = 0; k < own.size(); ++k)
      if (part(motion, k).norm() > (1 + 1e-6) * part(motion, most).norm()) most = k;
    fail_at(place_of_supports(model_.problem),
            "the model can still {}; hold it there with a [[support]]",
            describe(part(motion, most), own[most]));
  }
  static Vec3 part(const VectorX& motion, std::size_t k) {
    return motion.segment<3>(static_cast<Eigen::Index>(3 * k));
  }

  /// A motion that no row feels, empty if there is none; a shift along an axis where that is one.
  static VectorX free_motion(const SparseMatrix& gram) {
    constexpr double nothing = 1e-10;
    const auto is_free = [&](const VectorX& m) {
      return m.dot(gram * m) <= nothing * m.squaredNorm();
    };
    for (Eigen::Index axis = 0; axis < 2; ++axis) {
      VectorX shift = VectorX::Zero(gram.rows());
      for (Eigen::Index k = axis; k < shift.size(); k += 3)
        shift(k) = 1;
      if (is_free(shift)) return shift;
    }
    VectorX motion = lowest_mode(gram);
    return is_free(motion) ? motion : VectorX();
  }

  /// Inverse iteration for the lowest eigenvector of a positive semidefinite matrix.
  static VectorX lowest_mode(const SparseMatrix& gram) {
    using Columns = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;
    Columns shifted = gram;
    Columns unit(gram.rows(), gram.cols());
    unit.setIdentity();
    shifted += 1e-12 * unit;
    const Eigen::SimplicialLDLT<Columns> solver(shifted);
    VectorX mode(gram.rows());
    for (Eigen::Index i = 0; i < mode.size(); ++i)
      mode(i) = 1.0 + 0.5 * std::sin(1.0 + static_cast<double>(i));  // along no axis
    for (int step = 0; step < 6; ++step)
      mode = solver.solve(mode.normalized());
    return mode.normalized();
  }

  std::string describe(const Vec3& motion, int b) {
    const Body& piece = body(b);
    const std::string where =
        bodies_.size() > 1 ? fmt::format(" (the piece around ({:.6g}, {:.6g}), of {} pieces)",
                                         piece.centre.x(), piece.centre.y(), bodies_.size())
                           : "";
    const Vec2 shift = motion.head<2>() / motion.norm();
    const double turn = motion(2) / motion.norm() / piece.size;
    if (std::abs(turn) * piece.size < 1e-3) {
      if (std::abs(shift.y()) < 1e-3) return "move along x" + where;
      if (std::abs(shift.x()) < 1e-3) return "move along y" + where;
      return fmt::format("move along ({:.3g}, {:.3g})", shift.x(), shift.y()) + where;
    }
    // u = shift + turn (-(y - cy), x - cx) vanishes at the centre of rotation
    const Vec2 fixed = piece.centre + Vec2(-shift.y(), shift.x()) / turn;
    const std::string text = fmt::format("turn about ({:.6g}, {:.6g})", fixed.x(), fixed.y());
    const VertexId hinge = vertex_at(fixed, 1e-6 * piece.size);
    if (!hinge.valid()) return text + where;
    return fmt::format("{}, vertex {}, where pieces touch in one point{}", text, hinge.value,
                       where);
  }

  [[nodiscard]] bool is_hinge(VertexId v) const {
    const Adjacency& adjacency = model_.neighbours();
    int first = -1;
    HalfedgeId h = adjacency.ring_start(v);
    for (int i = 0; h.valid() && i < adjacency.num_ring_faces(v); ++i, h = adjacency.ring_next(h)) {
      const int b = body_of_face_[static_cast<std::size_t>(adjacency.face(h).value)];
      if (first >= 0 && b >= 0 && b != first) return true;
      if (b >= 0) first = b;
    }
    return false;
  }

  /// The control vertex, used by several bodies, whose limit point this is.
  VertexId vertex_at(const Vec2& x, double tolerance) {
    for (int v = 0; v < model_.mesh().points.size(); ++v) {
      const VertexId vertex(v);
      if ((model_.limit_points[vertex].head<2>() - x).norm() <= tolerance && is_hinge(vertex))
        return vertex;
    }
    return {};
  }

  const PlaneModel& model_;
  Eigen::Matrix<double, Eigen::Dynamic, 3> x_;
  std::vector<Body> bodies_;
  std::vector<std::vector<int>> bodies_of_dof_;
  std::vector<int> body_of_face_;  ///< -1 for holes
  std::vector<MotionRow> rows_;
};

}  // namespace

void require_no_rigid_motion(const PlaneModel& model, const std::vector<ConstraintRow>& rows) {
  RigidMotions(model, rows).require_none();
}

}  // namespace limes
