// limes: subdivision surfaces on the command line. This file parses, calls one command and turns
// what it throws into an exit code; the contract is docs/command-line.md.

#include <fmt/format.h>

#include <csignal>
#include <new>
#include <string>

#include "commands.h"
#include "exit_code.h"
#include "help.h"
#include "limes/core/error.h"
#include "limes/core/interrupt.h"
#include "memory.h"
#include "terminal.h"

namespace {

using namespace limes;

using namespace limes::app;

extern "C" void on_signal(int) {
  request_interrupt();
}

/// The first signal asks the work to stop; a second one ends the process at once.
void install_signal_handlers() {
  struct sigaction action {};
  action.sa_handler = on_signal;
  action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  struct sigaction hangup {};
  sigaction(SIGHUP, nullptr, &hangup);
  if (hangup.sa_handler != SIG_IGN) sigaction(SIGHUP, &action, nullptr);  // 'nohup' ignores it
  // A closed pipe and a file at its largest size are write errors like any other.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
}

int fail(ExitCode code, std::string_view message) {
  app::remark(fmt::format("limes: {}", message));
  return code;
}

int run(int argc, char** argv) {
  CLI::App program;
  app::set_up_program(program);
#define LIMES_ADD_COMMAND(name) app::add_##name(program);
  LIMES_COMMANDS(LIMES_ADD_COMMAND)
#undef LIMES_ADD_COMMAND
  app::set_up_commands(program);
  try {
    program.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    app::print(app::help_text(program));
  } catch (const CLI::CallForVersion& version) {
    app::print(fmt::format("{}\n", version.what()));
  } catch (const CLI::ParseError& error) {
    return fail(wrong_usage, app::usage_message(program, error));
  }
  return done;
}

}  // namespace

int main(int argc, char** argv) {
  install_signal_handlers();
  try {
    return run(argc, argv);
  } catch (const UsageError& error) {
    return fail(wrong_usage, error.what());
  } catch (const InputError& error) {
    return fail(bad_input, error.what());
  } catch (const SolverError& error) {
    return fail(not_converged, error.what());
  } catch (const OutputError& error) {
    return fail(cannot_write, error.what());
  } catch (const Interrupted& error) {
    if (const std::string stopped = app::memory_limit_message(); !stopped.empty())
      return fail(bad_input, stopped);
    return fail(interrupted, error.what());
  } catch (const std::bad_alloc&) {
    return fail(bad_input,
                "out of memory; a smaller mesh, fewer levels or a higher --memory-limit");
  } catch (const std::exception& error) {
    return fail(internal_error, fmt::format("internal error: {}", error.what()));
  }
}
