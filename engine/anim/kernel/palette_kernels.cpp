#include "engine/anim/kernel/kernels.h"
#include "engine/anim/kernel/targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/anim/kernel/palette_kernels.cpp"
#include <hwy/foreach_target.h>
// After foreach_target, which chooses the target that these are compiled for.
#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include "engine/anim/kernel/lanes/copy_blocks-inl.h"
#include "engine/anim/kernel/palette/model_joints-inl.h"
#include "engine/anim/kernel/palette/model_palette-inl.h"
#include "engine/anim/kernel/palette/write_lines-inl.h"

HWY_BEFORE_NAMESPACE();
namespace throng::anim::HWY_NAMESPACE {

void fence_stores() { hwy::FlushStream(); }

void set_palette(Kernels& kernels) {
  kernels.target = hwy::TargetName(HWY_TARGET);
  kernels.fused_multiply_add = HWY_NATIVE_FMA != 0;
  kernels.model_palette = &model_palette;
  kernels.model_joints = &model_joints;
  kernels.write_lines = &write_lines;
  kernels.copy_blocks = &copy_blocks;
  kernels.fence_stores = &fence_stores;
}

}  // namespace throng::anim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace throng::anim {

HWY_EXPORT(set_palette);
void set_palette_kernels(std::size_t target, Kernels& kernels) { HWY_DISPATCH_TABLE(set_palette)[target](kernels); }

}  // namespace throng::anim
#endif  // HWY_ONCE
