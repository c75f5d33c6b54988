// New positions on a topology that stays, by limes: what a stencil table is for elsewhere.
//   --in FILE --scheme catmull-clark --levels N --threads T --repeats R
//   --moved M (0: all control vertices; else only the first M of them, and what hangs on them)
#include "input.h"
#include "limes/subdiv/schemes.h"
#include "limes/subdiv/uniform.h"

using namespace bench;

namespace {

struct Times {
  std::vector<double> wall, cpu;
};

/// Moves all control vertices, or the first `moved`, a little, and refines again; and again.
Times update_repeatedly(limes::UniformRefinement& refinement, std::vector<limes::Vec3> control,
                        int moved, int repeats, std::vector<limes::Vec3>& fine) {
  std::vector<limes::VertexId> vertices;
  for (int v = 0; v < moved; ++v)
    vertices.emplace_back(v);
  refinement.positions(control, fine);
  Times times;
  Timer timer;
  for (int r = 0; r <= repeats; ++r) {  // the first pass is a warm-up
    for (const limes::VertexId v : vertices)
      control[static_cast<std::size_t>(v.value)] *= 1 + 1e-3;
    timer.restart();
    if (moved > 0)
      refinement.update(control, vertices, fine);
    else
      refinement.positions(control, fine);
    if (r == 0) continue;
    times.wall.push_back(timer.wall());
    times.cpu.push_back(timer.cpu());
  }
  return times;
}

void run(const Args& args) {
  const std::string in = args.get("in", "shape:cube");
  const limes::Mesh mesh = load_mesh(in);
  const limes::Scheme& scheme = limes::find_scheme(args.get("scheme", "catmull-clark"));
  const int levels = args.get("levels", 3), moved = args.get("moved", 0);
  if (moved < 0 || moved > mesh.topology.num_vertices())
    throw std::runtime_error("moved: 0 to all");
  use_threads(args.get("threads", 1));
  const std::int64_t rss_before = peak_rss();

  Timer timer;
  const limes::Adjacency adjacency(mesh.topology);
  limes::UniformRefinement refinement(adjacency, features_of(mesh), scheme, levels);
  const double build = timer.wall(), build_cpu = timer.cpu();
  std::vector<limes::Vec3> fine(static_cast<std::size_t>(refinement.num_vertices()));
  const Times times = update_repeatedly(refinement, mesh.points.vector(), moved,
                                        args.get("repeats", moved > 0 ? 101 : 5), fine);

  JsonLine line = first_fields(args, "uniform", in, scheme);
  line.add("levels", levels).add("in_faces", mesh.topology.num_faces()).add("moved", moved);
  line.add("out_faces", refinement.num_faces()).add("out_vertices", fine.size());
  line.add("seconds_build", build).add("seconds_positions", median(times.wall));
  line.add("cpu_seconds_build", build_cpu).add("cpu_seconds_positions", median(times.cpu));
  line.add("rss_before", rss_before).add("peak_rss", peak_rss());
  line.add("checksum", checksum(fine));
  args.require_all_read();
  line.print();
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("limes_update", argc, argv, run);
}
