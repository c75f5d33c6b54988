// CGAL Subdivision_method_3 on Surface_mesh (default) or Polyhedron_3, double precision.
//   --in FILE --scheme catmull-clark|loop|sqrt3|doo-sabin --levels N
//   --structure surface-mesh|polyhedron
// Catmull-Clark and Loop run twice: once whole and once with masks that do nothing
// (topology); seconds_positions is the difference.
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>
#include <CGAL/boost/graph/graph_traits_Surface_mesh.h>
#include <CGAL/subdivision_method_3.h>
#include <CGAL/version.h>

#include "measure.h"
#include "mesh_io.h"

using namespace bench;
using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;

namespace {

// A geometry policy that computes nothing, to time the connectivity alone.
template <typename Graph>
struct NoMask {
  using Traits = boost::graph_traits<Graph>;
  void face_node(typename Traits::face_descriptor, Point&) {}
  void edge_node(typename Traits::halfedge_descriptor, Point&) {}
  void vertex_node(typename Traits::vertex_descriptor, Point&) {}
  void border_node(typename Traits::halfedge_descriptor, Point&, Point&) {}
};

template <typename Graph>
Graph build(const Mesh& mesh) {
  std::vector<Point> points;
  for (int v = 0; v < mesh.num_vertices(); ++v)
    points.emplace_back(mesh.points[3 * v], mesh.points[3 * v + 1], mesh.points[3 * v + 2]);
  std::vector<std::vector<std::size_t>> polygons;
  std::size_t start = 0;
  for (int size : mesh.face_sizes) {
    polygons.emplace_back(mesh.face_vertices.begin() + start,
                          mesh.face_vertices.begin() + start + size);
    start += std::size_t(size);
  }
  namespace PMP = CGAL::Polygon_mesh_processing;
  if (!PMP::is_polygon_soup_a_polygon_mesh(polygons))
    throw std::runtime_error("CGAL: not an oriented manifold mesh: " + mesh.name);
  Graph graph;
  PMP::polygon_soup_to_polygon_mesh(points, polygons, graph);
  return graph;
}

template <typename Graph>
int run(const Args& args, const Mesh& mesh, const std::string& structure) {
  const std::string scheme = args.get("scheme", "catmull-clark");
  const int levels = args.get("levels", 3);
  namespace S = CGAL::Subdivision_method_3;
  const auto steps = CGAL::parameters::number_of_iterations(unsigned(levels));

  Graph graph = build<Graph>(mesh);
  const std::int64_t rss_before = peak_rss();
  Timer timer;
  if (scheme == "catmull-clark")
    S::CatmullClark_subdivision(graph, steps);
  else if (scheme == "loop")
    S::Loop_subdivision(graph, steps);
  else if (scheme == "sqrt3")
    S::Sqrt3_subdivision(graph, steps);
  else if (scheme == "doo-sabin")
    S::DooSabin_subdivision(graph, steps);
  else
    throw std::runtime_error("CGAL has no scheme " + scheme);
  const double seconds = timer.wall(), cpu = timer.cpu();

  Centroid centroid;
  auto vpm = get(CGAL::vertex_point, graph);
  for (auto v : vertices(graph)) {
    const Point& p = get(vpm, v);
    centroid.add(p.x(), p.y(), p.z());
  }
  const std::int64_t rss_peak = peak_rss();

  double topology = NAN, topology_cpu = NAN;
  if (scheme == "catmull-clark" || scheme == "loop") {
    graph = build<Graph>(mesh);
    timer.restart();
    if (scheme == "loop")
      S::PTQ(graph, NoMask<Graph>(), steps);
    else
      S::PQQ(graph, NoMask<Graph>(), steps);
    topology = timer.wall();
    topology_cpu = timer.cpu();
  }

  JsonLine line;
  line.add("library", "cgal").add("version", CGAL_VERSION_STR);
  line.add("scheme", scheme).add("model", mesh.name).add("variant", "double," + structure);
  line.add("threads", 1).add("levels", levels).add("in_faces", mesh.num_faces());
  line.add("out_faces", std::size_t(num_faces(graph)));
  line.add("out_vertices", std::size_t(num_vertices(graph)));
  line.add("seconds_topology", topology).add("seconds_positions", seconds - topology);
  line.add("seconds", seconds);
  line.add("cpu_seconds_topology", topology_cpu).add("cpu_seconds_positions", cpu - topology_cpu);
  line.add("cpu_seconds", cpu);
  line.add("rss_before", rss_before).add("peak_rss", rss_peak);
  line.add("checksum", centroid.checksum());
  args.require_all_read();
  line.print();
  return 0;
}

}  // namespace

int main(int argc, char** argv) try {
  Args args(argc, argv);
  Mesh mesh = read_mesh(args.get("in", "shape:cube"));
  const std::string structure = args.get("structure", "surface-mesh");
  if (structure == "polyhedron") return run<CGAL::Polyhedron_3<Kernel>>(args, mesh, structure);
  return run<CGAL::Surface_mesh<Point>>(args, mesh, structure);
} catch (const std::exception& error) {
  std::fprintf(stderr, "cgal_subdivide: %s\n", error.what());
  return 1;
}
