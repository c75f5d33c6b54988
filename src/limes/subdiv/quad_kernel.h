#pragma once

#include "limes/subdiv/point4.h"
#include "limes/subdiv/quad_runs.h"
#include "limes/subdiv/regular_rules.h"

namespace limes {

/// The loops over a grid of n x n cells as QuadGrid lays it out, for one instruction set. All give
/// the same bits.
struct QuadKernel {
  /// New face points of all cells.
  void (*make_face_points)(const RegularMasks&, int n, const Point4* vertices, Point4* faces);
  /// Vertices of the grid one step finer, margin included.
  void (*refine)(const RegularMasks&, int n, const Point4* vertices, const Point4* faces,
                 Point4* fine);
  /// New positions in the order of QuadRuns.
  void (*write_vertices)(const RegularMasks&, int n, const Point4* vertices, const Point4* faces,
                         const QuadRuns::OldVertex*, int count, Vec3* out);
  void (*write_edges)(const RegularMasks&, const Point4* vertices, const Point4* faces,
                      const QuadRuns::NewEdge*, int count, Vec3* out);
  void (*write_faces)(const Point4* faces, const std::uint16_t* order, int count, Vec3* out);

  /// For every machine.
  [[nodiscard]] static const QuadKernel& two_doubles();
  /// The fastest for this one: four doubles to a vector where it has AVX2.
  [[nodiscard]] static const QuadKernel& best();
};

}  // namespace limes
