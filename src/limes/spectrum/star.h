#pragma once

#include <vector>

#include "limes/core/types.h"
#include "limes/mesh/adjacency.h"
#include "limes/subdiv/features.h"
#include "limes/subdiv/scheme.h"

namespace limes {

/// A mesh of equal sectors around a vertex or a face at the origin; everything else is regular. The
/// positions only tell sectors and places apart.
struct Star {
  Topology topology;
  std::vector<Vec3> points;  ///< per vertex, z = 0
  RuleOptions options;       ///< tension, weights and level
  int sectors = 0;
  bool around_face = false;
  double first_angle = 0;  ///< direction of the first spoke, or of the face's first corner
};

/// Steps after which a scheme finds the same star, smaller and not turned: 2 where one step turns it
/// by half a sector.
[[nodiscard]] int steps_per_period(const Scheme& scheme);
/// Factor by which the rings multiply in a period.
[[nodiscard]] int rings_per_period(const Scheme& scheme);

/// Whether a scheme has vertices (dual schemes: faces) of this valence.
[[nodiscard]] bool has_valence(const Scheme& scheme, int valence);
/// @throws UsageError unless it is possible, saying which are
void require_valence(const Scheme& scheme, int valence);

/// @param valence  edges at the middle vertex, corners of the middle face for dual schemes
/// @param rings    how many rings of faces there are around, about
/// Precondition: has_valence()
[[nodiscard]] Star control_star(const Scheme& scheme, int valence, int rings,
                                const RuleOptions& options);

/// One step: the refined star, and the matrix of the step, (vertices of the child, of the parent).
struct StarStep {
  Star child;
  SparseMatrix matrix;
};
[[nodiscard]] StarStep refine_star(const Star& star, const Scheme& scheme);

/// A star that can be walked: its middle is found, its rings are counted. Keeps a reference.
class StarWalk {
 public:
  explicit StarWalk(const Star& star);

  /// Rings of faces between a vertex and the middle: 0 at the middle vertex or the corners of the
  /// middle face.
  [[nodiscard]] int ring(VertexId v) const { return ring_[v]; }
  /// The greatest of the rings of a face's corners.
  [[nodiscard]] int outer_ring(FaceId f) const;
  [[nodiscard]] int inner_ring(FaceId f) const;
  [[nodiscard]] const Adjacency& adjacency() const { return adjacency_; }

  /// The first spoke, or the side at the first corner of the middle face.
  [[nodiscard]] HalfedgeId first_spoke() const { return first_spoke_; }
  /// The same one sector on, counter-clockwise.
  [[nodiscard]] HalfedgeId second_spoke() const;

  /// Where the walks that lead from our first spoke to our vertices lead from a halfedge of another
  /// star (or this one); invalid beyond the given rings.
  /// Precondition: the other star has that many rings.
  [[nodiscard]] IdArray<VertexId, VertexId> same_walks(const StarWalk& other, HalfedgeId start,
                                                       int rings) const;

 private:
  void find_first_spoke();
  void count_rings();

  const Star* star_;
  Adjacency adjacency_;
  HalfedgeId first_spoke_;
  IdArray<VertexId, int> ring_;
};

}  // namespace limes
