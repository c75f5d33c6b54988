#include "limes/core/error.h"

namespace limes {

void assertion_failed(const char* condition, const char* file, int line) {
  throw InternalError(fmt::format("{}:{}: assertion failed: {}", file, line, condition));
}

}  // namespace limes
