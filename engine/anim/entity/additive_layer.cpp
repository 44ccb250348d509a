#include "engine/anim/entity/additive_layer.h"

#include <algorithm>
#include <iterator>

#include "engine/anim/entity/entity_run.h"

namespace throng::anim {
namespace {

std::span<Handle> sources_of_layer(std::byte* block, const EntityLayout&) {
  static_assert(offsetof(AdditiveLayer, reference) == offsetof(AdditiveLayer, base) + 2 * sizeof(Handle));
  return {&reinterpret_cast<AdditiveLayer*>(block)->base, 3};
}

void move_weight(AdditiveLayer& layer) {
  // An agent ahead of the clock may be wound back, and the weight of before is not known then.
  const auto seconds = static_cast<float>(to_seconds(std::max(layer.state.delta_time, Ticks{})));
  const float most = layer.weight_per_second > 0.0F ? layer.weight_per_second * seconds : 1.0F;
  layer.weight += std::clamp(layer.target_weight - layer.weight, -most, most);
  layer.state.delta_time = Ticks{};
}

void advance_layer(const EntityInStore& entity, const SourcesInStore& sources) {
  auto& layer = entity.as<AdditiveLayer>();
  move_weight(layer);
  take_velocity(layer.state, sources[0]);
}

void add_packet(const EntityInStore& entity, const PacketJob& job) {
  const auto& layer = entity.as<AdditiveLayer>();
  const Kernels& kernels = *entity.assets->kernels;
  const float* mask = entity.assets->mask(layer.mask);
  alignas(64) float delta[general_components * packet_bones];
  kernels.subtract(
      {.pose = job.sources[1], .reference = job.sources[2], .components = entity.assets->components, .out = delta});
  kernels.add({.base = job.sources[0],
               .delta = delta,
               .bone_weights = mask == nullptr ? nullptr : mask + job.packet * packet_bones,
               .weight = layer.weight,
               .components = entity.assets->components,
               .out = job.out});
}

}  // namespace

const EntityKind additive_layer_kind = {.name = "additive layer",
                                        .type = EntityType::additive_layer,
                                        .sources = sources_of_layer,
                                        .reads_identity = false,
                                        .advance = advance_each<advance_layer>,
                                        .pose_packet = add_packet};

}  // namespace throng::anim
