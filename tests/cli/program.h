#pragma once

#include <chrono>
#include <csignal>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace limes::test {

/// What a run of the program left behind.
struct Result {
  int exit_code = -1;  ///< -signal if a signal ended it
  std::string out, err;
  std::int64_t peak_memory = 0;  ///< in bytes
};

/// Runs the program limes.
/// @param signal_after  sends the signal so long after the program began to catch it; 0: never
Result run_limes(const std::vector<std::string>& arguments,
                 std::chrono::milliseconds signal_after = {}, int signal = SIGINT);

/// A folder of its own that vanishes at the end.
class TempFolder {
 public:
  TempFolder();
  ~TempFolder();
  TempFolder(const TempFolder&) = delete;
  TempFolder& operator=(const TempFolder&) = delete;

  [[nodiscard]] std::string operator/(const std::string& name) const {
    return (path_ / name).string();
  }
  /// Writes a file and returns its path.
  [[nodiscard]] std::string file(const std::string& name, const std::string& content) const;
  /// Names of the files in it, sorted.
  [[nodiscard]] std::vector<std::string> list() const;

 private:
  std::filesystem::path path_;
};

std::string read_file(const std::string& path);
/// A file of data/.
std::string data_file(const std::string& name);
/// Number of lines; a last line without end counts.
int num_lines(const std::string& text);

/// The failure contract: this code, one line that contains `reason` on standard error, nothing on
/// standard output.
void expect_failure(const Result& result, int exit_code, const std::string& reason);

}  // namespace limes::test
