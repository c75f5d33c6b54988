#pragma once

#include <memory>
#include <span>
#include <vector>

#include "limes/mesh/adjacency.h"
#include "limes/subdiv/corner_rings.h"
#include "limes/subdiv/scheme.h"

namespace limes {

/// Several steps of a scheme at once, by grids in the cache: what UniformRefinement uses where it can.
/// Each control face is refined as a grid of its own (structured.h, structured_triangles.h) and each
/// irregular vertex as a ring (CornerRings). Vertices have the same bits and the same numbers as with
/// RefinementStep.
class GridRefinement {
 public:
  virtual ~GridRefinement() = default;
  GridRefinement(const GridRefinement&) = delete;
  GridRefinement& operator=(const GridRefinement&) = delete;

  [[nodiscard]] int num_vertices() const { return num_vertices_; }
  [[nodiscard]] int num_faces() const { return control_->topology().num_faces() << (2 * depth_); }
  /// Of every face.
  [[nodiscard]] int face_size() const { return control_->topology().uniform_face_size(); }

  /// Positions of all vertices after the last step. Not to be called from several threads at once.
  /// @param control  one per control vertex
  /// @param fine     num_vertices() positions, written
  void positions(std::span<const Vec3> control, std::span<Vec3> fine);

  /// Renews those positions that change when some control vertices have moved.
  void update(std::span<const Vec3> control, std::span<const VertexId> moved, std::span<Vec3> fine);

  /// Corners of all faces after the last step, face_size() num_faces() vertices, written.
  void corners(std::span<VertexId> out) const;

  /// Features of the refined mesh.
  [[nodiscard]] Features features() const;

 protected:
  /// Whether grids can follow the sharpness: that of an edge stays the same all along it, which it does
  /// not with Chaikin's method, and weights do not depend on angles.
  [[nodiscard]] static bool can_follow(const Features& features);

  /// Keeps references to all but the features. Precondition: can_follow(features).
  GridRefinement(const Adjacency& control, const Features& features, const Scheme& scheme,
                 int depth);

  /// Calls gather_grid() for every face, then place_ring() for every irregular corner. The last thing
  /// that the constructor of a derived class does.
  void gather_grids();

  const Adjacency* control_;
  Features features_;
  const Scheme* scheme_;
  int depth_;
  CornerRings rings_;
  int num_vertices_ = 0;  ///< set by the derived class

 private:
  /// Finds what the grid of a face starts from. Different faces at the same time.
  virtual void gather_grid(FaceId f) = 0;
  /// Notes that a ring is at a corner of a face, whose side from there on is the ring's edge `edge`.
  virtual void place_ring(FaceId f, int corner, int ring, int edge) = 0;
  /// Writes the vertices that a face has numbered. Different faces at the same time.
  virtual void refine_face(FaceId f, std::span<const Vec3> control, std::span<Vec3> fine) const = 0;
  /// Writes the corners of the faces that a face becomes. Different faces at the same time.
  virtual void split_face(FaceId f, VertexId* out) const = 0;

  void refine_ring(int ring, std::span<const Vec3> control, std::span<Vec3> fine);

  std::vector<VertexId> unused_;  // control vertices without faces
};

/// The grids that fit a mesh and a scheme, or null. Keeps references to all but the features.
/// @param depth  number of steps, >= 1
/// @throws InputError if the result would have more vertices or corners than can be numbered
[[nodiscard]] std::unique_ptr<GridRefinement> grid_refinement(const Adjacency& control,
                                                              const Features& features,
                                                              const Scheme& scheme, int depth);

}  // namespace limes
