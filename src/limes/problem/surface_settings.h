#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "limes/core/types.h"
#include "limes/problem/expression.h"
#include "limes/problem/place.h"

namespace limes {

// Where vertices lie and which parts belong together, as a file states it; see problem.h.

/// A surface that is known exactly; shells take vertices and directors from it.
struct GeometrySettings {
  enum class Kind { cylinder, sphere, plane, cone, torus, graph, formula };
  Kind kind = Kind::cylinder;
  std::optional<std::string>
      part;                   ///< whose surface it is; nothing: of all parts without their own
  Vec3 point = Vec3::Zero();  ///< of the axis or plane, the centre, or a cone's apex
  Vec3 axis = Vec3::
      UnitZ();  ///< of a cylinder, torus or, from its apex, cone; normal of a plane; of any length > 0
  double radius = 1;         ///< > 0; of a torus that of the tube's middle
  double tube_radius = 0.5;  ///< of a torus, > 0 and less than radius
  double angle = 45;         ///< of a cone, in degrees between its axis and it, in (0, 90)
  Expression height;         ///< z of a graph
  Expression zero;           ///< of a formula: zero on the surface
  Origin origin = {};
};

/// A curve on the exact surface that boundary edges follow.
struct CurveSettings {
  std::string where;         ///< selects the boundary edges of the control mesh
  GeometrySettings surface;  ///< a formula; the curve is where it meets the part's own surface
  Origin origin = {};
};

/// Parts tied along the boundary polygons that they share.
struct SeamSettings {
  std::vector<std::string> parts;  ///< two or more
  Origin origin = {};
};

/// The surfaces of a mesh and the seams between its parts.
struct SurfaceSettings {
  std::filesystem::path file;
  std::optional<GeometrySettings> geometry;         ///< of all parts that have none of their own
  std::vector<GeometrySettings> geometry_of_parts;  ///< each names its part, no two the same
  std::vector<CurveSettings> curves;
  std::vector<SeamSettings> seams;
  bool junctions = false;  ///< edges of three faces or more are seams, see mesh/junctions.h
};

/// Reads [geometry], [[curve]] and [[seam]] of a file that has these tables of a problem file; others of a
/// problem file may be there and are not read.
/// @throws InputError "FILE:LINE: ..." for what the file says wrong, and for one without [geometry]
[[nodiscard]] SurfaceSettings read_surfaces(const std::filesystem::path& file);
[[nodiscard]] SurfaceSettings parse_surfaces(std::string_view text,
                                             const std::filesystem::path& file);

}  // namespace limes
