#include "engine/anim/entity/noise_maker.h"

#include <algorithm>

namespace throng::anim {
namespace {

void advance_noise(const EntityInStore& entity, std::span<const AnimationStateHeader* const> states) {
  auto& noise = entity.as<NoiseMaker>();
  noise.time += noise.state.delta_time;
  noise.state.delta_time = 0;
  entity.prepared_as<NoisePoint>() = noise_at(noise.time, noise.frequency);
  take_velocity(noise.state, *states[0]);
}

void shake_packet(const EntityInStore& entity, const PacketJob& job) {
  const auto& noise = entity.as<NoiseMaker>();
  const float* mask = entity.assets->mask(noise.mask);
  alignas(64) float amplitudes[packet_bones];
  for (int bone = 0; bone < packet_bones; ++bone) {
    const int index = job.packet * packet_bones + bone;
    const float share = mask == nullptr ? 1.0F : mask[index];
    amplitudes[bone] = index < entity.assets->bone_count ? noise.amplitude * share : 0.0F;
  }
  entity.assets->kernels->noise({.from = job.sources[0],
                                 .amplitudes = amplitudes,
                                 .point = entity.prepared_as<NoisePoint>(),
                                 .seed = noise.seed,
                                 .packet = job.packet,
                                 .components = entity.assets->components,
                                 .out = job.out});
}

}  // namespace

const EntityKind noise_maker_kind = {.name = "noise maker",
                                     .type = EntityType::noise_maker,
                                     .sources = only_source<NoiseMaker>,
                                     .prepared_bytes = 64,
                                     .advance = advance_noise,
                                     .pose_packet = shake_packet};

}  // namespace throng::anim
