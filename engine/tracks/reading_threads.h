#pragma once

#include <algorithm>
#include <cstddef>

#include "engine/base/files/cores.h"

namespace throng {

/// Returns into how many parts a file is read at once: one for each core, at most four.
inline std::size_t reading_threads() { return static_cast<std::size_t>(std::clamp(usable_cores(), 1, 4)); }

/// Work on fewer rows is over before a thread has begun.
inline constexpr std::size_t rows_worth_a_thread = 20'000;

}  // namespace throng
