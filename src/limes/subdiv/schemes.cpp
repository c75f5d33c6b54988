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
           .patch = LimitPatch::bicubic,
           .reach = 1,
           .boundary = Boundary::creases,
           .creases = true,
           .face_rule = catmull_clark_face,
           .edge_rule = catmull_clark_edge,
           .vertex_rule = catmull_clark_vertex},
    Scheme{.name = "loop",
           .summary = "quartic box splines on triangles, C2 but at extraordinary vertices (C1)",
           .faces = FaceKind::triangles,
           .split = Split::triangles,
           .patch = LimitPatch::box_spline,
           .reach = 1,
           .boundary = Boundary::creases,
           .creases = true,
           .edge_rule = loop_edge,
           .vertex_rule = loop_vertex},
    Scheme{.name = "doo-sabin",
           .summary = "biquadratic B-splines on any polygons, C1; a face per face, edge and vertex",
           .faces = FaceKind::polygons,
           .split = Split::dual,
           .reach = 1,
           .boundary = Boundary::shrinks,
           .corner_rule = doo_sabin_corner},
    Scheme{.name = "repeated-averaging",
           .summary = "biquadratic B-splines by means of linear refinement, on any polygons, C1",
           .faces = FaceKind::polygons,
           .split = Split::dual,
           .reach = 1,
           .boundary = Boundary::shrinks,
           .corner_rule = repeated_averaging_corner},
    Scheme{.name = "mid-edge",
           .summary = "joins the midpoints of edges, on any polygons; C1, the simplest scheme",
           .faces = FaceKind::polygons,
           .split = Split::mid_edge,
           .reach = 1,
           .boundary = Boundary::shrinks,
           .edge_rule = linear_edge},
    Scheme{.name = "sqrt3",
           .summary = "splits triangles in three, C2 but at extraordinary vertices (C1)",
           .faces = FaceKind::triangles,
           .split = Split::sqrt3,
           .reach = 2,
           .boundary = Boundary::own,
           .wide = true,
           .face_rule = sqrt3_face,
           .edge_rule = sqrt3_edge,
           .vertex_rule = sqrt3_vertex},
    Scheme{.name = "butterfly",
           .summary = "modified butterfly: interpolates the vertices of triangles, C1",
           .faces = FaceKind::triangles,
           .split = Split::triangles,
           .reach = 2,
           .boundary = Boundary::own,
           .wide = true,
           .interpolatory = true,
           .edge_rule = butterfly_edge,
           .vertex_rule = linear_vertex},
    Scheme{.name = "four-eight",
           .summary = "C4 box splines by bisection, on any polygons, C1 at extraordinary vertices",
           .faces = FaceKind::polygons,
           .split = Split::four_eight,
           .reach = 2,
           .boundary = Boundary::own,
           .creases = true,
           .face_rule = four_eight_face,
           .edge_rule = four_eight_edge,
           .vertex_rule = four_eight_vertex},
    Scheme{.name = "quasi-four-eight",
           .summary = "bisects the longest edges of triangles, then smooths; cuts other faces",
           .faces = FaceKind::polygons,
           .split = Split::longest_edges,
           .linear = false,
           .needs_positions = true,
           .reach = 2,
           .boundary = Boundary::quasi,
           .creases = true},
    Scheme{.name = "kobbelt",
           .summary = "interpolates the vertices of quads, with tension and breakpoints, C1",
           .faces = FaceKind::quads,
           .split = Split::quads,
           .reach = 2,
           .boundary = Boundary::open_net,
           .creases = true,
           .wide = true,
           .interpolatory = true,
           .face_rule = kobbelt_face,
           .edge_rule = kobbelt_edge,
           .vertex_rule = linear_vertex},
    Scheme{.name = "linear",
           .summary = "bilinear: splits faces and leaves the shape",
           .faces = FaceKind::polygons,
           .split = Split::quads,
           .patch = LimitPatch::bilinear,
           .reach = 0,
           .boundary = Boundary::own,
           .creases = true,
           .interpolatory = true,
           .face_rule = catmull_clark_face,
           .edge_rule = linear_edge,
           .vertex_rule = linear_vertex}};

constexpr Scheme linear_on_triangles{.name = "linear",
                                     .summary = "splits triangles in four and leaves the shape",
                                     .faces = FaceKind::triangles,
                                     .split = Split::triangles,
                                     .reach = 0,
                                     .boundary = Boundary::own,
                                     .creases = true,
                                     .interpolatory = true,
                                     .edge_rule = linear_edge,
                                     .vertex_rule = linear_vertex};

}  // namespace

std::span<const Scheme> all_schemes() {
  return schemes;
}

const Scheme& linear_triangles() {
  return linear_on_triangles;
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
