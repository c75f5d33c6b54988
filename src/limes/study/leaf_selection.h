#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "limes/mesh/measure.h"
#include "limes/problem/condition.h"
#include "limes/problem/selection.h"
#include "limes/subdiv/local_refinement.h"

namespace limes {

/// A `where` that means faces: "all", "group:NAME", "part:NAME" or a condition.
/// @throws InputError if the text is none of these, without the place in a file
[[nodiscard]] Where parse_face_where(std::string_view text);

/// The leaves of a forest that a `where` means: all of them, those on the faces of a group or part of
/// the control mesh, or those with a condition true at all corners, which lie on the limit
/// surface. == means within 1e-9 of the diagonal of the control mesh's vertices there.
class LeafSelection {
 public:
  /// @param where  as parse_face_where()
  /// @throws InputError as parse_face_where(), or if it means no leaf of the forest
  LeafSelection(const LocalRefinement& forest, std::string_view where);

  /// Whether it is all of them, in any forest.
  [[nodiscard]] bool means_all() const { return where_.kind == Where::Kind::all; }
  /// In the order of forest.leaves(); none is a possible answer. A vertex is tested once, so one
  /// selection belongs to one forest.
  /// @throws InputError where the condition is neither true nor false
  [[nodiscard]] std::vector<FaceId> leaves(const LocalRefinement& forest);

 private:
  [[nodiscard]] bool holds_at(const LocalRefinement& forest, VertexId v);
  [[noreturn]] void fail(const LocalRefinement& forest) const;

  Where where_;
  Bounds box_;               // of the control mesh's vertices on the limit surface
  std::vector<bool> roots_;  // of groups and parts: by control face
  std::optional<Condition> condition_;
  IdArray<VertexId, char> holds_;  // of conditions: 1, 0, or untested
};

}  // namespace limes
