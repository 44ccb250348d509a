#include "engine/anim/retarget/rig_match.h"

#include <gtest/gtest.h>

#include "engine/anim/asset/bone_mask.h"
#include "tests/anim/retarget/figures.h"

namespace throng::anim::rig_match_test {
namespace {

void expect_match(const RigMatch& match, const Skeleton& from, const Skeleton& to, const char* source,
                  const char* follower) {
  EXPECT_EQ(match.source_of[static_cast<std::size_t>(find_bone(to, follower))], find_bone(from, source)) << follower;
}

TEST(RigMatch, FindsNamesAfterTheirColonWhateverTheirCase) {
  const Skeleton from = figures::person({.prefix = "mixamorig:"});
  Skeleton to = figures::person();
  to.bones[static_cast<std::size_t>(find_bone(to, "root"))].name = "Root";
  const RigMatch match = match_rigs(from, to);
  expect_match(match, from, to, "mixamorig:root", "Root");
  expect_match(match, from, to, "mixamorig:foot.L", "foot.L");
  EXPECT_EQ(match.matched(), to.bone_count());
}

TEST(RigMatch, PutsPartsOfTheBodyBeforeNames) {
  const Skeleton from = figures::person();
  Skeleton to = figures::person();
  const auto rename = [&](const char* old, const char* name) {
    to.bones[static_cast<std::size_t>(find_bone(to, old))].name = name;
  };
  rename("root", "hips#");  // free the name
  const auto hips = static_cast<std::size_t>(find_bone(to, "hips"));
  to.bones[hips].name = "spine#";
  to.bones[hips].role = BodyRole::hips;
  const RigMatch match = match_rigs(from, to);
  EXPECT_EQ(match.source_of[hips], find_bone(from, "hips"));
}

TEST(RigMatch, LeavesOutNamesThatSeveralBonesHave) {
  Skeleton from = figures::person();
  from.bones[0].name = "prop";
  from.bones[2].name = "prop";
  Skeleton to = figures::person();
  to.bones[0].name = "prop";
  EXPECT_EQ(match_rigs(from, to).source_of[0], -1);
}

TEST(KeysFit, WhereOnlyTheRestPoseDiffersThatTheClipReplaces) {
  const Skeleton from = figures::person();
  Skeleton to = figures::person();
  const Clip clip = figures::knee_bend(from);
  const RigMatch match = match_rigs(from, to);
  EXPECT_TRUE(keys_fit(from, to, match, clip));
  to.bones[3].rest.rotation = glm::quat(0.0F, 1.0F, 0.0F, 0.0F);
  EXPECT_TRUE(keys_fit(from, to, match, clip));
  to.bones[3].rest.translation.y += 0.1F;
  EXPECT_FALSE(keys_fit(from, to, match, clip)) << "another length";
}

TEST(KeysFit, WhereAnArmatureStandsStillInTheOtherFile) {
  const Skeleton from = figures::person();
  Skeleton to = from;
  to.bones.front().prefix = glm::dmat4(2.0);
  EXPECT_FALSE(keys_fit(from, to, match_rigs(from, to), figures::knee_bend(from))) << "twice as large";
}

}  // namespace
}  // namespace throng::anim::rig_match_test
