#pragma once

#include "limes/study/shell_model.h"

namespace limes {

/// Sum of the problem's loads, one entry per unknown of the shell.
/// @throws InputError for selections that meet nothing, and for moments about the director of a
///         smooth node, which no shell carries
[[nodiscard]] VectorX assemble_shell_loads(const ShellModel& model);

}  // namespace limes
