#pragma once

namespace throng::anim {

/// Returns on how many cores this process may run, at least 1: those of the machine, or fewer where somebody pinned it
/// to some of them (`taskset`, a container).
int usable_cores();

}  // namespace throng::anim
