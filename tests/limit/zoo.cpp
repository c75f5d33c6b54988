#include "limit/zoo.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
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

/// A bumpy disk of two rings with creases along some of the spokes, to the rim.
Mesh creased(const Mesh& disk, const std::vector<std::pair<int, float>>& creases,
             CreaseMethod method) {
  Mesh mesh = bumpy(disk);
  mesh.tags.crease_method = method;
  const Adjacency adjacency(mesh.topology);
  const std::vector<VertexId> ends = spokes(mesh);
  for (const auto& [spoke, sharpness] : creases) {
    const VertexId end = ends[static_cast<std::size_t>(spoke)];
    mesh.tags.creases.push_back({VertexId(0), end, sharpness});
    // The edge of vertex `end` that goes straight on: half way round.
    HalfedgeId h = adjacency.ring_start(end);
    while (adjacency.to(h) != VertexId(0))
      h = adjacency.ring_next(h);
    for (int k = 0; k < adjacency.num_ring_faces(end) / 2; ++k)
      h = adjacency.ring_next(h);
    mesh.tags.creases.push_back({end, adjacency.to(h), sharpness});
  }
  return mesh;
}
Mesh creased_disk(int n, const std::vector<std::pair<int, float>>& creases,
                  CreaseMethod method = CreaseMethod::uniform) {
  return creased(shapes::disk(n, 2), creases, method);
}

/// Every edge gets a random sharpness, many none; some vertices too.
Mesh randomly_sharp(Mesh mesh, unsigned seed, CreaseMethod method = CreaseMethod::uniform,
                    const std::vector<float>& choices = {0, 0, 0, 0, 0.3F, 0.8F, 1, 1.6F, 2.2F,
                                                         3.5F, 10}) {
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

namespace {

// Triangles

/// Sectors of triangles around vertex 0: a regular polygon, or with fewer than a whole turn a fan on
/// whose border vertex 0 lies. The first faces are those at vertex 0.
Mesh fan(int num_sectors, int rings, double turn) {
  const bool closed = turn == 1;
  const auto direction = [&](int s) {
    const double a = 2 * std::numbers::pi * turn * s / num_sectors;
    return Vec3(std::cos(a), std::sin(a), 0);
  };
  const auto id = [&](int ring, int t) {  // t-th point of a ring, sector by sector
    if (ring == 0) return 0;
    const int inner = ring * (ring - 1) / 2 * num_sectors + (closed ? 0 : ring - 1);
    return 1 + inner + (closed ? t % (num_sectors * ring) : t);
  };
  Mesh mesh;
  mesh.points.push_back(Vec3::Zero());
  std::vector<VertexId> corners;
  const auto face = [&](int a, int b, int c) {
    for (const int v : {a, b, c})
      corners.emplace_back(v);
  };
  for (int r = 1; r <= rings; ++r) {
    for (int t = 0; t < num_sectors * r + (closed ? 0 : 1); ++t)
      mesh.points.push_back(((r - t % r) * direction(t / r) + t % r * direction(t / r + 1)) /
                            rings);
    for (int s = 0; s < num_sectors; ++s)
      for (int q = 0; q < r; ++q) {
        face(id(r - 1, s * (r - 1) + q), id(r, s * r + q), id(r, s * r + q + 1));
        if (q + 1 < r)
          face(id(r - 1, s * (r - 1) + q), id(r, s * r + q + 1), id(r - 1, s * (r - 1) + q + 1));
      }
  }
  mesh.topology = Topology(static_cast<int>(mesh.points.size()), 3, std::move(corners));
  return mesh;
}
Mesh triangle_disk(int n, int rings = 2) {
  return fan(n, rings, 1);
}
Mesh triangle_half_disk(int num_faces, int rings = 2) {
  return fan(num_faces, rings, num_faces == 1 ? 0.25 : 0.5);
}

/// Every quad cut into two triangles.
Mesh triangulated(const Mesh& quads) {
  std::vector<VertexId> corners;
  for (int f = 0; f < quads.topology.num_faces(); ++f) {
    const auto v = quads.topology.face(FaceId(f));
    corners.insert(corners.end(), {v[0], v[1], v[2], v[2], v[3], v[0]});
  }
  Mesh mesh;
  mesh.points = quads.points;
  mesh.topology = Topology(quads.topology.num_vertices(), 3, std::move(corners));
  return mesh;
}

void add_smooth_triangles(std::vector<Shape>& out) {
  for (int n = 3; n <= 16; ++n)
    out.push_back({fmt::format("interior{}", n), bumpy(triangle_disk(n))});
  for (const int n : {32, 64, 150})
    out.push_back({fmt::format("interior{}", n), bumpy(triangle_disk(n, 1))});
  out.push_back({"several_per_face", bumpy(triangle_disk(5, 1))});
  out.push_back({"tetrahedron", bumpy(shapes::tetrahedron())});
  out.push_back({"icosahedron", bumpy(shapes::icosahedron())});
  out.push_back({"cube", bumpy(triangulated(shapes::cube()))});
  out.push_back({"torus3x3", bumpy(triangulated(shapes::torus(3, 3)))});
}

void add_triangle_boundaries(std::vector<Shape>& out) {
  for (const BoundaryRule rule : {BoundaryRule::edges, BoundaryRule::edges_and_corners}) {
    const std::string tag = rule == BoundaryRule::edges ? "" : "_corners";
    for (const int k : {1, 2, 3, 4, 5, 6, 7, 9, 12})
      out.push_back({fmt::format("boundary{}", k) + tag, bumpy(triangle_half_disk(k)), rule});
    out.push_back({"triangle" + tag, bumpy(shapes::polygon(3)), rule});
    out.push_back({"strip" + tag, bumpy(triangulated(shapes::grid(5, 1))), rule});
    out.push_back({"grid_with_hole" + tag, bumpy(triangulated(shapes::grid_with_hole(3))), rule});
  }
  out.push_back({"cylinder", bumpy(triangulated(shapes::cylinder(3, 1)))});
  Mesh grid = triangulated(shapes::grid(4, 3));
  for (const int v : {0, 4, 15, 19})
    grid.tags.corners.push_back({VertexId(v), 10});
  out.push_back({"grid", grid});
}

void add_triangle_corners(std::vector<Shape>& out) {
  for (const float s : {0.3F, 1.0F, 1.5F, 2.7F, 10.0F}) {
    for (const int n : {5, 6}) {
      Mesh disk = bumpy(triangle_disk(n));
      disk.tags.corners.push_back({VertexId(0), s});
      out.push_back({fmt::format("corner{}_{:.0f}", n, 10 * s), disk});
    }
    for (const int k : {1, 2, 3, 4}) {
      Mesh half = bumpy(triangle_half_disk(k));
      half.tags.corners.push_back({VertexId(0), s});
      out.push_back({fmt::format("boundary_corner{}_{:.0f}", k, 10 * s), half});
    }
  }
}

void add_triangle_creases(std::vector<Shape>& out) {
  const auto disk = [](int n, const std::vector<std::pair<int, float>>& creases,
                       CreaseMethod method = CreaseMethod::uniform) {
    return creased(triangle_disk(n), creases, method);
  };
  for (const float s : {0.4F, 1.0F, 1.3F, 2.5F, 7.9F, 10.0F}) {
    const std::string tag = fmt::format("_{:.0f}", 10 * s);
    out.push_back({"crease6" + tag, disk(6, {{0, s}, {3, s}})});
    out.push_back({"crease6_bent" + tag, disk(6, {{0, s}, {2, s}})});
    out.push_back({"crease6_sharp_bend" + tag, disk(6, {{0, s}, {1, s}})});
    out.push_back({"crease5" + tag, disk(5, {{0, s}, {2, s}})});
    out.push_back({"crease9" + tag, disk(9, {{1, s}, {3, s}})});
    out.push_back({"crease9_fading" + tag, disk(9, {{0, s}, {4, 0.5F * s}})});
    out.push_back({"crease_corner" + tag, disk(6, {{0, s}, {2, s}, {4, s}})});
    out.push_back({"crease_lone_corner" + tag, disk(7, {{0, s}, {1, s}, {4, s}})});
    for (const int n : {3, 5, 6, 8})
      out.push_back({fmt::format("dart{}", n) + tag, disk(n, {{1, s}})});
  }
  out.push_back({"crease_in_crease", disk(6, {{0, 10}, {1, 1.7F}, {3, 10}})});
  out.push_back({"dart_in_crease", disk(5, {{0, 10}, {1, 2.3F}})});
  for (const float s : {0.9F, 1.8F, 3.2F}) {
    out.push_back({fmt::format("chaikin_{:.0f}", 10 * s),
                   disk(5, {{0, s}, {2, 0.6F * s}}, CreaseMethod::chaikin)});
    out.push_back({fmt::format("chaikin_three_{:.0f}", 10 * s),
                   disk(6, {{0, s}, {2, 1.5F * s}, {3, 10}}, CreaseMethod::chaikin)});
  }
  for (unsigned seed = 0; seed < 6; ++seed) {
    // Means of sharpness are sums in single precision, whose last bit depends on the edge at which a
    // walk begins: with eighths they are exact.
    const auto random = [&](const Mesh& mesh, CreaseMethod method = CreaseMethod::uniform) {
      return randomly_sharp(mesh, seed, method,
                            {0, 0, 0, 0, 0.25F, 0.75F, 1, 1.625F, 2.25F, 3.5F, 10});
    };
    out.push_back({fmt::format("random_icosahedron{}", seed), random(shapes::icosahedron())});
    out.push_back({fmt::format("random_torus{}", seed), random(triangulated(shapes::torus(4, 5)))});
    out.push_back({fmt::format("random_chaikin{}", seed),
                   random(triangulated(shapes::cube()), CreaseMethod::chaikin)});
  }
}

}  // namespace

std::vector<Shape> loop_shapes() {
  std::vector<Shape> shapes;
  add_smooth_triangles(shapes);
  add_triangle_boundaries(shapes);
  add_triangle_corners(shapes);
  add_triangle_creases(shapes);
  for (Shape& shape : shapes)
    shape.scheme = "loop";
  return shapes;
}

std::vector<Shape> limit_shapes() {
  std::vector<Shape> shapes;
  add_smooth(shapes);
  add_boundaries(shapes);
  add_corners(shapes);
  add_creases(shapes);
  return shapes;
}

}  // namespace limes::test
