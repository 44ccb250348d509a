#pragma once

#include <cstdint>

#if defined(_MSC_VER)
#include <intrin.h>
#endif

// Compilers and processors call some things by names of their own. This file alone uses these names; all else is
// standard C++.

/// THRONG_NOT_CHECKED marks a function that the address sanitizer leaves alone. It is never inlined, since its caller
/// is checked. THRONG_HAS_ADDRESS_SANITIZER says whether there is one.
#if defined(__SANITIZE_ADDRESS__)
#define THRONG_HAS_ADDRESS_SANITIZER 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define THRONG_HAS_ADDRESS_SANITIZER 1
#endif
#endif
#if defined(_MSC_VER) && !defined(__clang__)
#define THRONG_NOT_CHECKED __declspec(no_sanitize_address) __declspec(noinline)
#else
#define THRONG_NOT_CHECKED __attribute__((no_sanitize("address"), noinline))
#endif

/// THRONG_ALIASING_VECTOR(bytes) makes a number a vector of so many bytes, which may alias anything. Where the compiler
/// has no such vectors, the number stays one.
#if defined(_MSC_VER) && !defined(__clang__)
#define THRONG_ALIASING_VECTOR(bytes)
#else
#define THRONG_ALIASING_VECTOR(bytes) [[gnu::vector_size(bytes), gnu::may_alias]]
#endif

/// THRONG_ALWAYS_INLINE is `inline` that holds in every case. A function that only prefetches needs it: GCC sees that
/// such a function changes nothing and returns nothing, and leaves out all calls that it has not inlined by then.
#if defined(_MSC_VER) && !defined(__clang__)
#define THRONG_ALWAYS_INLINE __forceinline
#else
#define THRONG_ALWAYS_INLINE [[gnu::always_inline]] inline
#endif

namespace throng {

/// Asks for the cache line at `address`, to read it soon. Any address will do.
THRONG_ALWAYS_INLINE void prefetch([[maybe_unused]] const void* address) {
#if !defined(_MSC_VER) || defined(__clang__)
  __builtin_prefetch(address, 0, 3);
#elif defined(_M_X64)
  _mm_prefetch(static_cast<const char*>(address), _MM_HINT_T0);
#elif defined(_M_ARM64)
  __prefetch(address);
#endif
}

/// Asks for the cache line at `address`, to write it soon.
THRONG_ALWAYS_INLINE void prefetch_to_write([[maybe_unused]] void* address) {
#if !defined(_MSC_VER) || defined(__clang__)
  __builtin_prefetch(address, 1, 3);
#else
  prefetch(address);
#endif
}

/// Tells the processor that this thread waits in a loop.
inline void pause_in_loop() {
#if defined(_MSC_VER) && defined(_M_X64)
  _mm_pause();
#elif defined(_MSC_VER) && defined(_M_ARM64)
  __yield();
#elif defined(__x86_64__)
  __builtin_ia32_pause();
#elif defined(__aarch64__)
  asm volatile("yield");
#endif
}

/// Counts up at an even rate. Only processors of x86-64 have it: elsewhere the system's clock is read as fast.
#if defined(__x86_64__) || defined(_M_X64)
#define THRONG_HAS_TIME_STAMP 1
inline std::uint64_t time_stamp() {
#if defined(_MSC_VER)
  return __rdtsc();
#else
  return __builtin_ia32_rdtsc();
#endif
}
#endif

/// Keeps the compiler from knowing what `pointer` points to, so that it does not turn a loop over it into memcpy.
template <typename Value>
inline void forget_origin([[maybe_unused]] Value*& pointer) {
#if defined(_MSC_VER) && !defined(__clang__)
  _ReadWriteBarrier();
#else
  asm volatile("" : "+r"(pointer));
#endif
}

}  // namespace throng
