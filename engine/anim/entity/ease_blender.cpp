#include "engine/anim/entity/ease_blender.h"

#include <algorithm>

namespace throng::anim {

void advance_blender(EaseBlender& blender) {
  blender.elapsed += blender.state.delta_time;
  blender.state.delta_time = 0;
  if ((blender.flags & EaseBlender::held) != 0) return;
  const Ticks elapsed = std::clamp<Ticks>(blender.elapsed, 0, blender.total);
  blender.fraction = blender.total > 0 ? ease(static_cast<float>(elapsed) / static_cast<float>(blender.total)) : 1.0F;
}

void blend_packet(const EaseBlender& blender, const float* weights, const Kernels& kernels, int packet,
                  const float* from, const float* to, float* out) {
  kernels.blend({.from = from,
                 .to = to,
                 .bone_weights = weights == nullptr ? nullptr : weights + packet * packet_bones,
                 .fraction = blender.fraction,
                 .components = static_cast<int>(blender.state.components),
                 .out = out});
}

}  // namespace throng::anim
