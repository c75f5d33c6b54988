#include "limes/study/shell_hanging.h"

#include <map>

#include "limes/core/error.h"
#include "limes/fem/hanging.h"

namespace limes {
namespace {

SideNode side_node(const ShellModel& model, HalfedgeId corner) {
  const VertexId v = model.mesh->topology.corner(corner);
  return {model.mesh->points[v], model.director[corner], model.smooth[v] != 0,
          6 * model.node[v].value};
}

}  // namespace

SparseMatrix hanging_transfer(const ShellModel& model) {
  std::vector<Triplet> entries;
  for (int i = 0; i < model.num_unknowns(); ++i)
    if (!model.hangs[VertexId(i / 6)]) entries.emplace_back(i, i, 1.0);
  for (int f = 0; f < model.mesh->topology.num_faces(); ++f)
    for (int i = 0; i < 4; ++i) {
      const HalfedgeId h = model.faces.inside(FaceId(f), i);
      if (!h.valid()) continue;
      const SideNode a = side_node(model, model.corner(FaceId(f), i));
      const SideNode b = side_node(model, model.corner(FaceId(f), (i + 1) % 4));
      LIMES_ASSERT(!model.hangs[VertexId(a.first / 6)] && !model.hangs[VertexId(b.first / 6)]);
      const auto rows = hanging_constraints(side_node(model, h), a, b);
      for (const ConstraintRow& row : rows)
        for (std::size_t k = 1; k < row.size(); ++k)  // the first is the node's own, with -1
          entries.emplace_back(row.front().first, row[k].first, row[k].second);
    }
  SparseMatrix H(model.num_unknowns(), model.num_unknowns());
  H.setFromTriplets(entries.begin(), entries.end());
  return H;
}

std::vector<ConstraintRow> carried(const std::vector<ConstraintRow>& rows, const SparseMatrix& H) {
  std::vector<ConstraintRow> out;
  for (const ConstraintRow& row : rows) {
    std::map<int, double> sum;
    for (const auto& [unknown, weight] : row)
      for (SparseMatrix::InnerIterator it(H, unknown); it; ++it)
        sum[static_cast<int>(it.col())] += weight * it.value();
    out.emplace_back(sum.begin(), sum.end());
  }
  return out;
}

}  // namespace limes
