#include "limes/space/subdivision_space.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "limes/core/error.h"
#include "limes/core/interrupt.h"

namespace limes {
namespace {

std::vector<bool> hole_faces(const Mesh& mesh) {
  std::vector<bool> hole(static_cast<std::size_t>(mesh.topology.num_faces()), false);
  for (const FaceId f : mesh.tags.holes)
    hole[static_cast<std::size_t>(f.value)] = true;
  return hole;
}

}  // namespace

SubdivisionSpace::SubdivisionSpace(Mesh mesh, const Scheme& scheme, BoundaryRule boundary,
                                   std::vector<int> regions, const SpaceOptions& options)
    : mesh_(std::move(mesh)), quadrature_(options.quadrature), regions_(std::move(regions)) {
  require_squares(scheme, "finite elements");
  const Adjacency adjacency(mesh_.topology, options.check);
  const Features features = resolve_tags(adjacency, mesh_.tags, boundary);
  const bool ghosts = options.ghosts && scheme.reach > 0;  // no use for functions without reach
  extended_ = ghosts ? with_ghosts(adjacency, features, mesh_.points.span())
                     : without_ghosts(adjacency, features);
  geometry_ = std::make_unique<LimitBasis>(mesh_.topology, features, scheme, options.check);
  field_ =
      std::make_unique<LimitBasis>(extended_.topology, extended_.features, scheme, options.check);
  add_elements();
  number_dofs();
}

void SubdivisionSpace::add_elements() {
  has_element_ = hole_faces(mesh_);
  has_element_.flip();
  std::map<std::tuple<int, int, int>, int> shapes;
  for (int i = 0; i < mesh_.topology.num_faces(); ++i) {
    if (!has_element_[static_cast<std::size_t>(i)]) continue;
    const FaceId f(i);
    for (int c = 0; c < geometry_->num_quadrants(f); ++c) {
      const auto [it, added] = shapes.try_emplace({geometry_->kind(f), field_->kind(f), c},
                                                  static_cast<int>(tables_.size()));
      elements_.push_back({f, c, it->second});
      if (!added) continue;
      check_interrupt();
      tables_.push_back(quadrature_table(shape_of(elements_.back()), quadrature_));
      first_of_shape_.push_back(static_cast<int>(elements_.size()) - 1);
    }
  }
}

void SubdivisionSpace::number_dofs() {
  if (elements_.empty()) throw InputError("all faces are holes; a domain needs at least one other");
  const int num_regions =
      regions_.empty() ? 1 : *std::max_element(regions_.begin(), regions_.end()) + 1;
  const auto num_vertices = static_cast<std::size_t>(extended_.topology.num_vertices());
  dof_.assign(static_cast<std::size_t>(num_regions), IdArray<VertexId, int>(num_vertices, -1));
  const auto of_region = [&](const Element& e) -> IdArray<VertexId, int>& {
    return dof_[static_cast<std::size_t>(region(e.face))];
  };
  for (const Element& e : elements_) {
    const auto controls = field_->controls(e.face);
    for (const int a : table(e.shape).active)
      of_region(e)[controls[static_cast<std::size_t>(a)]] = 0;
  }
  for (IdArray<VertexId, int>& numbers : dof_)
    for (int& number : numbers)
      if (number == 0) number = num_dofs_++;
  first_dof_.push_back(0);
  for (const Element& e : elements_) {
    const auto controls = field_->controls(e.face);
    for (const int a : table(e.shape).active)
      element_dofs_.push_back(of_region(e)[controls[static_cast<std::size_t>(a)]]);
    first_dof_.push_back(static_cast<std::int64_t>(element_dofs_.size()));
  }
}

std::span<const int> SubdivisionSpace::dofs(int element) const {
  const auto i = static_cast<std::size_t>(element);
  return std::span(element_dofs_)
      .subspan(static_cast<std::size_t>(first_dof_[i]),
               static_cast<std::size_t>(first_dof_[i + 1] - first_dof_[i]));
}

Eigen::Matrix<double, Eigen::Dynamic, 3> SubdivisionSpace::control_points(int element) const {
  const auto controls = geometry_->controls(elements_[static_cast<std::size_t>(element)].face);
  Eigen::Matrix<double, Eigen::Dynamic, 3> P(static_cast<Eigen::Index>(controls.size()), 3);
  for (std::size_t i = 0; i < controls.size(); ++i)
    P.row(static_cast<Eigen::Index>(i)) = mesh_.points[controls[i]].transpose();
  return P;
}

ElementTable SubdivisionSpace::sample(int shape, const std::vector<Vec2>& points) const {
  return sample_table(shape_of(first_of_shape(shape)), points, table(shape).active);
}

std::vector<ParameterTile> SubdivisionSpace::tiles(int shape, int depth) const {
  return element_tiles(shape_of(first_of_shape(shape)), depth);
}

std::vector<int> SubdivisionSpace::face_dofs(FaceId face, int region) const {
  std::vector<int> out;
  for (const VertexId v : field_->controls(face))
    out.push_back(dof_[static_cast<std::size_t>(region)][v]);
  return out;
}

Eigen::Matrix<double, Eigen::Dynamic, 3> SubdivisionSpace::position_coefficients() const {
  const std::vector<Vec3> x = extended_.continued(mesh_.points.span());
  Eigen::Matrix<double, Eigen::Dynamic, 3> out(num_dofs_, 3);
  for (const IdArray<VertexId, int>& numbers : dof_)
    for (int v = 0; v < numbers.size(); ++v)
      if (numbers[VertexId(v)] >= 0)
        out.row(numbers[VertexId(v)]) = x[static_cast<std::size_t>(v)].transpose();
  return out;
}

}  // namespace limes
