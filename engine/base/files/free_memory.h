#pragma once

#include <cstdint>

namespace throng {

/// Returns the bytes of memory that this process may still take: what the machine, its container and the limit of its
/// address space (ulimit -v) have left, or the largest number where the system does not say.
std::uint64_t free_memory();

/// Returns the bytes of address space that this process may still reserve (ulimit -v), or the largest number where
/// there is no limit. Memory that is reserved and never touched counts too.
std::uint64_t free_address_space();

/// Returns whether there is such a limit. It takes no memory.
bool address_space_has_a_limit();

}  // namespace throng
