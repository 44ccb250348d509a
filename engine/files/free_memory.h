#pragma once

#include <cstdint>

namespace throng {

/// Returns the bytes of memory that this process may still take: what the machine, its container and the limit of its
/// address space (ulimit -v) have left, or all that there could be where nobody says.
std::uint64_t free_memory();

/// Returns the bytes of address space that this process may still reserve (ulimit -v), or all that there could be where
/// there is no limit. Memory that is reserved and never touched takes of it too.
std::uint64_t free_address_space();

/// Returns whether there is such a limit. It takes no memory.
bool address_space_has_a_limit();

}  // namespace throng
