#include "limes/subdiv/quad_kernel.h"

#include "limes/core/avx2.h"
#include "limes/subdiv/quad_grid.h"

namespace limes {
namespace {

#define LIMES_KERNEL_BODY "limes/subdiv/quad_kernel_body.h"
#include "limes/core/instruction_sets.h"

constexpr QuadKernel kernel_two{two::refine, two::write, two::split};

}  // namespace

const QuadKernel& QuadKernel::two_doubles() {
  return kernel_two;
}

const QuadKernel& QuadKernel::best() {
#ifdef LIMES_WITH_AVX2
  static constexpr QuadKernel kernel_four{four::refine, four::write, four::split};
  if (has_avx2()) return kernel_four;
#endif
  return kernel_two;
}

}  // namespace limes
