#include <algorithm>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "tests/anim/agent/crowd_rig.h"

namespace throng::anim::bone_selection_test {
namespace {

TEST(AddBoneSelection, LetsAPlayRequestPoseTheSelectedBonesAndTheOthersFollow) {
  constexpr int kept = 8;  // parents come before their children, so these are whole to the root
  const Skeleton& skeleton = test_character()->skeleton;
  std::vector<std::uint8_t> priorities(skeleton.bones.size(), 0);
  std::fill_n(priorities.begin(), kept, std::uint8_t{1});
  CrowdRig all, some;
  all->agent(0).play({.clip = 1});
  some->agent(0).play(
      {.clip = 1, .bone_selection = some->characters().add_bone_selection(BoneSelection(skeleton, priorities, 1))});
  all.step(5);
  some.step(5);
  const std::vector<int> unlike = some.bones_unlike(all);
  EXPECT_GT(unlike.size(), skeleton.bones.size() / 2);
  EXPECT_TRUE(std::ranges::all_of(unlike, [](int bone) { return bone >= kept; }));
}

}  // namespace
}  // namespace throng::anim::bone_selection_test
