#include "limes/study/shell_pieces.h"

#include <cmath>
#include <numbers>

namespace limes {

bool is_smooth_across(const ShellModel& model, HalfedgeId h) {
  const Adjacency& adjacency = *model.adjacency;
  const HalfedgeId twin = adjacency.twin(h);
  const double cosine = std::cos(model.problem.model.kink_angle * std::numbers::pi / 180);
  const auto material = [&](HalfedgeId side) {
    return model.material_of_face[static_cast<std::size_t>(adjacency.face(side).value)];
  };
  return material(h) == material(twin) &&
         model.director[h].dot(model.director[adjacency.next(twin)]) >= cosine &&
         model.director[adjacency.next(h)].dot(model.director[twin]) >= cosine;
}

PieceEdges edges_of_pieces(const ShellModel& model) {
  const Adjacency& adjacency = *model.adjacency;
  const Topology& t = model.mesh->topology;
  PieceEdges out;
  for (int i = 0; i < t.num_corners(); ++i) {
    const HalfedgeId h(i), twin = adjacency.twin(h);
    if (twin.valid() && twin < h) continue;
    const bool border = !twin.valid() || !is_smooth_across(model, h);
    (border ? out.borders : out.inside)
        .push_back({t.corner(h).value, t.corner(adjacency.next(h)).value});
  }
  return out;
}

}  // namespace limes
