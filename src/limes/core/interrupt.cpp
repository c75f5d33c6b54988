#include "limes/core/interrupt.h"

#include <atomic>

#include "limes/core/error.h"

namespace limes {
namespace {
std::atomic<bool> requested{false};
static_assert(std::atomic<bool>::is_always_lock_free, "set from a signal handler");
}  // namespace

void request_interrupt() noexcept {
  requested.store(true);
}
bool interrupt_requested() noexcept {
  return requested.load(std::memory_order_relaxed);
}
void check_interrupt() {
  if (interrupt_requested()) throw Interrupted();
}

}  // namespace limes
