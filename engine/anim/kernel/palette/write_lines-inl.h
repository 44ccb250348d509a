#if defined(THRONG_KERNEL_WRITE_LINES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef THRONG_KERNEL_WRITE_LINES_INL_H
#undef THRONG_KERNEL_WRITE_LINES_INL_H
#else
#define THRONG_KERNEL_WRITE_LINES_INL_H
#endif

#include <cassert>
#include <cstddef>

#include "engine/anim/kernel/lanes/lanes-inl.h"
#include "engine/anim/kernel/palette/write_lines.h"
#include "engine/base/compiler.h"

HWY_BEFORE_NAMESPACE();
namespace throng::anim::HWY_NAMESPACE {

inline void write_lines(const WriteLinesJob& job) {
  assert(is_valid(job));
  constexpr std::size_t line_floats = 16;
  constexpr std::size_t floats_ahead = 16 * line_floats;  // further than the processor fetches by itself
  const BoneLanes d;
  const auto value = hn::Set(d, job.value);
  for (std::size_t at = 0; at < job.lines.size(); at += line_floats) {
    float* const line = job.lines.data() + at;
    if (job.stores == StorePolicy::prefetched) prefetch_to_write(line + floats_ahead);
    for (std::size_t i = 0; i < line_floats; i += static_cast<std::size_t>(lane_count<BoneLanes>)) {
      if (job.stores == StorePolicy::streaming) {
        hn::Stream(value, d, line + i);
      } else {
        hn::Store(value, d, line + i);
      }
    }
  }
}

}  // namespace throng::anim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // toggled guard
