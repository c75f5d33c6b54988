#include "limes/limit/interpolatory_surface.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "limes/core/error.h"
#include "limes/limit/four_point.h"
#include "limes/limit/grid_block.h"
#include "limes/limit/star_masks.h"
#include "limes/subdiv/crease.h"
#include "limes/subdiv/refinement_step.h"
#include "limes/subdiv/split.h"
#include "limes/subdiv/surroundings.h"

namespace limes {
namespace {

/// Rings of faces around a face that are refined along with it. The vertices around a quarter of the
/// face, three rings of quarters, depend on three rings of faces, and extrapolated vertices on one
/// more.
constexpr int num_rings = 4;

/// A face and the faces around it, as a net of its own; face 0 is the face. Its rim is no boundary
/// of the surface, but what the rim's rules do wrong does not reach the face.
struct LocalNet {
  Topology topology;
  Features features;
  std::vector<Vec3> points;
  Vec2 uv;  ///< of the point in face 0
};

/// Numbers the vertices of the faces and restricts the features to them.
LocalNet restricted(const Adjacency& mesh, const Features& features, std::span<const Vec3> points,
                    const std::vector<FaceId>& faces) {
  LocalNet net;
  std::vector<VertexId> old;  // by new vertex
  std::vector<VertexId> corners;
  for (const FaceId f : faces)
    for (const VertexId v : mesh.topology().face(f))
      old.push_back(v);
  std::sort(old.begin(), old.end());
  old.erase(std::unique(old.begin(), old.end()), old.end());
  const auto number = [&](VertexId v) {
    const auto at = std::lower_bound(old.begin(), old.end(), v);
    return at != old.end() && *at == v ? VertexId(at - old.begin()) : VertexId();
  };
  for (const FaceId f : faces)
    for (const VertexId v : mesh.topology().face(f))
      corners.push_back(number(v));
  net.topology = Topology(static_cast<int>(old.size()), 4, std::move(corners));
  for (const VertexId v : old)
    net.points.push_back(points[static_cast<std::size_t>(v.value)]);

  net.features = features;
  net.features.edges.clear();
  net.features.vertices.clear();
  for (const SharpVertex& v : features.vertices)
    if (const VertexId mine = number(v.vertex); mine.valid())
      net.features.vertices.push_back({mine, v.sharpness});
  if (features.edges.empty()) return net;
  for (std::size_t i = 0; i < faces.size(); ++i)
    for (int k = 0; k < 4; ++k) {
      const HalfedgeId h = mesh.halfedge(mesh.edge(mesh.topology().halfedge(faces[i], k)));
      const auto at =
          std::lower_bound(features.edges.begin(), features.edges.end(), h,
                           [](const SharpEdge& e, HalfedgeId x) { return e.halfedge < x; });
      if (at == features.edges.end() || at->halfedge != h) continue;
      net.features.edges.push_back(
          {HalfedgeId(4 * static_cast<std::int64_t>(i) + k), at->sharpness});
    }
  return net;
}

/// An edge is named by its first halfedge, once.
void tidy_edges(const Adjacency& net, Features& features) {
  for (SharpEdge& e : features.edges)
    e.halfedge = net.halfedge(net.edge(e.halfedge));
  std::sort(features.edges.begin(), features.edges.end(),
            [](const SharpEdge& a, const SharpEdge& b) { return a.halfedge < b.halfedge; });
  features.edges.erase(
      std::unique(features.edges.begin(), features.edges.end(),
                  [](const SharpEdge& a, const SharpEdge& b) { return a.halfedge == b.halfedge; }),
      features.edges.end());
}

/// The face f first, then the faces around it ring by ring.
std::vector<FaceId> rings_of(const Adjacency& mesh, FaceId f) {
  std::vector<FaceId> faces{f};
  for (int ring = 0; ring < num_rings; ++ring) {
    std::vector<VertexId> corners;
    for (const FaceId g : faces)
      corners.insert(corners.end(), mesh.topology().face(g).begin(), mesh.topology().face(g).end());
    std::sort(corners.begin(), corners.end());
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    faces = faces_around(mesh, corners);
  }
  faces.erase(std::find(faces.begin(), faces.end(), f));
  faces.insert(faces.begin(), f);
  return faces;
}

LocalNet gather(const Adjacency& mesh, const Features& features, std::span<const Vec3> points,
                FaceId f, const Vec2& uv) {
  LocalNet net = restricted(mesh, features, points, rings_of(mesh, f));
  tidy_edges(Adjacency(net.topology, Adjacency::Check::edges), net.features);
  net.uv = uv;
  return net;
}

/// Which quarter of the face holds a point, and where in it: the child at corner 0 has its own corner
/// 0 there and turns with its corner.
std::pair<int, Vec2> quarter_of(const Vec2& uv) {
  const double u = 2.0 * uv.x(), v = 2.0 * uv.y();
  if (u <= 1.0 && v <= 1.0) return {0, {u, v}};
  if (v <= 1.0) return {1, {v, 2.0 - u}};
  if (u <= 1.0) return {3, {2.0 - v, u}};
  return {2, {2.0 - u, 2.0 - v}};
}

/// Derivatives in the frame of corner 0 from those in the quarter at corner c.
Mat2 turned_back(int c) {
  Mat2 J;  // d(quarter) / d(face) without the factor 2
  switch (c) {
    case 0:
      return Mat2::Identity();
    case 1:
      J << 0, 1, -1, 0;
      return J;
    case 2:
      return -Mat2::Identity();
    default:
      J << 0, -1, 1, 0;
      return J;
  }
}

SurfacePoint on_block(const GridBlock& block, std::span<const Vec3> points, const Vec2& uv,
                      double omega) {
  const SixWeights u = four_point_value(uv.x(), omega), v = four_point_value(uv.y(), omega);
  const SixWeights du = four_point_derivative(uv.x(), omega);
  const SixWeights dv = four_point_derivative(uv.y(), omega);
  SurfacePoint p;
  p.x = Vec3::Zero();
  p.first = SurfacePoint::First{Vec3::Zero(), Vec3::Zero()};
  for (Eigen::Index j = 0; j < 6; ++j)
    for (Eigen::Index i = 0; i < 6; ++i) {
      const Vec3& x =
          points[static_cast<std::size_t>(block[static_cast<std::size_t>(6 * j + i)].value)];
      p.x += u(i) * v(j) * x;
      p.first->xu += du(i) * v(j) * x;
      p.first->xv += u(i) * dv(j) * x;
    }
  return p;
}

Vec3 bilinear(const Topology& topology, std::span<const Vec3> points, const Vec2& uv) {
  const auto corner = [&](std::size_t i) -> const Vec3& {
    return points[static_cast<std::size_t>(topology.face(FaceId(0))[i].value)];
  };
  const double u = uv.x(), v = uv.y();
  return (1 - v) * ((1 - u) * corner(0) + u * corner(1)) +
         v * ((1 - u) * corner(3) + u * corner(2));
}

/// The corner of a face that a point is, or none.
std::optional<int> corner_at(const Vec2& uv) {
  const auto is_end = [](double t) { return t == 0.0 || t == 1.0; };
  if (!is_end(uv.x()) || !is_end(uv.y())) return {};
  if (uv.y() == 0.0) return uv.x() == 0.0 ? 0 : 1;
  return uv.x() == 0.0 ? 3 : 2;
}

void set_normal(const Vec3& xu, const Vec3& xv, SurfacePoint& p) {
  const Vec3 n = xu.cross(xv);
  const double length = n.norm();
  if (length > 0 && std::isfinite(length)) p.normal = n / length;
}

}  // namespace

InterpolatorySurface::InterpolatorySurface(const Adjacency& mesh, const Features& features,
                                           const Scheme& scheme, std::span<const Vec3> points)
    : mesh_(&mesh), features_(&features), scheme_(&scheme), points_(points) {
  (void)RefinementStep(mesh, features, scheme);  // refuses what does not fit
  tangents_[4] = star_tangents(scheme, features, 4);
  for (int v = 0; v < mesh.topology().num_vertices(); ++v) {
    if (!mesh.ring_start(VertexId(v)).valid() || mesh.is_boundary(VertexId(v))) continue;
    const auto [at, added] = tangents_.try_emplace(mesh.valence(VertexId(v)));
    if (added) at->second = star_tangents(scheme, features, at->first);
  }
}

namespace {

/// The net around a quarter of face 0 after one step; face 0 of the result is the quarter.
LocalNet refined(const LocalNet& net, const Scheme& scheme, int corner, const Vec2& uv) {
  const Adjacency mesh(net.topology, Adjacency::Check::edges);
  const RefinementStep step(mesh, net.features, scheme);
  std::vector<Vec3> points(static_cast<std::size_t>(step.num_child_vertices()));
  step.apply(net.points, points);
  const Topology child = step.child_topology();
  const Adjacency child_mesh(child, Adjacency::Check::edges);
  const FaceId quarter = quadrisection_child(net.topology.halfedge(FaceId(0), corner));
  return gather(child_mesh, step.child_features(), points, quarter, uv);
}

/// The normal at a corner of face 0 if it is a smooth interior vertex: after one step the vertices
/// around it are regular, and the masks of its valence hold.
void set_vertex_normal(const LocalNet& net, int corner, const Scheme& scheme,
                       const StarTangents& tangents, SurfacePoint& p) {
  const Adjacency mesh(net.topology, Adjacency::Check::edges);
  const Sharpness sharpness(mesh, net.features);
  const HalfedgeId start = net.topology.halfedge(FaceId(0), corner);
  int valence = 0;
  for (HalfedgeId h = start;;) {
    if (is_infinite(sharpness.edge(mesh.edge(h)))) return;
    ++valence;
    h = mesh.ring_next(h);
    if (!h.valid()) return;
    if (h == start) break;
  }
  const auto& rows = tangents.at(valence);
  if (!rows) return;
  const LocalNet fine = refined(net, scheme, corner, {0, 0});
  const Adjacency fine_mesh(fine.topology, Adjacency::Check::edges);
  const auto star = star_vertices(fine_mesh, fine.topology.halfedge(FaceId(0), 0));
  Vec3 t0 = Vec3::Zero(), t1 = Vec3::Zero();
  for (std::size_t i = 0; i < star.size(); ++i) {
    const Vec3& x = fine.points[static_cast<std::size_t>(star[i].value)];
    t0 += (*rows)(0, static_cast<Eigen::Index>(i)) * x;
    t1 += (*rows)(1, static_cast<Eigen::Index>(i)) * x;
  }
  set_normal(t0, t1, p);
}

/// Where the descent into a face ended and how its parameters depend on those of the face.
struct Place {
  LocalNet net;
  Mat2 J = Mat2::Identity();
  std::optional<GridBlock> block;
};

bool has_extraordinary_corner(const LocalNet& net) {
  const Adjacency mesh(net.topology, Adjacency::Check::edges);
  for (const VertexId v : net.topology.face(FaceId(0)))
    if (!mesh.is_boundary(v) && mesh.valence(v) != 4) return true;
  return false;
}

HalfedgeId net_corner(const LocalNet& net, int corner) {
  return net.topology.halfedge(FaceId(0), corner);
}

/// To a regular block, or to a vertex that will never be inside one.
Place descend(LocalNet net, const Scheme& scheme) {
  Place place{std::move(net), Mat2::Identity(), {}};
  for (int depth = 0;; ++depth) {
    const Adjacency mesh(place.net.topology, Adjacency::Check::edges);
    const Sharpness sharpness(mesh, place.net.features);
    place.block = grid_block(mesh, sharpness, FaceId(0));
    if (place.block) return place;
    if (const auto corner = corner_at(place.net.uv))
      if (!is_regular(mesh, sharpness, mesh.from(net_corner(place.net, *corner)))) return place;
    if (depth >= InterpolatorySurface::max_depth_at_vertex ||
        (depth >= InterpolatorySurface::max_depth && !has_extraordinary_corner(place.net)))
      return place;
    const auto [corner, uv] = quarter_of(place.net.uv);
    place.net = refined(place.net, scheme, corner, uv);
    place.J = 2.0 * turned_back(corner) * place.J;
  }
}

}  // namespace

SurfacePoint InterpolatorySurface::evaluate(FaceId f, const Vec2& uv) const {
  LocalNet start = gather(*mesh_, *features_, points_, f, uv);
  // Relative to the nearest corner: where the net shrinks towards it, digits are kept.
  const std::size_t nearest = uv.y() <= 0.5 ? (uv.x() <= 0.5 ? 0 : 1) : (uv.x() <= 0.5 ? 3 : 2);
  const Vec3 origin = points_[static_cast<std::size_t>(mesh_->topology().face(f)[nearest].value)];
  for (Vec3& x : start.points)
    x -= origin;

  const double omega = features_->tension / 16.0;
  const Place place = descend(std::move(start), *scheme_);
  SurfacePoint p;
  if (place.block) {
    p = on_block(*place.block, place.net.points, place.net.uv, omega);
    const Vec3 u = p.first->xu, v = p.first->xv;
    p.first->xu = place.J(0, 0) * u + place.J(1, 0) * v;
    p.first->xv = place.J(0, 1) * u + place.J(1, 1) * v;
    set_normal(p.first->xu, p.first->xv, p);
  } else if (const auto corner = corner_at(place.net.uv)) {
    const VertexId vertex = place.net.topology.face(FaceId(0))[static_cast<std::size_t>(*corner)];
    p.x = place.net.points[static_cast<std::size_t>(vertex.value)];
    set_vertex_normal(place.net, *corner, *scheme_, tangents_, p);
  } else {
    p.x = bilinear(place.net.topology, place.net.points, place.net.uv);
  }
  p.x += origin;
  return p;
}

}  // namespace limes
