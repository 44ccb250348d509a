#include "engine/anim/entity/mixer.h"

#include <algorithm>
#include <array>

#include "engine/anim/entity/entity_run.h"

namespace throng::anim {
namespace {

/// Divides the weights by their sum, as the kernel expects.
struct Shares {
  float of[max_sources];
};

std::span<Handle> sources_of_mixer(std::byte* block, const EntityLayout& layout) {
  return {mixer_sources(block, layout).sources, reinterpret_cast<const Mixer*>(block)->source_count};
}

void advance_mixer(const EntityInStore& entity, const SourcesInStore& sources) {
  auto& mixer = entity.as<Mixer>();
  auto& shares = entity.prepared_as<Shares>();
  const MixerSources& mixed = mixer_sources(entity.block, *entity.layout);
  mixer.state.delta_time = Ticks{};
  float sum = 0.0F;
  for (std::size_t i = 0; i < sources.size(); ++i) sum += mixed.weights[i];
  std::ranges::fill(mixer.state.linear_velocity, 0.0F);
  std::ranges::fill(mixer.state.angular_velocity, 0.0F);
  for (std::size_t i = 0; i < sources.size(); ++i) {
    shares.of[i] = sum > 0.0F ? mixed.weights[i] / sum : 0.0F;
    for (int axis = 0; axis < 3; ++axis) {
      mixer.state.linear_velocity[axis] += sources[i].linear_velocity[axis] * shares.of[i];
      mixer.state.angular_velocity[axis] += sources[i].angular_velocity[axis] * shares.of[i];
    }
  }
}

void mix_packet(const EntityInStore& entity, const PacketJob& job) {
  const auto& mixer = entity.as<Mixer>();
  bool any_mask = false;
  std::array<const float*, max_sources> bone_weights{};
  for (std::size_t i = 0; i < mixer.source_count; ++i) {
    const float* mask = entity.assets->mask(mixer.masks[i]);
    bone_weights[i] = mask == nullptr ? nullptr : mask + job.packet * packet_bones;
    any_mask = any_mask || mask != nullptr;
  }
  entity.assets->kernels->mix({.sources = job.sources,
                               .weights = entity.prepared_as<Shares>().of,
                               .bone_weights = any_mask ? bone_weights.data() : nullptr,
                               .count = static_cast<int>(mixer.source_count),
                               .components = entity.assets->components,
                               .out = job.out});
}

}  // namespace

const EntityKind mixer_kind = {.name = "mixer",
                               .type = EntityType::mixer,
                               .sources = sources_of_mixer,
                               .private_bytes = sizeof(MixerSources),
                               .prepared_bytes = 64,
                               .reads_identity = false,
                               .final_once_advanced = true,
                               .advance = advance_each<advance_mixer>,
                               .pose_packet = mix_packet};

}  // namespace throng::anim
