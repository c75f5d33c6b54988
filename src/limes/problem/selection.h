#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "limes/mesh/adjacency.h"
#include "limes/mesh/mesh.h"
#include "limes/problem/place.h"

namespace limes {

/// A `where` of a problem file, understood but not yet looked up in a mesh.
struct Where {
  enum class Kind { all, boundary, group, part, vertex, condition };
  Kind kind = Kind::all;
  std::string text;   ///< as written
  std::string name;   ///< of the group or part
  VertexId vertex{};  ///< counted from 0
};

/// Reads "all", "boundary", "group:NAME", "part:NAME", "vertex:12", or a condition in x, y, z.
/// @throws InputError that says what is wrong, without the place in a file
[[nodiscard]] Where parse_where(std::string_view text);

/// The faces of the groups (or parts) that a `where` of this kind names.
/// @throws InputError if there are none, with what there is to select, without the place in a file
[[nodiscard]] std::vector<FaceId> faces_in_groups(const std::vector<FaceGroup>& groups,
                                                  const Where& where);

/// The vertices, faces and boundary edges of a mesh that a `where` means.
///
/// A condition is tested at the vertices' limit positions; == means within 1e-9 of the diagonal of
/// their bounding box. Vertices without a face are never selected. Keeps references.
class Selection {
 public:
  /// @param adjacency  of mesh.topology
  /// @param points     limit position of every vertex
  /// @param place  of `where`, for messages
  /// @throws InputError, UsageError (for an override) if it selects no vertex, with what there is to select
  Selection(const Mesh& mesh, const Adjacency& adjacency, std::span<const Vec3> points,
            std::string_view where, Place place);

  /// For every vertex whether it is selected; those of a group are the corners of its faces.
  [[nodiscard]] const std::vector<bool>& vertices() const { return vertices_; }
  /// Faces whose vertices are all selected; of a group or part exactly its faces. Ascending.
  [[nodiscard]] std::vector<FaceId> faces() const;
  /// Boundary halfedges whose ends are both selected; of a group or part those of its faces.
  /// Ascending.
  [[nodiscard]] std::vector<HalfedgeId> boundary_edges() const;

 private:
  void select_group(const std::vector<FaceGroup>& groups);
  void select_boundary();
  void select_vertex();
  void select_condition(std::span<const Vec3> points);
  [[noreturn]] void fail(const std::string& what) const;
  [[nodiscard]] bool used(std::size_t vertex) const;

  const Mesh* mesh_;
  const Adjacency* adjacency_;
  Where where_;
  Place place_;
  std::vector<bool> vertices_;
  std::vector<bool> faces_;  // only for groups and parts
};

}  // namespace limes
