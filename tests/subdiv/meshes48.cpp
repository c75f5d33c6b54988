#include "subdiv/meshes48.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>

#include "limes/mesh/adjacency.h"
#include "limes/mesh/measure.h"

namespace limes {

Mesh fan(int n, Centre centre) {
  const int first = centre == Centre::first ? 1 : 0, middle = centre == Centre::first ? 0 : n;
  Mesh mesh;
  mesh.points.resize(static_cast<std::size_t>(n) + 1, Vec3::Zero());
  std::vector<VertexId> corners;
  for (int i = 0; i < n; ++i) {
    const double a = 2 * std::numbers::pi * i / n;
    mesh.points[VertexId(first + i)] = Vec3(std::cos(a), std::sin(a), 0);
    for (const int v : {middle, first + i, first + (i + 1) % n})
      corners.emplace_back(v);
  }
  mesh.topology = Topology(n + 1, 3, std::move(corners));
  return mesh;
}

Mesh centre_triangles(const Mesh& mesh) {
  Mesh result;
  result.points = mesh.points;
  std::vector<VertexId> corners;
  for (int f = 0; f < mesh.topology.num_faces(); ++f) {
    const auto face = mesh.topology.face(FaceId(f));
    const VertexId centre(result.points.size());
    Vec3 mean = Vec3::Zero();
    for (std::size_t i = 0; i < face.size(); ++i) {
      corners.insert(corners.end(), {centre, face[i], face[(i + 1) % face.size()]});
      mean += mesh.points[face[i]] / static_cast<double>(face.size());
    }
    result.points.push_back(mean);
  }
  result.topology = Topology(result.points.size(), 3, std::move(corners));
  return result;
}

std::map<int, int> interior_valences(const Topology& topology) {
  const Adjacency adjacency(topology);
  std::map<int, int> count;
  for (int v = 0; v < topology.num_vertices(); ++v)
    if (adjacency.ring_start(VertexId(v)).valid() && !adjacency.is_boundary(VertexId(v)))
      ++count[adjacency.valence(VertexId(v))];
  return count;
}

int num_irregular(const Topology& topology) {
  int count = 0;
  for (const auto& [valence, number] : interior_valences(topology))
    if (valence != 4 && valence != 8) count += number;
  return count;
}

namespace {

/// Faces in the order in which they are met from one halfedge, with vertices numbered as they are met.
std::vector<int> code_from(const Adjacency& mesh, HalfedgeId start) {
  const Topology& topology = mesh.topology();
  std::vector<int> number(static_cast<std::size_t>(topology.num_vertices()), -1);
  std::vector<char> met(static_cast<std::size_t>(topology.num_faces()), 0);
  std::vector<HalfedgeId> entries{start};
  std::vector<int> code;
  int next = 0;
  met[static_cast<std::size_t>(mesh.face(start).value)] = 1;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    HalfedgeId h = entries[i];
    for (int k = 0; k < 3; ++k, h = mesh.next(h)) {
      int& v = number[static_cast<std::size_t>(mesh.from(h).value)];
      if (v < 0) v = next++;
      code.push_back(v);
      const HalfedgeId twin = mesh.twin(h);
      if (!twin.valid() || met[static_cast<std::size_t>(mesh.face(twin).value)]) continue;
      met[static_cast<std::size_t>(mesh.face(twin).value)] = 1;
      entries.push_back(twin);
    }
  }
  return code;
}

}  // namespace

std::vector<int> canonical_code(const Topology& topology) {
  const Adjacency mesh(topology);
  std::vector<int> best;
  for (int h = 0; h < topology.num_corners(); ++h) {
    std::vector<int> code = code_from(mesh, HalfedgeId(h));
    if (best.empty() || code < best) best = std::move(code);
  }
  return best;
}

namespace {

/// Faces of the child that are faces of the parent, in any rotation.
std::vector<char> kept_faces(const Topology& parent, const Topology& child) {
  const auto key = [](std::span<const VertexId> face) {
    std::array<int, 3> k{face[0].value, face[1].value, face[2].value};
    std::rotate(k.begin(), std::min_element(k.begin(), k.end()), k.end());
    return k;
  };
  std::set<std::array<int, 3>> all;
  for (int f = 0; f < child.num_faces(); ++f)
    all.insert(key(child.face(FaceId(f))));
  std::vector<char> kept;
  for (int f = 0; f < parent.num_faces(); ++f)
    kept.push_back(all.contains(key(parent.face(FaceId(f)))) ? 1 : 0);
  return kept;
}

}  // namespace

void expect_binary_step(const Topology& parent, const Topology& child, int num_unsplit) {
  const Adjacency before(parent), after(child);  // both are surfaces, orientable as they run
  const std::vector<char> kept = kept_faces(parent, child);
  EXPECT_EQ(std::count(kept.begin(), kept.end(), 1), num_unsplit);
  EXPECT_EQ(child.num_faces(), 2 * parent.num_faces() - num_unsplit);
  const auto euler = [](const Topology& t) {
    Mesh mesh;
    mesh.topology = t;
    mesh.points.resize(static_cast<std::size_t>(t.num_vertices()), Vec3::Zero());
    const MeshMeasure m = measure(mesh);
    return std::array{m.euler, m.components, m.boundary_loops};
  };
  EXPECT_EQ(euler(child), euler(parent));

  int on_boundary = 0;
  for (int i = parent.num_vertices(); i < child.num_vertices(); ++i) {
    const VertexId v(i);
    const bool boundary = after.is_boundary(v);
    on_boundary += boundary ? 1 : 0;
    EXPECT_EQ(after.valence(v), boundary ? 3 : 4);
    const HalfedgeId start = after.ring_start(v);
    for (HalfedgeId h = start; h.valid();) {
      EXPECT_LT(after.to(h).value, parent.num_vertices());
      EXPECT_LT(after.from(after.prev(h)).value, parent.num_vertices());
      h = after.ring_next(h);
      if (h == start) break;
    }
  }
  const int num_splits = child.num_vertices() - parent.num_vertices();
  EXPECT_EQ(child.num_faces(), parent.num_faces() + 2 * num_splits - on_boundary);

  for (int h = 0; h < parent.num_corners(); ++h) {
    const HalfedgeId twin = before.twin(HalfedgeId(h));
    if (!kept[static_cast<std::size_t>(before.face(HalfedgeId(h)).value)]) continue;
    EXPECT_TRUE(twin.valid()) << "a face at the boundary stayed unsplit";
    if (twin.valid()) {
      EXPECT_FALSE(kept[static_cast<std::size_t>(before.face(twin).value)]);
    }
  }
}

}  // namespace limes
