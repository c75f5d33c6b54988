#include "limes/limit/tile_kernel.h"

#include <array>
#include <cstddef>

#include "limes/core/avx2.h"

namespace limes {
namespace {

#define LIMES_KERNEL_BODY "limes/limit/tile_kernel_body.h"
#include "limes/core/instruction_sets.h"

using Kernel = void (*)(const TilePoint*, std::size_t, const TileValues&);

using Kernels = std::array<Kernel, 3>;  // by order

constexpr Kernels kernels_two{two::evaluate<0>, two::evaluate<1>, two::evaluate<2>};

Kernels best_kernels() {
#ifdef LIMES_WITH_AVX2
  if (has_avx2()) return {four::evaluate<0>, four::evaluate<1>, four::evaluate<2>};
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
