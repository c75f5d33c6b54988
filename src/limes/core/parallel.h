#pragma once

#include <cstdint>

#ifdef LIMES_WITH_TBB
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#endif

namespace limes {

/// Calls body(begin, end) on disjoint pieces that cover [0, count), possibly at the same time.
/// Each index must write only what it owns: then the result is the same for any number of threads.
/// The number of threads is the process's (tbb::global_control, set by the application).
template <class Body>
void for_each_block(std::int64_t count, std::int64_t grain, const Body& body) {
#ifdef LIMES_WITH_TBB
  if (count > grain) {
    tbb::parallel_for(tbb::blocked_range<std::int64_t>(0, count, static_cast<std::size_t>(grain)),
                      [&](const tbb::blocked_range<std::int64_t>& r) { body(r.begin(), r.end()); });
    return;
  }
#else
  (void)grain;
#endif
  if (count > 0) body(std::int64_t{0}, count);
}

/// Calls body(i) for every i in [0, count); the same rule as for_each_block.
template <class Body>
void for_each_index(std::int64_t count, const Body& body) {
  for_each_block(count, 1024, [&](std::int64_t begin, std::int64_t end) {
    for (std::int64_t i = begin; i < end; ++i)
      body(i);
  });
}

}  // namespace limes
