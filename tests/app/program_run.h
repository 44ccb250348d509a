#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <sys/types.h>

namespace throng::app {

/// The output of the real program, and its end.
struct ProgramRun {
  int exit_status = -1;  ///< 128 and more: a signal
  std::string output;
  std::string errors;
};

/// Says how the program is run, and what is done to it meanwhile.
struct ProgramTreatment {
  std::string output = {};                    ///< a file in place of the one that ProgramRun::output is read from
  std::string input = {};                     ///< a file that it reads as standard input; empty: what we have
  std::function<void(pid_t)> meanwhile = {};  ///< is called with its number once it runs
  std::uint64_t address_space = 0;            ///< bytes; 0: no limit, which the sanitizers need
  std::vector<std::size_t> cores = {};        ///< those that it may run on; empty: all
  unsigned seconds = 0;                       ///< after these SIGALRM ends it; 0: no limit
  std::string program = {};                   ///< one in place of `throng`
  std::string folder = {};                    ///< where it works; empty: where we do
  std::vector<std::string> environment = {};  ///< "NAME=VALUE", beside what this process has
};

/// Returns whether a child has ended, which run_program() still waits for.
bool has_ended(pid_t child);

/// Returns what sends a signal to the program: at once, or when a file has bytes. PID in its name is the program's
/// number.
std::function<void(pid_t)> send(int signal, const std::string& once_written = {});

/// Runs `throng` without a display, with `arguments`, and waits for its end. It ends with us; ctest limits the time. A
/// program that cannot be run has the exit status 127.
ProgramRun run_program(const std::vector<std::string>& arguments, const ProgramTreatment& treatment = {});

}  // namespace throng::app
