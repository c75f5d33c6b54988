#pragma once

namespace limes::app {

/// What the program returns; the contract is docs/command-line.md.
enum ExitCode {
  done = 0,
  internal_error = 1,
  wrong_usage = 2,
  bad_input = 3,
  not_converged = 4,
  cannot_write = 5,
  interrupted = 130
};

}  // namespace limes::app
