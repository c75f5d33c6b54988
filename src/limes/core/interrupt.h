#pragma once

namespace limes {

/// Long loops call check_interrupt() now and then; a signal handler calls request_interrupt().
void request_interrupt() noexcept;
[[nodiscard]] bool interrupt_requested() noexcept;
/// @throws Interrupted once request_interrupt() was called
void check_interrupt();

}  // namespace limes
