#include "limes/subdiv/quad_kernel.h"

#define LIMES_INLINE inline __attribute__((always_inline))

namespace limes {
namespace {

namespace two {
#define LIMES_LANES 2
#include "limes/subdiv/quad_kernel_body.h"
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
#include "limes/subdiv/quad_kernel_body.h"
#undef LIMES_LANES
}  // namespace four
#if defined(__clang__)
#pragma clang attribute pop
#else
#pragma GCC pop_options
#endif
#endif

constexpr QuadKernel kernel_two{two::make_face_points, two::refine, two::write_vertices,
                                two::write_edges, two::write_faces};

}  // namespace

const QuadKernel& QuadKernel::two_doubles() {
  return kernel_two;
}

const QuadKernel& QuadKernel::best() {
#ifdef LIMES_WITH_AVX2
  static constexpr QuadKernel kernel_four{four::make_face_points, four::refine,
                                          four::write_vertices, four::write_edges,
                                          four::write_faces};
  static const bool has_avx2 = __builtin_cpu_supports("avx2") != 0;
  if (has_avx2) return kernel_four;
#endif
  return kernel_two;
}

}  // namespace limes
