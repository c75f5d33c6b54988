#include "mesh_io.h"

#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace bench {
namespace {

std::string base_name(const std::string& path) {
  std::size_t slash = path.find_last_of('/');
  std::string name = slash == std::string::npos ? path : path.substr(slash + 1);
  std::size_t dot = name.find_last_of('.');
  return dot == std::string::npos ? name : name.substr(0, dot);
}

// One OpenSubdiv tag line: "t NAME NI/NF/NS ints floats strings".
void read_tag(std::istringstream& line, Mesh& mesh) {
  std::string name, counts;
  line >> name >> counts;
  int ni = 0, nf = 0, ns = 0;
  if (std::sscanf(counts.c_str(), "%d/%d/%d", &ni, &nf, &ns) != 3) return;
  std::vector<int> ints(ni);
  std::vector<float> floats(nf);
  std::vector<std::string> strings(ns);
  for (int& i : ints)
    line >> i;
  for (float& f : floats)
    line >> f;
  for (std::string& s : strings)
    line >> s;
  if (name == "crease" && nf > 0) {
    for (int j = 0; j + 1 < ni; j += 2)
      mesh.creases.push_back({ints[j], ints[j + 1], floats[nf > 1 ? j / 2 : 0]});
  } else if (name == "corner" && nf > 0) {
    for (int j = 0; j < ni; ++j)
      mesh.corners.push_back({ints[j], floats[nf > 1 ? j : 0]});
  } else if (name == "hole") {
    mesh.holes.insert(mesh.holes.end(), ints.begin(), ints.end());
  } else if (name == "interpolateboundary" && ni == 1) {
    mesh.boundary = ints[0] == 0   ? Boundary::none
                    : ints[0] == 1 ? Boundary::edge_and_corner
                                   : Boundary::edge_only;
  } else if (name == "facevaryinginterpolateboundary" && ni == 1) {
    mesh.face_varying_boundary = ints[0];
  } else if (name == "creasemethod" && ns > 0) {
    mesh.chaikin_creases = strings[0] == "chaikin";
  } else if (name == "smoothtriangles" && ns > 0) {
    mesh.smooth_triangles = strings[0] == "smooth";
  }
}

Mesh read_obj(std::istream& in) {
  Mesh mesh;
  std::string text;
  while (std::getline(in, text)) {
    std::istringstream line(text);
    std::string key;
    line >> key;
    if (key == "v") {
      double x, y, z;
      line >> x >> y >> z;
      mesh.points.insert(mesh.points.end(), {x, y, z});
    } else if (key == "vt") {
      double u, v;
      line >> u >> v;
      mesh.uvs.insert(mesh.uvs.end(), {u, v});
    } else if (key == "f") {
      int size = 0;
      for (std::string corner; line >> corner; ++size) {
        int v = 0, t = 0;
        int fields = std::sscanf(corner.c_str(), "%d/%d", &v, &t);
        mesh.face_vertices.push_back(v > 0 ? v - 1 : mesh.num_vertices() + v);
        if (fields == 2) mesh.face_uvs.push_back(t > 0 ? t - 1 : int(mesh.uvs.size() / 2) + t);
      }
      mesh.face_sizes.push_back(size);
    } else if (key == "t") {
      read_tag(line, mesh);
    }
  }
  if (mesh.face_uvs.size() != mesh.face_vertices.size()) mesh.face_uvs.clear();
  return mesh;
}

Mesh read_off(std::istream& in) {
  Mesh mesh;
  std::string magic;
  in >> magic;
  if (magic != "OFF") throw std::runtime_error("not an ASCII OFF file");
  int nv = 0, nf = 0, ne = 0;
  in >> nv >> nf >> ne;
  mesh.points.resize(3 * std::size_t(nv));
  for (double& x : mesh.points)
    in >> x;
  std::string rest;
  std::getline(in, rest);
  for (int f = 0; f < nf; ++f) {
    std::getline(in, rest);
    std::istringstream line(rest);
    int n = 0;
    line >> n;
    mesh.face_sizes.push_back(n);
    for (int i = 0, v = 0; i < n && line >> v; ++i)
      mesh.face_vertices.push_back(v);
  }
  return mesh;
}

void add_face(Mesh& mesh, std::initializer_list<int> corners) {
  mesh.face_sizes.push_back(int(corners.size()));
  mesh.face_vertices.insert(mesh.face_vertices.end(), corners);
}

void add_quad(Mesh& mesh, int a, int b, int c, int d, bool split) {
  if (split) {
    add_face(mesh, {a, b, c});
    add_face(mesh, {a, c, d});
  } else {
    add_face(mesh, {a, b, c, d});
  }
}

Mesh torus(int m, int n, bool split) {
  Mesh mesh;
  const double pi = std::acos(-1.0);
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < n; ++j) {
      double a = 2 * pi * i / m, b = 2 * pi * j / n, r = 2 + std::cos(b);
      mesh.points.insert(mesh.points.end(), {r * std::cos(a), r * std::sin(a), std::sin(b)});
    }
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < n; ++j) {
      int i1 = (i + 1) % m, j1 = (j + 1) % n;
      add_quad(mesh, i * n + j, i1 * n + j, i1 * n + j1, i * n + j1, split);
    }
  return mesh;
}

Mesh grid(int m, int n) {
  Mesh mesh;
  for (int i = 0; i <= m; ++i)
    for (int j = 0; j <= n; ++j)
      mesh.points.insert(mesh.points.end(), {double(i), double(j), 0.3 * ((i * 7 + j * 3) % 5)});
  int s = n + 1;
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < n; ++j)
      add_face(mesh, {i * s + j, (i + 1) * s + j, (i + 1) * s + j + 1, i * s + j + 1});
  return mesh;
}

Mesh procedural(const std::string& spec) {
  std::istringstream in(spec);
  std::string kind, part;
  std::getline(in, kind, ':');
  std::vector<int> sizes;
  while (std::getline(in, part, ':'))
    sizes.push_back(std::stoi(part));
  auto size = [&](std::size_t i, int fallback) { return i < sizes.size() ? sizes[i] : fallback; };
  Mesh mesh;
  if (kind == "cube") {
    mesh.points = {-1, -1, -1, 1, -1, -1, -1, 1, -1, 1, 1, -1,
                   -1, -1, 1,  1, -1, 1,  -1, 1, 1,  1, 1, 1};
    add_face(mesh, {0, 2, 3, 1});
    add_face(mesh, {4, 5, 7, 6});
    add_face(mesh, {0, 1, 5, 4});
    add_face(mesh, {2, 6, 7, 3});
    add_face(mesh, {0, 4, 6, 2});
    add_face(mesh, {1, 3, 7, 5});
  } else if (kind == "tetrahedron") {
    mesh.points = {1, 1, 1, -1, -1, 1, -1, 1, -1, 1, -1, -1};
    add_face(mesh, {0, 2, 1});
    add_face(mesh, {0, 1, 3});
    add_face(mesh, {0, 3, 2});
    add_face(mesh, {1, 2, 3});
  } else if (kind == "icosahedron") {
    const double t = (1 + std::sqrt(5.0)) / 2;
    mesh.points = {-1, t,  0,  1, t, 0,  -1, -t, 0,  1, -t, 0, 0,  -1, t,  0,  1, t,
                   0,  -1, -t, 0, 1, -t, t,  0,  -1, t, 0,  1, -t, 0,  -1, -t, 0, 1};
    for (auto f : {std::initializer_list<int>{0, 11, 5},
                   {0, 5, 1},
                   {0, 1, 7},
                   {0, 7, 10},
                   {0, 10, 11},
                   {1, 5, 9},
                   {5, 11, 4},
                   {11, 10, 2},
                   {10, 7, 6},
                   {7, 1, 8},
                   {3, 9, 4},
                   {3, 4, 2},
                   {3, 2, 6},
                   {3, 6, 8},
                   {3, 8, 9},
                   {4, 9, 5},
                   {2, 4, 11},
                   {6, 2, 10},
                   {8, 6, 7},
                   {9, 8, 1}})
      add_face(mesh, f);
  } else if (kind == "torus" || kind == "tri-torus") {
    mesh = torus(size(0, 16), size(1, 8), kind == "tri-torus");
  } else if (kind == "grid") {
    mesh = grid(size(0, 4), size(1, 4));
  } else {
    throw std::runtime_error("unknown shape:" + spec);
  }
  return mesh;
}

}  // namespace

Mesh read_mesh(const std::string& path) {
  Mesh mesh;
  if (path.rfind("shape:", 0) == 0) {
    mesh = procedural(path.substr(6));
    mesh.name = path.substr(6);
  } else {
    std::ifstream in(path);
    if (!in) throw std::runtime_error("cannot open " + path);
    bool off = path.size() > 4 && path.compare(path.size() - 4, 4, ".off") == 0;
    mesh = off ? read_off(in) : read_obj(in);
    mesh.name = base_name(path);
  }
  if (mesh.num_faces() == 0) throw std::runtime_error("no faces in " + path);
  for (int v : mesh.face_vertices)
    if (v < 0 || v >= mesh.num_vertices())
      throw std::runtime_error("face vertex out of range in " + path);
  return mesh;
}

}  // namespace bench
