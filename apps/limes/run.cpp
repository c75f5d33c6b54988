#include "run.h"

#ifdef LIMES_WITH_TBB
#include <tbb/global_control.h>
#endif

namespace limes::app {
#ifdef LIMES_WITH_TBB
struct Run::Threads {
  explicit Threads(int number)
      : control(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(number)) {}
  tbb::global_control control;
};
#else
struct Run::Threads {
  explicit Threads(int) {}
};
#endif

Run::Run(const RunOptions& options)
    : memory_limit_(options.memory_limit.empty() ? free_memory()
                                                 : parse_size(options.memory_limit)),
      start_(std::chrono::steady_clock::now()) {
  if (!options.threads.empty())
    threads_ = std::make_unique<Threads>(parse_whole_number("--threads", options.threads, 1));
  watch_ = std::make_unique<MemoryWatch>(memory_limit_);
}

Run::~Run() = default;

double Run::seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

}  // namespace limes::app
