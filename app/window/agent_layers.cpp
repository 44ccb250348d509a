#include "app/window/agent_layers.h"

#include <algorithm>

#include "engine/anim/entity/chain_reach_entity.h"
#include "engine/anim/entity/fading_weight.h"
#include "engine/anim/entity/foot_placement_entity.h"
#include "engine/anim/entity/ik_entity.h"
#include "engine/anim/entity/look_at_entity.h"
#include "engine/anim/entity/spring_bones_entity.h"

namespace throng::app {
namespace {

using LayerSteps = std::vector<anim::PoseStep>;

std::size_t step_of(const anim::PoseGraph& graph, anim::Handle entity) {
  return static_cast<std::size_t>(std::ranges::find(graph.entities, entity) - graph.entities.begin());
}

// Claims the step and the steps that it reads, sources first. Steps that have been claimed belong to another layer.
void claim(const LayerSteps& steps, std::size_t step, std::vector<bool>& claimed, std::vector<std::size_t>& claims) {
  if (step >= steps.size() || claimed[step]) return;
  claimed[step] = true;
  for (std::size_t i = 0; i < steps[step].source_count; ++i) claim(steps, steps[step].sources[i], claimed, claims);
  claims.push_back(step);
}

/// Lays a channel over the channels before it; null for the first, and for a channel that plays nothing.
const anim::EaseBlender* blender_over(const anim::EntityPools& pools, const anim::PoseGraph& graph, std::size_t state,
                                      std::vector<bool>& claimed) {
  const LayerSteps& steps = graph.program->steps;
  for (std::size_t step = 0; step < steps.size(); ++step) {
    const bool reads_it = steps[step].source_count == 2 && steps[step].sources[1] == state;
    const auto& blender = pools.as<anim::EaseBlender>(graph.entities[step]);
    if (claimed[step] || !reads_it || blender.state.type != anim::EntityType::ease_blender) continue;
    claimed[step] = true;
    return &blender;
  }
  return nullptr;
}

template <typename Entity>
float weight_in(const anim::EntityPools& pools, anim::Handle entity) {
  return anim::value(pools.as<Entity>(entity).weight);
}

/// The weight of an entity's effect; for an entity without an effect of its own, its share of the pose.
float applied_weight(const anim::EntityPools& pools, anim::Handle entity, float in_pose) {
  switch (pools.as<anim::AnimationStateHeader>(entity).type) {
    case anim::EntityType::foot_placement:
      return weight_in<anim::FootPlacementEntity>(pools, entity);
    case anim::EntityType::two_bone_ik:
      return weight_in<anim::IkEntity>(pools, entity);
    case anim::EntityType::spring_bones:
      return weight_in<anim::SpringBonesEntity>(pools, entity);
    case anim::EntityType::chain_reach:
      return weight_in<anim::ChainReachEntity>(pools, entity);
    case anim::EntityType::look_at:
      return weight_in<anim::LookAtEntity>(pools, entity);
    default:
      return in_pose;
  }
}

}  // namespace

std::vector<LayerRow> agent_layers(const anim::AnimationSystem& system, std::uint32_t agent) {
  const anim::PoseGraph& graph = system.agent(agent).graph();
  const LayerSteps& steps = graph.program->steps;
  const anim::EntityPools& pools = system.agent(agent).pools();
  std::vector<LayerRow> layers;
  std::vector<bool> claimed(steps.size());
  for (std::size_t channel = 0; channel < system.agent(agent).channel_count(); ++channel) {
    const std::size_t state =
        step_of(graph, system.agent(agent).channel(system.agent(agent).channel_id(channel))->state());
    LayerRow& layer = layers.emplace_back(LayerRow{.name = "Channel " + std::to_string(channel), .entities = {}});
    claim(steps, state, claimed, layer.entities);
    if (channel == 0 || state == steps.size()) continue;
    const anim::EaseBlender* const blender = blender_over(pools, graph, state, claimed);
    if (blender == nullptr) continue;
    layer.weight = blender->fraction;
    layer.is_masked = blender->mask != anim::EaseBlender::no_mask;
  }
  const anim::PoseWeights in_pose = system.agent(agent).motion().weights(system.clock());
  for (std::size_t step = 0; step < steps.size(); ++step) {
    if (claimed[step]) continue;
    layers.push_back({.name = pools.kind(graph.entities[step]).name,
                      .weight = applied_weight(pools, graph.entities[step], in_pose[step]),
                      .is_channel = false,
                      .entities = {step}});
  }
  return layers;
}

}  // namespace throng::app
