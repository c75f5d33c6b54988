#include "limes/subdiv/sector.h"

#include <cmath>
#include <numbers>

namespace limes {
namespace {

/// The faces around a boundary vertex.
struct Sector {
  explicit Sector(const Spokes& of_ring)
      : ring(of_ring), num_faces(ring.size() - 1), theta(ring.angle / num_faces) {}

  /// Weight of the far end of an inner edge.
  [[nodiscard]] double gamma() const { return 0.375 - 0.25 * std::cos(theta); }
  /// A plane face has no more than pi.
  [[nodiscard]] bool is_concave() const {
    return ring.corner && ring.angle > std::numbers::pi && num_faces > 1;
  }
  /// How far new vertices are drawn to the plane sector, in [0, 1): lambda (1 - s) = 1/4, with the
  /// largest eigenvalue lambda that does not come from the boundary. Its eigenvector goes like
  /// sin(pi i / k) over the edges i, and face points follow.
  [[nodiscard]] double flatness() const {
    const double phi = std::numbers::pi / num_faces;
    const double edge = gamma() + 0.125 * std::cos(phi);
    const double half = std::cos(0.5 * phi);
    const double trace = edge + 0.25;
    const double determinant = 0.25 * edge - 0.0625 * half * half;
    const double lambda = 0.5 * (trace + std::sqrt(trace * trace - 4.0 * determinant));
    return 1.0 - 0.25 / lambda;
  }
  /// Draws the row of a new vertex to its place in the plane sector: half-way (eigenvalue 1/2) along
  /// the first and last edge's vectors times the coordinates (first, last).
  void flatten(double first, double last, Stencil& row) const {
    const double s = flatness();
    row.scale(1.0 - s);
    row.add(s * (1.0 - 0.5 * (first + last)), ring.centre);
    row.add(s * 0.5 * first, ring.ends.front());
    row.add(s * 0.5 * last, ring.ends.back());
  }
  /// Coordinates of the end of edge i of the plane sector.
  [[nodiscard]] double first(int i) const { return std::sin((num_faces - i) * theta) / whole(); }
  [[nodiscard]] double last(int i) const { return std::sin(i * theta) / whole(); }

  const Spokes& ring;
  int num_faces;
  double theta;

 private:
  [[nodiscard]] double whole() const { return std::sin(ring.angle); }
};

}  // namespace

bool has_sector(const EdgeNeighbourhood& edge) {
  const auto& [a, b] = edge.rings;
  if (edge.num_faces != 2) return false;
  return a.boundary != b.boundary || (a.boundary && a.corner != b.corner);
}

void add_sector_edge(const EdgeNeighbourhood& edge, Stencil& out) {
  const auto& [a, b] = edge.rings;
  const std::size_t at_boundary = (a.boundary && (!b.boundary || a.corner)) ? 0 : 1;
  const Sector sector(edge.rings[at_boundary]);
  const double gamma = sector.gamma();
  // In terms of face points, a quarter of whose weight lies on the two ends.
  out.add(0.625 - gamma, edge.ends[at_boundary]);
  out.add(gamma - 0.125, edge.ends[1 - at_boundary]);
  out.add(0.25, edge.faces);
  const int i = sector.ring.first;
  if (sector.is_concave()) sector.flatten(sector.first(i), sector.last(i), out);
}

void flatten_face(const FaceNeighbourhood& face, Stencil& row) {
  for (const Spokes& ring : face.rings) {
    if (!ring.boundary) continue;
    const Sector sector(ring);
    if (!sector.is_concave()) continue;
    // f' = (c + e + e+ + f)/4 = f/2 has the solution f = e + e+.
    const int i = ring.first;
    sector.flatten(sector.first(i) + sector.first(i + 1), sector.last(i) + sector.last(i + 1), row);
  }
}

}  // namespace limes
