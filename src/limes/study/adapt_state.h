#pragma once

#include "limes/adapt/loop.h"
#include "limes/problem/problem.h"

namespace limes {

/// If [adapt] has a state file: lets the loop keep there, after each step, the figures of the finished
/// steps and the leaves of the next mesh; with `resume` starts with what is there, which leads to the
/// same results as a run without a break. The file may come from a run with other targets, as long as
/// these would not have ended it before.
/// @param forest  as the loop starts; refined to the leaves of the file
/// @throws InputError for a file that is missing, damaged, of another problem or mesh, or beyond a
///         target; OutputError if it cannot be written, also later
void keep_state(const Problem& problem, Forest& forest, AdaptTargets& targets);

}  // namespace limes
