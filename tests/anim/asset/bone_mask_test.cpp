#include "engine/anim/asset/bone_mask.h"

#include <cstdint>

#include <gtest/gtest.h>

#include "engine/anim/asset/synthetic_model.h"
#include "engine/anim/base/pose.h"

namespace throng::anim::bone_mask_test {
namespace {

class BoneMaskOf62 : public testing::Test {
 protected:
  bool is_below(int bone, int ancestor) const {
    while (bone > ancestor) bone = skeleton_.bones[static_cast<std::size_t>(bone)].parent;
    return bone == ancestor;
  }
  Skeleton skeleton_ = synthetic_model(62, 1).skeleton;
  int spine_ = find_bone(skeleton_, "spine_3");
};

TEST_F(BoneMaskOf62, CoversASubtree) {
  ASSERT_GE(spine_, 0);
  const SubtreeWeight upper[] = {{spine_, 1.0F}};
  const BoneMask mask("upper body", skeleton_, upper, 0.25F);
  EXPECT_EQ(mask.name(), "upper body");
  for (int bone = 0; bone < 62; ++bone) EXPECT_EQ(mask.weight(bone), is_below(bone, spine_) ? 1.0F : 0.25F) << bone;
}

TEST_F(BoneMaskOf62, LetsTheInnerSubtreeWin) {
  const int shoulder = find_bone(skeleton_, "shoulder_14");
  ASSERT_GE(shoulder, 0);
  ASSERT_TRUE(is_below(shoulder, spine_));
  const SubtreeWeight weights[] = {{shoulder, 0.5F}, {spine_, 1.0F}};
  const BoneMask mask("arm", skeleton_, weights);
  EXPECT_EQ(mask.weight(0), 0.0F);
  EXPECT_EQ(mask.weight(spine_), 1.0F);
  for (int bone = 0; bone < 62; ++bone) {
    EXPECT_EQ(mask.weight(bone) == 0.5F, is_below(bone, shoulder)) << bone;
  }
}

TEST_F(BoneMaskOf62, LiesInPacketsWithNothingAboveTheLastBone) {
  const SubtreeWeight all[] = {{0, 1.0F}};
  const BoneMask mask("all", skeleton_, all);
  EXPECT_EQ(mask.packets(), 4);
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(mask.packet(0)) % 64, 0U);
  EXPECT_EQ(mask.packet(3), mask.packet(0) + 3 * packet_bones);
  EXPECT_EQ(mask.packet(3)[13], 1.0F);
  EXPECT_EQ(mask.packet(3)[14], 0.0F);
  EXPECT_EQ(mask.packet(3)[15], 0.0F);
}

TEST_F(BoneMaskOf62, FindsNoBoneOfAnUnknownName) { EXPECT_EQ(find_bone(skeleton_, "tentacle"), -1); }

}  // namespace
}  // namespace throng::anim::bone_mask_test
