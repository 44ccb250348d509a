#include "engine/anim/entity/noise_maker.h"

#include <array>
#include <new>

#include "engine/anim/entity/entity_run.h"

namespace throng::anim {
namespace {

/// The values that packets are made from, so that they do not read the block, which is final once it is advanced.
struct Shaking {
  NoiseMoment moment;
  const float* mask;  ///< [packets][16], or null
};
constexpr std::size_t prepared_shaking_bytes = 64;
static_assert(sizeof(Shaking) <= prepared_shaking_bytes);

void advance_noise(const EntityInStore& entity, const SourcesInStore& sources) {
  auto& noise = entity.as<NoiseMaker>();
  noise.time += noise.state.delta_time;
  noise.state.delta_time = Ticks{};
  // Constructed in place, since a copy waits for the parts that were just written.
  ::new (entity.prepared)
      Shaking{.moment = noise_moment(noise.seed, noise_at(noise.time, noise.frequency), noise.amplitude),
              .mask = entity.assets->mask(noise.mask)};
  take_velocity(noise.state, sources[0]);
}

void set_bones(const Shaking& shaking, int packet, const float* from, float* out, ShakenBones& bones) {
  bones.from = from;
  bones.out = out;
  bones.moment = &shaking.moment;
  bones.bone_weights = shaking.mask == nullptr ? nullptr : shaking.mask + packet * packet_bones;
}

void shake(const EntityAssets& assets, int packet, std::span<const ShakenBones> characters) {
  assets.kernels->noise(
      {.characters = characters, .packet = packet, .bone_count = assets.bone_count, .components = assets.components});
}

void shake_packet(const EntityInStore& entity, const PacketJob& job) {
  ShakenBones bones;
  set_bones(entity.prepared_as<Shaking>(), job.packet, job.sources[0], job.out, bones);
  shake(*entity.assets, job.packet, {&bones, 1});
}

void shake_packets(const PacketsJob& job) {
  std::array<ShakenBones, widest_strip> bones;
  for (std::size_t i = 0; i < job.all.size(); ++i) {
    float* const pose = job.bones_of(i);
    set_bones(job.all.entity(i).prepared_as<Shaking>(), job.packet, pose, pose, bones[i]);
  }
  shake(*job.all.alike.assets, job.packet, std::span(bones).first(job.all.size()));
}

}  // namespace

const EntityKind noise_maker_kind = {.name = "noise maker",
                                     .type = EntityType::noise_maker,
                                     .sources = only_source<NoiseMaker>,
                                     .prepared_bytes = prepared_shaking_bytes,
                                     .reads_identity = false,
                                     .final_once_advanced = true,
                                     .advance = advance_each<advance_noise>,
                                     .pose_packet = shake_packet,
                                     .displaced_quads = 0,
                                     .pose_packets = shake_packets};

}  // namespace throng::anim
