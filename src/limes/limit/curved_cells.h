#pragma once

#include <span>
#include <vector>

#include "limes/limit/limit_surface.h"

namespace limes {

/// A limit surface as polynomial cells of degree 3 in both directions, for files.
///
/// Where a face's limit is one bicubic polynomial, its cell is exact. Around extraordinary vertices
/// and features the face is cut into rings of such tiles, halving towards the vertex, until the
/// bicubic that interpolates the square that is left deviates little enough. Every cell has points
/// of its own: neighbours may differ in size, and normals in direction across a crease.
struct CurvedCells {
  static constexpr int nodes_per_cell = 16;

  /// Square of a face's parameters (see LimitBasis) that a cell covers, u along i and v along j.
  struct Cell {
    FaceId face;
    int corner;
    Vec2 origin;
    double size;
    bool exact;
    double deviation;  ///< largest distance to the surface at equal parameters, as sampled
  };
  std::vector<Cell> cells;

  /// Node 4 j + i of a cell is the surface at (i / 3, j / 3) of its square. Numbers that do not
  /// exist there are NaN: normals where there is no tangent plane, curvatures at extraordinary
  /// vertices.
  std::vector<Vec3> points;
  std::vector<Vec3> normals;
  std::vector<double> mean, gauss;

  /// Largest of the cells' deviations; 0 when all are exact.
  [[nodiscard]] double deviation() const;
};

/// @param faces      the faces to convert, in the order of the result
/// @param tolerance  largest deviation, > 0, unit of length. Halving stops at 2^-40 of a face
///                   whatever the tolerance: Cell::deviation tells what is left.
[[nodiscard]] CurvedCells curved_cells(const LimitSurface& surface, std::span<const FaceId> faces,
                                       double tolerance);

/// Bernstein coefficients of the polynomials that interpolate the nodes of each cell, in the same
/// order: coefficient 4 j + i. One missing value leaves a cell's coefficients all NaN.
[[nodiscard]] std::vector<double> bernstein_coefficients(std::span<const double> nodes);
[[nodiscard]] std::vector<Vec3> bernstein_coefficients(std::span<const Vec3> nodes);

}  // namespace limes
