#include "engine/anim/kernel/kernels.h"

#include <cassert>
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

#include "engine/anim/kernel/add-inl.h"
#include "engine/anim/kernel/blend-inl.h"
#include "engine/anim/kernel/copy_blocks-inl.h"
#include "engine/anim/kernel/foot_placement-inl.h"
#include "engine/anim/kernel/general_palette-inl.h"
#include "engine/anim/kernel/look_at-inl.h"
#include "engine/anim/kernel/mix-inl.h"
#include "engine/anim/kernel/noise-inl.h"
#include "engine/anim/kernel/offset-inl.h"
#include "engine/anim/kernel/packed_palette-inl.h"
#include "engine/anim/kernel/pose_clips-inl.h"
#include "engine/anim/kernel/rigid_palette-inl.h"
#include "engine/anim/kernel/sample-inl.h"
#include "engine/anim/kernel/subtract-inl.h"
#include "engine/anim/kernel/two_bone_ik-inl.h"
#include "engine/anim/kernel/write_lines-inl.h"

HWY_BEFORE_NAMESPACE();
namespace throng::anim::HWY_NAMESPACE {

template <int width>
void model_palette_strip(const ModelPaletteJob& job) {
  using D = LanesUpTo<width>;
  const int begin = job.packet * packet_bones;
  const int end = HWY_MIN(begin + packet_bones, job.bone_count);
  assert((job.format == PaletteFormat::matrices || job.hierarchy->packs()) && "palettes that cannot be packed");
  if (begin >= end) return;
  for (int lane = 0; lane < job.characters; lane += lane_count<D>) {
    if (job.format == PaletteFormat::packed) {
      rigid_palette_lanes<PackedMotion, width>(D(), job, lane, begin, end);
    } else if (job.hierarchy->rigid) {
      rigid_palette_lanes<RigidMotion, width>(D(), job, lane, begin, end);
    } else {
      general_palette_lanes<width>(D(), job, lane, begin, end);
    }
  }
}

void model_palette(const ModelPaletteJob& job) {
  switch (job.width) {
    case 1:
      return model_palette_strip<1>(job);
    case 2:
      return model_palette_strip<2>(job);
    case 4:
      return model_palette_strip<4>(job);
    case 8:
      return model_palette_strip<8>(job);
    default:
      return model_palette_strip<widest_strip>(job);
  }
}

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
