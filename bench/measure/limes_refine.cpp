// Uniform refinement by limes, topology and positions timed apart.
//   --in FILE --scheme catmull-clark --levels N --threads T
//   --method uniform (UniformRefinement) | general (one RefinementStep a level)
//   --memory fresh | used: with `used` the result is written twice, the second time is measured;
//     what it costs to get memory from the system is then left out (method uniform only)
#include "input.h"
#include "limes/core/memory.h"
#include "limes/subdiv/refinement_step.h"
#include "limes/subdiv/schemes.h"
#include "limes/subdiv/uniform.h"

using namespace bench;

namespace {

struct Refined {
  double topology = 0, topology_cpu = 0, positions = 0, positions_cpu = 0;
  int faces = 0;
  limes::FreshArray<limes::VertexId> corners;
  limes::FreshArray<limes::Vec3> points;
};

/// Everything that depends on the topology, then positions; into the memory of `result` if it has any.
void refine_uniformly(const limes::Mesh& mesh, const limes::Scheme& scheme, int levels,
                      Refined& result) {
  Timer timer;
  const limes::Adjacency adjacency(mesh.topology);
  limes::UniformRefinement refinement(adjacency, features_of(mesh, adjacency), scheme, levels);
  result.faces = refinement.num_faces();
  const std::size_t face_size = scheme.split == limes::Split::triangles ? 3 : 4;
  if (result.corners.empty())
    result.corners =
        limes::FreshArray<limes::VertexId>(face_size * static_cast<std::size_t>(result.faces));
  refinement.corners(result.corners.span());
  const limes::Features features = refinement.features();
  result.topology = timer.wall();
  result.topology_cpu = timer.cpu();
  timer.restart();
  if (result.points.empty())
    result.points =
        limes::FreshArray<limes::Vec3>(static_cast<std::size_t>(refinement.num_vertices()));
  refinement.positions(mesh.points.span(), result.points.span());
  result.positions = timer.wall();
  result.positions_cpu = timer.cpu();
}

Refined refine_in_general(const limes::Mesh& mesh, const limes::Scheme& scheme, int levels) {
  Refined result;
  Timer timer;
  const auto topology_done = [&] {
    result.topology += timer.wall();
    result.topology_cpu += timer.cpu();
    timer.restart();
  };
  limes::Topology topology = mesh.topology;
  limes::Features features = features_of(mesh);
  std::vector<limes::Vec3> points = mesh.points.vector();
  for (int level = 0; level < levels; ++level) {
    const limes::Adjacency adjacency(
        topology, level == 0 ? limes::Adjacency::Check::surface : limes::Adjacency::Check::edges);
    const limes::RefinementStep step(adjacency, features, scheme);
    limes::Topology child = step.child_topology();
    limes::Features child_features = step.child_features();
    topology_done();
    std::vector<limes::Vec3> fine(static_cast<std::size_t>(step.num_child_vertices()));
    step.apply(points, fine);
    points = std::move(fine);
    result.positions += timer.wall();
    result.positions_cpu += timer.cpu();
    timer.restart();
    topology = std::move(child);
    features = std::move(child_features);
  }
  topology_done();
  result.faces = topology.num_faces();
  result.points = limes::FreshArray<limes::Vec3>(points.size());
  std::copy(points.begin(), points.end(), result.points.span().begin());
  return result;
}

void run(const Args& args) {
  const std::string in = args.get("in", "shape:cube");
  const limes::Mesh mesh = load_mesh(in);
  const limes::Scheme& scheme = limes::find_scheme(args.get("scheme", "catmull-clark"));
  const int levels = args.get("levels", 3);
  const std::string method = args.get("method", "uniform");
  use_threads(args.get("threads", 1));
  const std::int64_t rss_before = peak_rss();
  if (method != "uniform" && method != "general")
    throw std::runtime_error("unknown method " + method);
  const std::string memory = args.get("memory", "fresh");
  if (memory != "fresh" && memory != "used") throw std::runtime_error("memory: fresh or used");
  Refined result;
  if (method == "general") result = refine_in_general(mesh, scheme, levels);
  for (int pass = 0; method == "uniform" && pass < (memory == "used" ? 2 : 1); ++pass)
    refine_uniformly(mesh, scheme, levels, result);

  JsonLine line = first_fields(args, method, in, scheme);
  line.add("memory", memory).add("levels", levels).add("in_faces", mesh.topology.num_faces());
  line.add("out_faces", result.faces).add("out_vertices", result.points.span().size());
  line.add("seconds_topology", result.topology).add("seconds_positions", result.positions);
  line.add("seconds", result.topology + result.positions);
  line.add("cpu_seconds_topology", result.topology_cpu);
  line.add("cpu_seconds_positions", result.positions_cpu);
  line.add("cpu_seconds", result.topology_cpu + result.positions_cpu);
  line.add("rss_before", rss_before).add("peak_rss", peak_rss());
  line.add("checksum", checksum(result.points.span()));
  args.require_all_read();
  line.print();
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("limes_refine", argc, argv, run);
}
