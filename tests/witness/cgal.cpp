#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/subdivision_method_3.h>

#include "witness/peers.h"

namespace limes::witness {
namespace {

using Point = CGAL::Simple_cartesian<double>::Point_3;
using SurfaceMesh = CGAL::Surface_mesh<Point>;

SurfaceMesh to_cgal(const Mesh& mesh) {
  SurfaceMesh out;
  std::vector<SurfaceMesh::Vertex_index> handles;
  for (const Vec3& x : mesh.points)
    handles.push_back(out.add_vertex(Point(x.x(), x.y(), x.z())));
  for (int f = 0; f < mesh.topology.num_faces(); ++f) {
    std::vector<SurfaceMesh::Vertex_index> face;
    for (const VertexId v : mesh.topology.face(FaceId(f)))
      face.push_back(handles[static_cast<std::size_t>(v.value)]);
    out.add_face(face);
  }
  return out;
}

PlainMesh from_cgal(SurfaceMesh& mesh) {
  mesh.collect_garbage();
  PlainMesh out;
  for (const auto v : mesh.vertices()) {
    const Point& p = mesh.point(v);
    out.points.emplace_back(p.x(), p.y(), p.z());
  }
  for (const auto f : mesh.faces()) {
    std::vector<int> face;
    for (const auto v : mesh.vertices_around_face(mesh.halfedge(f)))
      face.push_back(static_cast<int>(v.idx()));
    out.faces.push_back(std::move(face));
  }
  return out;
}

}  // namespace

PlainMesh cgal_doo_sabin(const Mesh& mesh, int levels) {
  SurfaceMesh m = to_cgal(mesh);
  CGAL::Subdivision_method_3::DooSabin_subdivision(m,
                                                   CGAL::parameters::number_of_iterations(levels));
  return from_cgal(m);
}
PlainMesh cgal_sqrt3(const Mesh& mesh, int levels) {
  SurfaceMesh m = to_cgal(mesh);
  CGAL::Subdivision_method_3::Sqrt3_subdivision(m, CGAL::parameters::number_of_iterations(levels));
  return from_cgal(m);
}
PlainMesh cgal_loop(const Mesh& mesh, int levels) {
  SurfaceMesh m = to_cgal(mesh);
  CGAL::Subdivision_method_3::Loop_subdivision(m, CGAL::parameters::number_of_iterations(levels));
  return from_cgal(m);
}

}  // namespace limes::witness
