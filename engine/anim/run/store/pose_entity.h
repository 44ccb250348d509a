#pragma once

#include <span>

#include "engine/anim/entity/entity_kind.h"
#include "engine/anim/run/store/copy_engine.h"

namespace throng::anim {

/// Poses an entity that was advanced: makes `out` from `sources`, which are whole poses. Lets the copy engine move a
/// slice after each packet; `engine` may be null.
void pose_entity(const EntityInStore& entity, std::span<const PoseView> sources, const PoseView& out, int packets,
                 CopyEngine* engine);

/// Copies a pose. Does nothing if both are the same pose.
void copy_pose(const PoseView& from, const PoseView& to, int packets);

}  // namespace throng::anim
