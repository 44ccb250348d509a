#pragma once

#include <atomic>
#include <cstdint>

namespace throng::anim {

/// Sleeps for as long as a number is `is`. The system wakes the thread without a lock: by a futex, or as Windows does.
void sleep_while(const std::atomic<std::uint32_t>& number, std::uint32_t is);

/// Wakes the threads that sleep for this number, after it has changed.
void wake_sleepers(std::atomic<std::uint32_t>& number);

}  // namespace throng::anim
