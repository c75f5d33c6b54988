#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace limes::app {

/// Results go to standard output. @throws OutputError if it does not take them
void print(std::string_view text);
void print_object(const nlohmann::ordered_json& object);

/// Remarks go to standard error, one line each.
void remark(std::string_view text);

/// Wipes the line of a Progress, for whoever ends the process without its destructor.
void wipe_progress();

/// A message as one line: what a file or an argument smuggled in cannot break it.
[[nodiscard]] std::string one_line(std::string_view text);

/// A line on standard error that shows how far a work is, if that is a terminal. It is wiped at the
/// end. advance() may be called from several threads.
class Progress {
 public:
  /// @param total  steps until the work is done; 0: unknown
  explicit Progress(std::string_view what, std::int64_t total = 0);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void advance(std::int64_t steps = 1);

 private:
  void draw(std::int64_t done) const;

  std::string what_;
  std::int64_t total_;
  bool shown_;
  std::atomic<std::int64_t> done_{0};
  std::atomic<std::int64_t> next_draw_{0};  // milliseconds since the start
  std::chrono::steady_clock::time_point start_;
};

}  // namespace limes::app
