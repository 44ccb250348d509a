#pragma once

#include <span>

#include "engine/anim/entity/entity_kind.h"
#include "engine/anim/run/store/copy_engine.h"

namespace throng::anim {

/// The second half of an entity's update where whole poses are at hand: `out` from `sources`, [components][16] by
/// packets. Lets the copy engine move a slice after each packet; `engine` may be null.
void pose_entity(const EntityInStore& entity, std::span<const PoseView> sources, const PoseView& out, int packets,
                 CopyEngine* engine);

/// Nothing where both are the same pose.
void copy_pose(const PoseView& from, const PoseView& to, int packets);

}  // namespace throng::anim
