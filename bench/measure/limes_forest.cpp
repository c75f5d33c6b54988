// A step of local refinement beside building the mesh, by limes.
//   --in FILE (of quads) --scheme kobbelt --share S (part of the faces that a step splits, in one piece)
//   --levels N (all faces split before, which counts as building) --repeats R   each time on a new forest
#include "input.h"
#include "limes/subdiv/forest.h"
#include "limes/subdiv/schemes.h"

using namespace bench;

namespace {

void run(const Args& args) {
  const std::string in = args.get("in", "shape:torus:1000:1000");
  const limes::Mesh mesh = load_mesh(in);
  const limes::Scheme& scheme = limes::find_scheme(args.get("scheme", "kobbelt"));
  const double share = std::stod(args.get("share", "0.01"));
  const int repeats = args.get("repeats", 3);
  const std::int64_t rss_before = peak_rss();

  std::vector<double> build, step;
  const int levels = args.get("levels", 0);
  int split = 0;
  std::size_t leaves = 0;
  for (int r = 0; r < repeats; ++r) {
    Timer timer;
    limes::Forest forest(mesh, scheme, {});
    for (int level = 0; level < levels; ++level)
      forest.refine(forest.leaves());
    build.push_back(timer.wall());
    std::vector<limes::FaceId> marked = forest.leaves();
    leaves = marked.size();
    marked.resize(static_cast<std::size_t>(share * static_cast<double>(leaves)));
    timer.restart();
    split = forest.refine(marked);
    step.push_back(timer.wall());
  }
  JsonLine line = first_fields(args, "forest", in, scheme);
  line.add("in_faces", mesh.topology.num_faces())
      .add("levels", levels)
      .add("leaves", leaves)
      .add("split", split);
  line.add("seconds_build", median(build)).add("seconds_step", median(step));
  line.add("ratio", median(step) / median(build));
  line.add("rss_before", rss_before).add("peak_rss", peak_rss());
  args.require_all_read();
  line.print();
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("limes_forest", argc, argv, run);
}
