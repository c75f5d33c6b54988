#pragma once

#include <functional>
#include <vector>

#include "limes/space/boundary_trace.h"

namespace limes {

/// Force density at a point of a plane model.
using PlaneDensity = std::function<Vec2(const Vec3& x)>;
/// The same on a boundary with its outward unit normal.
using PlaneTraction = std::function<Vec2(const Vec3& x, const Vec2& normal)>;

/// f_a = integral over the chosen elements of N_a p dA, (2 num_dofs).
/// @param chosen  one flag per element
[[nodiscard]] VectorX body_load(const SubdivisionSpace& space, const std::vector<bool>& chosen,
                                const PlaneDensity& p);

/// f_a = integral along sides of N_a p ds.
/// @param sides  boundary halfedges whose faces have elements
[[nodiscard]] VectorX side_load(const SubdivisionSpace& space, const std::vector<HalfedgeId>& sides,
                                const PlaneTraction& p);

/// Adds N_a(limit point of v) p to f.
/// @return  whether the vertex belongs to the domain
bool add_point_load(const SubdivisionSpace& space, VertexId v, const Vec2& p, VectorX& f);

/// Points of a rule along a side, pieces where functions are polynomial; in the side's parameter s.
struct SideRule {
  std::vector<double> s, weight;
};
[[nodiscard]] SideRule side_rule(const SubdivisionSpace& space, HalfedgeId h);

}  // namespace limes
