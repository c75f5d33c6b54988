#pragma once

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>

namespace limes::app {

/// Largest amount of memory the process has had so far, in bytes.
[[nodiscard]] std::int64_t peak_memory();

/// What the machine (and the process's control group) has free, in bytes.
[[nodiscard]] std::int64_t free_memory();

/// A size as "800000", "500M", "1.5G", in powers of 1024; a B or iB may follow the letter.
/// @throws UsageError
[[nodiscard]] std::int64_t parse_size(std::string_view text);
/// "1.4 GiB"
[[nodiscard]] std::string format_size(double bytes);

/// Stops the work, as an interrupt does, when a sixteenth of the memory that the process may have is left
/// (at most 64 MiB), and ends the process with its message when half of that is left, because libraries
/// that solve and sort do not listen. (A limit of the system would not do: libraries reserve buffers that
/// they never touch, and some of them wait forever when they get none.)
class MemoryWatch {
 public:
  explicit MemoryWatch(std::int64_t limit);
  ~MemoryWatch();
  MemoryWatch(const MemoryWatch&) = delete;
  MemoryWatch& operator=(const MemoryWatch&) = delete;

 private:
  void watch(std::int64_t limit);

  std::mutex mutex_;
  std::condition_variable stop_;
  bool stopped_ = false;
  std::thread thread_;
};
/// The message if a watch has stopped the work, else empty.
[[nodiscard]] std::string memory_limit_message();

}  // namespace limes::app
