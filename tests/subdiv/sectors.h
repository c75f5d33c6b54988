#pragma once

#include <vector>

#include "limes/core/types.h"
#include "limes/subdiv/bisect.h"

namespace limes {

/// The regular 4-8 pattern around a vertex with n sectors (valence 2n), and what two steps make of it:
/// the same pattern at half the size, in the plane. Vertex 0 is the middle one.
class Sectors {
 public:
  /// @param size  quads along the sides of a sector
  Sectors(int n, int size);

  [[nodiscard]] const Topology& coarse() const { return coarse_; }
  [[nodiscard]] const Bisection& first() const { return first_; }
  [[nodiscard]] const Bisection& second() const { return second_; }

  /// The matrix of two steps around the middle, made from its action.
  /// @param rings  how many rings of quads around the middle it covers
  /// @param steps  (values per coarse vertex) -> values per vertex after both steps
  /// Fails the test that runs if the rings are too few for the matrix to close.
  template <class Steps>
  [[nodiscard]] MatrixX matrix(int rings, const Steps& steps) const {
    const std::vector<int> coarse = inner_coarse(rings), fine = inner_fine(coarse);
    MatrixX result(fine.size(), coarse.size());
    const auto num_vertices = static_cast<std::size_t>(coarse_.num_vertices());
    for (std::size_t j = 0; j < num_vertices; j += 3) {
      std::vector<Vec3> impulses(num_vertices, Vec3::Zero());
      for (std::size_t k = 0; k < 3 && j + k < num_vertices; ++k)
        impulses[j + k][static_cast<Eigen::Index>(k)] = 1;
      const std::vector<Vec3> response = steps(impulses);
      for (std::size_t k = 0; k < 3 && j + k < num_vertices; ++k)
        store_column(static_cast<int>(j + k), static_cast<int>(k), response, coarse, fine, result);
    }
    return result;
  }

 private:
  [[nodiscard]] std::vector<int> inner_coarse(int rings) const;
  [[nodiscard]] std::vector<int> inner_fine(const std::vector<int>& coarse) const;
  static void store_column(int vertex, int component, const std::vector<Vec3>& response,
                           const std::vector<int>& coarse, const std::vector<int>& fine,
                           MatrixX& result);

  Topology coarse_;
  Bisection first_, second_;
  std::vector<double> ring_;  // of each coarse vertex
  std::vector<Vec2> coarse_places_, fine_places_;
};

/// Absolute values of the eigenvalues, descending.
[[nodiscard]] std::vector<double> eigenvalues(const MatrixX& matrix);

}  // namespace limes
