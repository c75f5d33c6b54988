#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "limes/subdiv/grid_refinement.h"
#include "limes/subdiv/sharp_lines.h"
#include "limes/subdiv/triangle_grid.h"
#include "limes/subdiv/triangle_kernel.h"
#include "limes/subdiv/triangle_runs.h"

namespace limes {

/// Several steps of quadrisection of a mesh of triangles at once, the sister of StructuredRefinement.
/// Each control triangle is refined as a small grid in the cache and only its last step is written:
///
///        o   o
///      o   +   o        o  margin: the faces around, refined along with the grid
///    o   +   +   o      +  vertices of the triangle, step by step: 3, 6, 15, ...
///      +   +   +        at its corners CornerRings takes over unless they are regular, and along
///    o   o   o   o      sharp sides TriangleLineRules do
///
/// Vertices on a side are computed by both triangles and written by the one that owns the side, vertices
/// at corners by the ring or by the first face. All weights come from the scheme's rules, in their
/// order of summation, which for a vertex depends on where its ring starts: on an axis that
/// TriangleNumbering knows for vertices inside, the neighbour for those on its sides.
class StructuredTriangles final : public GridRefinement {
 public:
  /// Whether the class can refine this mesh: triangles only, no semi-sharp edges with Chaikin's method,
  /// and a scheme whose regular rules are those of RegularTriangleMasks.
  [[nodiscard]] static bool applies(const Topology& topology, const Features& features,
                                    const Scheme& scheme);

  /// Keeps references to all but the features. Precondition: applies(...).
  /// @param depth  number of steps, 1 <= depth <= TriangleNumbering::max_depth
  /// @throws InputError if the result would have more vertices or corners than can be numbered
  StructuredTriangles(const Adjacency& control, const Features& features, const Scheme& scheme,
                      int depth);

 private:
  using Line = SharpLines<TriangleLineRules>::Line;
  struct Triangle {
    std::array<VertexId, 16> control;  // grid of one cell with its margin, line by line
    std::array<int, 3> ring;           // of the corners, -1: regular
    std::array<int, 3> ring_edge;      // number there of the side that starts at the corner
    std::array<int, 3> corner_axis;    // where the ring of a regular corner starts
    std::array<int, 3> lender;         // side of the lower face that shares the side, or -1
    std::array<const Line*, 3> line;   // rules of the sides, or null: smooth
    OwnedTriangleSides owned;
    unsigned own_corners;  // regular corners that this triangle writes
    int sides_before;      // sides owned by the triangles before this one
  };
  void number_runs();
  void number_sides(const Sharpness& sharpness);
  void gather_grid(FaceId f) override;
  void gather_corner(HalfedgeId h, int corner, Triangle& t) const;
  void place_ring(FaceId f, int corner, int ring, int edge) override;

  [[nodiscard]] const Triangle& triangle(FaceId f) const {
    return triangles_[static_cast<std::size_t>(f.value)];
  }
  [[nodiscard]] const TriangleRuns& runs(const Triangle& t) const { return *runs_[t.owned]; }
  [[nodiscard]] int first_of_run(FaceId f, int birth) const;

  void refine_face(FaceId f, std::span<const Vec3> control, std::span<Vec3> fine) const override;
  void apply_side(const Triangle& t, int side, int step, const TriangleGrid& grid,
                  TriangleGrid& fine) const;
  [[nodiscard]] int axis_on_side(const Triangle& t, int side, int step, int n, int along) const;
  void take_corners(const Triangle& t, int step, const TriangleGrid& coarse,
                    TriangleGrid& fine) const;
  void write_vertices(FaceId f, const TriangleGrid& grid, std::span<Vec3> fine) const;
  void split_face(FaceId f, VertexId* out) const override;
  void borrow_side(FaceId f, int side, int birth, VertexId* corners) const;

  RegularTriangleMasks masks_;
  const TriangleKernel* kernel_ = &TriangleKernel::best();
  TriangleNumbering numbering_;
  std::vector<Triangle> triangles_;
  SharpLines<TriangleLineRules> lines_;
  std::array<std::unique_ptr<TriangleRuns>, 8> runs_;  // by owned sides; only those that occur
  std::array<int, TriangleNumbering::max_depth + 1> first_vertex_{};  // by birth
};

}  // namespace limes
