#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "limes/subdiv/grid_refinement.h"
#include "limes/subdiv/refinement_step.h"

namespace limes {

/// A mesh refined uniformly any number of times, without the meshes in between where that can be
/// had: the first steps by the general rules (RefinementStep), as many as it takes until the rest can
/// be done on grids (GridRefinement). Which way a vertex was made shows neither in its number nor in its bits.
///
/// Holds what depends on the topology, so that positions() may be called again for other control
/// points. No table of weights is built: the rules run again.
class UniformRefinement {
 public:
  /// Keeps references to the adjacency and the scheme.
  /// @param levels  number of steps, >= 1
  /// @throws InputError if the scheme does not fit the faces, or if the result has too many vertices
  UniformRefinement(const Adjacency& control, const Features& features, const Scheme& scheme,
                    int levels);
  ~UniformRefinement();

  [[nodiscard]] int num_vertices() const;
  [[nodiscard]] int num_faces() const;

  /// Positions of the refined vertices. The same bits for any number of threads; not to be called
  /// from several threads at once.
  /// @param control  one per control vertex
  /// @param fine     num_vertices() positions, written
  void positions(std::span<const Vec3> control, std::span<Vec3> fine);

  /// Renews the positions that change when control vertices have moved: costs as much as there is to
  /// renew. Precondition: positions() was called before, with control points that differ in `moved`
  /// only.
  void update(std::span<const Vec3> control, std::span<const VertexId> moved, std::span<Vec3> fine);

  /// Corners of the refined faces, one face after another, written.
  void corners(std::span<VertexId> out) const;
  [[nodiscard]] Topology topology() const;
  [[nodiscard]] Features features() const;

 private:
  struct GeneralStep;

  std::vector<std::unique_ptr<GeneralStep>> general_;
  std::unique_ptr<GridRefinement> structured_;
};

}  // namespace limes
