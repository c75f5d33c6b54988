#pragma once

#include <stdexcept>

// The one place that includes toml++. Version 3.3 asserts where it should report: "[ä]", a table
// whose name begins with a letter that bare names must not have, ends a debug build, and a release
// build goes on with an assumption that does not hold. So every build checks, and what fails is an
// exception.

namespace limes {

/// toml++ met a text that it did not foresee.
class TomlAssertion : public std::logic_error {
  using std::logic_error::logic_error;
};

[[noreturn]] inline void toml_assertion_failed(const char* condition) {
  throw TomlAssertion(condition);
}

}  // namespace limes

#pragma push_macro("NDEBUG")
#undef NDEBUG
#define TOML_ASSERT(condition) ((condition) ? void(0) : ::limes::toml_assertion_failed(#condition))
#define TOML_ENABLE_FORMATTERS 0
#include <toml++/toml.h>
#pragma pop_macro("NDEBUG")
