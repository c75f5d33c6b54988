#include "limes/study/load_density.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "limes/core/error.h"
#include "limes/problem/selection.h"
#include "limes/study/supports.h"

namespace limes {
namespace {

/// A load and where it acts.
struct PlacedLoad {
  const LoadSettings* load;
  std::vector<bool> faces, sides;  ///< by face; by halfedge
};

bool acts_on_sides(LoadKind kind) {
  return kind == LoadKind::force_per_length || kind == LoadKind::pressure || kind == LoadKind::flux;
}

std::vector<PlacedLoad> placed_loads(const PlaneModel& model) {
  std::vector<PlacedLoad> out;
  const Topology& t = model.mesh().topology;
  for (const LoadSettings& load : model.problem.loads) {
    if (load.kind == LoadKind::force) continue;
    const Selection chosen = model.selection(load.where, load.origin.of("where"));
    PlacedLoad placed{&load, std::vector<bool>(static_cast<std::size_t>(t.num_faces()), false),
                      std::vector<bool>(static_cast<std::size_t>(t.num_corners()), false)};
    if (acts_on_sides(load.kind)) {
      for (const HalfedgeId h : selected_sides(model, chosen))
        placed.sides[static_cast<std::size_t>(h.value)] = true;
    } else {
      for (const FaceId f : chosen.faces())
        placed.faces[static_cast<std::size_t>(f.value)] = true;
    }
    out.push_back(std::move(placed));
  }
  return out;
}

/// By vertex and component.
std::vector<std::array<bool, 2>> held_components(const PlaneModel& model) {
  std::vector<std::array<bool, 2>> out(static_cast<std::size_t>(model.mesh().points.size()));
  for (const SupportSettings& s : model.problem.supports) {
    const Selection chosen = model.selection(s.where, s.origin.of("where"));
    const bool value = s.kind == SupportKind::value;
    for (std::size_t v = 0; v < out.size(); ++v)
      if (chosen.vertices()[v])
        for (std::size_t c = 0; c < 2; ++c)
          out[v][c] = out[v][c] || value || s.fix[c];
  }
  return out;
}

class Densities {
 public:
  explicit Densities(const PlaneModel& model)
      : model_(model),
        components_(model.problem.model.kind == ModelKind::poisson ? 1 : 2),
        loads_(placed_loads(model)),
        held_(held_components(model)) {}

  [[nodiscard]] VectorX on_element(int element, const Vec3& x) const {
    const FaceId f = model_.space->elements()[static_cast<std::size_t>(element)].face;
    VectorX sum = VectorX::Zero(components_);
    for (const PlacedLoad& p : loads_)
      if (p.faces[static_cast<std::size_t>(f.value)])
        sum += (p.load->kind == LoadKind::force_per_volume ? model_.thickness(element) : 1.0) *
               value(*p.load, x);
    return sum;
  }

  [[nodiscard]] VectorX on_side(HalfedgeId side, const Vec3& x, const Vec2& normal) const {
    VectorX sum = VectorX::Zero(components_);
    for (const PlacedLoad& p : loads_) {
      if (!p.sides[static_cast<std::size_t>(side.value)]) continue;
      if (p.load->kind == LoadKind::pressure)
        sum -= component(*p.load, 0, x) * thickness(side) * normal;
      else
        sum += value(*p.load, x);
    }
    return sum;
  }

  [[nodiscard]] bool held(HalfedgeId side, int component) const {
    const auto at = [&](VertexId v) {
      return held_[static_cast<std::size_t>(v.value)][static_cast<std::size_t>(component)];
    };
    return at(model_.adjacency().from(side)) && at(model_.adjacency().to(side));
  }

 private:
  [[nodiscard]] double component(const LoadSettings& load, std::size_t i, const Vec3& x) const {
    const double value = load.value[i](x);
    if (!std::isfinite(value))
      fail_at(place_of_value(load), "'{}' has no finite value at ({:.6g}, {:.6g})",
              load.value[i].text(), x.x(), x.y());
    return value;
  }
  [[nodiscard]] VectorX value(const LoadSettings& load, const Vec3& x) const {
    VectorX out(components_);
    for (Eigen::Index c = 0; c < components_; ++c)
      out(c) = component(load, static_cast<std::size_t>(c), x);
    return out;
  }
  [[nodiscard]] double thickness(HalfedgeId side) const {
    const FaceId f = model_.adjacency().face(side);
    const auto elements = model_.space->elements();
    const auto at = std::lower_bound(elements.begin(), elements.end(), f,
                                     [](const Element& e, FaceId face) { return e.face < face; });
    return model_.thickness(static_cast<int>(at - elements.begin()));
  }

  const PlaneModel& model_;
  Eigen::Index components_;
  std::vector<PlacedLoad> loads_;
  std::vector<std::array<bool, 2>> held_;
};

}  // namespace

LoadDensity load_density(const PlaneModel& model) {
  const auto densities = std::make_shared<const Densities>(model);
  return {[densities](int e, const Vec3& x) { return densities->on_element(e, x); },
          [densities](HalfedgeId h, const Vec3& x, const Vec2& n) {
            return densities->on_side(h, x, n);
          },
          [densities](HalfedgeId h, int c) { return densities->held(h, c); }};
}

}  // namespace limes
