#include "limes/subdiv/grid_refinement.h"

#include "limes/subdiv/structured.h"
#include "limes/subdiv/structured_triangles.h"

namespace limes {

std::unique_ptr<GridRefinement> grid_refinement(const Adjacency& control, const Features& features,
                                                const Scheme& scheme, int depth) {
  const Topology& topology = control.topology();
  if (depth <= QuadNumbering::max_depth &&
      StructuredRefinement::applies(topology, features, scheme))
    return std::make_unique<StructuredRefinement>(control, features, scheme, depth);
  if (depth <= TriangleNumbering::max_depth &&
      StructuredTriangles::applies(topology, features, scheme))
    return std::make_unique<StructuredTriangles>(control, features, scheme, depth);
  return nullptr;
}

}  // namespace limes
