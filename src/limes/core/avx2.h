#pragma once

#if defined(__x86_64__) && defined(__GNUC__)
#define LIMES_WITH_AVX2  // code for it can be compiled, whether this machine has it or not
#endif

namespace limes {

/// Whether the processor that runs this has AVX2.
[[nodiscard]] inline bool has_avx2() {
#ifdef LIMES_WITH_AVX2
  static const bool has = __builtin_cpu_supports("avx2") != 0;
  return has;
#else
  return false;
#endif
}

}  // namespace limes
