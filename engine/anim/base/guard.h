#pragma once

#include <cstddef>

#include "engine/base/compiler.h"

#if defined(THRONG_HAS_ADDRESS_SANITIZER)
#include <sanitizer/asan_interface.h>
#define THRONG_COPIES_GUARDED_MEMORY THRONG_NOT_CHECKED
#else
#define THRONG_COPIES_GUARDED_MEMORY
#endif

namespace throng::anim {

/// Under the address sanitizer, memory between guard() and release_guard() may be touched only by functions marked
/// THRONG_COPIES_GUARDED_MEMORY. Tests prove with it that kernels reach nothing but the local store.
inline void guard([[maybe_unused]] const void* memory, [[maybe_unused]] std::size_t size) {
#if defined(THRONG_HAS_ADDRESS_SANITIZER)
  ASAN_POISON_MEMORY_REGION(memory, size);
#endif
}

inline void release_guard([[maybe_unused]] const void* memory, [[maybe_unused]] std::size_t size) {
#if defined(THRONG_HAS_ADDRESS_SANITIZER)
  ASAN_UNPOISON_MEMORY_REGION(memory, size);
#endif
}

}  // namespace throng::anim
