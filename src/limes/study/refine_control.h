#pragma once

#include "limes/problem/problem.h"
#include "limes/subdiv/refine.h"

namespace limes {

/// refine() by the problem's scheme, as often as `options` say.
/// @throws InputError, UsageError (an override of the scheme) that names the mesh's file, and the line of a
///         face that the scheme does not take
[[nodiscard]] Mesh refine_control(const Problem& problem, const Mesh& control,
                                  const RefineOptions& options);

}  // namespace limes
