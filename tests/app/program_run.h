#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace throng::app {

/// The output of the real program, and its end.
struct ProgramRun {
  int exit_status = -1;  ///< 128 and more: a signal
  std::string output;
  std::string errors;
};

/// Whether the program can live within a limit of its addresses: the sanitizers take terabytes of them.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool addresses_have_limits = false;
#else
inline constexpr bool addresses_have_limits = true;
#endif

/// Says how the program is run, and what is done to it meanwhile.
struct ProgramTreatment {
  std::string output = {};              ///< a file in place of the one that ProgramRun::output is read from
  int signal = 0;                       ///< 0: none
  std::string once_written = {};        ///< the signal is sent when this file has bytes; PID: the program's number
  std::uint64_t address_space = 0;      ///< bytes; 0: no limit, as where !addresses_have_limits
  std::vector<std::size_t> cores = {};  ///< those that it may run on; empty: all
  unsigned seconds = 0;                 ///< after these SIGALRM ends it; 0: no limit
  std::string program = {};             ///< one in place of `throng`
  std::vector<std::string> environment = {};  ///< "NAME=VALUE", beside what this process has
};

/// Runs `throng` without a display, with `arguments`, and waits for its end. ctest limits the time.
ProgramRun run_program(const std::vector<std::string>& arguments, const ProgramTreatment& treatment = {});

}  // namespace throng::app
