#include "limes/study/approximation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "limes/mesh/shapes.h"
#include "limes/subdiv/refine.h"
#include "limes/subdiv/schemes.h"
#include "limes/subdiv/split.h"

namespace limes {
namespace {

Mesh refined(const Mesh& mesh, int levels, double tension) {
  RefineOptions options;
  options.levels = levels;
  options.tension = tension;
  return refine(mesh, find_scheme("kobbelt"), options);
}

/// Area of a quad of any shape: of the two triangles on each diagonal, averaged.
double area(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const auto triangle = [](const Vec3& p, const Vec3& q, const Vec3& r) {
    return 0.5 * (q - p).cross(r - p).norm();
  };
  return 0.5 * (triangle(a, b, c) + triangle(a, c, d) + triangle(a, b, d) + triangle(b, c, d));
}

}  // namespace

GraphError graph_error(int inverse_step, const ApproximationOptions& options) {
  // A vertex depends on points up to three cells away; one more keeps the boundary's out.
  constexpr int margin = 4;
  const int cells = 3 * inverse_step;
  const double spacing = 1.0 / cells;
  Mesh net = shapes::grid(cells + 2 * margin, cells + 2 * margin);
  for (Vec3& x : net.points) {
    const double u = (x.x() - margin) * spacing, v = (x.y() - margin) * spacing;
    x = Vec3(u, v, std::cos(std::hypot(u, v)));
  }
  const Mesh fine = refined(net, options.levels, options.tension);
  const double tolerance = 1e-9 * spacing;
  GraphError error{1.0 / inverse_step, 0.0, 0.0};
  // The trapezoidal rule counts vertices on sides by halves, at corners by quarters.
  const auto weight = [&](double t) {
    if (t < -tolerance || t > 1.0 + tolerance) return 0.0;
    return t < tolerance || t > 1.0 - tolerance ? 0.5 : 1.0;
  };
  double sum = 0.0;
  for (const Vec3& x : fine.points) {
    const double w = weight(x.x()) * weight(x.y());
    if (w == 0.0) continue;
    const double e = std::abs(x.z() - std::cos(std::hypot(x.x(), x.y())));
    error.mean += w * e;
    error.max = std::max(error.max, e);
    sum += w;
  }
  error.mean /= sum;
  return error;
}

SphereError sphere_error(int steps, const ApproximationOptions& options) {
  Mesh net = steps == 0 ? shapes::cube() : refined(shapes::cube(), steps, options.tension);
  for (Vec3& x : net.points)
    x.normalize();
  const Adjacency adjacency(net.topology);
  const Mesh fine = refined(net, options.levels, options.tension);

  SphereError error{std::ldexp(1.0, -steps), 0.0, 0.0};
  const double volume = 4.0 / 3.0 * std::numbers::pi;
  for (int f = 0; f < net.topology.num_faces(); ++f) {
    double integral = 0.0;
    const FaceRange children = descendants(net.topology, FaceId(f), Split::quads, options.levels);
    for (std::int64_t child = children.begin; child < children.end; ++child) {
      const auto v = fine.topology.face(FaceId(child));
      double mean = 0.0;
      for (const VertexId c : v)
        mean += 0.25 * std::abs(fine.points[c].norm() - 1.0);
      integral +=
          mean * area(fine.points[v[0]], fine.points[v[1]], fine.points[v[2]], fine.points[v[3]]);
    }
    const auto corners = net.topology.face(FaceId(f));
    const bool regular = std::all_of(corners.begin(), corners.end(),
                                     [&](VertexId v) { return adjacency.valence(v) == 4; });
    error.total += integral / volume;
    if (regular) error.regular += integral / volume;
  }
  return error;
}

}  // namespace limes
