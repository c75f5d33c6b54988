#pragma once

#include <span>
#include <vector>

#include "limes/core/ids.h"

namespace limes {

/// Which vertices every face has, in order: nothing else, and never changed once built.
/// Corner i of a face and the side from corner i to corner i + 1 share one index, a HalfedgeId.
/// Adjacency (twins, edges, rings) is a separate value, see adjacency.h.
class Topology {
 public:
  Topology() = default;

  /// All faces have face_size corners; corners.size() is a multiple of face_size.
  Topology(int num_vertices, int face_size, std::vector<VertexId> corners);

  /// Faces of any size >= 1: face f has the corners [offsets[f], offsets[f + 1]).
  /// offsets has num_faces + 1 entries and starts with 0.
  Topology(int num_vertices, std::vector<int> offsets, std::vector<VertexId> corners);

  [[nodiscard]] int num_vertices() const { return num_vertices_; }
  [[nodiscard]] int num_faces() const { return num_faces_; }
  [[nodiscard]] int num_corners() const { return static_cast<int>(corners_.size()); }

  /// The common number of corners, or 0 when faces differ.
  [[nodiscard]] int uniform_face_size() const { return face_size_; }
  [[nodiscard]] int face_size(FaceId f) const {
    return face_size_ ? face_size_ : offset(f.value + 1) - offset(f.value);
  }
  [[nodiscard]] std::span<const VertexId> face(FaceId f) const {
    return {corners_.data() + first(f), static_cast<std::size_t>(face_size(f))};
  }
  /// Halfedge at corner i of face f, 0 <= i < face_size(f).
  [[nodiscard]] HalfedgeId halfedge(FaceId f, int i) const { return HalfedgeId(first(f) + i); }
  [[nodiscard]] VertexId corner(HalfedgeId h) const {
    return corners_[static_cast<std::size_t>(h.value)];
  }
  [[nodiscard]] std::span<const VertexId> corners() const { return corners_; }
  /// Face of a halfedge; O(log num_faces) where faces differ in size (Adjacency::face is not).
  [[nodiscard]] FaceId face_of(HalfedgeId h) const;
  /// Next halfedge around the face of h; the same cost.
  [[nodiscard]] HalfedgeId next(HalfedgeId h) const;

  friend bool operator==(const Topology&, const Topology&) = default;

 private:
  [[nodiscard]] int offset(int f) const { return offsets_[static_cast<std::size_t>(f)]; }
  [[nodiscard]] int first(FaceId f) const {
    return face_size_ ? f.value * face_size_ : offset(f.value);
  }

  int num_vertices_ = 0;
  int num_faces_ = 0;
  int face_size_ = 0;
  std::vector<int> offsets_;  // empty when all faces have the same size
  std::vector<VertexId> corners_;
};

}  // namespace limes
