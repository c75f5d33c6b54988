#include "limes/subdiv/crease.h"
#include "limes/subdiv/schemes.h"
#include "limes/subdiv/sector.h"
#include "limes/subdiv/sharp_vertex.h"

namespace limes {

// Catmull-Clark subdivision [catmull_clark_1978] with the creases, corners and boundaries of
// [derose_1998] as OpenSubdiv defines them.

void catmull_clark_face(const FaceNeighbourhood& n, const RuleOptions&, Stencil& out) {
  out.add(1.0 / static_cast<double>(n.corners.size()), n.corners);
}

namespace {

/// Weight of a face point at a smooth edge; 0.47 for triangles keeps meshes of triangles smooth
/// ('t smoothtriangles', [stam_loop_2003] as OpenSubdiv uses it).
double edge_face_weight(const EdgeNeighbourhood& n, bool smooth_triangles) {
  if (!smooth_triangles) return 0.25;
  const auto weight = [](int face_size) { return face_size == 3 ? 0.470 : 0.25; };
  return 0.5 * (weight(n.face_sizes[0]) + weight(n.face_sizes[1]));
}

/// V' = (n - 2)/n V + 1/n^2 sum of neighbours + 1/n^2 sum of new face points, [catmull_clark_1978]
/// in the second form of [barendrecht_2013] eq. (1).
void smooth_vertex(const VertexNeighbourhood& v, double scale, Stencil& out) {
  const double n = static_cast<double>(v.faces.size());
  const double w = scale * (1.0 / (n * n));
  if (v.faces.size() != 2) out.add(scale * ((n - 2.0) / n), v.vertex);
  out.add(w, v.neighbours);
  out.add(w, v.faces);
}

/// Q/4 + R/2 + S/4 for every n: mean of the new face points, of the middles of edges, and V. The
/// first rule of [catmull_clark_1978]; the standard one agrees at n = 4.
void quarters_vertex(const VertexNeighbourhood& v, double scale, Stencil& out) {
  const double w = scale * (0.25 / static_cast<double>(v.faces.size()));
  out.add(scale * 0.5, v.vertex);
  out.add(w, v.neighbours);
  out.add(w, v.faces);
}

}  // namespace

void catmull_clark_edge(const EdgeNeighbourhood& n, const RuleOptions& options, Stencil& out) {
  if (is_sharp(n.sharpness) && n.child_sharp) {
    out.add(0.5, n.ends);
    return;
  }
  if (options.sector_stencils && !is_sharp(n.sharpness) && has_sector(n))
    return add_sector_edge(n, out);
  // Smooth, or in its last semi-sharp step: sharpness blends the two rules.
  const double sharp = static_cast<double>(n.sharpness);
  const double face = edge_face_weight(n, options.smooth_triangles);
  out.add(sharp * 0.5 + (1.0 - sharp) * (0.5 - face), n.ends);
  out.add((1.0 - sharp) * face, n.faces);
}

void catmull_clark_vertex(const VertexNeighbourhood& v, const RuleOptions& options, Stencil& out) {
  const bool quarters = options.weights == ExtraordinaryWeights::quarters;
  add_vertex_rule(v, quarters ? quarters_vertex : smooth_vertex, out);
}

}  // namespace limes
