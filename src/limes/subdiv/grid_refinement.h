#pragma once

#include <memory>
#include <span>

#include "limes/mesh/adjacency.h"
#include "limes/subdiv/scheme.h"

namespace limes {

/// Several steps of a scheme at once, by grids in the cache: what UniformRefinement uses where it can.
/// Vertices have the same bits and the same numbers as with RefinementStep.
class GridRefinement {
 public:
  virtual ~GridRefinement() = default;
  GridRefinement(const GridRefinement&) = delete;
  GridRefinement& operator=(const GridRefinement&) = delete;

  [[nodiscard]] virtual int num_vertices() const = 0;
  [[nodiscard]] virtual int num_faces() const = 0;
  /// Of every face.
  [[nodiscard]] virtual int face_size() const = 0;

  /// Positions of all vertices after the last step. Not to be called from several threads at once.
  /// @param control  one per control vertex
  /// @param fine     num_vertices() positions, written
  virtual void positions(std::span<const Vec3> control, std::span<Vec3> fine) = 0;

  /// Renews those positions that change when some control vertices have moved.
  virtual void update(std::span<const Vec3> control, std::span<const VertexId> moved,
                      std::span<Vec3> fine) = 0;

  /// Corners of all faces after the last step, face_size() num_faces() vertices, written.
  virtual void corners(std::span<VertexId> out) const = 0;

  /// Features of the refined mesh.
  [[nodiscard]] virtual Features features() const = 0;

 protected:
  GridRefinement() = default;
};

/// The grids that fit a mesh and a scheme, or null. Keeps references to all but the features.
/// @param depth  number of steps, >= 1
/// @throws InputError if the result would have more vertices or corners than can be numbered
[[nodiscard]] std::unique_ptr<GridRefinement> grid_refinement(const Adjacency& control,
                                                              const Features& features,
                                                              const Scheme& scheme, int depth);

}  // namespace limes
