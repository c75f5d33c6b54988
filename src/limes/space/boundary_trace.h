#pragma once

#include "limes/space/constraints.h"
#include "limes/space/subdivision_space.h"

namespace limes {

/// Where the side that starts at a halfedge runs in the parameters of its face.
struct SidePoint {
  int corner;  ///< quadrant
  Vec2 uv;
  Vec2 direction;  ///< d(uv)/ds
};
/// @param s  in [0, 1], 0 at the start of the halfedge
[[nodiscard]] SidePoint side_point(const LimitBasis& basis, HalfedgeId h, double s);

/// The sides of the domain: halfedges whose face has an element, with no element beyond.
[[nodiscard]] std::vector<HalfedgeId> domain_sides(const SubdivisionSpace& space);

/// Linear functionals of the field's degrees of freedom that vanish together if and only if the
/// field vanishes on the side of a face. On a side of a regular element these are the four control
/// values (g + 4 b + c) / 6 of its cubic B-spline curve.
/// @param h  halfedge of the control mesh whose face has an element
[[nodiscard]] std::vector<ConstraintRow> trace_of_side(const SubdivisionSpace& space, HalfedgeId h);

/// Constraints that make a field continuous between regions: equal values on both sides of every edge
/// where they meet.
[[nodiscard]] std::vector<ConstraintRow> continuity(const SubdivisionSpace& space);

/// Functionals that vanish together if and only if the field has equal values at the points of two
/// sides, the second run through backwards (s on the one is 1 - s on the other).
[[nodiscard]] std::vector<ConstraintRow> tie_of_sides(const SubdivisionSpace& space, HalfedgeId a,
                                                      HalfedgeId b);

/// The functional whose value is the field at a vertex of the control mesh (its limit point), by a face at
/// it that has an element, whichever fan that is in; empty if none has one.
[[nodiscard]] ConstraintRow value_at_vertex(const SubdivisionSpace& space, VertexId v);

}  // namespace limes
