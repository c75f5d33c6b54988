// OpenSubdiv limit evaluation at random (face, u, v) locations.
//   --in FILE --scheme S --method patch|bfr|osd-batch --derivatives 0|1|2
//   --samples N --threads T --precision double|float
//   --level L (isolation level of patch/osd-batch; Bfr: approximation level, 0 default)
//   --repeats R (points_per_second is of the best, points_per_cpu_second of the median)
//   --order random|sorted (sorted: by face, the tessellation pattern)
// osd-batch is Osd::CpuEvaluator / OmpEvaluator::EvalPatches (float only).
#include <omp.h>
#include <opensubdiv/osd/cpuEvaluator.h>
#include <opensubdiv/osd/cpuPatchTable.h>
#include <opensubdiv/osd/ompEvaluator.h>
#include <opensubdiv/osd/types.h>

#include <thread>

#include "locations.h"
#include "measure.h"
#include "osd_surfaces.h"

using namespace bench;

namespace {

struct Result {
  int repeats = 3;
  double build = 0, build_cpu = 0;
  std::vector<double> seconds, cpu;
  Centroid centroid;
  std::size_t missed = 0;
};

template <typename Real, typename Surfaces>
void evaluate_all(const Surfaces& surfaces, const std::vector<Location>& locations, int derivatives,
                  int threads, Result& result) {
  std::vector<Sample<Real>> out(locations.size());
  std::vector<std::size_t> missed(std::size_t(threads), 0);
  auto work = [&](int t) {
    const std::size_t n = locations.size();
    const std::size_t begin = n * t / threads, end = n * (t + 1) / threads;
    std::size_t count = 0;
    for (std::size_t i = begin; i < end; ++i) {
      const Location& l = locations[i];
      if (!surfaces.evaluate(l.face, Real(l.u), Real(l.v), derivatives, out[i])) ++count;
    }
    missed[std::size_t(t)] = count;
  };
  for (int pass = 0; pass <= result.repeats; ++pass) {  // the first pass is a warm-up
    Timer timer;
    if (threads == 1) {
      work(0);
    } else {
      std::vector<std::thread> pool;
      for (int t = 0; t < threads; ++t)
        pool.emplace_back(work, t);
      for (auto& t : pool)
        t.join();
    }
    if (!pass) continue;
    result.seconds.push_back(timer.wall());
    result.cpu.push_back(timer.cpu());
  }
  for (const auto& s : out)
    result.centroid.add(s.d[0][0], s.d[0][1], s.d[0][2]);
  for (std::size_t m : missed)
    result.missed += m;
}

// Osd batch evaluation: PatchCoords are looked up beforehand (timed as part of seconds).
void evaluate_batch(const PatchSurfaces<float>& surfaces, const std::vector<Location>& locations,
                    int derivatives, int threads, Result& result) {
  using namespace osd::Osd;
  std::unique_ptr<CpuPatchTable> table(CpuPatchTable::Create(&surfaces.table()));
  std::vector<Values<float, 3>> d[6];
  for (int k = 0; k < (derivatives == 0 ? 1 : derivatives == 1 ? 3 : 6); ++k)
    d[k].resize(locations.size());
  const BufferDescriptor desc(0, 3, 3);
  const float* in = surfaces.points()[0].x;
  std::vector<PatchCoord> coords(locations.size());
  omp_set_num_threads(threads);
  auto out = [&](int k) { return d[k].empty() ? nullptr : d[k][0].x; };
  auto run = [&](auto evaluator) {
    using E = decltype(evaluator);
    const int n = int(coords.size());
    if (derivatives == 0)
      E::EvalPatches(in, desc, out(0), desc, n, coords.data(), table->GetPatchArrayBuffer(),
                     table->GetPatchIndexBuffer(), table->GetPatchParamBuffer());
    else if (derivatives == 1)
      E::EvalPatches(in, desc, out(0), desc, out(1), desc, out(2), desc, n, coords.data(),
                     table->GetPatchArrayBuffer(), table->GetPatchIndexBuffer(),
                     table->GetPatchParamBuffer());
    else
      E::EvalPatches(in, desc, out(0), desc, out(1), desc, out(2), desc, out(3), desc, out(4), desc,
                     out(5), desc, n, coords.data(), table->GetPatchArrayBuffer(),
                     table->GetPatchIndexBuffer(), table->GetPatchParamBuffer());
  };
  for (int pass = 0; pass <= result.repeats; ++pass) {
    Timer timer;
#pragma omp parallel for
    for (std::size_t i = 0; i < locations.size(); ++i) {
      const Location& l = locations[i];
      coords[i].handle = *surfaces.map().FindPatch(l.face, l.u, l.v);
      coords[i].s = l.u;
      coords[i].t = l.v;
    }
    if (threads > 1)
      run(OmpEvaluator());
    else
      run(CpuEvaluator());
    if (!pass) continue;
    result.seconds.push_back(timer.wall());
    result.cpu.push_back(timer.cpu());
  }
  for (const auto& p : d[0])
    result.centroid.add(p.x[0], p.x[1], p.x[2]);
}

template <typename Real>
void run(const Args& args, const Mesh& mesh) {
  const std::string scheme = args.get("scheme", "catmull-clark");
  const std::string method = args.get("method", "patch"), order = args.get("order", "random");
  const int derivatives = args.get("derivatives", 1), threads = args.get("threads", 1);
  const int level = args.get("level", method == "bfr" ? 0 : 6);
  const std::size_t samples = std::size_t(args.get("samples", 1000000));
  const std::int64_t rss_before = peak_rss();

  Result result;
  result.repeats = args.get("repeats", 3);
  std::size_t patches = 0;
  std::int64_t rss_built = 0;
  Timer timer;
  auto built = [&] {
    result.build = timer.wall();
    result.build_cpu = timer.cpu();
    rss_built = peak_rss();
  };
  auto locations = [&](int faces) {
    return random_locations(faces, samples, scheme == "loop", order == "sorted");
  };
  if (method == "bfr") {
    BfrSurfaces<Real> surfaces(mesh, scheme, level, level);
    built();
    for (int size : mesh.face_sizes)
      if (size != (scheme == "loop" ? 3 : 4))
        throw std::runtime_error("bfr timing needs regular-size faces");
    patches = std::size_t(surfaces.num_faces());
    evaluate_all<Real>(surfaces, locations(surfaces.num_faces()), derivatives, threads, result);
  } else if (method == "patch") {
    PatchSurfaces<Real> surfaces(mesh, scheme, level);
    built();
    patches = std::size_t(surfaces.num_patches());
    evaluate_all<Real>(surfaces, locations(surfaces.num_faces()), derivatives, threads, result);
  } else if (method == "osd-batch" && sizeof(Real) == 4) {
    PatchSurfaces<float> surfaces(mesh, scheme, level);
    built();
    patches = std::size_t(surfaces.num_patches());
    evaluate_batch(surfaces, locations(surfaces.num_faces()), derivatives, threads, result);
  } else {
    throw std::runtime_error("unknown method, or osd-batch without --precision float");
  }

  std::sort(result.seconds.begin(), result.seconds.end());
  std::sort(result.cpu.begin(), result.cpu.end());
  const double seconds = result.seconds[result.seconds.size() / 2];
  const double cpu = result.cpu[result.cpu.size() / 2];
  JsonLine line;
  line.add("library", "opensubdiv-" + method).add("version", osd_version());
  line.add("scheme", scheme).add("model", mesh.name);
  line.add("variant", std::string(sizeof(Real) == 8 ? "double" : "float") + "," + order + ",level" +
                          std::to_string(level) + ",d" + std::to_string(derivatives));
  line.add("threads", threads).add("levels", level).add("in_faces", mesh.num_faces());
  line.add("derivatives", derivatives).add("samples", samples).add("patches", patches);
  line.add("seconds_build", result.build).add("seconds", seconds);
  line.add("seconds_best", result.seconds.front());
  line.add("cpu_seconds_build", result.build_cpu).add("cpu_seconds", cpu);
  line.add("points_per_second", double(samples) / result.seconds.front());
  line.add("points_per_cpu_second", double(samples) / cpu);
  line.add("missed", result.missed);
  line.add("rss_before", rss_before).add("rss_built", rss_built).add("peak_rss", peak_rss());
  line.add("checksum", result.centroid.checksum());
  args.require_all_read();
  line.print();
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("osd_evaluate", argc, argv, [](const Args& args) {
    const Mesh mesh = read_mesh(args.get("in", "shape:torus:64:32"));
    if (args.get("precision", "double") == "double")
      run<double>(args, mesh);
    else
      run<float>(args, mesh);
  });
}
