#pragma once

#include "engine/anim/run/program/agent_work.h"

namespace throng::anim {

/// Takes the bones of one packet that AgentWork::fade_level lacks half or all of the way to where they stand still
/// (asset/still_pose.h). `pose` is float [components][16]. Positions of quads that are not `displaced` are 0 and not
/// stored.
void fade_bones(const UpdateContext& context, const AgentWork& work, int packet, QuadMask displaced, float* pose);

}  // namespace throng::anim
