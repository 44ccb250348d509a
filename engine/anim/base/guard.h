#pragma once

#include <cstddef>

#if defined(__SANITIZE_ADDRESS__)
#include <sanitizer/asan_interface.h>
#define THRONG_COPIES_GUARDED_MEMORY __attribute__((no_sanitize("address"), noinline))
#else
#define THRONG_COPIES_GUARDED_MEMORY
#endif

namespace throng::anim {

/// Under the address sanitizer, memory between guard() and release_guard() may be touched only by functions marked
/// THRONG_COPIES_GUARDED_MEMORY. Tests prove with it that kernels reach nothing but the local store.
inline void guard([[maybe_unused]] const void* memory, [[maybe_unused]] std::size_t size) {
#if defined(__SANITIZE_ADDRESS__)
  ASAN_POISON_MEMORY_REGION(memory, size);
#endif
}

inline void release_guard([[maybe_unused]] const void* memory, [[maybe_unused]] std::size_t size) {
#if defined(__SANITIZE_ADDRESS__)
  ASAN_UNPOISON_MEMORY_REGION(memory, size);
#endif
}

}  // namespace throng::anim
