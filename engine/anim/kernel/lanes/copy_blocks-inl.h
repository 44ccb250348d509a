#if defined(THRONG_KERNEL_COPY_BLOCKS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef THRONG_KERNEL_COPY_BLOCKS_INL_H
#undef THRONG_KERNEL_COPY_BLOCKS_INL_H
#else
#define THRONG_KERNEL_COPY_BLOCKS_INL_H
#endif

#include <cassert>
#include <cstddef>

#include "engine/anim/base/guard.h"
#include "engine/anim/kernel/lanes/copy_blocks.h"
#include "engine/anim/kernel/lanes/lanes-inl.h"
#include "engine/base/compiler.h"

HWY_BEFORE_NAMESPACE();
namespace throng::anim::HWY_NAMESPACE {

inline constexpr std::size_t copied_line = 64;

/// Copies at least one line. It uses neither memcpy nor Highway: the address sanitizer checks both, and this function
/// must reach guarded pools.
THRONG_COPIES_GUARDED_MEMORY inline void copy_lines(const std::byte* from, std::byte* to, std::size_t size) {
  constexpr std::size_t part_bytes = HWY_MIN(HWY_MAX(HWY_MAX_BYTES, 16), copied_line);
  using Part THRONG_ALIASING_VECTOR(part_bytes) = long long;
  const std::byte* const end = from + size;
  do {
    for (std::size_t part = 0; part < copied_line; part += sizeof(Part)) {
      *reinterpret_cast<Part*>(to + part) = *reinterpret_cast<const Part*>(from + part);
    }
    from += copied_line;
    to += copied_line;
    forget_origin(from);
  } while (from != end);
}

inline void copy_blocks(const CopyBlocksJob& shared) {
  assert(is_valid(shared));
  const CopyBlocksJob job = shared;  // a copy, since the compiler would read the job again after each store
  std::byte* local = job.local;
  for (std::size_t i = 0; i < job.blocks.size(); ++i, local += job.stride) {
    std::byte* const block = job.blocks[i] + job.offset;
    copy_lines(job.inward ? block : local, job.inward ? local : block, job.size);
  }
}

}  // namespace throng::anim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
