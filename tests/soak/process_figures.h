#pragma once

#include <cstdint>

#include <sys/types.h>

namespace throng::soak {

/// Counts what a process takes of the system.
struct ProcessFigures {
  std::uint64_t resident = 0;  ///< bytes in memory
  int descriptors = 0;         ///< open files, sockets and the like
  int threads = 0;
  double computed = 0;  ///< seconds that its threads have run, which a busy machine does not stretch
};

/// Returns the figures of a process of ours; zeros once it has ended.
ProcessFigures figures_of(pid_t process);

/// Returns the bytes that this process has on its heap, and gives back to the system what the heap does not use.
std::uint64_t heap_in_use();

}  // namespace throng::soak
