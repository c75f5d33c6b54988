#include "limes/study/shell_supports.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <tuple>

#include "limes/core/error.h"
#include "limes/mesh/pieces.h"
#include "limes/problem/selection.h"

namespace limes {
namespace {

/// A direction that a support's edges have at a node, and the director of the face there.
struct EdgeEnd {
  VertexId vertex;
  Vec3 tangent, director;
};

/// Ends of the edges; two edges of nearly one direction meet in one end.
std::vector<EdgeEnd> edge_ends(const ShellModel& model, const std::vector<HalfedgeId>& edges) {
  const double straight = std::cos(30 * std::numbers::pi / 180);
  const Adjacency& adjacency = *model.adjacency;
  std::map<VertexId, std::vector<EdgeEnd>> at;
  for (const HalfedgeId h : edges) {
    const VertexId a = adjacency.from(h), b = adjacency.to(h);
    const Vec3 tangent = (model.mesh->points[b] - model.mesh->points[a]).normalized();
    at[a].push_back({a, tangent, model.director[h]});
    at[b].push_back({b, tangent, model.director[adjacency.next(h)]});
  }
  std::vector<EdgeEnd> out;
  for (auto& [vertex, ends] : at) {
    if (ends.size() == 2 && ends[0].tangent.dot(ends[1].tangent) > straight &&
        ends[0].director == ends[1].director) {
      ends[0].tangent += ends[1].tangent;
      ends.pop_back();
    }
    for (EdgeEnd& end : ends) {
      end.tangent -= end.tangent.dot(end.director) * end.director;
      end.tangent.normalize();
      out.push_back(end);
    }
  }
  return out;
}

class SupportRows {
 public:
  SupportRows(const ShellModel& model, std::vector<ConstraintRow>& rows)
      : model_(model), rows_(rows) {}

  void displacement(VertexId v, const Vec3& direction) { add(6 * node(v), direction); }
  void rotation(VertexId v, const Vec3& axis) { add(6 * node(v) + 3, axis); }
  /// The part of theta x V along a direction.
  void turn(const EdgeEnd& end, const Vec3& direction) {
    rotation(end.vertex, end.director.cross(direction));
  }

 private:
  void add(int first, const Vec3& direction) {
    ConstraintRow row;
    for (int i = 0; i < 3; ++i)
      if (direction(i) != 0) row.emplace_back(first + i, direction(i));
    rows_.push_back(std::move(row));
  }
  [[nodiscard]] int node(VertexId v) const { return model_.node[v].value; }

  const ShellModel& model_;
  std::vector<ConstraintRow>& rows_;
};

void add_kind(const SupportSettings& support, const EdgeEnd& end, SupportRows& rows) {
  const Vec3 across = end.director.cross(end.tangent);
  if (support.kind == SupportKind::symmetry) {
    rows.displacement(end.vertex, across);
    rows.turn(end, across);
    rows.rotation(end.vertex, end.director);
    return;
  }
  rows.displacement(end.vertex, end.director);
  rows.displacement(end.vertex, end.tangent);
  if (support.kind != SupportKind::diaphragm) rows.displacement(end.vertex, across);
  if (support.hard) rows.turn(end, end.tangent);
  if (support.kind == SupportKind::clamped)
    for (int i = 0; i < 3; ++i)
      rows.rotation(end.vertex, Vec3::Unit(i));
}

Selection selected(const ShellModel& model, const SupportSettings& support) {
  return {*model.mesh, *model.adjacency, model.mesh->points.span(), support.where,
          support.origin.of("where")};
}

/// Of a support of a kind.
std::vector<HalfedgeId> chosen_edges(const ShellModel& model, const SupportSettings& support) {
  const std::vector<HalfedgeId> edges = selected(model, support).boundary_edges();
  if (edges.empty())
    fail_at(support.origin.of("where"),
            "'{}' selects no boundary edge; both ends of an edge must be selected", support.where);
  return edges;
}

void add_support(const ShellModel& model, const SupportSettings& support,
                 std::vector<ConstraintRow>& out) {
  SupportRows rows(model, out);
  if (support.kind == SupportKind::listed) {
    const Selection chosen = selected(model, support);
    for (int v = 0; v < model.mesh->points.size(); ++v)
      for (int i = 0; i < 6; ++i)
        if (chosen.vertices()[static_cast<std::size_t>(v)] &&
            support.fix[static_cast<std::size_t>(i)])
          i < 3 ? rows.displacement(VertexId(v), Vec3::Unit(i))
                : rows.rotation(VertexId(v), Vec3::Unit(i - 3));
    return;
  }
  for (const EdgeEnd& end : edge_ends(model, chosen_edges(model, support)))
    add_kind(support, end, rows);
}

/// Directions of rows that are about one node each.
void add_directions(const std::vector<ConstraintRow>& rows, HeldDirections& out) {
  for (const ConstraintRow& row : rows) {
    Vec3 direction = Vec3::Zero();
    for (const auto& [unknown, weight] : row)
      direction(unknown % 3) = weight;
    (row.front().first % 6 < 3 ? out.displacement : out.rotation).push_back(direction);
  }
}

/// Normal of the plane in which the ends lie; nothing where they lie on a line or in no plane.
std::optional<Vec3> plane_normal(const ShellModel& model, const std::vector<EdgeEnd>& ends) {
  Vec3 mean = Vec3::Zero();
  for (const EdgeEnd& end : ends)
    mean += model.mesh->points[end.vertex] / static_cast<double>(ends.size());
  Mat3 spread = Mat3::Zero();
  for (const EdgeEnd& end : ends) {
    const Vec3 x = (model.mesh->points[end.vertex] - mean) / model.diagonal;
    spread += x * x.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Mat3> axes(spread);
  const Vec3 squares = axes.eigenvalues() / static_cast<double>(ends.size());
  if (squares(0) > 1e-12 || squares(1) < 1e-6) return {};
  return axes.eigenvectors().col(0);
}

/// Number of the connected piece of the mesh of every vertex, -1 without a face.
std::vector<int> pieces(const ShellModel& model) {
  const Topology& t = model.mesh->topology;
  DisjointSets sets(t.num_vertices());
  for (int f = 0; f < t.num_faces(); ++f)
    for (const VertexId v : t.face(FaceId(f)))
      sets.join(t.face(FaceId(f))[0].value, v.value);
  for (int v = 0; v < t.num_vertices(); ++v)
    sets.join(v, model.node[VertexId(v)].value);
  std::vector<int> root(static_cast<std::size_t>(t.num_vertices()));
  for (int v = 0; v < t.num_vertices(); ++v)
    root[static_cast<std::size_t>(v)] =
        model.adjacency->ring_start(VertexId(v)).valid() ? sets.find(v) : -1;
  return root;
}

/// What a rigid motion (shift, turn about the centre over the diagonal) gives an unknown.
Eigen::Matrix<double, 6, 6> rigid_motions(const ShellModel& model, VertexId v) {
  const Vec3 x = model.mesh->points[v] - model.centre;
  Eigen::Matrix<double, 6, 6> R = Eigen::Matrix<double, 6, 6>::Identity();
  for (int k = 0; k < 3; ++k) {
    Vec3 turn = Vec3::Unit(k);
    R.block<3, 1>(0, 3 + k) = turn.cross(x) / model.diagonal;
    if (model.smooth[v]) {
      const Vec3& V = model.director[model.adjacency->ring_start(v)];
      turn -= turn.dot(V) * V;
    }
    R.block<3, 1>(3, 3 + k) = turn;  // rotations count as displacements at a diagonal's distance
  }
  return R;
}

}  // namespace

std::vector<std::string> remarks_on_symmetry(const ShellModel& model) {
  const double most_slant = 5 * std::numbers::pi / 180;
  std::vector<std::string> out;
  for (const SupportSettings& support : model.problem.supports) {
    if (support.kind != SupportKind::symmetry) continue;
    const std::vector<EdgeEnd> ends = edge_ends(model, chosen_edges(model, support));
    const auto normal = plane_normal(model, ends);
    if (!normal) continue;
    double slant = 0;
    VertexId worst;
    for (const EdgeEnd& end : ends) {
      const double angle = std::asin(std::min(1.0, std::abs(end.director.dot(*normal))));
      if (angle > slant) std::tie(slant, worst) = std::tuple(angle, end.vertex);
    }
    if (slant > most_slant)
      out.push_back(fmt::format(
          "{}: symmetry at '{}' holds too firmly: at vertex {} the director leaves the plane of "
          "the edges by {:.0f} degrees; name a [geometry], or model both halves",
          support.origin.of("where").text, support.where, worst.value,
          slant * 180 / std::numbers::pi));
  }
  return out;
}

ShellConstraints shell_support_constraints(const ShellModel& model) {
  ShellConstraints out;
  for (const SupportSettings& support : model.problem.supports) {
    const int first = static_cast<int>(out.rows.size());
    add_support(model, support, out.rows);
    out.sources.push_back({support.where, first, static_cast<int>(out.rows.size())});
  }
  return out;
}

IdArray<HalfedgeId, HeldDirections> held_along_sides(const ShellModel& model) {
  const Adjacency& adjacency = *model.adjacency;
  const int n = model.mesh->topology.num_corners();
  IdArray<HalfedgeId, HeldDirections> out(static_cast<std::size_t>(n));
  for (const SupportSettings& support : model.problem.supports) {
    if (support.kind == SupportKind::listed) {
      const Selection chosen = selected(model, support);
      const auto is_held = [&](VertexId v) {
        return chosen.vertices()[static_cast<std::size_t>(v.value)];
      };
      for (int h = 0; h < n; ++h)
        for (int i = 0; i < 6; ++i)
          if (support.fix[static_cast<std::size_t>(i)] && is_held(adjacency.from(HalfedgeId(h))) &&
              is_held(adjacency.to(HalfedgeId(h))))
            (i < 3 ? out[HalfedgeId(h)].displacement : out[HalfedgeId(h)].rotation)
                .push_back(Vec3::Unit(i % 3));
      continue;
    }
    for (const HalfedgeId h : chosen_edges(model, support)) {
      const VertexId a = adjacency.from(h), b = adjacency.to(h);
      const Vec3 director = (model.director[h] + model.director[adjacency.next(h)]).normalized();
      const Vec3 chord = model.mesh->points[b] - model.mesh->points[a];
      std::vector<ConstraintRow> rows;
      SupportRows held(model, rows);
      add_kind(support, {a, (chord - chord.dot(director) * director).normalized(), director}, held);
      add_directions(rows, out[h]);
    }
  }
  return out;
}

std::vector<ConstraintRow> drilling_constraints(const ShellModel& model) {
  std::vector<ConstraintRow> out;
  SupportRows rows(model, out);
  for (int v = 0; v < model.mesh->points.size(); ++v) {
    const HalfedgeId h = model.adjacency->ring_start(VertexId(v));
    const bool own = model.node[VertexId(v)] == VertexId(v) && !model.hangs[VertexId(v)];
    if (h.valid() && own && model.smooth[VertexId(v)])
      rows.rotation(VertexId(v), model.director[h]);
    if (h.valid() && own) continue;
    for (int i = 0; i < 6; ++i)  // without faces, with another's unknowns, or hanging
      out.push_back({{6 * v + i, 1.0}});
  }
  return out;
}

void require_no_rigid_motion(const ShellModel& model, const ShellConstraints& supports) {
  using Gram = Eigen::Matrix<double, 6, 6>;
  const std::vector<int> piece = pieces(model);
  std::map<int, Gram> held;
  for (const int p : piece)
    if (p >= 0) held.try_emplace(p, Gram::Zero());
  for (const ConstraintRow& row : supports.rows) {
    if (row.empty()) continue;
    const VertexId v(row.front().first / 6);
    if (piece[static_cast<std::size_t>(v.value)] < 0) continue;
    const Gram R = rigid_motions(model, v);
    Eigen::Matrix<double, 1, 6> on_motions = Eigen::Matrix<double, 1, 6>::Zero();
    for (const auto& [unknown, weight] : row)
      on_motions += weight * R.row(unknown % 6);
    held[piece[static_cast<std::size_t>(v.value)]] += on_motions.transpose() * on_motions;
  }
  for (const auto& [p, gram] : held) {
    const Eigen::SelfAdjointEigenSolver<Gram> motions(gram);
    if (motions.eigenvalues()(0) > 1e-12) continue;
    Eigen::Matrix<double, 6, 1> free = motions.eigenvectors().col(0);
    Eigen::Index largest = 0;
    free.cwiseAbs().maxCoeff(&largest);
    constexpr std::array axes{"x", "y", "z"};
    fail_at(place_of_supports(model.problem),
            "the supports leave the piece of the mesh with vertex {} free to {} {}; hold it there",
            p, largest < 3 ? "move along" : "turn about",
            axes[static_cast<std::size_t>(largest % 3)]);
  }
}

}  // namespace limes
