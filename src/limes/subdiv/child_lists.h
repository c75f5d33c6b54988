#pragma once

#include <vector>

#include "limes/mesh/mesh.h"

namespace limes {

/// Faces of a refined mesh by the face they come from.
class ChildLists {
 public:
  /// @param parents  of each refined face, in [0, num_parents)
  ChildLists(const std::vector<FaceId>& parents, int num_parents);

  /// The children of some faces, ascending.
  [[nodiscard]] std::vector<FaceId> of(const std::vector<FaceId>& faces) const;
  [[nodiscard]] std::vector<FaceGroup> of(const std::vector<FaceGroup>& groups) const;

 private:
  std::vector<FaceId> children_;  // sorted by parent
  std::vector<int> first_;        // of each parent in children_
};

}  // namespace limes
