#if defined(THRONG_KERNEL_MODEL_PALETTE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef THRONG_KERNEL_MODEL_PALETTE_INL_H
#undef THRONG_KERNEL_MODEL_PALETTE_INL_H
#else
#define THRONG_KERNEL_MODEL_PALETTE_INL_H
#endif

#include <cassert>

#include "engine/anim/kernel/palette/general_palette-inl.h"
#include "engine/anim/kernel/palette/packed_palette-inl.h"
#include "engine/anim/kernel/palette/rigid_palette-inl.h"

HWY_BEFORE_NAMESPACE();
namespace throng::anim::HWY_NAMESPACE {

template <int width>
void model_palette_strip(const ModelPaletteJob& job) {
  using D = LanesUpTo<width>;
  const int begin = job.packet * packet_bones;
  const int end = HWY_MIN(begin + packet_bones, job.bone_count);
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
  assert(is_valid(job));
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

}  // namespace throng::anim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // THRONG_KERNEL_MODEL_PALETTE_INL_H
