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
  out.features.crease_method = model.features.crease_method;
  out.features.smooth_triangles = model.features.smooth_triangles;
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

Vec3 limit_by_refinement(const Model& model, const Scheme& scheme, FaceId face, int corner,
                         const Vec2& uv, int levels) {
  const int rings = model.features.crease_method == CreaseMethod::chaikin ? 3 : 2;
  Model piece = model;
  double u = uv.x();
  double v = uv.y();
  for (int level = 0; level < levels; ++level) {
    piece = cut_out(piece, rings, face);
    int child = corner;
    if (piece.topology.face_size(face) == 4) {
      child = u > 0.5 ? (v > 0.5 ? 2 : 1) : (v > 0.5 ? 3 : 0);
      const std::array<Vec2, 4> turned{Vec2(u, v), Vec2(v, 1 - u), Vec2(1 - u, 1 - v),
                                       Vec2(1 - v, u)};
      u = 2 * turned[static_cast<std::size_t>(child)].x();
      v = 2 * turned[static_cast<std::size_t>(child)].y();
    }
    const FaceId next(piece.topology.halfedge(face, child).value);
    piece = refined(piece, scheme);
    face = next;
  }
  const auto at = [&](int i) {
    return piece.points[static_cast<std::size_t>(
        piece.topology.face(face)[static_cast<std::size_t>(i)].value)];
  };
  return (1 - u) * ((1 - v) * at(0) + v * at(3)) + u * ((1 - v) * at(1) + v * at(2));
}

}  // namespace limes::test
