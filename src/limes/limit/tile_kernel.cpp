#include "limes/limit/tile_kernel.h"

#include <array>
#include <cstddef>

// Vectors of the compiler's own kind (GCC, clang), which it maps to what the machine has: two
// doubles on every x86-64, ARM or WebAssembly machine, four where a processor says at run time that
// it has AVX2. Without fused operations both give the same bits.

#define LIMES_INLINE inline __attribute__((always_inline))

namespace limes {
namespace {

namespace two {
#define LIMES_LANES 2
#include "limes/limit/tile_kernel_body.h"
#undef LIMES_LANES
}  // namespace two

#if defined(__x86_64__) && defined(__GNUC__)
#define LIMES_WITH_AVX2
#if defined(__clang__)
#pragma clang attribute push(__attribute__((target("avx2"))), apply_to = function)
#else
#pragma GCC push_options
#pragma GCC target("avx2")
#endif
namespace four {
#define LIMES_LANES 4
#include "limes/limit/tile_kernel_body.h"
#undef LIMES_LANES
}  // namespace four
#if defined(__clang__)
#pragma clang attribute pop
#else
#pragma GCC pop_options
#endif
#endif

using Kernel = void (*)(const TilePoint*, std::size_t, const TileValues&);

using Kernels = std::array<Kernel, 3>;  // by order

constexpr Kernels kernels_two{two::evaluate<0>, two::evaluate<1>, two::evaluate<2>};

Kernels best_kernels() {
#ifdef LIMES_WITH_AVX2
  if (__builtin_cpu_supports("avx2"))
    return {four::evaluate<0>, four::evaluate<1>, four::evaluate<2>};
#endif
  return kernels_two;
}

}  // namespace

void evaluate_tiles(std::span<const TilePoint> points, int order, const TileValues& out,
                    TileVectors vectors) {
  static const Kernels best = best_kernels();
  const Kernels& kernels = vectors == TileVectors::two_doubles ? kernels_two : best;
  kernels[static_cast<std::size_t>(order)](points.data(), points.size(), out);
}

}  // namespace limes
