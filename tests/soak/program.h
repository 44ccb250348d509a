#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tests/soak/process_figures.h"

namespace throng::soak {

/// The end of a run of the real program, and its figures while it ran.
struct ProgramRun {
  int status = 0;                       ///< 128 and more: a signal
  bool hung = false;                    ///< it had to be killed
  std::string output, errors;           ///< standard output and standard error
  std::vector<ProcessFigures> figures;  ///< one each tenth of a second
};

/// How long a run may take.
struct ProgramTime {
  double until_interrupt = 0;  ///< seconds of computing; then SIGINT asks it to end; 0: never
  double until_killed = 300;   ///< seconds; then it hangs, on a machine that does much else
};

/// Runs `throng` with these words, without a display, working in `folder`, and waits for its end.
ProgramRun run_program(const std::vector<std::string>& words, const std::filesystem::path& folder,
                       const ProgramTime& time = {});

/// Returns the words as a shell takes them, after the program's name.
std::string as_command(const std::vector<std::string>& words);

}  // namespace throng::soak
