#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/ModifiedButterFlyT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/Sqrt3T.hh>

#include "witness/peers.h"

namespace limes::witness {
namespace {

struct DoubleTraits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
};
using TriMesh = OpenMesh::TriMesh_ArrayKernelT<DoubleTraits>;

TriMesh to_openmesh(const Mesh& mesh) {
  TriMesh out;
  std::vector<TriMesh::VertexHandle> handles;
  for (const Vec3& x : mesh.points)
    handles.push_back(out.add_vertex(TriMesh::Point(x.x(), x.y(), x.z())));
  for (int f = 0; f < mesh.topology.num_faces(); ++f) {
    std::vector<TriMesh::VertexHandle> face;
    for (const VertexId v : mesh.topology.face(FaceId(f)))
      face.push_back(handles[static_cast<std::size_t>(v.value)]);
    out.add_face(face);
  }
  return out;
}

PlainMesh from_openmesh(const TriMesh& mesh) {
  PlainMesh out;
  for (const auto v : mesh.vertices()) {
    const auto& p = mesh.point(v);
    out.points.emplace_back(p[0], p[1], p[2]);
  }
  for (const auto f : mesh.faces()) {
    std::vector<int> face;
    for (const auto v : mesh.fv_ccw_range(f))
      face.push_back(v.idx());
    out.faces.push_back(std::move(face));
  }
  return out;
}

template <class Subdivider>
PlainMesh subdivided(const Mesh& mesh, int levels) {
  TriMesh m = to_openmesh(mesh);
  Subdivider subdivider;
  subdivider.attach(m);
  subdivider(static_cast<std::size_t>(levels));
  subdivider.detach();
  m.garbage_collection();
  return from_openmesh(m);
}

}  // namespace

PlainMesh openmesh_sqrt3(const Mesh& mesh, int levels) {
  return subdivided<OpenMesh::Subdivider::Uniform::Sqrt3T<TriMesh, double>>(mesh, levels);
}
PlainMesh openmesh_butterfly(const Mesh& mesh, int levels) {
  return subdivided<OpenMesh::Subdivider::Uniform::ModifiedButterflyT<TriMesh, double>>(mesh,
                                                                                        levels);
}

}  // namespace limes::witness
