#include <algorithm>
#include <array>

#include "limes/subdiv/schemes.h"

namespace limes {

// Interpolatory subdivision of quads [kobbelt_1996]. With omega = tension / 16 an edge point is
//
//   e = (1/2 + omega) (p + q) - omega (p* + q*),                                            eq. (1)
//
// where p* and q* continue the line p q beyond both ends: at a vertex of valence 4 the next vertex,
// otherwise the point of eq. (2). The paper prints (4 + w) / 8 and w / 8, that is omega = w / 8, but
// its standard w = 1 reproduces cubics only for omega = 1/16; see docs/theory/kobbelt.md. The nets
// are continued beyond their boundary (open_net.h), so that every ring is closed.
//
// In a ring of valence n, end(i) are the paper's p_i and diagonal(i) its k_i, counted from the edge in
// question; for a face from its side after the corner, so that end(0), end(1), diagonal(0) are its own.

namespace {

double omega_of(const RuleOptions& options) {
  return options.tension / 16.0;
}

template <std::size_t n>
void add(Stencil& out, double weight, const std::array<VertexId, n>& vertices) {
  out.add(weight, vertices);
}

/// The point beyond q on the line that reaches it along end(0), eq. (2).
void add_virtual(const Spokes& q, double weight, double omega, Stencil& out) {
  const double n = q.size();
  const double rho = omega / (0.5 + omega);  // the paper's w / (4 + w)
  out.add(weight * 4.0 / n, q.ends);
  add<3>(out, -weight, {q.end(-1), q.end(0), q.end(1)});
  add<4>(out, weight * rho, {q.diagonal(-2), q.diagonal(-1), q.diagonal(0), q.diagonal(1)});
  out.add(-weight * 4.0 * rho / n, q.diagonals);
}

/// The four-point rule along a curve, whatever the surface does. Beyond a breakpoint c after b the
/// curve continues to 2 c - b, which is written out: a seam has the same bits from both sides.
void add_curve_point(const std::array<VertexId, 2>& ends, const std::array<VertexId, 2>& beyond,
                     double weight, double omega, Stencil& out) {
  const bool breaks_at_start = !beyond[0].valid();
  const bool breaks_at_end = !beyond[1].valid();
  if (breaks_at_start && breaks_at_end) {
    out.add(weight * 0.5, ends);
  } else if (breaks_at_start || breaks_at_end) {
    const std::size_t broken = breaks_at_start ? 0 : 1;
    out.add(weight * (0.5 - omega), ends[broken]);
    out.add(weight * (0.5 + 2.0 * omega), ends[1 - broken]);
    out.add(-weight * omega, beyond[1 - broken]);
  } else {
    out.add(weight * (0.5 + omega), ends);
    out.add(-weight * omega, beyond);
  }
}

/// What a corner v contributes to the point of its face. Rule (3), in either direction and with the
/// two outer edge points continued from the rings of the face's corners, is the sum over the corners
/// of
///
///   c^2 v - omega [c (4/n sum p_i - p_0 - p_1) + omega (k_{-1} + k_0 + k_1 - 4/n sum k_i)]
///
/// with c = 1/2 + omega, because of eq. (2): that is why both directions agree. For n = 4 it is
/// c^2 v - omega c (p_2 + p_3) + omega^2 k_2.
void add_corner(const Spokes& v, double weight, double omega, Stencil& out) {
  const double n = v.size();
  const double c = 0.5 + omega;
  out.add(weight * c * c, v.centre);
  if (v.size() == 4) {
    add<2>(out, -weight * omega * c, {v.end(2), v.end(3)});
    out.add(weight * omega * omega, v.diagonal(2));
    return;
  }
  out.add(-weight * omega * c * 4.0 / n, v.ends);
  add<2>(out, weight * omega * c, {v.end(0), v.end(1)});
  add<3>(out, -weight * omega * omega, {v.diagonal(-1), v.diagonal(0), v.diagonal(1)});
  out.add(weight * omega * omega * 4.0 / n, v.diagonals);
}

/// The same for four corners of valence 4, in groups that do not depend on which comes first.
void add_regular_face(const FaceNeighbourhood& n, double omega, Stencil& out) {
  const auto at_corners = [&](const auto& vertex) {
    return std::array<VertexId, 4>{vertex(n.rings[0]), vertex(n.rings[1]), vertex(n.rings[2]),
                                   vertex(n.rings[3])};
  };
  const double c = 0.5 + omega;
  out.add(c * c, n.corners);
  add(out, -omega * c, at_corners([](const Spokes& v) { return v.end(2); }));
  add(out, -omega * c, at_corners([](const Spokes& v) { return v.end(3); }));
  add(out, omega * omega, at_corners([](const Spokes& v) { return v.diagonal(2); }));
}

/// What a side on a curve contributes to the point of its face in the direction across it: its edge
/// point and, from the rings of its ends u and v, the outer edge point beyond.
void add_curve_side(const FaceNeighbourhood& n, std::size_t side, double weight, double omega,
                    Stencil& out) {
  const std::size_t next = (side + 1) % 4;
  const Spokes& u = n.rings[side];
  const Spokes& v = n.rings[next];
  const double c = 0.5 + omega;
  add_curve_point({u.centre, v.centre}, n.curves[side].beyond, weight * c, omega, out);
  add<2>(out, -weight * omega * c, {u.end(-1), v.end(2)});
  add<2>(out, weight * omega * omega, {u.diagonal(-2), v.diagonal(2)});
}

}  // namespace

void kobbelt_edge(const EdgeNeighbourhood& n, const RuleOptions& options, Stencil& out) {
  const double omega = omega_of(options);
  if (n.curve.on_curve) return add_curve_point(n.ends, n.curve.beyond, 1.0, omega, out);
  const Spokes& a = n.rings[0];
  const Spokes& b = n.rings[1];
  add<2>(out, 0.5 + omega, {a.centre, b.centre});
  if (a.size() == 4 && b.size() == 4) {
    add<2>(out, -omega, {a.end(2), b.end(2)});
    return;
  }
  for (const Spokes* end : {&a, &b})
    if (end->size() == 4)
      out.add(-omega, end->end(2));
    else
      add_virtual(*end, -omega, omega, out);
}

void kobbelt_face(const FaceNeighbourhood& n, const RuleOptions& options, Stencil& out) {
  const double omega = omega_of(options);
  const auto on_curve = [&](std::size_t side) {
    return !n.curves.empty() && n.curves[side % 4].on_curve;
  };
  const bool smooth = !on_curve(0) && !on_curve(1) && !on_curve(2) && !on_curve(3);
  const auto regular = [](const Spokes& v) { return v.size() == 4; };
  if (smooth && std::all_of(n.rings.begin(), n.rings.end(), regular))
    return add_regular_face(n, omega, out);
  // The mean of both directions: each side that is smooth has a half of both its corners.
  for (std::size_t i = 0; i < 4; ++i) {
    const int smooth_sides = (on_curve(i) ? 0 : 1) + (on_curve(i + 3) ? 0 : 1);
    if (smooth_sides > 0) add_corner(n.rings[i], 0.5 * smooth_sides, omega, out);
    if (on_curve(i)) add_curve_side(n, i, 0.5, omega, out);
  }
}

}  // namespace limes
