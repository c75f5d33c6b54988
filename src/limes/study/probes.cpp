#include "limes/study/probes.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "limes/limit/limit_surface.h"

namespace limes {
namespace {

struct Candidate {
  double distance2;
  int element;
  Vec2 uv;
};

/// Nearest of a coarse set of sample points on every element, best first.
std::vector<Candidate> candidates(const SubdivisionSpace& space,
                                  const std::vector<ElementTable>& samples, const Vec3& at) {
  std::vector<Candidate> out;
  for (int e = 0; e < static_cast<int>(space.elements().size()); ++e) {
    const ElementTable& table =
        samples[static_cast<std::size_t>(space.elements()[static_cast<std::size_t>(e)].shape)];
    const Eigen::Matrix<double, Eigen::Dynamic, 3> x = table.G * space.control_points(e);
    Eigen::Index best = 0;
    const double d = (x.rowwise() - at.transpose()).rowwise().squaredNorm().minCoeff(&best);
    out.push_back({d, e, table.uv.row(best).transpose()});
  }
  constexpr std::size_t kept = 12;
  const auto middle = out.begin() + static_cast<std::ptrdiff_t>(std::min(kept, out.size()));
  std::partial_sort(out.begin(), middle, out.end(), [](const Candidate& a, const Candidate& b) {
    return a.distance2 < b.distance2 || (a.distance2 == b.distance2 && a.element < b.element);
  });
  out.erase(middle, out.end());
  return out;
}

/// Walks to the nearest point of one element: Gauss-Newton steps, kept inside the square, halved
/// while they lead away.
Candidate descend(const SubdivisionSpace& space, Candidate c, const Vec3& at) {
  const LimitSurface surface(space.geometry(), space.mesh().points.span());
  const Element& e = space.elements()[static_cast<std::size_t>(c.element)];
  const auto distance2 = [&](const Vec2& uv) {
    return (surface.position(e.face, e.corner, uv) - at).squaredNorm();
  };
  for (int step = 0; step < 50; ++step) {
    const SurfacePoint p = surface.evaluate(e.face, e.corner, c.uv);
    if (!p.first) {  // derivatives begin a little inside; the vertex itself stays a candidate
      c.uv += 0.01 * (Vec2(0.5, 0.5) - c.uv);
      c.distance2 = distance2(c.uv);
      continue;
    }
    Eigen::Matrix<double, 3, 2> A;
    A << p.first->xu, p.first->xv;
    Vec2 gradient = A.transpose() * (p.x - at);
    Mat2 M = A.transpose() * A;
    for (int i = 0; i < 2; ++i) {  // a direction that is blocked by the border of the square
      const bool blocked = (c.uv(i) <= 0 && gradient(i) > 0) || (c.uv(i) >= 1 && gradient(i) < 0);
      if (!blocked) continue;
      gradient(i) = 0;
      M.row(i).setZero();
      M.col(i).setZero();
      M(i, i) = 1;
    }
    Vec2 direction = -M.ldlt().solve(gradient);
    double scale = 1;
    Vec2 next = (c.uv + direction).cwiseMax(0.0).cwiseMin(1.0);
    while (scale > 1e-6 && !(distance2(next) < c.distance2)) {
      scale /= 2;
      next = (c.uv + scale * direction).cwiseMax(0.0).cwiseMin(1.0);
    }
    if (scale <= 1e-6) break;
    c = {distance2(next), c.element, next};
  }
  return c;
}

Candidate nearest_point(const SubdivisionSpace& space, const std::vector<ElementTable>& samples,
                        const Vec3& at) {
  Candidate best{std::numeric_limits<double>::infinity(), 0, Vec2::Zero()};
  for (Candidate c : candidates(space, samples, at)) {
    const Element& e = space.elements()[static_cast<std::size_t>(c.element)];
    const LimitSurface surface(space.geometry(), space.mesh().points.span());
    c.distance2 = (surface.position(e.face, e.corner, c.uv) - at).squaredNorm();
    if (c.distance2 < best.distance2) best = c;
    c = descend(space, c, at);
    if (c.distance2 < best.distance2) best = c;
  }
  return best;
}

}  // namespace

std::vector<ProbePlace> probe_places(const PlaneModel& model) {
  std::vector<ProbePlace> out;
  if (model.problem.probes.empty()) return out;
  const SubdivisionSpace& space = *model.space;
  std::vector<Vec2> grid;
  for (int j = 0; j <= 4; ++j)
    for (int i = 0; i <= 4; ++i)
      grid.emplace_back(i / 4.0, j / 4.0);
  std::vector<ElementTable> samples;
  for (int s = 0; s < space.num_shapes(); ++s)
    samples.push_back(space.sample(s, grid));
  for (const ProbeSettings& p : model.problem.probes) {
    Vec3 at = p.at;
    at.z() = model.z;  // plane models: z is not asked for
    const Candidate c = nearest_point(space, samples, at);
    out.push_back({p.name, p.at, std::sqrt(c.distance2), c.element, c.uv});
  }
  return out;
}

std::vector<ProbeResult> probe(const PlaneModel& model, const PlaneSolution& solution) {
  std::vector<ProbeResult> out;
  for (ProbePlace& place : probe_places(model)) {
    const int shape = model.space->elements()[static_cast<std::size_t>(place.element)].shape;
    const PlaneState state =
        states(model, solution, place.element, model.space->sample(shape, {place.uv})).front();
    out.push_back({std::move(place), state});
  }
  return out;
}

std::optional<std::string> remark_on(const ProbePlace& place, const Vec3& point,
                                     const PlaneModel& model) {
  if (!(place.distance > 0.01 * model.diagonal)) return std::nullopt;
  return fmt::format(
      "{}: probe '{}' at ({:.6g}, {:.6g}) is {:.3g} away from the surface; its values are "
      "those of the nearest point ({:.6g}, {:.6g})",
      model.problem.file.string(), place.name, place.at.x(), place.at.y(), place.distance,
      point.x(), point.y());
}

std::vector<std::string> remarks_on(const std::vector<ProbeResult>& probes,
                                    const PlaneModel& model) {
  std::vector<std::string> out;
  for (const ProbeResult& p : probes)
    if (std::optional<std::string> remark = remark_on(p, p.state.x, model))
      out.push_back(std::move(*remark));
  return out;
}

}  // namespace limes
