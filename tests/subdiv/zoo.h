#pragma once

#include <random>
#include <string>
#include <vector>

#include "limes/mesh/shapes.h"
#include "subdiv/fits.h"

namespace limes {

/// A control mesh with a name, for tests of schemes.
struct Shape {
  std::string name;
  Mesh mesh;
};

inline Mesh bumpy(Mesh mesh) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> shift(-0.1, 0.1);
  for (Vec3& x : mesh.points)
    x += Vec3(shift(random), shift(random), shift(random));
  return mesh;
}

/// Faces cut into fans from their first corners; without tags.
inline Mesh triangulated(const Mesh& mesh) {
  Mesh out;
  std::vector<VertexId> corners;
  for (int f = 0; f < mesh.topology.num_faces(); ++f) {
    const auto face = mesh.topology.face(FaceId(f));
    for (std::size_t i = 1; i + 1 < face.size(); ++i)
      corners.insert(corners.end(), {face[0], face[i], face[i + 1]});
  }
  out.topology = Topology(mesh.topology.num_vertices(), 3, std::move(corners));
  out.points = mesh.points;
  return out;
}

/// A cube with everything that tags can say.
inline Mesh tagged_cube(CreaseMethod method) {
  Mesh mesh = bumpy(shapes::cube());
  mesh.tags.creases = {{VertexId(0), VertexId(1), 2.3F},
                       {VertexId(1), VertexId(3), 0.4F},
                       {VertexId(3), VertexId(2), 10.0F}};
  mesh.tags.corners = {{VertexId(5), 1.7F}, {VertexId(6), 10.0F}};
  mesh.tags.crease_method = method;
  return mesh;
}

/// Closed and open, regular and not, with tags and without; each also cut into triangles.
inline std::vector<Shape> zoo() {
  std::vector<Shape> shapes{{"cube", shapes::cube()},
                            {"tetrahedron", shapes::tetrahedron()},
                            {"icosahedron", shapes::icosahedron()},
                            {"torus", shapes::torus(5, 4)},
                            {"grid", shapes::grid(4, 3)},
                            {"strip", shapes::grid(6, 1)},
                            {"grid_with_hole", shapes::grid_with_hole(5)},
                            {"cylinder", shapes::cylinder(5, 3)},
                            {"tagged_cube", tagged_cube(CreaseMethod::uniform)},
                            {"chaikin_cube", tagged_cube(CreaseMethod::chaikin)}};
  for (const int n : {3, 5, 6, 8, 17}) {
    shapes.push_back({"disk" + std::to_string(n), shapes::disk(n, 2)});
    shapes.push_back({"polygon" + std::to_string(n), shapes::polygon(n)});
    shapes.push_back({"half_disk" + std::to_string(n), shapes::half_disk(n, 2)});
  }
  for (Shape& s : shapes)
    s.mesh = bumpy(std::move(s.mesh));
  const std::size_t count = shapes.size();
  for (std::size_t i = 0; i < count; ++i)
    if (shapes[i].mesh.topology.uniform_face_size() != 3)
      shapes.push_back({shapes[i].name + "_triangulated", triangulated(shapes[i].mesh)});
  return shapes;
}

}  // namespace limes
