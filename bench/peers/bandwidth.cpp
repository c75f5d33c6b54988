// Memory bandwidth, the physical limit for refinement output.
//   --megabytes M (per array) --threads T --repeats R
// Prints copy, triad and fill on touched memory, and first-touch fill (fresh pages, with
// and without huge pages).  Bytes counted are the ones the program names (no write-allocate).
#include <sys/mman.h>

#include <algorithm>
#include <functional>
#include <thread>

#include "measure.h"

using namespace bench;

namespace {

void parallel(int threads, std::size_t n, const std::function<void(std::size_t, std::size_t)>& f) {
  if (threads == 1) return f(0, n);
  std::vector<std::thread> pool;
  for (int t = 0; t < threads; ++t)
    pool.emplace_back(f, n * std::size_t(t) / std::size_t(threads),
                      n * std::size_t(t + 1) / std::size_t(threads));
  for (auto& t : pool)
    t.join();
}

double* map_pages(std::size_t bytes, bool huge) {
  void* p = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (p == MAP_FAILED) std::abort();
  madvise(p, bytes, huge ? MADV_HUGEPAGE : MADV_NOHUGEPAGE);
  return static_cast<double*>(p);
}

struct Times {
  std::vector<double> wall, cpu;
  void add(const Timer& timer) {
    wall.push_back(timer.wall());
    cpu.push_back(timer.cpu());
  }
};

void report(const std::string& kernel, int threads, std::size_t megabytes, double bytes,
            Times times) {
  std::sort(times.wall.begin(), times.wall.end());
  std::sort(times.cpu.begin(), times.cpu.end());
  const double median = times.wall[times.wall.size() / 2];
  const double cpu_median = times.cpu[times.cpu.size() / 2] / threads;
  JsonLine line;
  line.add("library", "bandwidth").add("kernel", kernel).add("threads", threads);
  line.add("megabytes_per_array", megabytes);
  line.add("gigabytes_per_second_median", bytes / median * 1e-9);
  line.add("gigabytes_per_second_best", bytes / times.wall.front() * 1e-9);
  // By CPU time of the threads: steadier than wall time on a machine that is shared.
  line.add("gigabytes_per_cpu_second_median", bytes / cpu_median * 1e-9);
  line.print();
}

}  // namespace

int main(int argc, char** argv) try {
  Args args(argc, argv);
  const std::size_t megabytes = std::size_t(args.get("megabytes", 1024));
  const int threads = args.get("threads", 1), repeats = args.get("repeats", 7);
  args.require_all_read();
  const std::size_t bytes = megabytes << 20, n = bytes / sizeof(double);

  double* a = map_pages(bytes, true);
  double* b = map_pages(bytes, true);
  double* c = map_pages(bytes, true);
  parallel(threads, n, [&](std::size_t i0, std::size_t i1) {
    for (std::size_t i = i0; i < i1; ++i)
      a[i] = 0, b[i] = double(i), c[i] = 1;
  });
  auto measure = [&](const char* name, double bytes_moved, auto kernel) {
    Times times;
    for (int r = 0; r <= repeats; ++r) {
      Timer timer;
      parallel(threads, n, kernel);
      if (r) times.add(timer);
    }
    report(name, threads, megabytes, bytes_moved, times);
  };
  const double s = 3.0;
  measure("copy", 2.0 * double(bytes), [=](std::size_t i0, std::size_t i1) {
    for (std::size_t i = i0; i < i1; ++i)
      a[i] = b[i];
  });
  measure("triad", 3.0 * double(bytes), [=](std::size_t i0, std::size_t i1) {
    for (std::size_t i = i0; i < i1; ++i)
      a[i] = b[i] + s * c[i];
  });
  measure("fill", double(bytes), [=](std::size_t i0, std::size_t i1) {
    for (std::size_t i = i0; i < i1; ++i)
      a[i] = s;
  });
  munmap(a, bytes);
  munmap(b, bytes);
  munmap(c, bytes);

  for (bool huge : {false, true}) {
    Times times;
    for (int r = 0; r < repeats; ++r) {
      double* fresh = map_pages(bytes, huge);
      Timer timer;
      parallel(threads, n, [=](std::size_t i0, std::size_t i1) {
        for (std::size_t i = i0; i < i1; ++i)
          fresh[i] = s;
      });
      times.add(timer);
      munmap(fresh, bytes);
    }
    report(huge ? "first-touch-fill-huge" : "first-touch-fill", threads, megabytes, double(bytes),
           times);
  }
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "bandwidth: %s\n", error.what());
  return 1;
}
