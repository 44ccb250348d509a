#pragma once

#include <string>
#include <vector>

namespace throng::app {

/// The output of the real program, and its end.
struct ProgramRun {
  int exit_status = -1;  ///< 128 and more: a signal
  std::string output;
  std::string errors;
};

/// Runs `throng` without a display, with `arguments`, and waits for its end. ctest limits the time.
ProgramRun run_program(const std::vector<std::string>& arguments);

}  // namespace throng::app
