#pragma once

#include <chrono>
#include <cstdint>
#include <memory>

#include "memory.h"
#include "options.h"

namespace limes::app {

/// One run of a command: applies the number of threads and the memory limit, and keeps the time.
class Run {
 public:
  /// @throws UsageError for values that are no number of threads, no size
  explicit Run(const RunOptions& options);
  ~Run();
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;

  [[nodiscard]] double seconds() const;
  /// Bytes this run may use.
  [[nodiscard]] std::int64_t memory_limit() const { return memory_limit_; }

 private:
  struct Threads;
  std::unique_ptr<Threads> threads_;
  std::unique_ptr<MemoryWatch> watch_;
  std::int64_t memory_limit_;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace limes::app
