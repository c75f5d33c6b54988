#include "limes/adapt/zienkiewicz_zhu.h"

#include <cmath>
#include <optional>

#include "limes/core/parallel.h"
#include "limes/fem/element_points.h"
#include "limes/space/element_of_face.h"

namespace limes {
namespace {

/// Flux and place of every element's centre.
struct Centres {
  std::vector<VectorX> flux;
  std::vector<Vec2> x;
};

Centres centres_of(const SubdivisionSpace& space, const EnergyDensity& energy) {
  std::vector<ElementTable> tables;
  for (int s = 0; s < space.num_shapes(); ++s)
    tables.push_back(space.sample(s, {Vec2(0.5, 0.5)}));
  const std::size_t n = space.elements().size();
  Centres out{std::vector<VectorX>(n), std::vector<Vec2>(n)};
  for_each_index(static_cast<std::int64_t>(n), [&](std::int64_t i) {
    const int e = static_cast<int>(i);
    const auto at = static_cast<std::size_t>(i);
    const ElementTable& table = tables[static_cast<std::size_t>(space.elements()[at].shape)];
    out.flux[at] = energy.stiffness(e) * energy.gradient(e, table).row(0).transpose();
    out.x[at] = (table.G * space.control_points(e)).row(0).head<2>().transpose();
  });
  return out;
}

/// The flux in a patch; nothing in one of holes.
LinearFit fit_in(const RecoveryPatch& patch, const std::vector<int>& element,
                 const Centres& centres) {
  const auto of = [&](FaceId f) { return element[static_cast<std::size_t>(f.value)]; };
  if (of(patch.faces[0]) < 0) return {};
  const auto m = static_cast<Eigen::Index>(patch.faces.size());
  Eigen::Matrix<double, Eigen::Dynamic, 2> at(m, 2);
  MatrixX values;
  for (Eigen::Index k = 0; k < m; ++k) {
    const auto e = static_cast<std::size_t>(of(patch.faces[static_cast<std::size_t>(k)]));
    at.row(k) = centres.x[e].transpose();
    if (k == 0) values.resize(m, centres.flux[e].size());
    values.row(k) = centres.flux[e].transpose();
  }
  return linear_fit(at, values);
}

/// The recovered flux at every corner of every face.
IdArray<HalfedgeId, VectorX> recovered(const SubdivisionSpace& space, const Adjacency& adjacency,
                                       const Centres& centres, const JoinsFaces& joined) {
  const std::vector<int> element = element_of_face(space);
  const std::vector<RecoveryPatch> patches = recovery_patches(adjacency, [&](HalfedgeId h) {
    return space.has_element(adjacency.face(h)) &&
           space.has_element(adjacency.face(adjacency.twin(h))) && joined(h);
  });
  const std::vector<std::vector<int>> sources = recovering_patches(adjacency, patches);
  std::vector<LinearFit> fits(patches.size());
  for_each_index(static_cast<std::int64_t>(patches.size()), [&](std::int64_t i) {
    const auto at = static_cast<std::size_t>(i);
    fits[at] = fit_in(patches[at], element, centres);
  });
  IdArray<HalfedgeId, VectorX> out(static_cast<std::size_t>(adjacency.topology().num_corners()));
  for_each_index(static_cast<std::int64_t>(patches.size()), [&](std::int64_t i) {
    const RecoveryPatch& patch = patches[static_cast<std::size_t>(i)];
    if (!space.has_element(patch.faces[0])) return;
    const Vec2 x = space.mesh().points[patch.vertex].head<2>();
    const std::vector<int>& from = sources[static_cast<std::size_t>(i)];
    VectorX value = fits[static_cast<std::size_t>(from[0])].at(x);
    for (std::size_t k = 1; k < from.size(); ++k)
      value += fits[static_cast<std::size_t>(from[k])].at(x);
    value /= static_cast<double>(from.size());
    for (const HalfedgeId h : patch.corners)
      out[h] = value;
  });
  return out;
}

}  // namespace

std::vector<double> zienkiewicz_zhu(const SubdivisionSpace& space, const EnergyDensity& energy,
                                    const JoinsFaces& joined, const HangingFaces* hanging) {
  std::optional<Adjacency> closed;
  if (hanging) closed.emplace(hanging->topology);
  const IdArray<HalfedgeId, VectorX> corner = recovered(
      space, closed ? *closed : space.geometry().adjacency(), centres_of(space, energy), joined);
  const Topology& t = space.mesh().topology;
  std::vector<double> out(static_cast<std::size_t>(t.num_faces()), 0.0);
  for_each_index(static_cast<std::int64_t>(space.elements().size()), [&](std::int64_t i) {
    const int e = static_cast<int>(i);
    const Element& element = space.elements()[static_cast<std::size_t>(e)];
    const ElementTable& table = space.table(element.shape);
    ElementPoints points;
    to_physical(table, space.control_points(e), points);
    const MatrixX D = energy.stiffness(e), gradient = energy.gradient(e, table);
    const Eigen::LDLT<MatrixX> inverse(D);
    double sum = 0;
    for (Eigen::Index q = 0; q < points.J.size(); ++q) {
      const double u = table.uv(q, 0), v = table.uv(q, 1);
      const std::array<double, 4> N{(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v};
      VectorX difference = -(D * gradient.row(q).transpose());
      for (int k = 0; k < 4; ++k)
        difference +=
            N[static_cast<std::size_t>(k)] *
            corner[hanging ? hanging->corner(element.face, k) : t.halfedge(element.face, k)];
      sum += std::abs(points.J(q)) * table.weight(q) * difference.dot(inverse.solve(difference));
    }
    out[static_cast<std::size_t>(element.face.value)] = sum;
  });
  return out;
}

}  // namespace limes
