#pragma once

#include <span>

#include "limes/mesh/adjacency.h"
#include "limes/mesh/mesh.h"
#include "limes/problem/problem.h"

namespace limes {

/// Index in problem.materials of the material of every face; -1 where there is none.
/// @param points  limit position of every vertex
/// @throws InputError for a face with two materials
[[nodiscard]] std::vector<int> materials_of_faces(const Problem& problem, const Mesh& mesh,
                                                  const Adjacency& adjacency,
                                                  std::span<const Vec3> points);

/// @throws InputError, or UsageError where an override of `where` may be the reason
[[noreturn]] void fail_no_material(const Problem& problem, FaceId face);

}  // namespace limes
