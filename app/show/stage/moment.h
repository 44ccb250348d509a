#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "app/people/crowd/crowd.h"
#include "app/show/stage/body_details.h"
#include "app/show/stage/cut_scene.h"
#include "app/show/stage/fallen_agents.h"
#include "engine/anim/agent/system_snapshot.h"

namespace throng::app {

/// All of a stage that changes as time passes; its memory is used again when it is filled again.
struct StageMoment {
  std::uint64_t crowd_number = 0;  ///< AnimatedCrowd::number; the moment cannot be put back into another crowd
  Ticks clock{};
  anim::SystemSnapshot system;
  std::optional<CrowdState> crowd;
  std::optional<CutScene::Moment> cut_scene;
  std::optional<FallenAgents> fallen;
  BodyDetails::Moment details;
  std::vector<float> played_speeds;
};

}  // namespace throng::app
