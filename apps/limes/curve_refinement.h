#pragma once

#include "options.h"
#include "run.h"

namespace limes::app {

/// What 'limes refine' does with a curve scheme: OBJ polylines to OBJ polylines.
struct CurveRefinement {
  std::filesystem::path input, output;
  SchemeOptions scheme;
  int levels;
};
/// @throws UsageError for options and file types that curves do not have, InputError, OutputError
void refine_curves(const CurveRefinement& work, const RunOptions& options, const Run& run);

}  // namespace limes::app
