#include "limes/subdiv/quad_kernel.h"

#include "limes/core/avx2.h"

namespace limes {
namespace {

#define LIMES_KERNEL_BODY "limes/subdiv/quad_kernel_body.h"
#include "limes/core/instruction_sets.h"

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
  if (has_avx2()) return kernel_four;
#endif
  return kernel_two;
}

}  // namespace limes
