#pragma once

namespace throng {

/// Returns on how many cores this process may run, at least 1: all cores of the machine, or fewer where the process is
/// pinned (`taskset`, a container).
int usable_cores();

}  // namespace throng
