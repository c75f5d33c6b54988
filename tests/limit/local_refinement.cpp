#include "limit/local_refinement.h"

#include <algorithm>
#include <array>

#include "limes/subdiv/refinement_step.h"
#include "limes/subdiv/split.h"

namespace limes::test {
namespace {

/// Marks the faces that share a vertex with the marked ones, `rings` times.
std::vector<bool> faces_around(const Topology& topology, FaceId face, int rings) {
  std::vector<bool> marked(static_cast<std::size_t>(topology.num_faces()), false);
  marked[static_cast<std::size_t>(face.value)] = true;
  for (int r = 0; r < rings; ++r) {
    std::vector<bool> touched(static_cast<std::size_t>(topology.num_vertices()), false);
    for (int f = 0; f < topology.num_faces(); ++f)
      if (marked[static_cast<std::size_t>(f)])
        for (const VertexId v : topology.face(FaceId(f)))
          touched[static_cast<std::size_t>(v.value)] = true;
    for (int f = 0; f < topology.num_faces(); ++f)
      for (const VertexId v : topology.face(FaceId(f)))
        if (touched[static_cast<std::size_t>(v.value)]) marked[static_cast<std::size_t>(f)] = true;
  }
  return marked;
}

/// The model without all other faces; face becomes the id of the face there. The order of faces and
/// corners stays. Creases that the cut makes boundary are left out.
Model cut_out(const Model& model, int rings, FaceId& face) {
  const Topology& topology = model.topology;
  const std::vector<bool> keep = faces_around(topology, face, rings);
  std::vector<int> new_vertex(static_cast<std::size_t>(topology.num_vertices()), -1);
  std::vector<int> new_halfedge(static_cast<std::size_t>(topology.num_corners()), -1);
  std::vector<int> offsets{0};
  std::vector<VertexId> corners;
  Model out;
  FaceId new_face;
  for (int f = 0; f < topology.num_faces(); ++f) {
    if (!keep[static_cast<std::size_t>(f)]) continue;
    if (FaceId(f) == face) new_face = FaceId(static_cast<int>(offsets.size()) - 1);
    for (int i = 0; i < topology.face_size(FaceId(f)); ++i) {
      const HalfedgeId h = topology.halfedge(FaceId(f), i);
      int& v = new_vertex[static_cast<std::size_t>(topology.corner(h).value)];
      if (v < 0) {
        v = static_cast<int>(out.points.size());
        out.points.push_back(model.points[static_cast<std::size_t>(topology.corner(h).value)]);
      }
      new_halfedge[static_cast<std::size_t>(h.value)] = static_cast<int>(corners.size());
      corners.emplace_back(v);
    }
    offsets.push_back(static_cast<int>(corners.size()));
  }
  face = new_face;
  out.topology = Topology(static_cast<int>(out.points.size()), offsets, corners);
  static_cast<RuleOptions&>(out.features) = model.features;
  for (const SharpVertex& v : model.features.vertices)
    if (new_vertex[static_cast<std::size_t>(v.vertex.value)] >= 0)
      out.features.vertices.push_back(
          {VertexId(new_vertex[static_cast<std::size_t>(v.vertex.value)]), v.sharpness});
  std::sort(out.features.vertices.begin(), out.features.vertices.end(),
            [](const SharpVertex& a, const SharpVertex& b) { return a.vertex < b.vertex; });
  const Adjacency old(topology, Adjacency::Check::edges);
  for (const SharpEdge& e : model.features.edges) {
    const int a = new_halfedge[static_cast<std::size_t>(e.halfedge.value)];
    const int b = new_halfedge[static_cast<std::size_t>(old.twin(e.halfedge).value)];
    if (a >= 0 && b >= 0) out.features.edges.push_back({HalfedgeId(std::min(a, b)), e.sharpness});
  }
  std::sort(out.features.edges.begin(), out.features.edges.end(),
            [](const SharpEdge& a, const SharpEdge& b) { return a.halfedge < b.halfedge; });
  return out;
}

Model refined(const Model& model, const Scheme& scheme) {
  const Adjacency adjacency(model.topology, Adjacency::Check::edges);
  const RefinementStep step(adjacency, model.features, scheme);
  Model child{step.child_topology(), step.child_features(), {}};
  child.points.resize(static_cast<std::size_t>(step.num_child_vertices()));
  step.apply(model.points, child.points);
  return child;
}

}  // namespace

Model make_model(const Mesh& mesh, BoundaryRule boundary) {
  return {mesh.topology, resolve_tags(Adjacency(mesh.topology), mesh.tags, boundary),
          mesh.points.vector()};
}

void perturb(Mesh& mesh, double amount, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> shift(-amount, amount);
  for (Vec3& x : mesh.points)
    for (int k = 0; k < 3; ++k)
      x[k] += shift(random);
}

namespace {

/// The piece of a model around the sub-face that holds a point, and the point's parameters there.
struct Piece {
  Model model;
  FaceId face;
  Vec2 uv;
  Mat2 J = Mat2::Identity();   ///< d(uv there) / d(uv of the face at the start)
  Vec3 origin = Vec3::Zero();  ///< to be added to the points
};

void step_towards_point(Piece& p, const Scheme& scheme, int corner) {
  const int rings = p.model.features.crease_method == CreaseMethod::chaikin ? 3 : 2;
  p.model = cut_out(p.model, rings, p.face);
  const Topology& topology = p.model.topology;
  const Vec3 centre = p.model.points[static_cast<std::size_t>(topology.face(p.face)[0].value)];
  for (Vec3& x : p.model.points)
    x -= centre;
  p.origin += centre;
  if (scheme.split == Split::triangles) {
    // Weights of the corners; the child in the middle has its corners opposite ours.
    const std::array<double, 3> w{1 - p.uv.x() - p.uv.y(), p.uv.x(), p.uv.y()};
    const auto largest = std::max_element(w.begin(), w.end()) - w.begin();
    const auto weight = [&](std::ptrdiff_t i) { return w[static_cast<std::size_t>(i % 3)]; };
    const bool middle = weight(largest) <= 0.5;
    p.uv = middle ? Vec2(1 - 2 * w[0], 1 - 2 * w[1])
                  : Vec2(2 * weight(largest + 1), 2 * weight(largest + 2));
    const FaceId next(4 * p.face.value + (middle ? 3 : static_cast<int>(largest)));
    p.model = refined(p.model, scheme);
    p.face = next;
    return;
  }
  int child = corner;
  if (topology.face_size(p.face) == 4) {
    const double u = p.uv.x();
    const double v = p.uv.y();
    child = u > 0.5 ? (v > 0.5 ? 2 : 1) : (v > 0.5 ? 3 : 0);
    const std::array<Vec2, 4> turned{Vec2(u, v), Vec2(v, 1 - u), Vec2(1 - u, 1 - v),
                                     Vec2(1 - v, u)};
    Mat2 turn;
    turn << 0, 1, -1, 0;
    p.uv = 2 * turned[static_cast<std::size_t>(child)];
    for (int i = 0; i < child; ++i)
      p.J = turn * p.J;
    p.J *= 2;
  }
  const FaceId next(topology.halfedge(p.face, child).value);
  p.model = refined(p.model, scheme);
  p.face = next;
}

Piece piece_around_point(const Model& model, const Scheme& scheme, FaceId face, int corner,
                         const Vec2& uv, int levels) {
  Piece piece{model, face, uv};
  for (int level = 0; level < levels; ++level)
    step_towards_point(piece, scheme, corner);
  return piece;
}

/// The 4 x 4 points around a face, point (i, j) at 4 j + i; nothing if the face is not regular.
std::optional<std::array<Vec3, 16>> points_around(const Piece& p) {
  const Adjacency a(p.model.topology, Adjacency::Check::edges);
  const Sharpness sharpness(a, p.model.features);
  std::array<Vec3, 16> grid;
  for (int c = 0; c < 4; ++c) {
    const HalfedgeId h = p.model.topology.halfedge(p.face, c);
    const VertexId v = a.from(h);
    if (a.is_boundary(v) || a.num_ring_faces(v) != 4 || sharpness.vertex(v) > 0) return {};
    for (HalfedgeId g = a.ring_start(v);;) {
      if (sharpness.edge(a.edge(g)) > 0) return {};
      g = a.ring_next(g);
      if (g == a.ring_start(v)) break;
    }
    constexpr std::array<std::array<int, 2>, 4> corners{{{1, 1}, {2, 1}, {2, 2}, {1, 2}}};
    constexpr std::array<std::array<int, 2>, 4> along{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
    const auto [x, y] = corners[static_cast<std::size_t>(c)];
    const auto [dx, dy] = along[static_cast<std::size_t>(c)];
    const auto put = [&](int i, int j, VertexId w) {
      grid[static_cast<std::size_t>(4 * j + i)] = p.model.points[static_cast<std::size_t>(w.value)];
    };
    const HalfedgeId beside = a.next(a.twin(h));  // outwards is (dy, -dx)
    put(x, y, v);
    put(x + dy, y - dx, a.to(beside));
    put(x + dx + dy, y + dy - dx, a.from(a.prev(a.twin(h))));
    put(x + dy - dx, y - dx - dy, a.from(a.prev(a.twin(beside))));
  }
  return grid;
}

std::array<double, 4> spline(double t) {
  const double r = 1 - t;
  return {r * r * r / 6, (3 * t * t * t - 6 * t * t + 4) / 6, (3 * r * r * r - 6 * r * r + 4) / 6,
          t * t * t / 6};
}
std::array<double, 4> spline_derivative(double t) {
  const double r = 1 - t;
  return {-r * r / 2, (3 * t * t - 4 * t) / 2, -(3 * r * r - 4 * r) / 2, t * t / 2};
}

}  // namespace

Vec3 limit_by_refinement(const Model& model, const Scheme& scheme, FaceId face, int corner,
                         const Vec2& uv, int levels) {
  const Piece p = piece_around_point(model, scheme, face, corner, uv, levels);
  const double u = p.uv.x();
  const double v = p.uv.y();
  const auto at = [&](int i) {
    return p.model.points[static_cast<std::size_t>(
        p.model.topology.face(p.face)[static_cast<std::size_t>(i)].value)];
  };
  if (scheme.split == Split::triangles)
    return p.origin + (1 - u - v) * at(0) + u * at(1) + v * at(2);
  return p.origin + (1 - u) * ((1 - v) * at(0) + v * at(3)) + u * ((1 - v) * at(1) + v * at(2));
}

std::optional<std::array<Vec3, 2>> tangents_by_refinement(const Model& model, const Scheme& scheme,
                                                          FaceId face, int corner, const Vec2& uv,
                                                          int levels) {
  const Piece p = piece_around_point(model, scheme, face, corner, uv, levels);
  const auto grid = points_around(p);
  if (!grid) return {};
  const auto sum = [&](const std::array<double, 4>& s, const std::array<double, 4>& t) {
    Vec3 x = Vec3::Zero();
    for (std::size_t k = 0; k < 16; ++k)
      x += s[k % 4] * t[k / 4] * (*grid)[k];
    return x;
  };
  const Vec3 xs = sum(spline_derivative(p.uv.x()), spline(p.uv.y()));
  const Vec3 xt = sum(spline(p.uv.x()), spline_derivative(p.uv.y()));
  return {{p.J(0, 0) * xs + p.J(1, 0) * xt, p.J(0, 1) * xs + p.J(1, 1) * xt}};
}

}  // namespace limes::test
