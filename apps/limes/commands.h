#pragma once

#include <CLI/CLI.hpp>

namespace limes::app {

/// Every command, in the order of the help. A command NAME is one file, cmd_NAME.cpp, that defines
/// add_NAME(): it adds a subcommand with its options to the program and sets its callback. And one
/// line here.
#define LIMES_COMMANDS(X) \
  X(info)                 \
  X(refine)               \
  X(adapt)                \
  X(coarsen)              \
  X(limit)                \
  X(evaluate)             \
  X(spectrum)             \
  X(solve)                \
  X(study)                \
  X(schemes)              \
  X(formats)

#define LIMES_DECLARE_COMMAND(name) void add_##name(CLI::App& program);
LIMES_COMMANDS(LIMES_DECLARE_COMMAND)
#undef LIMES_DECLARE_COMMAND

}  // namespace limes::app
