#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

#include "limes/mesh/adjacency.h"
#include "limes/subdiv/edge_sharpness.h"
#include "limes/subdiv/leaf_mesh.h"
#include "limes/subdiv/local_refinement.h"

namespace limes {

/// A mesh of polygons refined in places by bisection of the 4-8 family, newest vertex bisection: a tree on
/// every control face. The first split puts a vertex into the face and makes a triangle of it and each
/// side; every other halves a triangle across the side opposite its newest vertex, together with the
/// triangle beyond, so that no vertex ever hangs. Children come in the order of the scheme
/// four-eight, and all leaves of a level are what it makes of the control mesh. Nothing moves: new
/// vertices lie in the middle of their sides or faces, as with `linear`.
///
/// The triangle beyond the side has it as the side that it is halved across, too, or is one level
/// coarser and has a child for which that holds. So a split of a triangle of level k takes one more
/// triangle with it and may ask first for one of level k - 1: at most 2 k triangles and one control
/// face are split [mitchell_1991]. Since all sides of control faces are split first, the number of splits
/// over any number of steps is at most a constant times that of the leaves asked for
/// [binev_dahmen_devore_2004].
///
/// A mutable value; copies are independent. What coarsening removes is found again by the next
/// refinement. What a step costs depends on what it changes.
class BisectionForest final : public LocalRefinement {
 public:
  static constexpr int max_level = 40;  ///< two levels halve a side, so that is a millionth

  /// @throws InputError if the mesh is no surface, or its creases have the method chaikin
  explicit BisectionForest(const Mesh& control);

  int refine(std::span<const FaceId> leaves) override;
  /// A vertex goes if all leaves around it are marked.
  int coarsen(std::span<const FaceId> leaves) override;

  [[nodiscard]] const Mesh& control() const override { return root_->mesh; }
  [[nodiscard]] Children children(FaceId f) const override {
    return faces_[f].split ? Children{faces_[f].first_child, num_children(f)} : Children{};
  }
  [[nodiscard]] FaceAncestry ancestry(FaceId f) const override;
  /// Of triangles the newest vertex first.
  [[nodiscard]] std::span<const VertexId> corners(FaceId f) const override;
  [[nodiscard]] bool is_split(FaceId f) const { return faces_[f].split; }

  [[nodiscard]] int num_vertices() const override { return positions_.size(); }
  [[nodiscard]] const Vec3& position(VertexId v) const override { return positions_[v]; }
  [[nodiscard]] float edge_sharpness(VertexId a, VertexId b) const override {
    return sharp_edges_.of(a, b);
  }
  [[nodiscard]] float vertex_sharpness(int level, VertexId v) const override;

 private:
  struct Face {
    std::array<VertexId, 3> corners;  // of control faces invalid
    std::int64_t path = 0;
    FaceId root, parent;
    FaceId first_child = {};  // invalid: never made
    FaceId mate = {};         // made children together with this one
    int level = 0;
    bool split = false;
  };

  [[nodiscard]] int num_children(FaceId f) const;
  [[nodiscard]] int child_index(FaceId f) const {
    return f.value - faces_[faces_[f].parent].first_child.value;
  }
  [[nodiscard]] FaceId child(FaceId f, int i) const {
    return FaceId(faces_[f].first_child.value + i);
  }
  /// A triangle of the level before and which of its children lies beyond the side that f is halved across.
  struct Beyond {
    FaceId parent;  // invalid: the boundary
    int child = 0;
  };
  [[nodiscard]] Beyond beyond(FaceId f) const;
  void split(FaceId f, int& count);
  void split_control_face(FaceId f);
  void make_children(FaceId f, FaceId mate);
  void add_triangle(FaceId parent, int index, const std::array<VertexId, 3>& corners);
  [[nodiscard]] bool all_marked(FaceId parent, const std::vector<FaceId>& marked) const;

  std::shared_ptr<const ControlMesh> root_;
  IdArray<FaceId, Face> faces_;  // the control faces first
  IdArray<VertexId, Vec3> positions_;
  EdgeSharpness sharp_edges_;
  std::unordered_map<std::int32_t, float> sharp_vertices_;  // of the control mesh
};

/// The leaves as a mesh, as they are: nothing has to be closed.
[[nodiscard]] ForestMesh forest_mesh(const BisectionForest& forest);

}  // namespace limes
