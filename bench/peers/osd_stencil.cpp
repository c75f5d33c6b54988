// OpenSubdiv Far::StencilTable: build once, then update positions repeatedly.
//   --in FILE --scheme S --levels N --threads T --repeats R
//   --precision float (Osd::CpuEvaluator, or when T > 1 --evaluator omp, Osd::OmpEvaluator,
//                      or --evaluator ranges, Osd::CpuEvaluator on one range a thread)
//               double (Far::StencilTable::UpdateValues, 1 thread)
#include <omp.h>
#include <opensubdiv/far/stencilTable.h>
#include <opensubdiv/far/stencilTableFactory.h>
#include <opensubdiv/osd/cpuEvaluator.h>
#include <opensubdiv/osd/ompEvaluator.h>

#include <algorithm>
#include <thread>

#include "measure.h"
#include "osd_common.h"

using namespace bench;

template <typename Real>
void run(const Args& args, const Mesh& mesh) {
  const std::string scheme = args.get("scheme", "catmull-clark");
  const int levels = args.get("levels", 3), repeats = args.get("repeats", 5);
  const int threads = sizeof(Real) == 8 ? 1 : args.get("threads", 1);
  const bool ranges = args.get("evaluator", "omp") == "ranges";
  using Factory = osd::Far::StencilTableFactoryReal<Real>;

  const auto coarse = control_points<Real>(mesh);
  const std::int64_t rss_before = peak_rss();

  Timer timer;
  auto refiner = make_refiner(mesh, scheme);
  refiner->RefineUniform(osd::Far::TopologyRefiner::UniformOptions(levels));
  const double topology = timer.wall(), topology_cpu = timer.cpu();

  timer.restart();
  typename Factory::Options options;
  options.generateOffsets = true;
  options.generateIntermediateLevels = false;
  std::unique_ptr<const osd::Far::StencilTableReal<Real>> table(Factory::Create(*refiner, options));
  const double build = timer.wall(), build_cpu = timer.cpu();

  const std::size_t n = std::size_t(table->GetNumStencils());
  std::vector<Values<Real, 3>> refined(n);
  std::vector<double> times, cpu_times;
  omp_set_num_threads(threads);
  for (int r = 0; r <= repeats; ++r) {  // the first pass is a warm-up
    timer.restart();
    if constexpr (sizeof(Real) == 8) {
      table->UpdateValues(coarse, refined);
    } else {
      const float* in = coarse[0].x;
      float* out = refined[0].x;
      const osd::Osd::BufferDescriptor desc(0, 3, 3);
      const int* sizes = table->GetSizes().data();
      const int* offsets = table->GetOffsets().data();
      const int* indices = table->GetControlIndices().data();
      const float* weights = table->GetWeights().data();
      auto eval = [&](auto evaluator, int begin, int end) {
        decltype(evaluator)::EvalStencils(in, desc, out + 3 * std::size_t(begin), desc, sizes,
                                          offsets, indices, weights, begin, end);
      };
      if (threads == 1) {
        eval(osd::Osd::CpuEvaluator(), 0, int(n));
      } else if (!ranges) {
        eval(osd::Osd::OmpEvaluator(), 0, int(n));
      } else {
        std::vector<std::thread> pool;
        for (int t = 0; t < threads; ++t)
          pool.emplace_back(eval, osd::Osd::CpuEvaluator(), int(n * t / threads),
                            int(n * (t + 1) / threads));
        for (auto& t : pool)
          t.join();
      }
    }
    if (r) times.push_back(timer.wall()), cpu_times.push_back(timer.cpu());
  }
  std::sort(times.begin(), times.end());
  std::sort(cpu_times.begin(), cpu_times.end());

  Centroid centroid;
  for (const auto& p : refined)
    centroid.add(p.x[0], p.x[1], p.x[2]);
  const std::size_t entries = table->GetControlIndices().size();
  JsonLine line;
  line.add("library", "opensubdiv-stencil").add("version", osd_version());
  line.add("scheme", scheme).add("model", mesh.name);
  line.add("variant", sizeof(Real) == 8 ? "double"
                      : threads == 1    ? "float,cpu"
                      : ranges          ? "float,cpu-ranges"
                                        : "float,omp");
  line.add("threads", threads).add("levels", levels).add("in_faces", mesh.num_faces());
  line.add("out_faces", refiner->GetLevel(levels).GetNumFaces()).add("out_vertices", n);
  line.add("seconds_topology", topology).add("seconds_build", build);
  line.add("seconds_positions", times[times.size() / 2]);
  line.add("seconds_positions_best", times.front());
  line.add("cpu_seconds_topology", topology_cpu).add("cpu_seconds_build", build_cpu);
  line.add("cpu_seconds_positions", cpu_times[cpu_times.size() / 2]);
  line.add("stencil_entries", entries);
  line.add("stencil_bytes", entries * (sizeof(int) + sizeof(Real)) + n * 2 * sizeof(int));
  line.add("rss_before", rss_before).add("peak_rss", peak_rss());
  line.add("checksum", centroid.checksum());
  args.require_all_read();
  line.print();
}

int main(int argc, char** argv) {
  return run_program("osd_stencil", argc, argv, [](const Args& args) {
    const Mesh mesh = read_mesh(args.get("in", "shape:cube"));
    if (args.get("precision", "float") == "double")
      run<double>(args, mesh);
    else
      run<float>(args, mesh);
  });
}
