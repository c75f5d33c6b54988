#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <string>
#include <utility>

namespace limes {

/// Base of everything the library throws on purpose. The message is one line: what and where,
/// what is wrong, what would be right.
class Error : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The caller asked for something that does not exist: an option, a scheme, a path of a setting.
class UsageError : public Error {
 public:
  explicit UsageError(const std::string& message) : Error(message) {}
  template <class... Args>
  explicit UsageError(fmt::format_string<Args...> format, Args&&... args)
      : Error(fmt::format(format, std::forward<Args>(args)...)) {}
};

/// A file, mesh or problem that cannot be used as it is.
class InputError : public Error {
 public:
  explicit InputError(const std::string& message) : Error(message) {}
  template <class... Args>
  explicit InputError(fmt::format_string<Args...> format, Args&&... args)
      : Error(fmt::format(format, std::forward<Args>(args)...)) {}
};

/// A file that cannot be written.
class OutputError : public Error {
 public:
  explicit OutputError(const std::string& message) : Error(message) {}
  template <class... Args>
  explicit OutputError(fmt::format_string<Args...> format, Args&&... args)
      : Error(fmt::format(format, std::forward<Args>(args)...)) {}
};

/// A numerical method that did not reach its goal.
class SolverError : public Error {
 public:
  explicit SolverError(const std::string& message) : Error(message) {}
  template <class... Args>
  explicit SolverError(fmt::format_string<Args...> format, Args&&... args)
      : Error(fmt::format(format, std::forward<Args>(args)...)) {}
};

/// The user asked to stop (see core/interrupt.h).
class Interrupted : public Error {
 public:
  Interrupted() : Error("interrupted") {}
};

/// A broken promise of our own code: always checked, never caught for control flow.
class InternalError : public std::logic_error {
  using std::logic_error::logic_error;
};

[[noreturn]] void assertion_failed(const char* condition, const char* file, int line);

}  // namespace limes

#define LIMES_ASSERT(condition) \
  ((condition) ? void(0) : ::limes::assertion_failed(#condition, __FILE__, __LINE__))
