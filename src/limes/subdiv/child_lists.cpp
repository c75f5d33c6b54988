#include "limes/subdiv/child_lists.h"

#include <algorithm>

namespace limes {

ChildLists::ChildLists(const std::vector<FaceId>& parents, int num_parents)
    : children_(parents.size()), first_(static_cast<std::size_t>(num_parents) + 1, 0) {
  for (const FaceId parent : parents)
    ++first_[static_cast<std::size_t>(parent.value) + 1];
  for (std::size_t f = 1; f < first_.size(); ++f)
    first_[f] += first_[f - 1];
  std::vector<int> next(first_.begin(), first_.end() - 1);
  for (std::size_t child = 0; child < parents.size(); ++child) {
    int& at = next[static_cast<std::size_t>(parents[child].value)];
    children_[static_cast<std::size_t>(at++)] = FaceId(static_cast<std::int64_t>(child));
  }
}

std::vector<FaceId> ChildLists::of(const std::vector<FaceId>& faces) const {
  std::vector<FaceId> all;
  for (const FaceId f : faces)
    all.insert(all.end(), children_.begin() + first_[static_cast<std::size_t>(f.value)],
               children_.begin() + first_[static_cast<std::size_t>(f.value) + 1]);
  std::sort(all.begin(), all.end());
  return all;
}

std::vector<FaceGroup> ChildLists::of(const std::vector<FaceGroup>& groups) const {
  std::vector<FaceGroup> all;
  for (const FaceGroup& g : groups)
    all.push_back({g.name, of(g.faces)});
  return all;
}

}  // namespace limes
