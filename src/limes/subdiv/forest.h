#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "limes/mesh/mesh.h"
#include "limes/subdiv/forest_nodes.h"
#include "limes/subdiv/placement.h"
#include "limes/subdiv/refine.h"

namespace limes {

/// Where a face of a forest comes from: the control face, and which child was taken on each level, as
/// digits to the base of 4, the first one highest.
struct FaceAncestry {
  FaceId root;
  int level;
  std::int64_t path;
  friend bool operator==(const FaceAncestry&, const FaceAncestry&) = default;
};

/// Which faces are split together.
enum class SplitUnit {
  families,  ///< below the control faces, four siblings: what an all-quad closure needs
  faces      ///< each alone
};

/// A quad mesh refined in places: a quadtree on every control face [kobbelt_1996]. A face is split
/// like in uniform refinement, children in its order, and its vertices lie where uniform refinement
/// puts them, bitwise with interpolatory schemes; other schemes place vertices at their limits.
///
/// The forest is balanced: leaves that share a vertex differ by at most one level; a face is split
/// only where all faces around its corners exist on its level, and those are exactly what its new
/// vertices depend on. So asking for one split may cause others.
///
/// A mutable value; copies are independent. Faces and vertices have ids of the forest's own, which
/// stay valid: what coarsening removes is found again by the next refinement. What a step costs
/// depends on what it changes, not on the size of the forest.
class Forest {
 public:
  static constexpr int max_level = 26;  ///< paths are exact in a double, sides 1.5e-8 of a root's

  /// @param limits  for schemes that are not interpolatory, see limit/forest_limits.h
  /// @param placement  with interpolatory schemes; of the vertices that splits add, those of the control mesh stay
  /// @throws InputError if a face is no quad, for BoundaryRule::none, or as refine(); UsageError if the scheme splits
  ///         otherwise
  Forest(const Mesh& control, const Scheme& scheme, const RefineOptions& options,
         SplitUnit unit = SplitUnit::families, LimitsOf limits = {}, Placement placement = {});

  /// Splits leaves, and others as balance asks.
  /// @return number of faces split. Leaves that were split meanwhile count once.
  /// @throws InputError beyond max_level; the forest is unchanged then. Interrupted, between levels; it is
  ///         balanced then
  int refine(std::span<const FaceId> leaves);

  /// Takes back splits all of whose children are marked leaves, where balance allows it.
  /// @return number of splits taken back
  int coarsen(std::span<const FaceId> leaves);

  /// All leaves: trees in order of the control faces, children in order.
  [[nodiscard]] std::vector<FaceId> leaves() const;
  [[nodiscard]] const Mesh& control() const { return root_->mesh; }
  [[nodiscard]] const Adjacency& control_adjacency() const { return root_->adjacency; }
  [[nodiscard]] SplitUnit unit() const { return unit_; }
  [[nodiscard]] const ForestNodes& nodes() const { return nodes_; }

  [[nodiscard]] FaceAncestry ancestry(FaceId f) const;
  [[nodiscard]] const QuadCorners& corners(FaceId f) const { return face(f).corners; }
  [[nodiscard]] bool is_split(FaceId f) const { return face(f).split; }
  [[nodiscard]] FaceId parent(FaceId f) const { return face(f).parent; }
  /// Of a split face; child i lies at corner i.
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
  struct Root {
    explicit Root(const Mesh& control) : mesh(control), adjacency(mesh.topology) {}
    Mesh mesh;
    Adjacency adjacency;
  };
  struct Face {
    QuadCorners corners;
    std::int64_t path = 0;
    FaceId root, parent;
    FaceId first_child = {};  // invalid: never made
    int level = 0;
    bool split = false;
  };
  using Levels = std::vector<std::vector<FaceId>>;

  [[nodiscard]] const Face& face(FaceId f) const { return faces_[f]; }
  [[nodiscard]] bool exists(FaceId f) const {
    return !face(f).parent.valid() || face(face(f).parent).split;
  }
  [[nodiscard]] bool before(FaceId a, FaceId b) const;
  /// Faces that were made, whether they exist now or not.
  template <class Visit>
  void for_each_made_at(int level, VertexId v, const Visit& visit) const;
  void request(FaceId f, Levels& wanted, std::unordered_set<std::int32_t>& seen) const;
  void request_around(FaceId f, Levels& wanted, std::unordered_set<std::int32_t>& seen) const;
  [[nodiscard]] std::vector<FaceId> family(FaceId f) const;
  void add_neighbours(std::vector<FaceId>& patch) const;
  void sort_unique(std::vector<FaceId>& faces) const;
  [[nodiscard]] bool touches_curve(FaceId f) const;
  [[nodiscard]] std::vector<FaceId> parents_around(std::span<const FaceId> faces) const;
  [[nodiscard]] std::vector<FaceId> patch_around(std::span<const FaceId> faces) const;
  void make_children(std::vector<FaceId> faces);
  void place(std::span<const FaceId> faces, std::span<const ChildNodes> made, int num_before);
  [[nodiscard]] bool can_merge(FaceId f) const;

  std::shared_ptr<const Root> root_;
  SplitUnit unit_;
  ForestNodes nodes_;
  Placement placement_;
  IdArray<FaceId, Face> faces_;    // the control faces first, then children by fours
  std::vector<int> root_offsets_;  // faces of the control mesh by vertex
  std::vector<FaceId> root_faces_;
  std::unordered_map<std::uint64_t, std::vector<FaceId>> faces_at_;  // by level >= 1 and vertex
};

}  // namespace limes
