#include "engine/anim/agent/wind_back.h"

#include <algorithm>

#include "engine/anim/entity/foot_placement_entity.h"
#include "engine/anim/entity/inertialiser.h"

namespace throng::anim {
namespace {

// The offset was captured after that, or is about to be.
bool has_no_offset_of(const Inertialiser& offset, Ticks ahead) {
  return !has_left(offset) || offset.since_capture < ahead;
}

// The places where feet were held, and where they are let go to, depend on frames in which they were not posed.
bool holds_feet_of(const FootPlacementEntity& feet, Ticks ahead) {
  FadingWeight weight = feet.weight;
  advance_weight(weight, -static_cast<float>(to_seconds(ahead)));
  return value(weight) > 0.0F;
}

}  // namespace

bool can_pose_exactly(const Population& population, std::uint32_t agent) {
  const Ticks ahead = population.posed_at(agent) - population.clock();
  const EntityPools& pools = population.character_of(agent).pools;
  return ahead <= Ticks{} || std::ranges::none_of(population.graph(agent).entities, [&](Handle entity) {
           switch (pools.state(entity).type) {
             case EntityType::inertialiser:
               return has_no_offset_of(pools.as<Inertialiser>(entity), ahead);
             case EntityType::foot_placement:
               return holds_feet_of(pools.as<FootPlacementEntity>(entity), ahead);
             default:
               return false;
           }
         });
}

bool can_wind_back(const Population& population, std::uint32_t agent) {
  const Ticks ahead = population.posed_at(agent) - population.clock();
  const EntityPools& pools = population.character_of(agent).pools;
  return ahead <= Ticks{} || std::ranges::none_of(population.graph(agent).entities, [&](Handle entity) {
           switch (pools.state(entity).type) {
             case EntityType::foot_placement:
               return holds_feet_of(pools.as<FootPlacementEntity>(entity), ahead);
             case EntityType::look_at:
             case EntityType::two_bone_ik:
             case EntityType::ragdoll:
             case EntityType::spring_bones:
             case EntityType::chain_reach:
             case EntityType::user:
               return true;
             default:
               return EntityPools::is_shared(entity);
           }
         });
}

}  // namespace throng::anim
