#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>

#include "limes/mesh/shapes.h"
#include "limes/subdiv/refinement_step.h"
#include "limes/subdiv/schemes.h"
#include "limes/subdiv/triangle_mesh.h"
#include "subdiv/meshes48.h"
#include "subdiv/zoo.h"

// Schemes once more, written as stellar operators and then one smoothing pass over the neighbours in
// the refined mesh: they must be what the direct rules make.

namespace limes {
namespace {

using Points = std::vector<Vec3>;

Vec3& at(Points& points, VertexId v) {
  return points[static_cast<std::size_t>(v.value)];
}
const Vec3& at(const Points& points, VertexId v) {
  return points[static_cast<std::size_t>(v.value)];
}

HalfedgeId find(const TriangleMesh& mesh, VertexId from, VertexId to) {
  for (int h = 0; h < 3 * mesh.num_faces(); ++h)
    if (mesh.from(HalfedgeId(h)) == from && mesh.to(HalfedgeId(h)) == to) return HalfedgeId(h);
  return {};
}
HalfedgeId find_any_way(const TriangleMesh& mesh, VertexId a, VertexId b) {
  const HalfedgeId h = find(mesh, a, b);
  return h.valid() ? h : find(mesh, b, a);
}

/// Vertices around v in the refined mesh, from the boundary if there is one.
struct Ring {
  std::vector<VertexId> vertices;
  bool boundary;
};
Ring ring_of(const TriangleMesh& mesh, VertexId v) {
  HalfedgeId out;
  for (int h = 0; h < 3 * mesh.num_faces(); ++h)
    if (mesh.from(HalfedgeId(h)) == v) out = HalfedgeId(h);
  const std::vector<HalfedgeId> halfedges = mesh.ring(out);
  Ring ring{{}, !mesh.twin(halfedges.front()).valid()};
  for (const HalfedgeId h : halfedges)
    ring.vertices.push_back(mesh.to(h));
  if (ring.boundary) ring.vertices.push_back(mesh.opposite(halfedges.back()));
  return ring;
}
/// Mean of the vertices of a ring that `wanted` takes.
template <class Wanted>
Vec3 mean(const Ring& ring, const Points& points, const Wanted& wanted) {
  Vec3 sum = Vec3::Zero();
  int count = 0;
  for (const VertexId v : ring.vertices) {
    if (!wanted(v)) continue;
    sum += at(points, v);
    ++count;
  }
  return sum / count;
}

/// Faces whatever their order and first corner.
using FaceSet = std::multiset<std::vector<int>>;
void add_face(std::vector<int> face, FaceSet& faces) {
  std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
  faces.insert(std::move(face));
}
FaceSet faces_of(const Topology& topology) {
  FaceSet faces;
  for (int f = 0; f < topology.num_faces(); ++f) {
    std::vector<int> face;
    for (const VertexId v : topology.face(FaceId(f)))
      face.push_back(v.value);
    add_face(std::move(face), faces);
  }
  return faces;
}

/// One step by the direct code.
struct Direct {
  Direct(const Mesh& mesh, const char* scheme)
      : adjacency(mesh.topology), step(adjacency, features, find_scheme(scheme)) {
    points.resize(static_cast<std::size_t>(step.num_child_vertices()));
    step.apply(mesh.points.span(), points);
  }
  Adjacency adjacency;
  Features features;
  RefinementStep step;
  Points points;
};

void expect_same(const Points& points, const Points& expected) {
  ASSERT_EQ(points.size(), expected.size());
  for (std::size_t v = 0; v < points.size(); ++v)
    EXPECT_LE((points[v] - expected[v]).norm(), 4e-15 * 3) << "vertex " << v;
}

/// Cuts every edge of the parent, in order, and puts the middles there.
void split_edges(const Adjacency& parent, TriangleMesh& mesh, Points& points) {
  for (int e = 0; e < parent.num_edges(); ++e) {
    const HalfedgeId h = parent.halfedge(EdgeId(e));
    const VertexId a = parent.from(h), b = parent.to(h);
    mesh.split_edge(find(mesh, a, b));
    points.push_back(0.5 * (at(points, a) + at(points, b)));
  }
}

TEST(Factored, LoopIsSplitsFlipsAndOneSmoothing) {
  for (const Mesh& start :
       {bumpy(shapes::icosahedron()), bumpy(triangulated(shapes::torus(5, 4))),
        bumpy(triangulated(shapes::grid(3, 3))), bumpy(fan(7, Centre::first))}) {
    const Direct direct(start, "loop");
    const VertexId first_new(start.points.size());
    TriangleMesh mesh(direct.adjacency);
    Points linear = start.points.vector();
    split_edges(direct.adjacency, mesh, linear);
    // What joins a new vertex with an old one that is no end of its edge is flipped.
    for (int f = 0; f < direct.adjacency.topology().num_faces(); ++f)
      for (const VertexId corner : direct.adjacency.topology().face(FaceId(f)))
        for (int e = 0; e < 3; ++e) {
          const HalfedgeId side = direct.adjacency.topology().halfedge(FaceId(f), e);
          if (direct.adjacency.from(side) == corner || direct.adjacency.to(side) == corner)
            continue;
          const VertexId middle(first_new.value + direct.adjacency.edge(side).value);
          const HalfedgeId h = find(mesh, middle, corner);
          if (h.valid() && mesh.can_flip(h)) mesh.flip(h);
        }
    EXPECT_EQ(faces_of(mesh.topology()), faces_of(direct.step.child_topology()));

    Points smooth = linear;
    for (int i = 0; i < mesh.num_vertices(); ++i) {
      const VertexId v(i);
      const Ring ring = ring_of(mesh, v);
      const auto is_new = [&](VertexId w) { return w >= first_new; };
      if (is_new(v) && !ring.boundary) {
        at(smooth, v) = 0.5 * at(linear, v) + 0.5 * mean(ring, linear, is_new);
      } else if (!is_new(v) && ring.boundary) {
        at(smooth, v) = 0.5 * at(linear, v) + 0.25 * (at(linear, ring.vertices.front()) +
                                                      at(linear, ring.vertices.back()));
      } else if (!is_new(v)) {
        const auto n = static_cast<double>(ring.vertices.size());
        const double c = 0.375 + 0.25 * std::cos(2 * std::numbers::pi / n);
        const double pull = 2 * (0.625 - c * c);  // of the mean of the middles
        at(smooth, v) = (1 - pull) * at(linear, v) + pull * mean(ring, linear, is_new);
      }
    }
    expect_same(smooth, direct.points);
  }
}

TEST(Factored, Sqrt3IsFaceSplitsFlipsAndOneSmoothing) {
  for (const Mesh& start :
       {bumpy(shapes::icosahedron()), bumpy(triangulated(shapes::torus(5, 4))),
        bumpy(triangulated(shapes::grid(3, 3))), bumpy(fan(7, Centre::first))}) {
    const Direct direct(start, "sqrt3");
    TriangleMesh mesh(direct.adjacency);
    Points points = start.points.vector();
    for (int f = 0; f < start.topology.num_faces(); ++f) {
      const auto face = start.topology.face(FaceId(f));
      mesh.split_face(FaceId(f));
      points.push_back((at(points, face[0]) + at(points, face[1]) + at(points, face[2])) / 3.0);
    }
    for (int e = 0; e < direct.adjacency.num_edges(); ++e) {
      const HalfedgeId h = direct.adjacency.halfedge(EdgeId(e));
      if (direct.adjacency.is_boundary(EdgeId(e))) continue;
      mesh.flip(find(mesh, direct.adjacency.from(h), direct.adjacency.to(h)));
    }
    EXPECT_EQ(faces_of(mesh.topology()), faces_of(direct.step.child_topology()));

    for (int i = 0; i < start.points.size(); ++i) {
      const VertexId v(i);
      const Ring ring = ring_of(mesh, v);
      if (ring.boundary) continue;
      const auto n = static_cast<double>(ring.vertices.size());
      const double alpha = (4 - 2 * std::cos(2 * std::numbers::pi / n)) / 9;
      // Three times the mean of the face points is the vertex and twice the mean of its neighbours.
      const Vec3 faces = mean(ring, points, [](VertexId) { return true; });
      at(points, v) = (1 - 1.5 * alpha) * at(points, v) + 1.5 * alpha * faces;
    }
    expect_same(points, direct.points);
  }
}

TEST(Factored, CatmullClarkIsEdgeSplitsAndOneSmoothing) {
  for (const Mesh& start : {bumpy(shapes::cube()), bumpy(shapes::torus(5, 4)),
                            bumpy(shapes::grid(3, 3)), bumpy(shapes::disk(5, 2))}) {
    const Direct direct(start, "catmull-clark");
    const Topology triangles = triangulated(start).topology;
    const Adjacency triangle_adjacency(triangles);
    TriangleMesh mesh(triangle_adjacency);
    Points linear = start.points.vector();
    // A vertex on the diagonal of every quad, then one on every edge of the quads.
    for (int f = 0; f < start.topology.num_faces(); ++f) {
      const auto face = start.topology.face(FaceId(f));
      mesh.split_edge(find_any_way(mesh, face[0], face[2]));
      linear.push_back(0.25 * ((at(linear, face[0]) + at(linear, face[2])) +
                               (at(linear, face[1]) + at(linear, face[3]))));
    }
    const int num_old = start.points.size(), num_faces = start.topology.num_faces();
    const auto is_face = [&](VertexId v) {
      return v.value >= num_old && v.value < num_old + num_faces;
    };
    const auto is_edge = [&](VertexId v) { return v.value >= num_old + num_faces; };
    split_edges(direct.adjacency, mesh, linear);

    // Direct code numbers edges before faces.
    const int num_edges = direct.adjacency.num_edges();
    const auto number = [&](VertexId v) {
      return is_face(v) ? v.value + num_edges : is_edge(v) ? v.value - num_faces : v.value;
    };
    FaceSet quads;
    for (int h = 0; h < 3 * mesh.num_faces(); ++h) {
      const HalfedgeId spoke(h);
      if (mesh.from(spoke).value >= num_old || !is_face(mesh.to(spoke))) continue;
      add_face({number(mesh.from(spoke)), number(mesh.opposite(mesh.twin(spoke))),
                number(mesh.to(spoke)), number(mesh.opposite(spoke))},
               quads);
    }
    EXPECT_EQ(quads, faces_of(direct.step.child_topology()));

    Points smooth(linear.size());
    for (int i = 0; i < mesh.num_vertices(); ++i) {
      const VertexId v(i);
      Vec3& x = smooth[static_cast<std::size_t>(number(v))];
      x = at(linear, v);
      if (is_face(v)) continue;
      const Ring ring = ring_of(mesh, v);
      if (is_edge(v)) {
        if (!ring.boundary) x = 0.5 * x + 0.5 * mean(ring, linear, is_face);
      } else if (ring.boundary) {
        x = 0.5 * x + 0.25 * (at(linear, ring.vertices.front()) + at(linear, ring.vertices.back()));
      } else {
        const double n = static_cast<double>(ring.vertices.size()) / 2;
        x = (n - 3) / n * x + 2 / n * mean(ring, linear, is_edge) +
            1 / n * mean(ring, linear, is_face);
      }
    }
    expect_same(smooth, direct.points);
  }
}

}  // namespace
}  // namespace limes
