#include "limes/study/supports.h"

#include <algorithm>

#include "limes/core/error.h"
#include "limes/problem/selection.h"
#include "limes/space/boundary_trace.h"

namespace limes {
namespace {

/// A scalar functional as a row on one component.
ConstraintRow on_component(const ConstraintRow& scalar, int component) {
  ConstraintRow row;
  for (const auto& [dof, weight] : scalar)
    row.emplace_back(2 * dof + component, weight);
  return row;
}

/// Functionals of the scalar field that a selection holds.
std::vector<ConstraintRow> held(const PlaneModel& model, const Selection& chosen) {
  const SubdivisionSpace& space = *model.space;
  const Adjacency& adjacency = model.adjacency();
  std::vector<ConstraintRow> rows;
  std::vector<bool> open = chosen.vertices();
  for (const HalfedgeId h : selected_sides(model, chosen)) {
    for (ConstraintRow& row : trace_of_side(space, h))
      rows.push_back(std::move(row));
    for (const VertexId v : {adjacency.from(h), adjacency.to(h)})
      open[static_cast<std::size_t>(v.value)] = false;
  }
  for (std::size_t v = 0; v < open.size(); ++v) {
    const VertexId vertex(static_cast<std::int64_t>(v));
    ConstraintRow row = open[v] ? value_at_vertex(space, vertex) : ConstraintRow();
    if (!row.empty()) rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace

std::vector<HalfedgeId> selected_sides(const PlaneModel& model, const Selection& chosen) {
  const Adjacency &adjacency = model.adjacency(), &neighbours = model.neighbours();
  const std::vector<HalfedgeId> boundary = chosen.boundary_edges();  // ascending
  const auto selected = [&](VertexId v) {
    return chosen.vertices()[static_cast<std::size_t>(v.value)];
  };
  std::vector<HalfedgeId> sides;
  for (const HalfedgeId h : domain_sides(*model.space)) {
    const HalfedgeId side = model.among_neighbours(h), twin = neighbours.twin(side);
    if (twin.valid() && model.space->has_element(neighbours.face(twin))) continue;  // vertices hang
    const bool wanted = twin.valid() ? selected(adjacency.from(h)) && selected(adjacency.to(h))
                                     : std::binary_search(boundary.begin(), boundary.end(), side);
    if (wanted) sides.push_back(h);
  }
  return sides;
}

std::vector<ConstraintRow> on_both_components(const std::vector<ConstraintRow>& scalar) {
  std::vector<ConstraintRow> rows;
  for (const ConstraintRow& row : scalar)
    for (int i = 0; i < 2; ++i)
      rows.push_back(on_component(row, i));
  return rows;
}

Constraints support_constraints(const PlaneModel& model) {
  const Problem& problem = model.problem;
  Constraints out;
  for (const SupportSettings& support : problem.supports) {
    if (support.fix[2])
      fail_at(culprit(support.origin.of("fix"), {problem.model.origin.of("kind")}),
              "plane models have no uz; fix ux, uy or both");
    const Place& place = support.origin.of("where");
    const Selection chosen = model.selection(support.where, place);
    const std::vector<ConstraintRow> rows = held(model, chosen);
    if (rows.empty()) fail_at(place, "'{}' selects only vertices of hole faces", support.where);
    const int first = static_cast<int>(out.rows.size());
    for (int i = 0; i < 2; ++i)
      if (support.fix[static_cast<std::size_t>(i)])
        for (const ConstraintRow& row : rows)
          out.rows.push_back(on_component(row, i));
    out.sources.push_back({support.where, first, static_cast<int>(out.rows.size())});
  }
  return out;
}

}  // namespace limes
