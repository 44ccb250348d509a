#include "engine/anim/kernel/kernels.h"
#include "engine/anim/kernel/targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/anim/kernel/pose_kernels.cpp"
#include <hwy/foreach_target.h>
// After foreach_target, which chooses the target that these are compiled for.
#include <hwy/highway.h>

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

void set_pose(Kernels& kernels) {
  kernels.sample = &sample;
  kernels.pose_clips = &pose_clips;
  kernels.blend = &blend;
  kernels.mix = &mix;
  kernels.add = &add;
  kernels.subtract = &subtract;
  kernels.capture_offset = &capture_offset;
  kernels.apply_offset = &apply_offset;
  kernels.noise = &noise;
}

}  // namespace throng::anim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace throng::anim {

HWY_EXPORT(set_pose);
void set_pose_kernels(std::size_t target, Kernels& kernels) { HWY_DISPATCH_TABLE(set_pose)[target](kernels); }

}  // namespace throng::anim
#endif  // HWY_ONCE
