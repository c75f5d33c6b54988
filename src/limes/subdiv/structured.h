#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "limes/mesh/adjacency.h"
#include "limes/subdiv/grid_refinement.h"
#include "limes/subdiv/quad_grid.h"
#include "limes/subdiv/quad_kernel.h"
#include "limes/subdiv/quad_runs.h"
#include "limes/subdiv/sharp_lines.h"

namespace limes {

/// Several steps of quadrisection of a mesh of quads at once. Each control quad is refined as a small
/// grid in the cache and only its last step is written:
///
///      o . + . + . o      o  margin: the faces around, refined along with the grid
///      . +-------+ .      +  vertices of the quad, step by step: 2 x 2, 3 x 3, 5 x 5, ...
///      + |  grid | +      at its corners CornerRings takes over unless they are regular, and
///      . +-------+ .      along sharp sides LineRules does
///      o . + . + . o
///
/// Vertices on a side are computed by both quads and written by the one that owns the side, vertices
/// at corners by the ring or by the first face. All weights come from the scheme's rules, in their
/// order of summation, so vertices have the same bits and the same numbers as with RefinementStep.
class StructuredRefinement final : public GridRefinement {
 public:
  /// Whether the class can refine this mesh: quads only, no semi-sharp edges with Chaikin's method,
  /// and a scheme whose regular rules are those of RegularMasks.
  [[nodiscard]] static bool applies(const Topology& topology, const Features& features,
                                    const Scheme& scheme);

  /// Keeps references to all but the features. Precondition: applies(...).
  /// @param depth  number of steps, 1 <= depth <= QuadNumbering::max_depth
  /// @throws InputError if the result would have more vertices or corners than can be numbered
  StructuredRefinement(const Adjacency& control, const Features& features, const Scheme& scheme,
                       int depth);

 private:
  using Line = SharpLines<LineRules>::Line;
  struct Quad {
    std::array<VertexId, 16> control;  // grid of one cell with its margin, row by row
    std::array<int, 4> ring;           // of the corners, -1: regular
    std::array<int, 4> ring_edge;      // number there of the side that starts at the corner
    std::array<const Line*, 4> line;   // rules of the sides, or null: smooth
    OwnedSides owned;
    unsigned own_corners;  // regular corners that this quad writes
    int sides_before;      // sides owned by the quads before this one
  };
  /// A side whose vertices another quad has numbered.
  struct BorrowedSide {
    FaceId owner;
    int side = 0;  // as the owner counts
    const QuadRuns* runs = nullptr;
  };
  void number_runs();
  void number_sides(const Sharpness& sharpness);
  void gather_grid(FaceId f) override;
  void gather_side(FaceId f, int side, Quad& quad) const;
  void place_ring(FaceId f, int corner, int ring, int edge) override;

  [[nodiscard]] const Quad& quad(FaceId f) const {
    return quads_[static_cast<std::size_t>(f.value)];
  }
  [[nodiscard]] const QuadRuns& runs(const Quad& q) const { return *runs_[q.owned]; }
  [[nodiscard]] int first_of_edge_run(FaceId f, int birth) const;
  [[nodiscard]] int first_of_face_run(FaceId f, int birth) const;

  void refine_face(FaceId f, std::span<const Vec3> control, std::span<Vec3> fine) const override;
  void apply_lines(const Quad& q, int step, const QuadGrid& grid, QuadGrid& fine) const;
  void take_corners(const Quad& q, int step, QuadGrid& grid) const;
  void write_runs(FaceId f, const QuadGrid& grid, std::span<Vec3> fine) const;
  void write_corners(const Quad& q, const QuadGrid& grid, std::span<Vec3> fine) const;
  void split_face(FaceId f, VertexId* out) const override;
  [[nodiscard]] std::array<BorrowedSide, 4> borrowed_sides(FaceId f) const;
  void borrow_side(const QuadRuns::SideVertex* vertices, const BorrowedSide& side, int birth,
                   VertexId* corners) const;

  RegularMasks masks_;
  const QuadKernel* kernel_ = &QuadKernel::best();
  QuadNumbering numbering_;
  std::vector<Quad> quads_;
  SharpLines<LineRules> lines_;
  std::array<std::unique_ptr<QuadRuns>, 16> runs_;  // by OwnedSides; only those that occur
  std::array<int, QuadNumbering::max_depth + 1> first_edge_vertex_{};  // by birth
  std::array<int, QuadNumbering::max_depth + 1> first_face_vertex_{};
};

}  // namespace limes
