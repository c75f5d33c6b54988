#pragma once

#include <memory>
#include <optional>
#include <span>

#include "limes/core/types.h"
#include "limes/mesh/adjacency.h"
#include "limes/subdiv/explicit_split.h"
#include "limes/subdiv/scheme.h"
#include "limes/subdiv/surroundings.h"

namespace limes {

/// @throws InputError if the scheme does not fit the faces, naming the first that does not
void require_faces(const Topology& topology, const Scheme& scheme);

/// One step of a scheme on one mesh. The weights go straight to values (apply) or into a matrix,
/// from the same rules. Keeps references to all three arguments.
class RefinementStep {
 public:
  /// @throws InputError if the scheme does not fit the faces, or knows no creases and is given some;
  ///         names the first; UsageError if it needs positions to refine
  RefinementStep(const Adjacency& parent, const Features& features, const Scheme& scheme);

  [[nodiscard]] int num_child_vertices() const;
  [[nodiscard]] int num_child_faces() const;
  [[nodiscard]] Topology child_topology() const;
  [[nodiscard]] Features child_features() const;
  /// Of each child face, the parent's face that it covers or (dual splits) touches.
  [[nodiscard]] std::vector<FaceId> parent_faces() const;

  /// Values of the child's vertices. The same bits for any number of threads.
  /// @param coarse  one value per parent vertex
  /// @param fine    num_child_vertices() values, written
  void apply(std::span<const double> coarse, std::span<double> fine) const;
  void apply(std::span<const Vec2> coarse, std::span<Vec2> fine) const;
  void apply(std::span<const Vec3> coarse, std::span<Vec3> fine) const;

  /// Renews the values that change when some parent vertices have.
  /// @return the child vertices that were renewed, ascending
  std::vector<VertexId> update(std::span<const Vec3> coarse, std::span<const VertexId> changed,
                               std::span<Vec3> fine) const;

  /// The operator S with fine = S coarse, (num_child_vertices, num_parent_vertices); a vertex that
  /// no face uses keeps its value.
  [[nodiscard]] SparseMatrix matrix() const;

  /// Writes the row of one child vertex. A face point in it means the mean of the face's corners.
  void stencil(NeighbourhoodWalk& walk, VertexId child, Stencil& out) const;

 private:
  /// Whether rules of faces and edges are given the rings of the corners.
  [[nodiscard]] bool is_wide() const { return scheme_->wide || features_->sector_stencils; }
  [[nodiscard]] ChildVertex source(VertexId child) const;
  /// First child vertex that other rules may read as that of a face.
  [[nodiscard]] VertexId first_face_point() const;
  [[nodiscard]] std::vector<VertexId> children_of(const SurroundedElements& elements) const;
  void stencil(NeighbourhoodWalk& walk, const ChildVertex& source, Stencil& out) const;
  /// Value of a face point: read from the child, where it has been written before, unless corners draw
  /// the vertices of faces elsewhere.
  template <class Value>
  [[nodiscard]] Value face_point(FaceId f, std::span<const Value> coarse,
                                 std::span<const Value> face_points) const;
  template <class Value>
  void apply_values(std::span<const Value> coarse, std::span<Value> fine) const;

  const Adjacency* parent_;
  const Features* features_;
  const Scheme* scheme_;
  Sharpness sharpness_;
  std::optional<ExplicitSplit> split_;       // unless quadrisection
  std::unique_ptr<const OpenNet> open_net_;  // if the scheme continues the net

 public:
  /// For callers that walk on their own.
  [[nodiscard]] NeighbourhoodWalk walk() const {
    return {*parent_, *features_, sharpness_, open_net_.get()};
  }
};

/// Adds a stencil to one matrix row, face points replaced by the means of their corners.
void append_stencil_row(int row, const Stencil& stencil, const Topology& topology,
                        std::vector<Triplet>& out);

}  // namespace limes
