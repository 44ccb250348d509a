#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "engine/anim/agent/animation_system.h"
#include "engine/anim/asset/synthetic_model.h"

namespace throng::anim {

/// Returns the pose hash of 200 fading agents after 20 frames on 4 PUs. The system's own threads run them if there is
/// no executor.
inline std::uint64_t crowd_hash(Schedule schedule, Executor* executor = nullptr) {
  constexpr std::uint32_t agents = 200;
  static const auto character = std::make_shared<const Character>(bake_character(synthetic_model(62, 3)));
  const auto created = AnimationSystem::create(character, {.pus = 4, .schedule = schedule, .executor = executor});
  EXPECT_TRUE(created.has_value()) << (created ? "" : created.error().message);
  if (!created) return 0;
  AnimationSystem& system = **created;
  system.set_agent_count(agents);
  std::vector<PoseRequest> updates;
  for (std::uint32_t agent = 0; agent < agents; ++agent) {
    system.agent(agent).play({.clip = static_cast<int>(agent % 3), .start = to_ticks(0.004 * agent)});
    updates.push_back({.agent = {agent}});
  }
  for (std::uint32_t frame = 0; frame < 20; ++frame) {
    const PlayRequest next{.clip = static_cast<int>(frame % 3), .fade = to_ticks(0.2)};
    for (std::uint32_t agent = frame; agent < agents; agent += 11) system.agent(agent).play(next);
    system.advance(ticks_per_second / 60);
    system.update(updates);
  }
  return system.figures().pose_hash();
}

inline void expect_the_poses_of_our_own_threads(Executor& executor) {
  for (const Schedule schedule : {Schedule::fused, Schedule::levels}) {
    EXPECT_EQ(crowd_hash(schedule, &executor), crowd_hash(schedule));
  }
}

}  // namespace throng::anim
