#include "engine/anim/entity/noise_maker.h"

#include <new>

#include "engine/anim/entity/entity_run.h"

namespace throng::anim {
namespace {

void advance_noise(const EntityInStore& entity, const SourcesInStore& sources) {
  auto& noise = entity.as<NoiseMaker>();
  noise.time += noise.state.delta_time;
  noise.state.delta_time = 0;
  // Made in its place: a copy would wait for the parts that were just written.
  ::new (entity.prepared) NoiseMoment(noise_moment(noise.seed, noise_at(noise.time, noise.frequency)));
  take_velocity(noise.state, sources[0]);
}

void shake_packet(const EntityInStore& entity, const PacketJob& job) {
  const auto& noise = entity.as<NoiseMaker>();
  const EntityAssets& assets = *entity.assets;
  const float* mask = assets.mask(noise.mask);
  assets.kernels->noise({.from = job.sources[0],
                         .amplitude = noise.amplitude,
                         .bone_weights = mask == nullptr ? nullptr : mask + job.packet * packet_bones,
                         .moment = &entity.prepared_as<NoiseMoment>(),
                         .packet = job.packet,
                         .bone_count = assets.bone_count,
                         .components = assets.components,
                         .out = job.out});
}

}  // namespace

const EntityKind noise_maker_kind = {.name = "noise maker",
                                     .type = EntityType::noise_maker,
                                     .sources = only_source<NoiseMaker>,
                                     .prepared_bytes = 64,
                                     .reads_identity = false,
                                     .advance = advance_each<advance_noise>,
                                     .pose_packet = shake_packet,
                                     .displaces = false};

}  // namespace throng::anim
