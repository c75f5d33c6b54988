#include "limes/spectrum/characteristic_map.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "limes/core/error.h"

namespace limes {
namespace {

double cross(const Vec2& a, const Vec2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// A field over places, found by vertex.
template <class Value>
class AtVertices {
 public:
  AtVertices(const LocalSubdivision& local, const std::vector<Value>& values)
      : values_(&values),
        place_(static_cast<std::size_t>(local.star().topology.num_vertices()), -1) {
    for (std::size_t p = 0; p < local.vertices().size(); ++p)
      place_[local.vertices()[p]] = static_cast<int>(p);
  }
  const Value& operator[](VertexId v) const {
    return (*values_)[static_cast<std::size_t>(place_[v])];
  }

 private:
  const std::vector<Value>* values_;
  IdArray<VertexId, int> place_;
};

int outermost_ring(const LocalSubdivision& local) {
  return local.places().back().ring;
}

/// Least Jacobian of corners over the mean of all, for faces between two rings.
double least_jacobian(const LocalSubdivision& local, const AtVertices<Vec2>& at, int inner,
                      int outer) {
  const Topology& topology = local.star().topology;
  double least = std::numeric_limits<double>::infinity(), sum = 0;
  int count = 0;
  for (int f = 0; f < topology.num_faces(); ++f) {
    if (local.walk().inner_ring(FaceId(f)) < inner || local.walk().outer_ring(FaceId(f)) > outer)
      continue;
    const auto corners = topology.face(FaceId(f));
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vec2 x = at[corners[i]];
      const Vec2 next = at[corners[(i + 1) % corners.size()]];
      const Vec2 previous = at[corners[(i + corners.size() - 1) % corners.size()]];
      const double jacobian = cross(next - x, previous - x);
      least = std::min(least, jacobian);
      sum += jacobian;
      ++count;
    }
  }
  LIMES_ASSERT(count > 0);
  return least / std::abs(sum / count);
}

/// Of the outline of the faces within a ring around the origin.
int winding_number(const LocalSubdivision& local, const AtVertices<Vec2>& at, int outer) {
  const Adjacency& adjacency = local.walk().adjacency();
  const auto inside = [&](HalfedgeId h) {
    return h.valid() && local.walk().outer_ring(adjacency.face(h)) <= outer;
  };
  double angle = 0;
  for (int i = 0; i < local.star().topology.num_corners(); ++i) {
    const HalfedgeId h(i);
    if (!inside(h) || inside(adjacency.twin(h))) continue;
    const Vec2 a = at[adjacency.from(h)], b = at[adjacency.to(h)];
    angle += std::atan2(cross(a, b), a.dot(b));
  }
  return static_cast<int>(std::lround(angle / (2 * std::numbers::pi)));
}

/// The largest second difference along opposite edges at the vertices between two rings, over the largest
/// first difference there.
double largest_turn(const LocalSubdivision& local, const std::vector<double>& values, int inner,
                    int outer) {
  const Adjacency& adjacency = local.walk().adjacency();
  const AtVertices<double> at(local, values);
  double first = 0, second = 0;
  std::vector<double> ends;
  for (std::size_t p = 0; p < values.size(); ++p) {
    const int ring = local.places()[p].ring;
    if (ring < inner || ring >= outer) continue;
    const HalfedgeId start = adjacency.ring_start(local.vertices()[p]);
    ends.clear();
    HalfedgeId h = start;
    do {
      ends.push_back(at[adjacency.to(h)]);
      h = adjacency.ring_next(h);
    } while (h != start);
    for (std::size_t i = 0; i < ends.size(); ++i) {
      first = std::max(first, std::abs(ends[i] - values[p]));
      if (ends.size() % 2 == 0 && i < ends.size() / 2)
        second = std::max(second, std::abs(ends[i] - 2 * values[p] + ends[i + ends.size() / 2]));
    }
  }
  return first > 0 ? second / first : 0;
}

}  // namespace

CharacteristicMap characteristic_map(const LocalSubdivision& local, const Scheme& scheme,
                                     double eigenvalue) {
  const Eigen::VectorXcd v =
      local.extended(block_eigenvectors(local, {1, eigenvalue}).right, eigenvalue);
  CharacteristicMap map;
  map.eigenvalue = eigenvalue;
  for (const std::complex<double>& x : v)
    map.points.emplace_back(x.real(), x.imag());
  const AtVertices<Vec2> at(local, map.points);
  const int outer = outermost_ring(local);
  map.least_jacobian = least_jacobian(local, at, outer / rings_per_period(scheme), outer);
  map.winding_number = winding_number(local, at, outer);
  return map;
}

double kink_factor(const LocalSubdivision& local, const Scheme& scheme) {
  const int factor = rings_per_period(scheme);
  const int outer = outermost_ring(local);
  const int inner = outer / factor;
  VectorX x = VectorX::Zero(local.matrix().rows());
  x[local.first_place(local.star().around_face ? 0 : 1)] = 1;
  // The rings from inner to outer then show what those of the control mesh around the second do.
  const int periods = factor == 2 ? 3 : 2;
  double before = 0, after = 0;
  for (int i = 0; i < periods; ++i) {
    x = (local.matrix() * x).eval();
    const std::vector<double> values(x.begin(), x.end());
    if (i + 2 == periods) before = largest_turn(local, values, inner / factor, inner);
    if (i + 1 == periods) after = largest_turn(local, values, inner, outer);
  }
  return before > 0 ? after / before : 0;
}

}  // namespace limes
