// OpenSubdiv Far: uniform refinement, topology (TopologyRefiner) and positions
// (PrimvarRefiner) timed apart.
//   --in FILE --scheme catmull-clark|loop --levels N --precision double|float
//   --full-topology 0|1  --limit 0|1 (limit positions and tangents of the last level)
#include <opensubdiv/far/primvarRefiner.h>

#include "measure.h"
#include "osd_common.h"

using namespace bench;

template <typename Real>
void run(const Args& args, const Mesh& mesh) {
  const std::string scheme = args.get("scheme", "catmull-clark");
  const int levels = args.get("levels", 3);
  const bool limit = args.get("limit", 0) != 0;
  const bool full = limit || args.get("full-topology", 0) != 0;
  using Point = Values<Real, 3>;

  std::vector<Point> coarse = control_points<Real>(mesh);
  const std::int64_t rss_before = peak_rss();

  Timer timer;
  auto refiner = make_refiner(mesh, scheme);
  osd::Far::TopologyRefiner::UniformOptions options(levels);
  options.fullTopologyInLastLevel = full;
  refiner->RefineUniform(options);
  const double topology = timer.wall(), topology_cpu = timer.cpu();

  timer.restart();
  osd::Far::PrimvarRefinerReal<Real> primvar(*refiner);
  std::vector<Point> source = std::move(coarse), target;
  for (int level = 1; level <= levels; ++level) {
    target.resize(std::size_t(refiner->GetLevel(level).GetNumVertices()));
    primvar.Interpolate(level, source, target);
    source.swap(target);
  }
  const double positions = timer.wall(), positions_cpu = timer.cpu();

  double limit_seconds = NAN, limit_cpu = NAN;
  if (limit) {
    std::vector<Point> p(source.size()), du(source.size()), dv(source.size());
    timer.restart();
    primvar.Limit(source, p, du, dv);
    limit_seconds = timer.wall();
    limit_cpu = timer.cpu();
  }

  Centroid centroid;
  for (const Point& p : source)
    centroid.add(p.x[0], p.x[1], p.x[2]);
  const auto& last = refiner->GetLevel(levels);
  JsonLine line;
  line.add("library", "opensubdiv-far").add("version", osd_version());
  line.add("scheme", scheme).add("model", mesh.name);
  line.add("variant",
           std::string(sizeof(Real) == 8 ? "double" : "float") + (limit  ? ",limit"
                                                                  : full ? ",full-topology"
                                                                         : ""));
  line.add("threads", 1).add("levels", levels).add("in_faces", mesh.num_faces());
  line.add("out_faces", last.GetNumFaces()).add("out_vertices", last.GetNumVertices());
  line.add("seconds_topology", topology).add("seconds_positions", positions);
  line.add("seconds", topology + positions);
  line.add("cpu_seconds_topology", topology_cpu).add("cpu_seconds_positions", positions_cpu);
  line.add("cpu_seconds", topology_cpu + positions_cpu);
  if (limit) line.add("seconds_limit", limit_seconds).add("cpu_seconds_limit", limit_cpu);
  line.add("rss_before", rss_before).add("peak_rss", peak_rss());
  line.add("checksum", centroid.checksum());
  args.require_all_read();
  line.print();
}

int main(int argc, char** argv) {
  return run_program("osd_refine", argc, argv, [](const Args& args) {
    const Mesh mesh = read_mesh(args.get("in", "shape:cube"));
    if (args.get("precision", "double") == "double")
      run<double>(args, mesh);
    else
      run<float>(args, mesh);
  });
}
