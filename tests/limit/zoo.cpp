#include "limit/zoo.h"

#include <fmt/format.h>

#include <random>

#include "limes/mesh/adjacency.h"
#include "limes/mesh/shapes.h"
#include "limit/local_refinement.h"

namespace limes::test {
namespace {

Mesh bumpy(Mesh mesh, unsigned seed = 7) {
  perturb(mesh, 0.1, seed);
  return mesh;
}

/// Ends of the edges at vertex 0, counter-clockwise.
std::vector<VertexId> spokes(const Mesh& mesh) {
  const Adjacency adjacency(mesh.topology);
  std::vector<VertexId> ends;
  const HalfedgeId start = adjacency.ring_start(VertexId(0));
  for (HalfedgeId h = start; h.valid();) {
    ends.push_back(adjacency.to(h));
    h = adjacency.ring_next(h);
    if (h == start) break;
  }
  return ends;
}

/// A bumpy disk of valence n with creases along some of the spokes, to the rim.
Mesh creased_disk(int n, const std::vector<std::pair<int, float>>& creases,
                  CreaseMethod method = CreaseMethod::uniform) {
  Mesh mesh = bumpy(shapes::disk(n, 2));
  mesh.tags.crease_method = method;
  const Adjacency adjacency(mesh.topology);
  const std::vector<VertexId> ends = spokes(mesh);
  for (const auto& [spoke, sharpness] : creases) {
    const VertexId end = ends[static_cast<std::size_t>(spoke)];
    mesh.tags.creases.push_back({VertexId(0), end, sharpness});
    // The edge of valence-4 vertex `end` that goes straight on.
    HalfedgeId h = adjacency.ring_start(end);
    while (adjacency.to(h) != VertexId(0))
      h = adjacency.ring_next(h);
    const HalfedgeId on = adjacency.ring_next(adjacency.ring_next(h));
    mesh.tags.creases.push_back({end, adjacency.to(on), sharpness});
  }
  return mesh;
}

/// Every edge gets a random sharpness, many none; some vertices too.
Mesh randomly_sharp(Mesh mesh, unsigned seed, CreaseMethod method = CreaseMethod::uniform) {
  const std::vector<float> choices{0, 0, 0, 0, 0.3F, 0.8F, 1, 1.6F, 2.2F, 3.5F, 10};
  std::mt19937 random(seed);
  const auto pick = [&] { return choices[random() % choices.size()]; };
  const Adjacency adjacency(mesh.topology);
  mesh.tags.crease_method = method;
  for (int e = 0; e < adjacency.num_edges(); ++e) {
    const HalfedgeId h = adjacency.halfedge(EdgeId(e));
    mesh.tags.creases.push_back({adjacency.from(h), adjacency.to(h), pick()});
  }
  for (int v = 0; v < mesh.topology.num_vertices(); v += 3)
    mesh.tags.corners.push_back({VertexId(v), pick()});
  return bumpy(std::move(mesh));
}

/// A pentagon, triangles and quads around it: a cut house.
Mesh mixed_polygons() {
  Mesh mesh;
  std::vector<int> offsets{0};
  std::vector<VertexId> corners;
  const auto face = [&](std::initializer_list<int> f) {
    for (const int v : f)
      corners.emplace_back(v);
    offsets.push_back(static_cast<int>(corners.size()));
  };
  const Mesh inner = shapes::polygon(5);
  for (const Vec3& x : inner.points)
    mesh.points.push_back(x);
  for (const Vec3& x : inner.points)
    mesh.points.push_back(2.2 * x + Vec3(0.1, -0.2, 0.3));
  face({0, 1, 2, 3, 4});
  face({0, 5, 6, 1});
  face({1, 6, 7, 2});
  face({2, 7, 8, 3});
  face({3, 8, 4});
  face({4, 8, 9});
  face({4, 9, 5, 0});
  mesh.topology = Topology(10, offsets, corners);
  return mesh;
}

void add_smooth(std::vector<Shape>& out) {
  for (int n = 3; n <= 32; ++n)
    out.push_back({fmt::format("interior{}", n), bumpy(shapes::disk(n, 2))});
  for (const int n : {64, 150, 400})
    out.push_back({fmt::format("interior{}", n), bumpy(shapes::disk(n, 1))});
  out.push_back({"several_per_face", bumpy(shapes::disk(5, 1))});
  out.push_back({"cube", bumpy(shapes::cube())});
  out.push_back({"torus3x3", bumpy(shapes::torus(3, 3))});
  out.push_back({"torus4x3", bumpy(shapes::torus(4, 3))});
  out.push_back({"tetrahedron", bumpy(shapes::tetrahedron())});
  out.push_back({"icosahedron", bumpy(shapes::icosahedron())});
  Mesh smooth = bumpy(shapes::icosahedron());
  smooth.tags.smooth_triangles = true;
  out.push_back({"smooth_triangles", smooth});
}

void add_boundaries(std::vector<Shape>& out) {
  for (const int k : {1, 2, 3, 4, 5, 6, 9, 12, 40})
    for (const BoundaryRule rule : {BoundaryRule::edges, BoundaryRule::edges_and_corners}) {
      const char* name = rule == BoundaryRule::edges ? "boundary{}" : "boundary{}_corners";
      out.push_back({fmt::format(fmt::runtime(name), k), bumpy(shapes::half_disk(k, 2)), rule});
    }
  for (const int n : {3, 4, 5, 7})
    for (const BoundaryRule rule : {BoundaryRule::edges, BoundaryRule::edges_and_corners}) {
      const char* name = rule == BoundaryRule::edges ? "polygon{}" : "polygon{}_corners";
      out.push_back({fmt::format(fmt::runtime(name), n), bumpy(shapes::polygon(n)), rule});
    }
  out.push_back({"grid", bumpy(shapes::grid(4, 3))});
  out.push_back({"strip", bumpy(shapes::grid(5, 1)), BoundaryRule::edges_and_corners});
  out.push_back({"grid_with_hole", bumpy(shapes::grid_with_hole(3))});
  out.push_back({"cylinder", bumpy(shapes::cylinder(3, 1))});
  out.push_back({"mixed_polygons", bumpy(mixed_polygons())});
}

void add_corners(std::vector<Shape>& out) {
  for (const float s : {0.3F, 1.0F, 1.5F, 2.7F, 10.0F}) {
    Mesh disk = bumpy(shapes::disk(5, 2));
    disk.tags.corners.push_back({VertexId(0), s});
    out.push_back({fmt::format("corner_{:.0f}", 10 * s), disk});
    Mesh half = bumpy(shapes::half_disk(3, 2));
    half.tags.corners.push_back({VertexId(0), s});
    out.push_back({fmt::format("boundary_corner_{:.0f}", 10 * s), half});
  }
}

void add_creases(std::vector<Shape>& out) {
  for (const float s : {0.4F, 1.0F, 1.3F, 2.5F, 7.9F, 10.0F}) {
    const std::string tag = fmt::format("_{:.0f}", 10 * s);
    out.push_back({"crease4" + tag, creased_disk(4, {{0, s}, {2, s}})});
    out.push_back({"crease4_bent" + tag, creased_disk(4, {{0, s}, {1, s}})});
    out.push_back({"crease5" + tag, creased_disk(5, {{0, s}, {2, s}})});
    out.push_back({"crease7" + tag, creased_disk(7, {{1, s}, {2, s}})});
    out.push_back({"crease9_fading" + tag, creased_disk(9, {{0, s}, {4, 0.5F * s}})});
    out.push_back({"crease_corner" + tag, creased_disk(6, {{0, s}, {2, s}, {4, s}})});
    for (const int n : {3, 4, 5, 8})
      out.push_back({fmt::format("dart{}", n) + tag, creased_disk(n, {{1, s}})});
  }
  out.push_back({"crease_in_crease", creased_disk(5, {{0, 10}, {1, 1.7F}, {3, 10}})});
  out.push_back({"dart_in_crease", creased_disk(4, {{0, 10}, {1, 2.3F}})});
  for (const float s : {0.9F, 1.8F, 3.2F}) {
    out.push_back({fmt::format("chaikin_{:.0f}", 10 * s),
                   creased_disk(5, {{0, s}, {2, 0.6F * s}}, CreaseMethod::chaikin)});
    out.push_back({fmt::format("chaikin_three_{:.0f}", 10 * s),
                   creased_disk(6, {{0, s}, {2, 1.5F * s}, {3, 10}}, CreaseMethod::chaikin)});
  }
  for (unsigned seed = 0; seed < 6; ++seed) {
    out.push_back({fmt::format("random_cube{}", seed), randomly_sharp(shapes::cube(), seed)});
    out.push_back({fmt::format("random_torus{}", seed), randomly_sharp(shapes::torus(4, 5), seed)});
    out.push_back({fmt::format("random_polygons{}", seed), randomly_sharp(mixed_polygons(), seed)});
    out.push_back({fmt::format("random_chaikin{}", seed),
                   randomly_sharp(shapes::cube(), seed, CreaseMethod::chaikin)});
  }
}

}  // namespace

std::vector<Shape> limit_shapes() {
  std::vector<Shape> shapes;
  add_smooth(shapes);
  add_boundaries(shapes);
  add_corners(shapes);
  add_creases(shapes);
  return shapes;
}

}  // namespace limes::test
