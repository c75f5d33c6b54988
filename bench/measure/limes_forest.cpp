// A step of local refinement beside building the mesh, by limes.
//   --in FILE (quads or triangles) --scheme kobbelt (or bisect: halves, placed by linear) --share S (part of the faces that a step splits, in one piece)
//   --levels N (all faces split before, which counts as building) --repeats R   each time on a new forest
#include "input.h"
#include "limes/subdiv/bisection_forest.h"
#include "limes/subdiv/forest.h"
#include "limes/subdiv/schemes.h"

using namespace bench;

namespace {

struct Measured {
  std::vector<double> build, step;
  int split = 0;
  std::size_t leaves = 0;
};

/// Adds one measurement.
/// @param timer  started before the forest was made
void measure(limes::LocalRefinement&& forest, Timer& timer, int levels, double share,
             Measured& all) {
  for (int level = 0; level < levels; ++level)
    forest.refine(forest.leaves());
  all.build.push_back(timer.wall());
  std::vector<limes::FaceId> marked = forest.leaves();
  all.leaves = marked.size();
  marked.resize(static_cast<std::size_t>(share * static_cast<double>(all.leaves)));
  timer.restart();
  all.split = forest.refine(marked);
  all.step.push_back(timer.wall());
}

void run(const Args& args) {
  const std::string in = args.get("in", "shape:torus:1000:1000");
  const limes::Mesh mesh = load_mesh(in);
  const std::string name = args.get("scheme", "kobbelt");
  const bool bisect = name == "bisect";
  const limes::Scheme& scheme = limes::find_scheme(bisect ? "linear" : name);
  const double share = std::stod(args.get("share", "0.01"));
  const int repeats = args.get("repeats", 3);
  const std::int64_t rss_before = peak_rss();

  Measured all;
  const int levels = args.get("levels", 0);
  for (int r = 0; r < repeats; ++r) {
    Timer timer;
    if (bisect)
      measure(limes::BisectionForest(mesh), timer, levels, share, all);
    else
      measure(limes::Forest(mesh, scheme, {}), timer, levels, share, all);
  }
  JsonLine line = first_fields(args, bisect ? "bisection" : "forest", in, scheme);
  line.add("in_faces", mesh.topology.num_faces())
      .add("levels", levels)
      .add("leaves", all.leaves)
      .add("split", all.split);
  line.add("seconds_build", median(all.build)).add("seconds_step", median(all.step));
  line.add("ratio", median(all.step) / median(all.build));
  line.add("rss_before", rss_before).add("peak_rss", peak_rss());
  args.require_all_read();
  line.print();
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("limes_forest", argc, argv, run);
}
