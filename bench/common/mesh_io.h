// Polygon meshes from OBJ (with OpenSubdiv's 't' tag lines) or OFF files, plus a few
// procedural shapes written as "shape:NAME".
#pragma once

#include <string>
#include <vector>

namespace bench {

struct Crease {
  int v0, v1;
  float sharpness;
};

struct Corner {
  int vertex;
  float sharpness;
};

enum class Boundary { none, edge_only, edge_and_corner };

struct Mesh {
  std::string name;
  std::vector<double> points;      // x y z per vertex
  std::vector<int> face_sizes;     // vertices per face
  std::vector<int> face_vertices;  // concatenated, 0-based
  std::vector<double> uvs;         // u v per value
  std::vector<int> face_uvs;       // empty, or one per face-vertex
  std::vector<Crease> creases;
  std::vector<Corner> corners;
  std::vector<int> holes;
  Boundary boundary = Boundary::edge_only;
  int face_varying_boundary = -1;  // OpenSubdiv Sdc::Options value, -1 unset
  bool chaikin_creases = false;
  bool smooth_triangles = false;

  int num_vertices() const { return int(points.size() / 3); }
  int num_faces() const { return int(face_sizes.size()); }
  bool all_triangles() const {
    for (int n : face_sizes)
      if (n != 3) return false;
    return true;
  }
};

// path is a .obj or .off file, or "shape:NAME" with NAME one of cube, tetrahedron,
// icosahedron, torus:M:N (M x N quads), grid:M:N (open), and tri-torus:M:N.
// Throws std::runtime_error on any error.
Mesh read_mesh(const std::string& path);

}  // namespace bench
