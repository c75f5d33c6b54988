#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "limes/adapt/recovery.h"
#include "limes/fem/plane_elasticity.h"
#include "limes/problem/selection.h"
#include "limes/space/constraints.h"
#include "limes/study/control_mesh.h"
#include "limes/subdiv/hanging_faces.h"

namespace limes {

/// A mesh in whose sides vertices hang, and the same with them as corners (see HangingFaces), which tells
/// neighbours and boundaries.
struct ClosedMesh {
  HangingFaces faces;
  Mesh mesh;  ///< of these faces
  Adjacency adjacency;
  std::vector<HangingVertex> hanging;  ///< in sides of faces that are no holes

  ClosedMesh(Mesh quads, std::span<const HangingVertex> vertices);
  ClosedMesh(const ClosedMesh&) = delete;
  ClosedMesh& operator=(const ClosedMesh&) = delete;
};

/// A plane problem, of elasticity or Poisson's equation, on its mesh, ready for loads and supports: what
/// was read, refined, selected.
struct PlaneModel {
  Problem problem;
  Mesh control;  ///< as in the file
  BoundaryRule boundary = BoundaryRule::edges;
  std::unique_ptr<SubdivisionSpace> space;  ///< on the control mesh after `levels` refinements

  std::unique_ptr<ClosedMesh> closed;  ///< of mesh() if vertices hang; else none

  IdArray<VertexId, Vec3> limit_points;  ///< of the space's control vertices: what `where` is about
  double diagonal = 0;                   ///< of the box around them
  Vec2 centre = Vec2::Zero();            ///< of that box
  double z = 0;                          ///< of all of them
  std::vector<int> material_of_element;  ///< index in problem.materials
  /// Elasticity matrix times thickness, per element; nothing for Poisson's equation.
  ElementStiffness C;
  std::vector<std::string> remarks;  ///< of the mesh file's reader, and on probes

  [[nodiscard]] const Mesh& mesh() const { return space->mesh(); }
  /// Sides in which vertices hang, and their halves, have no twins here.
  [[nodiscard]] const Adjacency& adjacency() const { return space->geometry().adjacency(); }
  /// The same where nothing hangs; else of closed->mesh, in which they have.
  [[nodiscard]] const Adjacency& neighbours() const {
    return closed ? closed->adjacency : adjacency();
  }
  /// A side of mesh() as one of neighbours(): its first half, if a vertex hangs in it.
  [[nodiscard]] HalfedgeId among_neighbours(HalfedgeId side) const {
    return closed ? closed->faces.corners[side] : side;
  }
  /// @param place  of `where` in the problem
  [[nodiscard]] Selection selection(const std::string& where, const Place& place) const;
  /// Face of the control mesh that a face of mesh() is part of.
  [[nodiscard]] FaceId control_face(FaceId face) const;
  [[nodiscard]] PlaneAssumption assumption() const;
  [[nodiscard]] Isotropic material(int element) const;
  [[nodiscard]] double thickness(int element) const;
  [[nodiscard]] double conductivity(int element) const;
  /// Whether the faces on both sides of an inner edge of neighbours() are of one material.
  [[nodiscard]] JoinsFaces same_material() const;
};

/// Refines a control mesh, finds the materials and builds the space.
/// @param hanging  vertices that hang in sides: with scheme "linear" and no levels, on quads
/// @throws InputError for a mesh that cannot be refined, is not plane or is folded, and for faces
///         with no material or two
[[nodiscard]] PlaneModel build_model(const Problem& problem, Mesh control,
                                     std::span<const HangingVertex> hanging = {});

/// Conditions on the scalar field at hanging vertices: the mean of the ends of the side, so that it is
/// continuous. The vertex itself comes first, with weight -1.
[[nodiscard]] std::vector<ConstraintRow> hanging_rows(const PlaneModel& model);

/// The same for the mesh file that the problem names.
[[nodiscard]] PlaneModel read_model(const Problem& problem, const ModelOptions& options = {});

}  // namespace limes
