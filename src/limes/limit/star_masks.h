#pragma once

#include <optional>
#include <vector>

#include "limes/core/types.h"
#include "limes/mesh/adjacency.h"
#include "limes/subdiv/scheme.h"

namespace limes {

// The two rings of quads around an interior vertex of valence n, whose other vertices are regular: what
// its limit tangents depend on where a scheme reaches two rings. Order: the vertex, then by sector m =
// 0 ... n - 1, counter-clockwise, the vertices (1,0) (1,1) (1,2) (2,0) (2,1) (2,2), where (i, j) lies
// i steps along edge m and j along edge m + 1.

constexpr int star_sector_size = 6;

/// The 6 n + 1 vertices of the star around the start of a halfedge, which begins sector 0.
/// Precondition: the two rings exist.
[[nodiscard]] std::vector<VertexId> star_vertices(const Adjacency& mesh, HalfedgeId start);

/// One step of the scheme on the star, (6 n + 1, 6 n + 1), from the scheme's own rules. n >= 3.
[[nodiscard]] MatrixX star_matrix(const Scheme& scheme, const RuleOptions& options, int valence);

/// Two rows of weights on the star that give tangents t0, t1 at the vertex, t0 x t1 along the normal
/// of counter-clockwise faces: the left eigenvectors of the double subdominant eigenvalue, in the
/// Fourier block of one turn. Nothing where that is not the subdominant one: no tangent plane exists.
[[nodiscard]] std::optional<Eigen::Matrix<double, 2, Eigen::Dynamic>> star_tangents(
    const Scheme& scheme, const RuleOptions& options, int valence);

}  // namespace limes
