#include "limes/subdiv/split_leaves.h"

namespace limes {

Forest split_leaves(Forest forest, int levels) {
  for (int level = 0; level < levels; ++level)
    forest.refine(forest.leaves());
  return forest;
}

}  // namespace limes
