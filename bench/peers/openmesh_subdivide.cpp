// OpenMesh uniform subdividers, double precision.
//   --in FILE --levels N
//   --scheme catmull-clark|loop|sqrt3|modified-butterfly|interpolating-sqrt3|
//            composite-loop|composite-sqrt3|midpoint
// OpenMesh changes connectivity and positions in one pass, so they are not timed apart.
#define OM_STATIC_BUILD
#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/CatmullClarkT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/CompositeLoopT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/CompositeSqrt3T.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/LoopT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/MidpointT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/ModifiedButterFlyT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/Sqrt3InterpolatingSubdividerLabsikGreinerT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/Sqrt3T.hh>

#include "measure.h"
#include "mesh_io.h"

using namespace bench;
namespace Uniform = OpenMesh::Subdivider::Uniform;

namespace {

struct DoubleTraits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};
using PolyMesh = OpenMesh::PolyMesh_ArrayKernelT<DoubleTraits>;
using TriMesh = OpenMesh::TriMesh_ArrayKernelT<DoubleTraits>;

struct CompositeTraits : OpenMesh::Subdivider::Uniform::CompositeTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};
using CompositeMesh = OpenMesh::TriMesh_ArrayKernelT<CompositeTraits>;

template <typename Graph>
Graph build(const Mesh& mesh) {
  Graph graph;
  std::vector<typename Graph::VertexHandle> handles;
  for (int v = 0; v < mesh.num_vertices(); ++v)
    handles.push_back(
        graph.add_vertex({mesh.points[3 * v], mesh.points[3 * v + 1], mesh.points[3 * v + 2]}));
  std::size_t start = 0;
  for (int size : mesh.face_sizes) {
    std::vector<typename Graph::VertexHandle> face;
    for (int i = 0; i < size; ++i)
      face.push_back(handles[std::size_t(mesh.face_vertices[start + std::size_t(i)])]);
    start += std::size_t(size);
    if (!graph.add_face(face).is_valid())
      throw std::runtime_error("OpenMesh: complex face in " + mesh.name);
  }
  return graph;
}

template <typename Graph, typename Subdivider>
int run(const Mesh& mesh, const std::string& scheme, int levels) {
  Graph graph = build<Graph>(mesh);
  const std::int64_t rss_before = peak_rss();
  Timer timer;
  {
    Subdivider subdivider;
    if (!subdivider.attach(graph)) throw std::runtime_error("OpenMesh: attach failed");
    if (!subdivider(std::size_t(levels))) throw std::runtime_error("OpenMesh: failed");
    subdivider.detach();
  }
  const double seconds = timer.wall(), cpu = timer.cpu();
  const std::int64_t rss_peak = peak_rss();

  Centroid centroid;
  for (auto v : graph.vertices()) {
    const auto& p = graph.point(v);
    centroid.add(p[0], p[1], p[2]);
  }
  JsonLine line;
  line.add("library", "openmesh").add("version", "9.0");
  line.add("scheme", scheme).add("model", mesh.name).add("variant", "double");
  line.add("threads", 1).add("levels", levels).add("in_faces", mesh.num_faces());
  line.add("out_faces", graph.n_faces()).add("out_vertices", graph.n_vertices());
  line.add_null("seconds_topology").add_null("seconds_positions").add("seconds", seconds);
  line.add("cpu_seconds", cpu);
  line.add("rss_before", rss_before).add("peak_rss", rss_peak);
  line.add("checksum", centroid.checksum());
  line.print();
  return 0;
}

}  // namespace

int main(int argc, char** argv) try {
  Args args(argc, argv);
  const Mesh mesh = read_mesh(args.get("in", "shape:cube"));
  const std::string scheme = args.get("scheme", "catmull-clark");
  const int levels = args.get("levels", 3);
  args.require_all_read();
  if (scheme == "catmull-clark")
    return run<PolyMesh, Uniform::CatmullClarkT<PolyMesh>>(mesh, scheme, levels);
  if (!mesh.all_triangles()) throw std::runtime_error(scheme + " needs triangles");
  if (scheme == "loop") return run<TriMesh, Uniform::LoopT<TriMesh>>(mesh, scheme, levels);
  if (scheme == "sqrt3") return run<TriMesh, Uniform::Sqrt3T<TriMesh>>(mesh, scheme, levels);
  if (scheme == "modified-butterfly")
    return run<TriMesh, Uniform::ModifiedButterflyT<TriMesh>>(mesh, scheme, levels);
  if (scheme == "interpolating-sqrt3")
    return run<TriMesh, Uniform::InterpolatingSqrt3LGT<TriMesh>>(mesh, scheme, levels);
  if (scheme == "midpoint")
    return run<PolyMesh, Uniform::MidpointT<PolyMesh>>(mesh, scheme, levels);
  if (scheme == "composite-loop")
    return run<CompositeMesh, Uniform::CompositeLoopT<CompositeMesh>>(mesh, scheme, levels);
  if (scheme == "composite-sqrt3")
    return run<CompositeMesh, Uniform::CompositeSqrt3T<CompositeMesh>>(mesh, scheme, levels);
  throw std::runtime_error("OpenMesh has no scheme " + scheme);
} catch (const std::exception& error) {
  std::fprintf(stderr, "openmesh_subdivide: %s\n", error.what());
  return 1;
}
