#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace limes {

/// What a reader did that the user should know, one sentence per kind:
/// "FILE:12: face with fewer than 3 corners left out (also lines 15, 18 and 4 more)".
class Remarks {
 public:
  explicit Remarks(std::string_view file) : file_(file) {}

  /// @param line 1-based, or 0 where the file has no lines
  void add(std::int64_t line, std::string_view what);
  [[nodiscard]] std::vector<std::string> sentences() const;

 private:
  struct Kind {
    std::string what;
    std::vector<std::int64_t> lines;  // the first few
    std::int64_t count = 0;           // of lines, or of calls without a line
    std::int64_t last_line = 0;
  };
  [[nodiscard]] std::string sentence(const Kind& kind) const;

  std::string file_;
  std::vector<Kind> kinds_;
  std::int64_t left_out_ = 0;
};

}  // namespace limes
