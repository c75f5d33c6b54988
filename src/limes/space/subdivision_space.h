#pragma once

#include <memory>
#include <span>
#include <vector>

#include "limes/mesh/mesh.h"
#include "limes/space/element_table.h"
#include "limes/space/extended_mesh.h"

namespace limes {

/// One parameter square of a face: the whole quad, or one quadrant of another face.
struct Element {
  FaceId face;
  int corner = 0;
  int shape = 0;  ///< elements of equal shape have equal tables
};

struct SpaceOptions {
  bool ghosts = true;  ///< free ghosts beyond the boundary; otherwise the standard functions
  ElementQuadrature quadrature = {};
  /// `edges` for functions without reach on quads in whose sides vertices hang. The space does not know where:
  /// those sides count as its border, and nothing ties their two sides.
  Adjacency::Check check = Adjacency::Check::surface;
};

/// The limit functions of a subdivision surface as a function space: a list of elements, each with
/// its degrees of freedom and its basis functions. One scalar degree of freedom per region and vertex
/// of the extended mesh that some element of the region feels; vector fields use the same numbers
/// per component.
///
/// Regions are sets of faces, such as those of one material, between which a field is continuous but
/// may kink. Each region has copies of its own of all functions it feels, those of vertices beyond
/// its border included; continuity() ties the copies along the borders. So every region has free
/// ghosts at its borders and the geometry, which is smooth there, stays in the space.
class SubdivisionSpace {
 public:
  /// @param mesh      control mesh; hole faces shape their neighbours but are no elements
  /// @param boundary  rule of the geometry, not `none` (tag the faces at the boundary as holes)
  /// @param regions   region of every face, from 0; empty: one region
  /// @throws InputError if the scheme has no exact limit or does not fit the mesh, or if all
  ///         faces are holes
  SubdivisionSpace(Mesh mesh, const Scheme& scheme, BoundaryRule boundary, std::vector<int> regions,
                   const SpaceOptions& options);

  [[nodiscard]] const Mesh& mesh() const { return mesh_; }
  [[nodiscard]] const LimitBasis& geometry() const { return *geometry_; }
  [[nodiscard]] const LimitBasis& field() const { return *field_; }
  [[nodiscard]] const ExtendedMesh& extended() const { return extended_; }

  /// At least one.
  [[nodiscard]] std::span<const Element> elements() const { return elements_; }
  /// Whether the face is part of the domain: no hole.
  [[nodiscard]] bool has_element(FaceId f) const {
    return has_element_[static_cast<std::size_t>(f.value)];
  }
  [[nodiscard]] int num_dofs() const { return num_dofs_; }
  /// Degrees of freedom of an element, in the order of its table's field functions.
  [[nodiscard]] std::span<const int> dofs(int element) const;
  /// Control points of an element's geometry, (m, 3), in the order of its table.
  [[nodiscard]] Eigen::Matrix<double, Eigen::Dynamic, 3> control_points(int element) const;

  [[nodiscard]] int num_shapes() const { return static_cast<int>(tables_.size()); }
  /// Quadrature of all elements of a shape.
  [[nodiscard]] const ElementTable& table(int shape) const {
    return tables_[static_cast<std::size_t>(shape)];
  }
  /// The same with another rule.
  [[nodiscard]] ElementTable quadrature(int shape, const ElementQuadrature& rule) const {
    return quadrature_table(shape_of(first_of_shape(shape)), rule);
  }
  /// The same functions at points of one's own.
  [[nodiscard]] ElementTable sample(int shape, const std::vector<Vec2>& points) const;
  /// Tiles on which all functions of a shape are polynomials, see element_tiles.
  [[nodiscard]] std::vector<ParameterTile> tiles(int shape, int depth) const;

  [[nodiscard]] int region(FaceId face) const {
    return regions_.empty() ? 0 : regions_[static_cast<std::size_t>(face.value)];
  }
  /// Degrees of freedom of a region for all controls of a face, in the order of
  /// field().controls(face); -1 where the region does not feel a control.
  [[nodiscard]] std::vector<int> face_dofs(FaceId face, int region) const;
  [[nodiscard]] std::vector<int> face_dofs(FaceId face) const {
    return face_dofs(face, region(face));
  }

  /// Coefficients of the field x -> position of the geometry, (num_dofs, 3). Exact.
  [[nodiscard]] Eigen::Matrix<double, Eigen::Dynamic, 3> position_coefficients() const;

 private:
  void add_elements();
  void number_dofs();
  [[nodiscard]] const Element& first_of_shape(int shape) const {
    return elements_[static_cast<std::size_t>(first_of_shape_[static_cast<std::size_t>(shape)])];
  }
  [[nodiscard]] ElementShape shape_of(const Element& e) const {
    return {geometry_.get(), field_.get(), e.face, e.corner};
  }

  Mesh mesh_;
  ExtendedMesh extended_;
  std::unique_ptr<LimitBasis> geometry_, field_;
  ElementQuadrature quadrature_;
  std::vector<Element> elements_;
  std::vector<bool> has_element_;  // by face
  std::vector<ElementTable> tables_;
  std::vector<int> first_of_shape_;  // an element of each shape
  std::vector<int> regions_;
  std::vector<IdArray<VertexId, int>> dof_;  // per region, -1 where a vertex is not felt
  int num_dofs_ = 0;
  std::vector<std::int64_t> first_dof_;
  std::vector<int> element_dofs_;
};

}  // namespace limes
