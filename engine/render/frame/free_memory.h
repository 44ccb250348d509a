#pragma once

#include <cstdint>

namespace throng::render {

/// Gives the bytes of memory that the machine has left for this process, or all that there could be where nobody says.
std::uint64_t free_memory();

}  // namespace throng::render
