#include "limes/subdiv/schemes.h"

#include <array>
#include <string>

#include "limes/core/error.h"

namespace limes {
namespace {

constexpr std::array schemes{
    Scheme{.name = "catmull-clark",
           .summary = "bicubic B-splines on any polygons, C2 but at extraordinary vertices (C1)",
           .faces = FaceKind::polygons,
           .split = Split::quads,
           .linear = true,
           .needs_positions = false,
           .patch = LimitPatch::bicubic,
           .reach = 1,
           .face_rule = catmull_clark_face,
           .edge_rule = catmull_clark_edge,
           .vertex_rule = catmull_clark_vertex},
    Scheme{.name = "loop",
           .summary = "quartic box splines on triangles, C2 but at extraordinary vertices (C1)",
           .faces = FaceKind::triangles,
           .split = Split::triangles,
           .linear = true,
           .needs_positions = false,
           .patch = LimitPatch::box_spline,
           .reach = 1,
           .face_rule = nullptr,
           .edge_rule = loop_edge,
           .vertex_rule = loop_vertex},
    Scheme{.name = "linear",
           .summary = "bilinear: splits faces and leaves the shape",
           .faces = FaceKind::polygons,
           .split = Split::quads,
           .linear = true,
           .needs_positions = false,
           .patch = LimitPatch::bilinear,
           .reach = 0,
           .face_rule = catmull_clark_face,
           .edge_rule = linear_edge,
           .vertex_rule = linear_vertex}};

}  // namespace

std::span<const Scheme> all_schemes() {
  return schemes;
}

const Scheme& find_scheme(std::string_view name) {
  std::string known;
  for (const Scheme& s : schemes) {
    if (s.name == name) return s;
    known += known.empty() ? "" : ", ";
    known += s.name;
  }
  throw UsageError("there is no scheme '{}'; known are {}", name, known);
}

}  // namespace limes
