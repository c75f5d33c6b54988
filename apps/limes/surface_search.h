#pragma once

#include <filesystem>

#include "mesh_surface.h"

namespace limes::app {

/// Reads points (columns x, y, z) and writes the closest point of the surface for each.
/// @return number of points
std::size_t write_closest_points(const MeshSurface& surface, const std::filesystem::path& points,
                                 const std::filesystem::path& output);

/// What became of rays.
struct RayCount {
  std::size_t rays, hits;
};
/// Reads rays (columns x, y, z, dx, dy, dz) and writes where each first meets the surface.
RayCount write_ray_hits(const MeshSurface& surface, const std::filesystem::path& rays,
                        const std::filesystem::path& output);

}  // namespace limes::app
