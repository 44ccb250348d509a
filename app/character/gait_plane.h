#pragma once

#include <memory>

#include "app/character/roles.h"
#include "engine/anim/agent/blend_space_2d_channel.h"
#include "engine/anim/base/result.h"

namespace throng::app {

/// Returns the blend space in which a character stands, walks and steps by its velocity: x to the left and y ahead,
/// metres a second at scale 1. Standing is in the middle, and each gait of `roles` lies at its own velocity. Where side
/// steps or steps back are missing, the shuffle or the walk tramples in their place. A character that cannot walk only
/// stands. Errors: a role plays a clip that the character does not have.
anim::Result<std::shared_ptr<const anim::BlendSpace2d>> gait_plane(const CharacterRoles& roles, int clip_count);

}  // namespace throng::app
