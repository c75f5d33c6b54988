#pragma once

#include <span>
#include <vector>

#include "limes/limit/cell_shape.h"
#include "limes/limit/limit_surface.h"

namespace limes {

/// A limit surface as polynomial cells (see CellShape), for files: of degree 3 in both directions, or
/// of degree 4 on triangles.
///
/// Where a face's limit is one polynomial, its cell is exact. Around extraordinary vertices and
/// features the face is cut into rings of such tiles, halving towards the vertex, until the
/// polynomial that interpolates what is left deviates little enough. Every cell has points of its
/// own: neighbours may differ in size, and normals in direction across a crease.
struct CurvedCells {
  /// Part of a face's parameters (see LimitBasis) that a cell covers: point (s, t) of the shape is
  /// origin + size (s, t), where triangles that lie upside down have a negative size.
  struct Cell {
    FaceId face;
    int corner;
    Vec2 origin;
    double size;
    bool exact;
    double deviation;  ///< largest distance to the surface at equal parameters, as sampled
  };
  std::vector<Cell> cells;

  /// The surface at the nodes of each cell. Numbers that do not exist there are NaN: normals where
  /// there is no tangent plane, curvatures at extraordinary vertices.
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
/// order. One missing value leaves a cell's coefficients all NaN.
[[nodiscard]] std::vector<double> bernstein_coefficients(const CellShape& shape,
                                                         std::span<const double> nodes);
[[nodiscard]] std::vector<Vec3> bernstein_coefficients(const CellShape& shape,
                                                       std::span<const Vec3> nodes);

}  // namespace limes
