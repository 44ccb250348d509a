#include "engine/anim/run/program/bone_fade.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace throng::anim {

namespace {

constexpr float whole_way = 2.0F;  // halves
constexpr int rotation_components = 4;

/// A bone's component in a packet.
float& component_of(float* packet, int component, int lane) { return packet[component * packet_bones + lane]; }
float component_of(const float* packet, int component, int lane) { return packet[component * packet_bones + lane]; }

/// The shorter way round, back to unit length.
void fade_rotation(const float* still, int lane, float share, float* pose) {
  float cosine = 0.0F;
  for (int i = 0; i < rotation_components; ++i) cosine += component_of(still, i, lane) * component_of(pose, i, lane);
  const float side = cosine < 0.0F ? -1.0F : 1.0F;
  float squares = 0.0F;
  for (int i = 0; i < rotation_components; ++i) {
    float& value = component_of(pose, i, lane);
    value = (1.0F - share) * value + share * side * component_of(still, i, lane);
    squares += value * value;
  }
  const float length = std::sqrt(squares);
  for (int i = 0; i < rotation_components; ++i) component_of(pose, i, lane) /= length;
}

}  // namespace

void fade_bones(const UpdateContext& context, const AgentWork& work, int packet, QuadMask displaced, float* pose) {
  const int components = context.assets.components;
  const int kept = context.bones(work.fade_level) - packet * packet_bones;
  if (work.fade_halves == 0 || kept >= packet_bones) return;
  assert(!context.still_pose.empty() && "the context lacks the still pose");
  const float share = static_cast<float>(work.fade_halves) / whole_way;
  const float* still = &context.still_pose[static_cast<std::size_t>(packet) * context.packet_floats()];
  for (int lane = std::max(kept, 0); lane < packet_bones; ++lane) {
    fade_rotation(still, lane, share, pose);
    const int last_component = is_in(displaced, lane / quad_bones) ? components : rotation_components;
    for (int i = rotation_components; i < last_component; ++i) {
      float& value = component_of(pose, i, lane);
      value = (1.0F - share) * value + share * component_of(still, i, lane);
    }
  }
}

}  // namespace throng::anim
