#pragma once

#include <map>
#include <vector>

#include "limes/mesh/mesh.h"

namespace limes {

/// The regular n-gon with corners on the unit circle, cut into n triangles around its centre, which
/// is vertex 0 or the last one.
enum class Centre { first, last };
[[nodiscard]] Mesh fan(int n, Centre centre);

/// Every face cut into triangles around its centroid, which is the first corner of each.
[[nodiscard]] Mesh centre_triangles(const Mesh& mesh);

/// How many interior vertices have so many edges.
[[nodiscard]] std::map<int, int> interior_valences(const Topology& topology);
/// Interior vertices with neither 4 nor 8 edges.
[[nodiscard]] int num_irregular(const Topology& topology);

/// The same for two connected triangle meshes if and only if one becomes the other by renumbering
/// vertices and faces. O(faces^2)
[[nodiscard]] std::vector<int> canonical_code(const Topology& topology);

/// The 2.1 of the reference, for one binary step: counts, Euler number, valences and neighbours of the
/// new vertices, and which faces may stay unsplit. Reports as test failures.
void expect_binary_step(const Topology& parent, const Topology& child, int num_unsplit);

}  // namespace limes
