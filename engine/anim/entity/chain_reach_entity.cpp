#include "engine/anim/entity/chain_reach_entity.h"

#include "engine/anim/entity/whole_pose_step.h"

namespace throng::anim {
namespace {

void reach(const EntityInStore& entity, const PoseView& pose) {
  const auto& reaching = entity.as<ChainReachEntity>();
  auto& memory = entity.private_as<ChainReachMemory>();
  memory.missed_by = reach_with_chain({.reach = &entity.resource_as<std::vector<ReachChain>>()[memory.chain],
                                       .pose = pose,
                                       .target = {reaching.target[0], reaching.target[1], reaching.target[2]},
                                       .weight = value(reaching.weight),
                                       .iterations = memory.iterations,
                                       .tolerance = memory.tolerance});
}

}  // namespace

EntityKind chain_reach_kind(const std::vector<ReachChain>& chains) {
  return {.name = "chain reach",
          .type = EntityType::chain_reach,
          .sources = only_source<ChainReachEntity>,
          .private_bytes = sizeof(ChainReachMemory),
          .prepared_bytes = whole_pose_prepared_bytes,
          .reads_identity = false,
          .advance = advance_each<advance_weighed<ChainReachEntity>>,
          .pose_whole = reach,
          .whole_bones = bone_end_of(chains),
          .whole_pose_work = 4,
          .displaced_quads = 0,
          .resource = &chains};
}

}  // namespace throng::anim
