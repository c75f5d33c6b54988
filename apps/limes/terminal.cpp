#include "terminal.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <nlohmann/json.hpp>

#include "limes/core/error.h"

namespace limes::app {

void print(std::string_view text) {
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (!written || std::fflush(stdout) != 0) throw OutputError("standard output cannot be written");
}

void print_object(const nlohmann::ordered_json& object) {
  // Names in files may hold any bytes; JSON is UTF-8.
  print(object.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
}

void remark(std::string_view text) {
  const std::string line = one_line(text) + "\n";
  std::fwrite(line.data(), 1, line.size(), stderr);
}

void wipe_progress() {
  if (isatty(STDERR_FILENO) == 1) std::fputs("\r\033[K", stderr);
}

std::string one_line(std::string_view text) {
  std::string line(text);
  for (char& c : line)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
  return line;
}

Progress::Progress(std::string_view what, std::int64_t total)
    : what_(what),
      total_(total),
      shown_(isatty(STDERR_FILENO) == 1),
      start_(std::chrono::steady_clock::now()) {
  if (shown_) draw(0);
}

Progress::~Progress() {
  if (shown_) wipe_progress();
}

void Progress::advance(std::int64_t steps) {
  if (!shown_) return;
  const std::int64_t done = done_ += steps;
  const auto now = std::chrono::duration_cast<std::chrono::milliseconds>(
                       std::chrono::steady_clock::now() - start_)
                       .count();
  std::int64_t due = next_draw_.load();
  if (now < due || !next_draw_.compare_exchange_strong(due, now + 100)) return;
  draw(done);
}

void Progress::draw(std::int64_t done) const {
  constexpr std::int64_t width = 40;
  std::string line = fmt::format("\r{} ", what_);
  if (total_ > 0) {
    const std::int64_t filled = width * done / total_;
    line +=
        fmt::format("[{:=<{}}{: <{}}] {:3} %", "", filled, "", width - filled, 100 * done / total_);
  }
  line += "\033[K";
  std::fputs(line.c_str(), stderr);
}

}  // namespace limes::app
