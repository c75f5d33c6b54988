// Timing, memory and one-line JSON output shared by all measurement programs.
#pragma once

#include <time.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <exception>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace bench {

inline double clock_seconds(clockid_t id) {
  timespec t;
  clock_gettime(id, &t);
  return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}

// Wall-clock and process CPU time since construction (or the last restart).
class Timer {
 public:
  Timer() { restart(); }
  void restart() {
    wall_ = clock_seconds(CLOCK_MONOTONIC);
    cpu_ = clock_seconds(CLOCK_PROCESS_CPUTIME_ID);
  }
  double wall() const { return clock_seconds(CLOCK_MONOTONIC) - wall_; }
  double cpu() const { return clock_seconds(CLOCK_PROCESS_CPUTIME_ID) - cpu_; }

 private:
  double wall_ = 0, cpu_ = 0;
};

// Peak resident set size of this process so far, in bytes. Not from getrusage, whose ru_maxrss also
// counts the program that started this one.
inline std::int64_t peak_rss() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
    if (word == "VmHWM:") {
      std::int64_t kilobytes = 0;
      status >> kilobytes;
      return kilobytes * 1024;
    }
  throw std::runtime_error("no VmHWM in /proc/self/status");
}

// Minimal insertion-ordered JSON object, printed on one line.
class JsonLine {
 public:
  JsonLine& add(const char* key, const std::string& value) {
    std::string quoted = "\"";
    for (char c : value) {
      if (c == '"' || c == '\\') quoted += '\\';
      quoted += c;
    }
    return raw(key, quoted + "\"");
  }
  JsonLine& add(const char* key, const char* value) { return add(key, std::string(value)); }
  JsonLine& add(const char* key, double value) {
    if (!std::isfinite(value)) return raw(key, "null");
    char text[40];
    std::snprintf(text, sizeof text, "%.9g", value);
    return raw(key, text);
  }
  JsonLine& add(const char* key, std::int64_t value) { return raw(key, std::to_string(value)); }
  JsonLine& add(const char* key, int value) { return add(key, std::int64_t(value)); }
  JsonLine& add(const char* key, std::size_t value) { return add(key, std::int64_t(value)); }
  JsonLine& add_null(const char* key) { return raw(key, "null"); }
  void print(std::FILE* out = stdout) const {
    std::fprintf(out, "{%s}\n", body_.c_str());
    std::fflush(out);
  }

 private:
  JsonLine& raw(const char* key, const std::string& text) {
    if (!body_.empty()) body_ += ", ";
    body_ += "\"" + std::string(key) + "\": " + text;
    return *this;
  }
  std::string body_;
};

// Command line of the form --key value. A program gets what it knows; what is left is an error.
class Args {
 public:
  Args(int argc, char** argv) {
    for (int i = 1; i < argc; ++i) {
      std::string key = argv[i];
      if (key.rfind("--", 0) != 0 || i + 1 >= argc) {
        std::fprintf(stderr, "expected --key value, got '%s'\n", argv[i]);
        std::exit(2);
      }
      keys_.push_back(key.substr(2));
      values_.push_back(argv[++i]);
    }
    read_.resize(keys_.size());
  }
  std::string get(const std::string& key, const std::string& fallback) const {
    for (std::size_t i = 0; i < keys_.size(); ++i)
      if (keys_[i] == key) {
        read_[i] = true;
        return values_[i];
      }
    return fallback;
  }
  int get(const std::string& key, int fallback) const {
    return std::stoi(get(key, std::to_string(fallback)));
  }
  void require_all_read() const {
    for (std::size_t i = 0; i < keys_.size(); ++i)
      if (!read_[i]) throw std::runtime_error("unknown option --" + keys_[i]);
  }

 private:
  std::vector<std::string> keys_, values_;
  mutable std::vector<bool> read_;
};

// What main() does: the exit code is 0, or 1 after a message if something is thrown.
template <class Body>
int run_program(const char* name, int argc, char** argv, const Body& body) {
  try {
    body(Args(argc, argv));
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", name, error.what());
    return 1;
  }
}

// Order-independent checksum of a point set, so that runs can be compared.
struct Centroid {
  double x = 0, y = 0, z = 0;
  std::size_t n = 0;
  void add(double px, double py, double pz) {
    x += px;
    y += py;
    z += pz;
    ++n;
  }
  double checksum() const { return n ? (x + 2 * y + 3 * z) / double(n) : 0; }
};

}  // namespace bench
