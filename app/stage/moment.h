#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "app/crowd/crowd.h"
#include "app/stage/cut_scene.h"
#include "app/stage/fallen_agents.h"
#include "app/stage/gazes.h"
#include "app/stage/joined_hands.h"
#include "app/stage/placed_feet.h"
#include "engine/anim/agent/system_snapshot.h"

namespace throng::app {

/// All of a stage that changes as time passes; its memory is used again when it is filled again.
struct StageMoment {
  std::uint64_t crowd_number = 0;  ///< AnimatedCrowd::number; the moment cannot be put back into another crowd
  anim::Ticks clock{};
  anim::SystemSnapshot system;
  std::optional<CrowdState> crowd;
  std::optional<CutScene::Moment> cut_scene;
  std::optional<FallenAgents> fallen;
  PlacedFeet::Moment feet;
  Gazes::Moment gazes;
  JoinedHands::Moment joined_hands;
  std::vector<float> played_speeds;
};

}  // namespace throng::app
