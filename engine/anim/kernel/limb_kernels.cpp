#include "engine/anim/kernel/kernels.h"
#include "engine/anim/kernel/targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/anim/kernel/limb_kernels.cpp"
#include <hwy/foreach_target.h>
// After foreach_target, which chooses the target that these are compiled for.
#include <hwy/highway.h>

#include "engine/anim/kernel/limb/foot_placement-inl.h"
#include "engine/anim/kernel/limb/look_at-inl.h"
#include "engine/anim/kernel/limb/two_bone_ik-inl.h"

HWY_BEFORE_NAMESPACE();
namespace throng::anim::HWY_NAMESPACE {

void set_limb(Kernels& kernels) {
  kernels.look_at = &look_at;
  kernels.two_bone_ik = &two_bone_ik;
  kernels.place_feet = &place_feet;
}

}  // namespace throng::anim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace throng::anim {

HWY_EXPORT(set_limb);
void set_limb_kernels(std::size_t target, Kernels& kernels) { HWY_DISPATCH_TABLE(set_limb)[target](kernels); }

}  // namespace throng::anim
#endif  // HWY_ONCE
