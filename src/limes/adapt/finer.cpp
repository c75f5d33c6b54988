#include "limes/adapt/finer.h"

#include <cmath>

#include "limes/core/parallel.h"
#include "limes/fem/element_points.h"
#include "limes/space/element_of_face.h"
#include "limes/subdiv/split.h"

namespace limes {
namespace {

/// The points of a table of a descendant, as parameters of its ancestor.
std::vector<Vec2> points_in_ancestor(const ElementTable& table, std::int64_t path, int levels) {
  std::vector<Vec2> out;
  for (Eigen::Index q = 0; q < table.uv.rows(); ++q)
    out.push_back(in_ancestor(table.uv.row(q).transpose(), path, levels));
  return out;
}

/// Over one element of the finer space.
/// @param table  of the coarse element `under` it, at the points of the finer element's table
double square_over(const SubdivisionSpace& finer, const EnergyDensity& finer_energy, int e,
                   const EnergyDensity& energy, int under, const ElementTable& table) {
  const ElementTable& fine = finer.table(finer.elements()[static_cast<std::size_t>(e)].shape);
  ElementPoints points;
  to_physical(fine, finer.control_points(e), points);
  const MatrixX D = finer_energy.stiffness(e);
  const Eigen::LDLT<MatrixX> inverse(D);
  const MatrixX difference =
      finer_energy.gradient(e, fine) * D - energy.gradient(under, table) * energy.stiffness(under);
  double sum = 0;
  for (Eigen::Index q = 0; q < points.J.size(); ++q) {
    const VectorX d = difference.row(q).transpose();
    sum += std::abs(points.J(q)) * fine.weight(q) * d.dot(inverse.solve(d));
  }
  return sum;
}

}  // namespace

std::vector<double> error_against(const SubdivisionSpace& finer, const EnergyDensity& finer_energy,
                                  int levels, const SubdivisionSpace& space,
                                  const EnergyDensity& energy) {
  const std::int64_t children = std::int64_t(1) << (2 * levels);
  const std::vector<int> element_of = element_of_face(finer);
  std::vector<std::vector<ElementTable>> tables(static_cast<std::size_t>(space.num_shapes()));
  for (int shape = 0; shape < space.num_shapes(); ++shape)
    for (std::int64_t path = 0; path < children; ++path)
      tables[static_cast<std::size_t>(shape)].push_back(
          space.sample(shape, points_in_ancestor(finer.table(0), path, levels)));
  std::vector<double> out(static_cast<std::size_t>(space.mesh().topology.num_faces()), 0.0);
  for_each_index(static_cast<std::int64_t>(space.elements().size()), [&](std::int64_t i) {
    const Element& element = space.elements()[static_cast<std::size_t>(i)];
    const std::int64_t face = element.face.value;
    for (std::int64_t path = 0; path < children; ++path)
      out[static_cast<std::size_t>(face)] += square_over(
          finer, finer_energy, element_of[static_cast<std::size_t>(children * face + path)], energy,
          static_cast<int>(i),
          tables[static_cast<std::size_t>(element.shape)][static_cast<std::size_t>(path)]);
  });
  return out;
}

}  // namespace limes
