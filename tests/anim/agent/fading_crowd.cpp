#include "tests/anim/agent/fading_crowd.h"

#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "engine/anim/asset/synthetic_model.h"

namespace throng::anim {
namespace {

constexpr std::uint32_t agents = 200;
constexpr int frames = 20;

std::shared_ptr<const Character> character() {
  static const auto shared = std::make_shared<const Character>(bake_character(synthetic_model(62, 3)));
  return shared;
}

PlayRequest request(std::uint32_t agent, std::uint32_t turn, unsigned seed) {
  const std::uint32_t mixed = (agent + seed * 31U) * 2654435761U + turn * 40503U;
  return {.clip = static_cast<int>(mixed % 3),
          .fade = turn == 0 ? Ticks{} : to_ticks(0.15 + 0.01 * (mixed % 7)),
          .speed = 0.8 + 0.05 * (mixed % 9),
          .start = to_ticks(0.001 * (mixed % 800))};
}

}  // namespace

std::uint64_t hash_of_fading_crowd(const SystemOptions& options, unsigned seed) {
  auto created = AnimationSystem::create(character(), options);
  EXPECT_TRUE(created.has_value()) << (created ? "" : created.error().message);
  if (!created) return 0;
  AnimationSystem& system = **created;
  system.set_agent_count(agents);
  for (std::uint32_t agent = 0; agent < agents; ++agent) system.agent(agent).play(request(agent, 0, seed));
  std::vector<PoseRequest> updates;
  for (std::uint32_t frame = 1; frame <= frames; ++frame) {
    system.advance(ticks_per_second / 60);
    updates.clear();
    for (std::uint32_t agent = 0; agent < agents; ++agent) {
      if ((agent + frame) % 11 == 0) system.agent(agent).play(request(agent, frame, seed));
      if (agent % 3 == 0 && frame % 2 == 0) continue;
      const auto levels = static_cast<std::uint32_t>(character()->skeleton.level_bone_counts.size());
      updates.push_back({.agent = {agent},
                         .level = static_cast<std::uint8_t>(agent / 7 % levels),
                         .look_ahead = agent % 3 == 0 ? ticks_per_second / 30 : Ticks{}});
    }
    system.update(updates);
  }
  return system.figures().pose_hash();
}

}  // namespace throng::anim
