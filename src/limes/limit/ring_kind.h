#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "limes/core/types.h"
#include "limes/limit/append_only.h"
#include "limes/limit/regular_patch.h"
#include "limes/subdiv/scheme.h"

namespace limes {

/// Everything about the limit of a face that depends only on what its ring looks like (valences,
/// boundary, sharpness), not on where the control points are. See docs/theory/limit.md.
struct RingKind {
  Ring ring;
  std::optional<PatchGrid> patch;  ///< set: the limit is this one polynomial
};

/// A kind without a patch after one step of the scheme.
struct RefinedKind {
  /// Child i (at corner i, its own corner 0 there) is of the kind children[i].kind, and its
  /// controls are A times ours. A triangle's last child is the one in the middle, whose corner 0 is
  /// the middle of side 0.
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

/// Control points of the patch of a sub-face reached by a path of children, as functions of the ring's
/// controls: point k = D.row(k) + limit, where rows of D sum to zero. limit is the limit position of
/// the extraordinary vertex on the path, or the first control point of the sub-face. Kept apart
/// because D shrinks with the path's length while limit does not: derivatives need the small part
/// alone.
struct Tile {
  PatchGrid D;
  VectorX limit;
};

/// The kinds of one mesh or family of meshes, found by key and built once, each when it is first
/// asked for. All functions may be called from several threads.
class RingKinds {
 public:
  explicit RingKinds(const Scheme& scheme) : scheme_(&scheme) {}

  /// Index of the kind of a ring. Indices of kinds that several threads add at the same time come
  /// in any order.
  int kind_of(Ring ring) const;
  [[nodiscard]] const RingKind& operator[](int kind) const { return entry(kind).kind; }
  /// Number of kinds met so far.
  [[nodiscard]] int size() const;
  [[nodiscard]] const Scheme& scheme() const { return *scheme_; }

  /// The children of a kind and what follows from them. Precondition: it has no patch.
  [[nodiscard]] const RefinedKind& refined(int kind) const {
    const RefinedKind* known = entry(kind).refined.load(std::memory_order_acquire);
    return known ? *known : refine(kind);
  }

  /// The patch at the end of a path from a kind: child indices, one byte each. Precondition: the
  /// path ends where kinds have a patch.
  [[nodiscard]] const Tile& tile(int kind, const std::string& path) const;

 private:
  struct Entry {
    RingKind kind;
    std::atomic<const RefinedKind*> refined = nullptr;
    std::unique_ptr<const RefinedKind> owned;
    std::unordered_map<std::string, std::unique_ptr<Tile>> tiles;  // never iterated
  };
  [[nodiscard]] Entry& entry(int kind) const { return entries_[static_cast<std::size_t>(kind)]; }
  const RefinedKind& refine(int kind) const;
  [[nodiscard]] RefinedKind build_refined(int kind) const;
  [[nodiscard]] Tile make_tile(int kind, const std::string& path) const;
  [[nodiscard]] const Tile& tile_locked(int kind, const std::string& path) const;

  const Scheme* scheme_;
  mutable std::mutex mutex_;                            // of index_ and of the size of entries_
  mutable std::unordered_map<std::string, int> index_;  // never iterated
  mutable AppendOnly<Entry> entries_;
  mutable std::mutex tile_mutex_;  // of Entry::tiles
};

}  // namespace limes
