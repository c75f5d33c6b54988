#pragma once

#include <complex>
#include <vector>

#include "limes/spectrum/star.h"

namespace limes {

/// Where a vertex of a star is: `place` counts the vertices of its ring counter-clockwise within its
/// sector, from the first spoke on.
struct StarPlace {
  int ring, place, sector;
  friend auto operator<=>(const StarPlace&, const StarPlace&) = default;
};

/// What one period of a scheme does to the values around a vertex or face: the subdivision matrix,
/// from the scheme's own rules. Rows and columns are the vertices of a star in the order of their
/// places, so the n vertices of an orbit of the rotation follow one another.
class LocalSubdivision {
 public:
  /// @param rings  of the star; the matrix covers them all
  /// @throws UsageError as control_star()
  LocalSubdivision(const Scheme& scheme, int valence, const RuleOptions& options, int rings);
  LocalSubdivision(const LocalSubdivision&) = delete;
  LocalSubdivision& operator=(const LocalSubdivision&) = delete;

  [[nodiscard]] int num_sectors() const { return star_.sectors; }
  [[nodiscard]] int num_steps() const { return num_steps_; }
  [[nodiscard]] const std::vector<StarPlace>& places() const { return places_; }
  /// The vertex of the star at each place.
  [[nodiscard]] const std::vector<VertexId>& vertices() const { return vertices_; }
  [[nodiscard]] const Star& star() const { return star_; }
  [[nodiscard]] const StarWalk& walk() const { return walk_; }

  /// (places, places): the value at a place after the period from those before.
  [[nodiscard]] const SparseMatrix& matrix() const { return matrix_; }

  /// The rings whose values determine the limit around the middle: nothing inside depends on what is
  /// outside, and every ring outside depends on rings further in only, so that all other
  /// eigenvalues of larger matrices are 0.
  [[nodiscard]] int num_invariant_rings() const { return num_invariant_rings_; }
  [[nodiscard]] int num_invariant_places() const { return first_place(num_invariant_rings_ + 1); }
  /// Number of places inside a ring.
  [[nodiscard]] int first_place(int ring) const;

  /// Adds what the matrix makes of the values on the invariant rings, divided by an eigenvalue: an
  /// eigenvector of the invariant rings becomes one of all rings.
  [[nodiscard]] Eigen::VectorXcd extended(const Eigen::VectorXcd& invariant,
                                          std::complex<double> eigenvalue) const;

 private:
  void sort_places(int rings);
  [[nodiscard]] int find_invariant_rings(int rings) const;

  Star star_;
  StarWalk walk_;
  int num_steps_;
  std::vector<StarPlace> places_;
  std::vector<VertexId> vertices_;
  SparseMatrix matrix_;
  int num_invariant_rings_;
};

}  // namespace limes
