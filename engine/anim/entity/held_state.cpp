#include "engine/anim/entity/held_state.h"

#include "engine/anim/entity/entity_run.h"

namespace throng::anim {
namespace {

void use_up_time(const EntityInStore& entity, const SourcesInStore&) {
  entity.as<HeldState>().state.delta_time = Ticks{};
}

// The block holds the pose, so there is nothing to do.
void keep_packet(const EntityInStore&, const PacketJob&) {}

}  // namespace

const EntityKind held_state_kind = {.name = "held state",
                                    .type = EntityType::state,
                                    .keeps_transforms = true,
                                    .advance = advance_each<use_up_time>,
                                    .pose_packet = keep_packet};

}  // namespace throng::anim
