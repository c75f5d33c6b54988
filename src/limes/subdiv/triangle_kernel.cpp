#include "limes/subdiv/triangle_kernel.h"

#include "limes/core/avx2.h"
#include "limes/subdiv/triangle_grid.h"

namespace limes {
namespace {

#define LIMES_KERNEL_BODY "limes/subdiv/triangle_kernel_body.h"
#include "limes/core/instruction_sets.h"

constexpr TriangleKernel kernel_two{two::refine, two::write, two::split};

}  // namespace

const TriangleKernel& TriangleKernel::two_doubles() {
  return kernel_two;
}

const TriangleKernel& TriangleKernel::best() {
#ifdef LIMES_WITH_AVX2
  static constexpr TriangleKernel kernel_four{four::refine, four::write, four::split};
  if (has_avx2()) return kernel_four;
#endif
  return kernel_two;
}

Point4 regular_vertex(const RegularTriangleMasks& masks, const Point4* v, int axis) {
  const two::Point p = two::vertex_point(masks, reinterpret_cast<const two::Point*>(v), axis);
  return {p.part[0], p.part[1]};
}

}  // namespace limes
