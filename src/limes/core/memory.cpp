#include "limes/core/memory.h"

#include <cstdint>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace limes {

void prefer_huge_pages(void* begin, std::size_t bytes) {
#ifdef __linux__
  constexpr std::uintptr_t huge = std::uintptr_t{1} << 21;
  const auto first = (reinterpret_cast<std::uintptr_t>(begin) + huge - 1) / huge * huge;
  const auto last = (reinterpret_cast<std::uintptr_t>(begin) + bytes) / huge * huge;
  // A hint: whether the system follows it makes no difference to the result.
  if (last > first) (void)madvise(reinterpret_cast<void*>(first), last - first, MADV_HUGEPAGE);
#else
  (void)begin;
  (void)bytes;
#endif
}

}  // namespace limes
