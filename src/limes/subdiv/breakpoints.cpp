#include "limes/subdiv/breakpoints.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "limes/mesh/pieces.h"
#include "limes/subdiv/crease.h"

namespace limes {
namespace {

bool before(const Vec3& a, const Vec3& b) {
  return std::tie(a[0], a[1], a[2]) < std::tie(b[0], b[1], b[2]);
}

/// What the curve vertices at one position know together.
struct Meeting {
  std::vector<Vec3> others;  ///< other ends of the curve edges, elsewhere; no position twice
  int num_parts;
  bool single_face;  ///< a part has one face here
  bool tagged;
};

/// Angle by which a curve turns at x on its way from a to b, in degrees.
double turn(const Vec3& a, const Vec3& x, const Vec3& b) {
  const Vec3 in = x - a, out = b - x;
  return std::atan2(in.cross(out).norm(), in.dot(out)) * 180.0 / std::numbers::pi;
}

bool breaks(const Meeting& m, const Vec3& x, CornerRule rule) {
  if (m.tagged) return true;
  if (!m.others.empty() && m.others.size() != 2) return true;
  if (rule == CornerRule::none) return false;
  if (m.num_parts >= 3) return true;
  if (rule == CornerRule::all) return m.single_face;
  return m.others.size() == 2 && turn(m.others[0], x, m.others[1]) > breakpoint_angle;
}

class BreakpointSearch {
 public:
  BreakpointSearch(const Adjacency& mesh, std::span<const Vec3> points, const Features& features)
      : mesh_(mesh),
        points_(points),
        sharpness_(mesh, features),
        pieces_(mesh.topology().num_vertices()),
        curve_ends_(points.size()),
        single_face_(points.size(), 0) {
    for (int h = 0; h < mesh.topology().num_corners(); ++h)
      visit(HalfedgeId(h));
    for (int v = 0; v < mesh.topology().num_vertices(); ++v)
      if (!ends(VertexId(v)).empty()) vertices_.emplace_back(v);
    std::stable_sort(vertices_.begin(), vertices_.end(),
                     [&](VertexId a, VertexId b) { return before(at(a), at(b)); });
  }

  /// The vertices that break, ascending.
  std::vector<VertexId> run(CornerRule rule) {
    std::vector<VertexId> found;
    for (auto begin = vertices_.begin(); begin != vertices_.end();) {
      const auto end =
          std::upper_bound(begin, vertices_.end(), *begin,
                           [&](VertexId a, VertexId b) { return before(at(a), at(b)); });
      if (breaks(meeting({begin, end}), at(*begin), rule)) found.insert(found.end(), begin, end);
      begin = end;
    }
    std::sort(found.begin(), found.end());
    return found;
  }

 private:
  [[nodiscard]] const Vec3& at(VertexId v) const {
    return points_[static_cast<std::size_t>(v.value)];
  }
  std::vector<VertexId>& ends(VertexId v) { return curve_ends_[static_cast<std::size_t>(v.value)]; }
  [[nodiscard]] bool on_curve(HalfedgeId h) const {
    return is_infinite(sharpness_.edge(mesh_.edge(h)));
  }

  void visit(HalfedgeId h) {
    const VertexId a = mesh_.from(h), b = mesh_.to(h);
    pieces_.join(a.value, b.value);
    if (!on_curve(h)) return;
    if (on_curve(mesh_.prev(h))) single_face_[static_cast<std::size_t>(a.value)] = 1;
    if (mesh_.halfedge(mesh_.edge(h)) != h) return;
    ends(a).push_back(b);
    ends(b).push_back(a);
  }

  Meeting meeting(std::span<const VertexId> vertices) {
    Meeting m{.others = {}, .num_parts = 0, .single_face = false, .tagged = false};
    std::vector<int> parts;
    for (const VertexId v : vertices) {
      parts.push_back(pieces_.find(v.value));
      m.single_face = m.single_face || single_face_[static_cast<std::size_t>(v.value)] != 0;
      m.tagged = m.tagged || is_infinite(sharpness_.vertex(v));
      for (const VertexId other : ends(v))
        if (at(other) != at(v) &&
            std::find(m.others.begin(), m.others.end(), at(other)) == m.others.end())
          m.others.push_back(at(other));
    }
    std::sort(parts.begin(), parts.end());
    m.num_parts = static_cast<int>(std::unique(parts.begin(), parts.end()) - parts.begin());
    return m;
  }

  const Adjacency& mesh_;
  std::span<const Vec3> points_;
  Sharpness sharpness_;
  DisjointSets pieces_;
  std::vector<std::vector<VertexId>> curve_ends_;
  std::vector<char> single_face_;
  std::vector<VertexId> vertices_;  // on curves, by position
};

}  // namespace

void add_breakpoints(const Adjacency& mesh, std::span<const Vec3> points, CornerRule rule,
                     Features& features) {
  for (const VertexId v : BreakpointSearch(mesh, points, features).run(rule))
    features.vertices.push_back({v, infinite_sharpness});
  std::stable_sort(features.vertices.begin(), features.vertices.end(),
                   [](const SharpVertex& a, const SharpVertex& b) { return a.vertex < b.vertex; });
  // A vertex that was tagged keeps its tag, which comes first.
  features.vertices.erase(
      std::unique(features.vertices.begin(), features.vertices.end(),
                  [](const SharpVertex& a, const SharpVertex& b) { return a.vertex == b.vertex; }),
      features.vertices.end());
}

}  // namespace limes
