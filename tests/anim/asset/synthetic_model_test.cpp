#include "engine/anim/asset/synthetic_model.h"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "engine/anim/asset/reference_pose.h"
#include "engine/anim/bake/character.h"

namespace throng::anim::synthetic_model_test {
namespace {

class SyntheticModel : public testing::TestWithParam<int> {
 protected:
  Model model_ = synthetic_model(GetParam(), 2);
  const Skeleton& skeleton_ = model_.skeleton;
};

TEST_P(SyntheticModel, HasTheBonesAskedForParentsFirst) {
  ASSERT_EQ(skeleton_.bone_count(), GetParam());
  EXPECT_EQ(skeleton_.palette_count(), GetParam());
  EXPECT_EQ(static_cast<int>(skeleton_.references.size()), GetParam());
  EXPECT_EQ(skeleton_.bones.front().parent, -1);
  std::set<std::string> names;
  for (int bone = 0; bone < GetParam(); ++bone) {
    const Bone& own = skeleton_.bones[static_cast<std::size_t>(bone)];
    EXPECT_LT(own.parent, bone);
    EXPECT_EQ(skeleton_.palette[static_cast<std::size_t>(bone)].bone, bone);
    names.insert(own.name);
  }
  EXPECT_EQ(static_cast<int>(names.size()), GetParam());
}

TEST_P(SyntheticModel, HasLevelsThatArePrefixes) {
  const std::vector<int>& levels = skeleton_.level_bone_counts;
  ASSERT_GE(levels.size(), 1U);
  ASSERT_LE(levels.size(), static_cast<std::size_t>(max_bone_levels));
  EXPECT_EQ(levels.front(), GetParam());
  EXPECT_TRUE(std::ranges::is_sorted(levels, std::ranges::greater()));
  EXPECT_GE(levels.back(), 1);
}

TEST_P(SyntheticModel, IsBoundInItsRestPose) {
  const ReferencePose rest = reference_pose(skeleton_, nullptr, 0.0);
  for (std::size_t bone = 0; bone < skeleton_.bones.size(); ++bone) {
    EXPECT_LT(glm::distance(glm::dvec3(rest.globals[bone][3]), skeleton_.references[bone].origin), 1e-5);
    const StateTransform state = to_state(skeleton_, static_cast<int>(bone), rest.locals[bone]);
    EXPECT_NEAR(std::abs(state.rotation.w), 1.0, 1e-9);
    EXPECT_LT(glm::length(state.position), 1e-6);
  }
}

TEST_P(SyntheticModel, TurnsEveryBoneAndMovesTheRootAlone) {
  for (const Clip& clip : model_.clips) {
    ASSERT_EQ(static_cast<int>(clip.tracks.size()), GetParam());
    for (const BoneTracks& tracks : clip.tracks) {
      EXPECT_NE(tracks.rotation.values.front(), tracks.rotation.values[tracks.rotation.values.size() / 3]);
      EXPECT_EQ(tracks.rotation.values.front(), tracks.rotation.values.back()) << "the clip must loop";
      EXPECT_EQ(tracks.translation.empty(), tracks.bone != 0);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, SyntheticModel, testing::Values(1, 2, 5, 16, 21, 62, 67, 300, max_bones));

TEST(SyntheticModel, IsTheSameFromTheSameSeedOnly) {
  const Model model = synthetic_model(20, 2, 5);
  const Model again = synthetic_model(20, 2, 5);
  const Model other = synthetic_model(20, 2, 6);
  const auto key = [](const Model& m, std::size_t clip) { return m.clips[clip].tracks[7].rotation.values[4]; };
  EXPECT_EQ(key(model, 0), key(again, 0));
  EXPECT_NE(key(model, 0), key(other, 0));
  EXPECT_NE(key(model, 0), key(model, 1));
}

TEST(SyntheticModel, IsSampledAtItsOwnThirtyHertzAndLoops) {
  const Character character = bake_character(synthetic_model(62, 3));
  for (const BakedClip& clip : character.clips) {
    EXPECT_TRUE(clip.loops) << clip.note;
    ASSERT_NE(clip.sampled(), nullptr) << clip.note;
    EXPECT_DOUBLE_EQ(std::fmod(clip.sampled_rate, 30.0), 0.0);
    EXPECT_EQ(clip.loop_displacement, glm::dvec3(0.0));
  }
}

}  // namespace
}  // namespace throng::anim::synthetic_model_test
