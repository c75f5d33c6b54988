#pragma once

#include <CLI/CLI.hpp>

#include <string>

namespace limes::app {

/// "0.1.0"
[[nodiscard]] std::string version();

/// Name, version, help layout of the program; call before commands are added.
void set_up_program(CLI::App& program);
/// What all commands have alike; call after commands are added.
void set_up_commands(CLI::App& program);

/// Help of the command that was asked for, or of the program.
[[nodiscard]] std::string help_text(const CLI::App& program);

/// A usage error as one sentence, with the nearest known name for a misspelt one.
[[nodiscard]] std::string usage_message(const CLI::App& program, const CLI::ParseError& error);

}  // namespace limes::app
