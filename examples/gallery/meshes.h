#pragma once

#include <array>
#include <optional>
#include <vector>

#include "limes/mesh/mesh.h"

namespace gallery {

[[nodiscard]] limes::Mesh from_triangles(std::vector<limes::Vec3> points,
                                         const std::vector<std::array<int, 3>>& triangles);

/// The same surface of triangles; tags, groups and parts are left out.
[[nodiscard]] limes::Mesh triangulated(const limes::Mesh& mesh);

[[nodiscard]] limes::Mesh without_tags(limes::Mesh mesh);

/// Enclosed volume, with faces cut as triangulated() does; nothing for a surface with boundary.
[[nodiscard]] std::optional<double> volume(const limes::Mesh& mesh);

}  // namespace gallery
