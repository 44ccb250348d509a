#include "engine/anim/entity/ease_blender.h"

#include <cstring>

#include "engine/anim/entity/entity_run.h"

namespace throng::anim {
namespace {

std::span<Handle> sources_of_blender(std::byte* block, const EntityLayout&) {
  static_assert(offsetof(EaseBlender, to) == offsetof(EaseBlender, from) + sizeof(Handle));
  return {&reinterpret_cast<EaseBlender*>(block)->from, 2};
}

/// Blends the linear and the angular velocity, which lie side by side, four floats at a time. Two floats are blended
/// twice, which is faster than two single ones.
void blend_velocities(EaseBlender& blender, const AnimationStateHeader& from, const AnimationStateHeader& to) {
  constexpr std::size_t first = offsetof(AnimationStateHeader, linear_velocity);
  static_assert(offsetof(AnimationStateHeader, angular_velocity) == first + 3 * sizeof(float));
  const float to_share = blender.fraction, from_share = 1.0F - blender.fraction;
  for (const std::size_t offset : {first, first + 2 * sizeof(float)}) {
    float some[4], others[4], blended[4];
    std::memcpy(some, reinterpret_cast<const std::byte*>(&from) + offset, sizeof(some));
    std::memcpy(others, reinterpret_cast<const std::byte*>(&to) + offset, sizeof(others));
    for (int axis = 0; axis < 4; ++axis) blended[axis] = from_share * some[axis] + to_share * others[axis];
    std::memcpy(reinterpret_cast<std::byte*>(&blender.state) + offset, blended, sizeof(blended));
  }
}

void advance_entity(const EntityInStore& entity, const SourcesInStore& sources) {
  auto& blender = entity.as<EaseBlender>();
  advance_blender(blender);
  blend_velocities(blender, sources[0], sources[1]);
}

ShownClips clips_of_blender(const EntityInStore& entity, const SourcesInStore& sources) {
  const auto& blender = entity.as<EaseBlender>();
  const ShownClips &from = sources.shown(0), &to = sources.shown(1);
  if (entity.assets->mask(blender.mask) != nullptr || from.clip == nullptr || to.clip == nullptr) return {};
  if (blender.fraction == 0.0F) return from;
  if (blender.fraction == 1.0F) return to;
  if (from.blended != nullptr || to.blended != nullptr) return {};
  return {.clip = from.clip, .blended = to.clip, .fraction = blender.fraction};
}

void blend_packet(const EntityInStore& entity, const PacketJob& job) {
  const auto& blender = entity.as<EaseBlender>();
  const float* weights = entity.assets->mask(blender.mask);
  if (weights == nullptr && (blender.fraction == 0.0F || blender.fraction == 1.0F)) {
    const float* const all = job.sources[blender.fraction == 0.0F ? 0 : 1];
    std::memmove(job.out, all, packet_bytes(entity.assets->components));
    return;
  }
  entity.assets->kernels->blend({.from = job.sources[0],
                                 .to = job.sources[1],
                                 .bone_weights = weights == nullptr ? nullptr : weights + job.packet * packet_bones,
                                 .fraction = blender.fraction,
                                 .components = entity.assets->components,
                                 .out = job.out});
}

}  // namespace

void advance_blender(EaseBlender& blender) {
  blender.elapsed += blender.state.delta_time;
  blender.state.delta_time = Ticks{};
  if ((blender.flags & EaseBlender::held) != 0) return;
  if ((blender.flags & EaseBlender::linear) != 0) {
    blender.fraction = value(blender.weight, blender.elapsed);
    return;
  }
  const Ticks elapsed = std::clamp(blender.elapsed, Ticks{}, blender.total);
  blender.fraction = blender.total > Ticks{}
                         ? ease(static_cast<float>(elapsed.count()) / static_cast<float>(blender.total.count()))
                         : 1.0F;
}

const EntityKind ease_blender_kind = {.name = "ease blender",
                                      .type = EntityType::ease_blender,
                                      .sources = sources_of_blender,
                                      .reads_identity = false,
                                      .final_once_advanced = true,
                                      .advance = advance_each<advance_entity, clips_of_blender>,
                                      .pose_packet = blend_packet};

}  // namespace throng::anim
