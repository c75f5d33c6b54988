#pragma once

#include <fmt/format.h>

#include <cmath>
#include <ostream>
#include <vector>

#include "limes/fem/assemble.h"
#include "limes/fem/laplace.h"
#include "limes/fem/plane_elasticity.h"
#include "limes/solve/linear.h"
#include "limes/subdiv/refine.h"
#include "limes/subdiv/schemes.h"

namespace limes::testing {

/// Errors of a sequence of refined meshes.
struct RateTable {
  struct Row {
    int dofs;
    double L2, H1;
  };
  std::vector<Row> rows;

  [[nodiscard]] double rate_L2() const { return rate(&Row::L2); }
  [[nodiscard]] double rate_H1() const { return rate(&Row::H1); }
  /// Of the last step; every step halves the mesh size.
  [[nodiscard]] double rate(double Row::*error) const {
    return std::log2(rows[rows.size() - 2].*error / (rows.back().*error));
  }
};

inline std::ostream& operator<<(std::ostream& out, const RateTable& t) {
  for (std::size_t i = 0; i < t.rows.size(); ++i) {
    const auto& r = t.rows[i];
    out << fmt::format("{:8d} dofs   L2 {:.3e}   H1 {:.3e}", r.dofs, r.L2, r.H1);
    if (i > 0)
      out << fmt::format("   rates {:.2f} {:.2f}", std::log2(t.rows[i - 1].L2 / r.L2),
                         std::log2(t.rows[i - 1].H1 / r.H1));
    out << '\n';
  }
  return out;
}

inline SubdivisionSpace space_on(const Mesh& mesh, int levels, const SpaceOptions& options = {}) {
  const Scheme& scheme = find_scheme("catmull-clark");
  const BoundaryRule boundary = mesh.tags.boundary.value_or(BoundaryRule::edges);
  return {refine(mesh, scheme, {.levels = levels, .boundary = boundary}),
          scheme,
          boundary,
          {},
          options};
}

/// Calls use(element, points, dA) for every element.
template <class Use>
void for_each_element(const SubdivisionSpace& space, const Use& use) {
  for (int e = 0; e < static_cast<int>(space.elements().size()); ++e) {
    const ElementTable& table = space.table(space.elements()[std::size_t(e)].shape);
    ElementPoints p;
    to_physical(table, space.control_points(e), p);
    use(e, table, p, VectorX(p.J.cwiseAbs().cwiseProduct(table.weight)));
  }
}

}  // namespace limes::testing
