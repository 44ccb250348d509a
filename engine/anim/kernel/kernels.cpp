#include "engine/anim/kernel/kernels.h"

#include <vector>

// Every target that this compiler can write, the one-lane SCALAR target among them, which the others are measured
// against: Highway would replace it by emulated 128-bit vectors on newer compilers. The kernels keep vectors in
// structures, which targets without a compile-time width do not allow.
#define HWY_COMPILE_ALL_ATTAINABLE
#define HWY_BROKEN_EMU128 1
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/anim/kernel/kernels.cpp"
#include <hwy/foreach_target.h>
// After foreach_target, which chooses the target that these are compiled for.
#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include "engine/anim/kernel/lanes/copy_blocks-inl.h"
#include "engine/anim/kernel/limb/foot_placement-inl.h"
#include "engine/anim/kernel/limb/look_at-inl.h"
#include "engine/anim/kernel/limb/two_bone_ik-inl.h"
#include "engine/anim/kernel/palette/model_palette-inl.h"
#include "engine/anim/kernel/palette/write_lines-inl.h"
#include "engine/anim/kernel/pose/add-inl.h"
#include "engine/anim/kernel/pose/blend-inl.h"
#include "engine/anim/kernel/pose/mix-inl.h"
#include "engine/anim/kernel/pose/noise-inl.h"
#include "engine/anim/kernel/pose/offset-inl.h"
#include "engine/anim/kernel/pose/pose_clips-inl.h"
#include "engine/anim/kernel/pose/sample-inl.h"
#include "engine/anim/kernel/pose/subtract-inl.h"

HWY_BEFORE_NAMESPACE();
namespace throng::anim::HWY_NAMESPACE {

void fence_stores() { hwy::FlushStream(); }

Kernels kernel_set() {
  return {.target = hwy::TargetName(HWY_TARGET),
          .fused_multiply_add = HWY_NATIVE_FMA != 0,
          .sample = &sample,
          .pose_clips = &pose_clips,
          .blend = &blend,
          .mix = &mix,
          .add = &add,
          .subtract = &subtract,
          .capture_offset = &capture_offset,
          .apply_offset = &apply_offset,
          .noise = &noise,
          .look_at = &look_at,
          .two_bone_ik = &two_bone_ik,
          .place_feet = &place_feet,
          .model_palette = &model_palette,
          .write_lines = &write_lines,
          .copy_blocks = &copy_blocks,
          .fence_stores = &fence_stores};
}

}  // namespace throng::anim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace throng::anim {
namespace {

HWY_EXPORT(kernel_set);

std::vector<Kernels> find_runnable_kernels() {
  std::vector<Kernels> sets;
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    hwy::ChosenTarget chosen;
    chosen.Update(target);
    sets.push_back(HWY_DISPATCH_TABLE(kernel_set)[chosen.GetIndex()]());
  }
  return sets;
}

}  // namespace

std::span<const Kernels> runnable_kernels() {
  static const std::vector<Kernels> sets = find_runnable_kernels();
  return sets;
}

const Kernels& best_kernels() { return runnable_kernels().front(); }

const Kernels& scalar_kernels() { return runnable_kernels().back(); }

}  // namespace throng::anim
#endif  // HWY_ONCE
