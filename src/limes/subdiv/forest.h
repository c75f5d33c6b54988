#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "limes/core/error.h"
#include "limes/mesh/mesh.h"
#include "limes/subdiv/forest_nodes.h"
#include "limes/subdiv/local_refinement.h"
#include "limes/subdiv/placement.h"
#include "limes/subdiv/refine.h"

namespace limes {

/// Which quads are split together; triangles are split each alone.
enum class SplitUnit {
  families,  ///< below the control faces, four siblings: what a closure by quads needs
  faces      ///< each alone
};

/// The scheme that refines a mesh in places: the one given, and for `linear` on triangles one that
/// splits each into four (linear_triangles()).
/// @throws UsageError if the scheme does not split faces into four; InputError if it does not fit a face
[[nodiscard]] const Scheme& forest_scheme(const Scheme& scheme, const Topology& control);

/// A mesh of quads or of triangles refined in places: a quadtree on every control face
/// [kobbelt_1996]. A face is split like in uniform refinement, children in its order, and its vertices
/// lie where uniform refinement puts them, bitwise with interpolatory schemes; other schemes place
/// vertices at their limits.
///
/// The forest is balanced: leaves that share a vertex differ by at most one level; a face is split
/// only where all faces around its corners exist on its level, and those are exactly what its new
/// vertices depend on. So asking for one split may cause others.
///
/// A mutable value; copies are independent. What coarsening removes is found again by the next
/// refinement. What a step costs depends on what it changes, not on the size of the forest.
class Forest final : public LocalRefinement {
 public:
  static constexpr int max_level = 26;  ///< paths are exact in a double, sides 1.5e-8 of a root's

  /// @param limits  for schemes that are not interpolatory, see limit/forest_limits.h
  /// @param placement  with interpolatory schemes; of the vertices that splits add, those of the control mesh stay
  /// @throws as forest_scheme() and refine(); InputError for BoundaryRule::none
  Forest(const Mesh& control, const Scheme& scheme, const RefineOptions& options,
         SplitUnit unit = SplitUnit::families, LimitsOf limits = {}, Placement placement = {});

  int refine(std::span<const FaceId> leaves) override;
  int coarsen(std::span<const FaceId> leaves) override;

  [[nodiscard]] const Mesh& control() const override { return root_->mesh; }
  [[nodiscard]] const Adjacency& control_adjacency() const { return root_->adjacency; }
  [[nodiscard]] SplitUnit unit() const { return unit_; }
  [[nodiscard]] const ForestNodes& nodes() const { return nodes_; }
  [[nodiscard]] int num_vertices() const override { return nodes_.size(); }
  [[nodiscard]] const Vec3& position(VertexId v) const override { return nodes_.position(v); }
  [[nodiscard]] float edge_sharpness(VertexId a, VertexId b) const override {
    return nodes_.edge_sharpness(a, b);
  }
  [[nodiscard]] float vertex_sharpness(int level, VertexId v) const override {
    return nodes_.vertex_sharpness(level, v);
  }

  [[nodiscard]] FaceAncestry ancestry(FaceId f) const override;
  /// Corners of every face: 3 or 4.
  [[nodiscard]] int face_size() const { return size_; }
  [[nodiscard]] std::span<const VertexId> corners(FaceId f) const override {
    return std::span(face(f).corners).first(static_cast<std::size_t>(size_));
  }
  /// The same of a forest of quads.
  [[nodiscard]] const QuadCorners& quad(FaceId f) const {
    LIMES_ASSERT(size_ == 4);
    return face(f).corners;
  }
  [[nodiscard]] bool is_split(FaceId f) const { return face(f).split; }
  [[nodiscard]] Children children(FaceId f) const override {
    return face(f).split ? Children{face(f).first_child, 4} : Children{};
  }
  [[nodiscard]] FaceId parent(FaceId f) const { return face(f).parent; }
  /// Of a split face; child i lies at corner i, child 3 of a triangle in the middle.
  [[nodiscard]] FaceId child(FaceId f, int i) const {
    return FaceId(face(f).first_child.value + i);
  }
  /// Number among its siblings.
  [[nodiscard]] int child_index(FaceId f) const { return static_cast<int>(face(f).path & 3); }
  /// The side of the control face that a side of a face lies on; invalid inside the control face.
  [[nodiscard]] HalfedgeId control_side(FaceId f, int side) const;
  /// The faces of a level that meet in a vertex, split or not.
  [[nodiscard]] std::vector<FaceId> faces_at(int level, VertexId v) const;

  /// The vertices that a split of each of some faces adds, which need not be split.
  std::vector<ChildNodes> child_nodes(std::span<const FaceId> faces);

 private:
  Forest(std::shared_ptr<const ControlMesh> root, const Scheme& scheme,
         const RefineOptions& options, SplitUnit unit, LimitsOf limits, Placement placement);

  struct Face {
    FaceCorners corners;
    std::int64_t path = 0;
    FaceId root, parent;
    FaceId first_child = {};  // invalid: never made
    int level = 0;
    bool split = false;
    bool collected = false;  // by a Collection, while it lives
  };
  class Collection;
  using Levels = std::vector<std::vector<FaceId>>;

  [[nodiscard]] const Face& face(FaceId f) const { return faces_[f]; }
  [[nodiscard]] bool exists(FaceId f) const {
    return !face(f).parent.valid() || face(face(f).parent).split;
  }
  [[nodiscard]] bool before(FaceId a, FaceId b) const;
  /// Faces that were made, whether they exist now or not.
  template <class Visit>
  void for_each_made_at(int level, VertexId v, const Visit& visit) const;
  [[nodiscard]] std::vector<FaceId> requested(std::span<const FaceId> leaves);
  void request(FaceId f, Collection& wanted) const;
  void request_around(FaceId f, Collection& wanted) const;
  template <class Visit>
  void for_family(FaceId f, const Visit& visit) const;
  void sort(std::vector<FaceId>& faces) const;
  template <class Visit>
  void for_each_made_around_child(FaceId parent, int child, const Visit& visit) const;
  [[nodiscard]] bool touches_curve(FaceId f) const;
  [[nodiscard]] std::vector<FaceId> parents_around(std::span<const FaceId> faces);
  [[nodiscard]] std::vector<FaceId> patch_around(std::span<const FaceId> faces);
  void make_children(std::vector<FaceId> faces);
  void add_children(FaceId f, const ChildNodes& made);
  void place(std::span<const FaceId> faces, std::span<const ChildNodes> made, int num_before);
  [[nodiscard]] bool can_merge(FaceId f) const;

  std::shared_ptr<const ControlMesh> root_;
  int size_;
  SplitUnit unit_;
  ForestNodes nodes_;
  Placement placement_;
  IdArray<FaceId, Face> faces_;    // the control faces first, then children by fours
  std::vector<int> root_offsets_;  // faces of the control mesh by vertex
  std::vector<FaceId> root_faces_;
  // Of each vertex the child made last, and of each corner of a child the one made before, of any level.
  std::vector<FaceId> last_face_at_;
  std::vector<std::array<FaceId, 4>> face_before_;
};

}  // namespace limes
