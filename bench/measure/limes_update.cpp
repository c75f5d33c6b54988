// New positions on a topology that stays, by limes: what a stencil table is for.
//   --in FILE --scheme catmull-clark --levels N --threads T --repeats R
//   --method general (every level's RefinementStep is kept and applied again)
#include <deque>
#include <utility>

#include "input.h"
#include "limes/subdiv/refinement_step.h"
#include "limes/subdiv/schemes.h"

using namespace bench;

namespace {

/// The refined levels of a mesh without positions: a RefinementStep each.
class Levels {
 public:
  Levels(const limes::Mesh& mesh, const limes::Scheme& scheme, int count) {
    limes::Topology topology = mesh.topology;
    limes::Features features = features_of(mesh);
    for (int i = 0; i < count; ++i) {
      const limes::RefinementStep& step =
          levels_.emplace_back(std::move(topology), std::move(features), scheme).step;
      topology = step.child_topology();
      features = step.child_features();
    }
    num_faces_ = topology.num_faces();
  }

  [[nodiscard]] int num_faces() const { return num_faces_; }
  /// buffers[i] gets the points of level i + 1.
  void update(std::span<const limes::Vec3> coarse, std::vector<std::vector<limes::Vec3>>& buffers) {
    buffers.resize(levels_.size());
    for (std::size_t i = 0; i < levels_.size(); ++i) {
      buffers[i].resize(static_cast<std::size_t>(levels_[i].step.num_child_vertices()));
      levels_[i].step.apply(i == 0 ? coarse : buffers[i - 1], buffers[i]);
    }
  }

 private:
  struct Level {
    Level(limes::Topology t, limes::Features f, const limes::Scheme& scheme)
        : topology(std::move(t)),
          features(std::move(f)),
          adjacency(topology, limes::Adjacency::Check::edges),
          step(adjacency, features, scheme) {}
    limes::Topology topology;
    limes::Features features;
    limes::Adjacency adjacency;
    limes::RefinementStep step;
  };
  std::deque<Level> levels_;  // steps keep references
  int num_faces_ = 0;
};

void run(const Args& args) {
  const limes::Mesh mesh = load_mesh(args.get("in", "shape:cube"));
  const limes::Scheme& scheme = limes::find_scheme(args.get("scheme", "catmull-clark"));
  const int num_levels = args.get("levels", 3);
  const std::string method = args.get("method", "general");
  if (method != "general") throw std::runtime_error("unknown method " + method);
  use_threads(args.get("threads", 1));
  const std::int64_t rss_before = peak_rss();

  Timer timer;
  Levels levels(mesh, scheme, num_levels);
  const double build = timer.wall();
  const double build_cpu = timer.cpu();
  std::vector<std::vector<limes::Vec3>> points;
  std::vector<double> wall, cpu;
  for (int r = 0; r <= args.get("repeats", 5); ++r) {  // the first pass is a warm-up
    timer.restart();
    levels.update(mesh.points.span(), points);
    if (r == 0) continue;
    wall.push_back(timer.wall());
    cpu.push_back(timer.cpu());
  }

  JsonLine line = first_fields(args, method);
  line.add("levels", num_levels).add("in_faces", mesh.topology.num_faces());
  line.add("out_faces", levels.num_faces()).add("out_vertices", points.back().size());
  line.add("seconds_build", build).add("seconds_positions", median(wall));
  line.add("cpu_seconds_build", build_cpu).add("cpu_seconds_positions", median(cpu));
  line.add("rss_before", rss_before).add("peak_rss", peak_rss());
  line.add("checksum", checksum(points.back()));
  args.require_all_read();
  line.print();
}

}  // namespace

int main(int argc, char** argv) try {
  run(Args(argc, argv));
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "limes_update: %s\n", error.what());
  return 1;
}
