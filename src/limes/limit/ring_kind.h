#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "limes/core/types.h"
#include "limes/limit/regular_patch.h"
#include "limes/subdiv/scheme.h"

namespace limes {

/// Everything about the limit of a face that depends only on what its ring looks like (valences,
/// boundary, sharpness), not on where the control points are. See docs/theory/limit.md.
struct RingKind {
  Ring ring;
  std::optional<PatchGrid> patch;  ///< set: the limit is this one polynomial

  /// Otherwise: after one step of the scheme, child i (at corner i, its own corner 0 there) is of
  /// the kind children[i].kind, and its controls are A times ours.
  struct Child {
    int kind;
    SparseMatrix A;  ///< (num_controls of the child's kind, num_controls)
  };
  std::vector<Child> children;

  /// Child 0 is of this kind again: corner 0 is an extraordinary vertex or feature that stays.
  /// Then limit is the position of that vertex and tangents, if they exist, span its tangent plane
  /// with the normal t0 x t1.
  bool self_similar = false;
  VectorX limit;
  std::optional<Eigen::Matrix<double, 2, Eigen::Dynamic>> tangents;
};

/// B-spline control points of a sub-face reached by a path of children, as functions of the ring's
/// controls: point k = D.row(k) + limit, where D is relative to the limit position of the
/// extraordinary vertex on the path (rows sum to zero), or limit is empty and D is all. Kept apart
/// because D shrinks with the path's length while limit does not: derivatives need the small part
/// alone.
struct Tile {
  PatchGrid D;
  VectorX limit;
};

/// The kinds of one mesh or family of meshes, found by key and built once.
/// tile() may be called from several threads; kind_of() may not.
class RingKinds {
 public:
  explicit RingKinds(const Scheme& scheme) : scheme_(&scheme) {}

  /// Index of the kind of a ring; builds it and all kinds below it if it is new.
  int kind_of(Ring ring);
  [[nodiscard]] const RingKind& operator[](int kind) const {
    return *kinds_[static_cast<std::size_t>(kind)];
  }
  [[nodiscard]] int size() const { return static_cast<int>(kinds_.size()); }
  [[nodiscard]] const Scheme& scheme() const { return *scheme_; }

  /// The patch at the end of a path from a kind: child indices, one byte each. Precondition: the
  /// path ends where kinds have a patch.
  [[nodiscard]] const Tile& tile(int kind, const std::string& path) const;

 private:
  void build_children(RingKind& kind, int index);
  void build_corner(RingKind& kind);
  [[nodiscard]] Tile make_tile(int kind, const std::string& path) const;
  [[nodiscard]] const Tile& tile_locked(int kind, const std::string& path) const;

  const Scheme* scheme_;
  std::map<std::string, int> index_;
  std::vector<std::unique_ptr<RingKind>> kinds_;

  using Tiles = std::unordered_map<std::string, std::unique_ptr<Tile>>;  // never iterated
  mutable std::mutex mutex_;
  mutable std::vector<Tiles> tiles_;
};

}  // namespace limes
