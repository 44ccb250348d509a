#include "engine/anim/base/sleep.h"

#if defined(_WIN32)
#ifndef NOMINMAX
#define NOMINMAX
#endif
#include <windows.h>
#endif

namespace throng::anim {

// Where there is no futex, std::atomic::wait() of GCC 12 looks at the number before it locks, and misses a wake-up.
#if defined(_WIN32)

void sleep_while(const std::atomic<std::uint32_t>& number, std::uint32_t is) {
  static_assert(sizeof(number) == sizeof(is));
  auto* const address = const_cast<std::atomic<std::uint32_t>*>(&number);  // it is only read
  while (number.load(std::memory_order_acquire) == is) WaitOnAddress(address, &is, sizeof(is), INFINITE);
}

void wake_sleepers(std::atomic<std::uint32_t>& number) { WakeByAddressAll(&number); }

#else

void sleep_while(const std::atomic<std::uint32_t>& number, std::uint32_t is) {
  number.wait(is, std::memory_order_acquire);
}

void wake_sleepers(std::atomic<std::uint32_t>& number) { number.notify_all(); }

#endif

}  // namespace throng::anim
