#include "engine/anim/entity/noise_maker.h"

#include <array>
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

void set_bones(const EntityInStore& entity, int packet, const float* from, float* out, ShakenBones& bones) {
  const auto& noise = entity.as<NoiseMaker>();
  const float* mask = entity.assets->mask(noise.mask);
  bones.from = from;
  bones.out = out;
  bones.moment = &entity.prepared_as<NoiseMoment>();
  bones.bone_weights = mask == nullptr ? nullptr : mask + packet * packet_bones;
  bones.amplitude = noise.amplitude;
}

void shake(const EntityAssets& assets, int packet, std::span<const ShakenBones> characters) {
  assets.kernels->noise(
      {.characters = characters, .packet = packet, .bone_count = assets.bone_count, .components = assets.components});
}

void shake_packet(const EntityInStore& entity, const PacketJob& job) {
  ShakenBones bones;
  set_bones(entity, job.packet, job.sources[0], job.out, bones);
  shake(*entity.assets, job.packet, {&bones, 1});
}

void shake_packets(const PacketsJob& job) {
  std::array<ShakenBones, widest_tile> bones;
  for (std::size_t i = 0; i < job.all.size(); ++i) {
    float* const pose = job.bones_of(job.all[i]);
    set_bones(job.all[i].entity, job.packet, pose, pose, bones[i]);
  }
  shake(*job.all.front().entity.assets, job.packet, std::span(bones).first(job.all.size()));
}

}  // namespace

const EntityKind noise_maker_kind = {.name = "noise maker",
                                     .type = EntityType::noise_maker,
                                     .sources = only_source<NoiseMaker>,
                                     .prepared_bytes = 64,
                                     .reads_identity = false,
                                     .advance = advance_each<advance_noise>,
                                     .pose_packet = shake_packet,
                                     .displaces = false,
                                     .pose_packets = shake_packets};

}  // namespace throng::anim
