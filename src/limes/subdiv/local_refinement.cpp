#include "limes/subdiv/local_refinement.h"

namespace limes {

std::vector<FaceId> LocalRefinement::leaves() const {
  std::vector<FaceId> all, open;
  for (int root = 0; root < control().topology.num_faces(); ++root) {
    open.push_back(FaceId(root));
    while (!open.empty()) {
      const FaceId f = open.back();
      open.pop_back();
      const Children below = children(f);
      if (below.count == 0) all.push_back(f);
      for (int i = below.count - 1; i >= 0; --i)
        open.push_back(FaceId(below.first.value + i));
    }
  }
  return all;
}

}  // namespace limes
