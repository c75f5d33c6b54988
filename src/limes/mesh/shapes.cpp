#include "limes/mesh/shapes.h"

#include <cmath>
#include <initializer_list>
#include <map>
#include <numbers>
#include <utility>

#include "limes/core/error.h"

namespace limes::shapes {
namespace {

constexpr double pi = std::numbers::pi;

/// Collects points and faces of one size.
class Builder {
 public:
  explicit Builder(int face_size) : face_size_(face_size) {}

  int add_point(const Vec3& x) {
    points_.push_back(x);
    return static_cast<int>(points_.size()) - 1;
  }
  void add_face(std::initializer_list<int> corners) {
    for (const int v : corners)
      corners_.emplace_back(v);
  }
  Mesh build() {
    Mesh mesh;
    mesh.topology = Topology(static_cast<int>(points_.size()), face_size_, std::move(corners_));
    mesh.points = IdArray<VertexId, Vec3>(std::move(points_));
    return mesh;
  }

 private:
  int face_size_;
  std::vector<Vec3> points_;
  std::vector<VertexId> corners_;
};

/// A columns x lines block of quads over indices (i, j); closed directions wrap around.
template <class PointAt>
Mesh block(int columns, int lines, bool close_columns, bool close_lines, const PointAt& point) {
  const int width = columns + (close_columns ? 0 : 1);
  const int height = lines + (close_lines ? 0 : 1);
  Builder b(4);
  for (int j = 0; j < height; ++j)
    for (int i = 0; i < width; ++i)
      b.add_point(point(i, j));
  const auto at = [&](int i, int j) { return (j % height) * width + i % width; };
  for (int j = 0; j < lines; ++j)
    for (int i = 0; i < columns; ++i)
      b.add_face({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
  return b.build();
}

/// Sectors of size x size quads around vertex 0. Sector s is spanned by spokes s and s + 1.
/// spoke(s) is the end of spoke s, tip(s) the outer corner of sector s.
template <class Spoke, class Tip>
Mesh sectors(int num_sectors, int size, bool closed, const Spoke& spoke, const Tip& tip) {
  Builder b(4);
  std::map<std::pair<int, std::pair<int, int>>, int> known;
  const int num_spokes = num_sectors + (closed ? 0 : 1);
  const auto vertex = [&](int sector, int i, int j) {  // i along spoke s, j along spoke s + 1
    if (i == 0 && j == 0) sector = 0;
    if (i == 0 && j > 0) {
      sector = (sector + 1) % num_spokes;
      std::swap(i, j);
    }
    const auto [it, added] = known.emplace(std::pair(sector, std::pair(i, j)), 0);
    if (added) {
      const double u = static_cast<double>(i) / size;
      const double v = static_cast<double>(j) / size;
      Vec3 x = u * (1 - v) * spoke(sector);
      if (j > 0) x += u * v * tip(sector) + (1 - u) * v * spoke((sector + 1) % num_spokes);
      it->second = b.add_point(x);
    }
    return it->second;
  };
  vertex(0, 0, 0);
  for (int s = 0; s < num_sectors; ++s)
    for (int j = 0; j < size; ++j)
      for (int i = 0; i < size; ++i)
        b.add_face(
            {vertex(s, i, j), vertex(s, i + 1, j), vertex(s, i + 1, j + 1), vertex(s, i, j + 1)});
  return b.build();
}

Vec3 on_circle(double angle, double radius) {
  return {radius * std::cos(angle), radius * std::sin(angle), 0.0};
}

}  // namespace

Mesh cube() {
  Builder b(4);
  for (int i = 0; i < 8; ++i)
    b.add_point({i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0});
  b.add_face({0, 2, 3, 1});
  b.add_face({4, 5, 7, 6});
  b.add_face({0, 1, 5, 4});
  b.add_face({2, 6, 7, 3});
  b.add_face({0, 4, 6, 2});
  b.add_face({1, 3, 7, 5});
  return b.build();
}

Mesh tetrahedron() {
  Builder b(3);
  for (const Vec3& x : {Vec3(1, 1, 1), Vec3(1, -1, -1), Vec3(-1, 1, -1), Vec3(-1, -1, 1)})
    b.add_point(x / std::sqrt(3.0));
  b.add_face({0, 1, 2});
  b.add_face({0, 2, 3});
  b.add_face({0, 3, 1});
  b.add_face({1, 3, 2});
  return b.build();
}

Mesh icosahedron() {
  Builder b(3);
  // A pole, two rings of five, a pole.
  const double z = 1.0 / std::sqrt(5.0);
  b.add_point({0, 0, 1});
  for (int i = 0; i < 5; ++i)
    b.add_point(on_circle(2 * pi * i / 5, 2 * z) + Vec3(0, 0, z));
  for (int i = 0; i < 5; ++i)
    b.add_point(on_circle(2 * pi * (i + 0.5) / 5, 2 * z) - Vec3(0, 0, z));
  b.add_point({0, 0, -1});
  for (int i = 0; i < 5; ++i) {
    const int k = (i + 1) % 5;
    b.add_face({0, 1 + i, 1 + k});
    b.add_face({1 + i, 6 + i, 1 + k});
    b.add_face({1 + k, 6 + i, 6 + k});
    b.add_face({6 + i, 11, 6 + k});
  }
  return b.build();
}

Mesh torus(int columns, int lines) {
  LIMES_ASSERT(columns >= 3 && lines >= 3);
  return block(columns, lines, true, true, [&](int i, int j) {
    const double a = 2 * pi * i / columns;
    const double b = 2 * pi * j / lines;
    return Vec3(on_circle(a, 2 + std::cos(b)) + Vec3(0, 0, std::sin(b)));
  });
}

Mesh grid(int columns, int lines) {
  return block(columns, lines, false, false, [](int i, int j) { return Vec3(i, j, 0); });
}

Mesh grid_with_hole(int size) {
  LIMES_ASSERT(size >= 3 && size % 2 == 1);
  const Mesh whole = grid(size, size);
  std::vector<VertexId> corners;
  for (int f = 0; f < whole.topology.num_faces(); ++f) {
    const auto face = whole.topology.face(FaceId(f));
    if (f != size * size / 2) corners.insert(corners.end(), face.begin(), face.end());
  }
  Mesh mesh;
  mesh.topology = Topology(whole.topology.num_vertices(), 4, std::move(corners));
  mesh.points = whole.points;
  return mesh;
}

Mesh polygon(int n) {
  LIMES_ASSERT(n >= 3);
  Mesh mesh;
  std::vector<VertexId> corners;
  for (int i = 0; i < n; ++i) {
    corners.emplace_back(i);
    mesh.points.push_back(on_circle(2 * pi * i / n, 1));
  }
  mesh.topology = Topology(n, n, std::move(corners));
  return mesh;
}

Mesh disk(int n, int size) {
  LIMES_ASSERT(n >= 3 && size >= 1);
  const double apothem = std::cos(pi / n);
  return sectors(
      n, size, true, [&](int s) { return on_circle(2 * pi * s / n, apothem); },
      [&](int s) { return on_circle(2 * pi * (s + 0.5) / n, 1); });
}

Mesh star(int n, int size) {
  LIMES_ASSERT(n >= 2 && size >= 1);
  return sectors(
      n, size, true, [&](int s) { return on_circle(2 * pi * s / n, 1); },
      [&](int s) { return on_circle(2 * pi * (s + 0.5) / n, 1.4); });
}

Mesh triangle_star(int n, int size) {
  LIMES_ASSERT(n >= 3 && size >= 1);
  Builder b(3);
  b.add_point(Vec3::Zero());
  // Ring r has r vertices per sector, from its spoke on.
  const auto vertex = [&](int r, int k) {
    return r == 0 ? 0 : 1 + n * (r - 1) * r / 2 + k % (n * r);
  };
  for (int r = 1; r <= size; ++r)
    for (int s = 0; s < n; ++s)
      for (int i = 0; i < r; ++i)
        b.add_point((on_circle(2 * pi * s / n, r - i) + on_circle(2 * pi * (s + 1) / n, i)) / size);
  for (int r = 1; r <= size; ++r)
    for (int s = 0; s < n; ++s)
      for (int i = 0; i < r; ++i) {
        const int inner = s * (r - 1) + i, outer = s * r + i;
        b.add_face({vertex(r - 1, inner), vertex(r, outer), vertex(r, outer + 1)});
        if (i + 1 < r)
          b.add_face({vertex(r - 1, inner), vertex(r, outer + 1), vertex(r - 1, inner + 1)});
      }
  return b.build();
}

Mesh half_disk(int num_faces, int size) {
  LIMES_ASSERT(num_faces >= 1 && size >= 1);
  const double step = num_faces == 1 ? pi / 2 : pi / num_faces;
  return sectors(
      num_faces, size, false, [&](int s) { return on_circle(step * s, 1); },
      [&](int s) { return on_circle(step * (s + 0.5), 1.4); });
}

Mesh cylinder(int columns, int lines) {
  LIMES_ASSERT(columns >= 3 && lines >= 1);
  return block(columns, lines, true, false, [&](int i, int j) {
    return Vec3(on_circle(2 * pi * i / columns, 1) + Vec3(0, 0, j));
  });
}

Mesh moebius_strip(int n) {
  LIMES_ASSERT(n >= 3);
  Builder b(4);
  for (int i = 0; i < n; ++i) {
    const double a = 2 * pi * i / n;
    for (const double side : {-0.5, 0.5})
      b.add_point(on_circle(a, 2 + side * std::cos(a / 2)) + Vec3(0, 0, side * std::sin(a / 2)));
  }
  for (int i = 0; i + 1 < n; ++i)
    b.add_face({2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1});
  b.add_face({2 * n - 2, 1, 0, 2 * n - 1});
  return b.build();
}

}  // namespace limes::shapes
