// No include guard: compiles LIMES_KERNEL_BODY, the name of a file with functions, once for each
// instruction set, in namespaces of their own:
//
//   two   LIMES_LANES = 2 doubles to a vector: every x86-64, ARM or WebAssembly machine
//   four  LIMES_LANES = 4, if LIMES_WITH_AVX2 is defined (avx2.h): where has_avx2() is true
//
// Vectors are those of GCC and clang (vector_size). Without fused operations, which are off for the
// whole project, both give the same bits. LIMES_INLINE marks the helpers of a body: a function takes
// on the instruction set of the one it is inlined into. LIMES_UNROLL before a loop repeats its body eight times.
//
// Include it inside an anonymous namespace, with the headers that the body needs and
// limes/core/avx2.h before.

#define LIMES_INLINE inline __attribute__((always_inline))
#if defined(__clang__)
#define LIMES_UNROLL _Pragma("unroll 8")
#else
#define LIMES_UNROLL _Pragma("GCC unroll 8")
#endif

namespace two {
#define LIMES_LANES 2
#include LIMES_KERNEL_BODY
#undef LIMES_LANES
}  // namespace two

#ifdef LIMES_WITH_AVX2
#if defined(__clang__)
#pragma clang attribute push(__attribute__((target("avx2"))), apply_to = function)
#else
#pragma GCC push_options
#pragma GCC target("avx2")
#endif
namespace four {
#define LIMES_LANES 4
#include LIMES_KERNEL_BODY
#undef LIMES_LANES
}  // namespace four
#if defined(__clang__)
#pragma clang attribute pop
#else
#pragma GCC pop_options
#endif
#endif
