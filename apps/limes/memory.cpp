#include "memory.h"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <limits>

#include "exit_code.h"
#include "limes/core/atomic_file.h"
#include "limes/core/error.h"
#include "limes/core/interrupt.h"
#include "limes/core/text.h"
#include "terminal.h"

namespace limes::app {
namespace {

constexpr std::int64_t unknown = std::numeric_limits<std::int64_t>::max();
constexpr std::int64_t kilobyte = 1024;  // the kernel's kB

/// The only number in a file of the control group; "max" and a missing file are unknown.
std::int64_t read_number(const char* path) {
  std::ifstream file(path);
  std::int64_t value = 0;
  return file >> value ? value : unknown;
}

/// The number of a line "KEY  1234 kB" or "KEY 1234", in bytes.
std::int64_t read_entry(const char* path, std::string_view key, std::int64_t unit) {
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    std::string_view rest = line;
    if (next_token(rest) != key) continue;
    if (const auto number = parse_integer(next_token(rest))) return *number * unit;
  }
  return unknown;
}

/// What the group uses counts the files that it has read lately; those that nobody looks at any more
/// (inactive_file) make room as soon as memory is wanted.
std::int64_t free_in_control_group() {
  const std::int64_t limit = read_number("/sys/fs/cgroup/memory.max");
  const std::int64_t used = read_number("/sys/fs/cgroup/memory.current");
  if (limit == unknown || used == unknown) return unknown;
  const std::int64_t files = read_entry("/sys/fs/cgroup/memory.stat", "inactive_file", 1);
  return std::max<std::int64_t>(limit - used + (files == unknown ? 0 : files), 0);
}

/// The second number of statm, in pages.
std::int64_t used_memory() {
  std::ifstream file("/proc/self/statm");
  std::int64_t size = 0, resident = 0;
  return file >> size >> resident ? resident * sysconf(_SC_PAGESIZE) : unknown;
}

}  // namespace

std::int64_t peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
#ifdef __APPLE__
  return usage.ru_maxrss;
#else
  return std::int64_t{usage.ru_maxrss} * 1024;
#endif
}

std::int64_t free_memory() {
  return std::min(read_entry("/proc/meminfo", "MemAvailable:", kilobyte), free_in_control_group());
}

std::int64_t parse_size(std::string_view text) {
  constexpr std::string_view letters = "KMGT";
  std::string_view number = text;
  if (number.ends_with("iB"))
    number.remove_suffix(2);
  else if (number.ends_with('B'))
    number.remove_suffix(1);
  double factor = 1;
  if (!number.empty() && letters.find(number.back()) != std::string_view::npos) {
    for (std::size_t i = 0; i <= letters.find(number.back()); ++i)
      factor *= 1024;
    number.remove_suffix(1);
  }
  const auto value = parse_real(number);
  if (!value || *value <= 0 || *value * factor > 1e18)
    throw UsageError("--memory-limit: {} is no size; 500M and 8G are", quote(text));
  return static_cast<std::int64_t>(*value * factor);
}

std::string format_size(double bytes) {
  constexpr std::array units{"bytes", "KiB", "MiB", "GiB", "TiB"};
  std::size_t unit = 0;
  for (; bytes >= 1024 && unit + 1 < units.size(); ++unit)
    bytes /= 1024;
  return fmt::format("{:.{}f} {}", bytes, unit == 0 || bytes >= 100 ? 0 : 1, units[unit]);
}

namespace {

std::atomic<std::int64_t> exceeded_limit{0};

[[noreturn]] void end_process() {
  abandon_files();
  wipe_progress();
  remark("limes: " + memory_limit_message());
  std::_Exit(bad_input);
}

}  // namespace

std::string memory_limit_message() {
  const std::int64_t limit = exceeded_limit.load();
  if (limit == 0) return {};
  return fmt::format("stopped at the memory limit of {}; raise --memory-limit or work on less",
                     format_size(static_cast<double>(limit)));
}

MemoryWatch::MemoryWatch(std::int64_t limit) : thread_([this, limit] { watch(limit); }) {}

MemoryWatch::~MemoryWatch() {
  {
    const std::lock_guard lock(mutex_);
    stopped_ = true;
  }
  stop_.notify_one();
  thread_.join();
}

void MemoryWatch::watch(std::int64_t limit) {
  constexpr std::chrono::milliseconds period(2);
  // What is taken between two looks, or while the work unwinds, still fits below the limit.
  constexpr std::int64_t most_left = std::int64_t{64} << 20U;
  const std::int64_t left = std::min(limit / 16, most_left);
  std::unique_lock lock(mutex_);
  while (!stop_.wait_for(lock, period, [this] { return stopped_; })) {
    const std::int64_t used = used_memory();
    if (used == unknown || used <= limit - left) continue;
    exceeded_limit.store(limit);
    request_interrupt();
    if (used > limit - left / 2) end_process();
  }
}

}  // namespace limes::app
