#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "engine/anim/lod/lod.h"

namespace throng::anim::force_test {
namespace {

/// Six agents side by side, 20 m in front of a camera that sees everything.
struct ForcedLod : testing::Test {
  static constexpr std::uint32_t agents = 6;
  std::vector<glm::vec3> positions = std::vector<glm::vec3>(agents, glm::vec3(0.0F, 0.0F, -20.0F));
  std::vector<float> scales = std::vector<float>(agents, 1.0F);
  LodCharacter character{.level_count = 3};
  LodFrame frame;
  LodState state;
  LodSelection selection;

  ForcedLod() {
    frame.positions = positions;
    frame.scales = scales;
    frame.characters = {&character, 1};
    frame.camera.frustum.fill({0.0F, 0.0F, -1.0F, 100.0F});
    frame.rules = {.rule = LodRule::distance, .smooth = true};
    state.resize(agents, selection);
  }

  /// How often each was due.
  std::vector<int> updates_in(int frames) {
    std::vector<int> updates(agents, 0);
    for (int i = 0; i < frames; ++i, ++frame.number) {
      select_for_update(frame, state, selection);
      for (const std::uint32_t agent : selection.due) ++updates[agent];
    }
    return updates;
  }
};

TEST_F(ForcedLod, EveryoneIsUpdatedAsRarelyAsIsForced) {
  frame.force.interval = 5;
  updates_in(20);
  EXPECT_EQ(updates_in(50), std::vector<int>(agents, 10));
  for (const VisibleAgent& agent : selection.visible) EXPECT_EQ(agent.interval, 5);
}

TEST_F(ForcedLod, EveryoneKeepsTheBonesOfTheForcedLevelOrOfTheLastThereIs) {
  frame.rules.bone_lod = false;
  for (const auto& [forced, shown] : {std::pair{1, 1}, {3, 2}, {0, 0}}) {
    frame.force.bone_level = forced;
    updates_in(20);
    for (const VisibleAgent& agent : selection.visible) EXPECT_EQ(agent.bone_level, shown);
  }
}

TEST_F(ForcedLod, ConcernsOneAgentAloneIfToldSo) {
  frame.force = {.interval = 7, .bone_level = 2, .agent = 3};
  updates_in(20);
  for (const VisibleAgent& agent : selection.visible) {
    EXPECT_EQ(agent.interval, agent.agent == 3 ? 7 : 2);
    EXPECT_EQ(agent.bone_level, agent.agent == 3 ? 2 : 1);
  }
}

TEST_F(ForcedLod, LetGoTheRuleHasItsWayAgain) {
  frame.force = {.interval = 9, .bone_level = 2};
  updates_in(20);
  frame.force = {};
  updates_in(20);
  for (const VisibleAgent& agent : selection.visible) EXPECT_EQ(agent.interval, 2);
}

}  // namespace
}  // namespace throng::anim::force_test
