#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace limes::app {

/// Largest amount of memory the process has had so far, in bytes.
[[nodiscard]] std::int64_t peak_memory();

/// What the machine (and the process's control group) has free, in bytes.
[[nodiscard]] std::int64_t free_memory();

/// A size as "800000", "500M", "1.5G", in powers of 1024; a B or iB may follow the letter.
/// @throws UsageError
[[nodiscard]] std::int64_t parse_size(std::string_view text);
/// "1.4 GiB"
[[nodiscard]] std::string format_size(double bytes);

/// Allocations beyond this fail with std::bad_alloc, as far as the system can count them.
void limit_memory(std::int64_t bytes);

}  // namespace limes::app
