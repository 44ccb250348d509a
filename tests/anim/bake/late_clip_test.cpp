// Clips whose first key lies later than 0, as those that begin at Blender's frame 1, play from their first key.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "engine/anim/asset/keyframe_stream_clip.h"
#include "engine/anim/asset/synthetic_model.h"
#include "engine/anim/bake/character.h"
#include "tests/anim/asset/clip_fixtures.h"
#include "tests/anim/bake/definition_error.h"

namespace throng::anim::late_clip_test {
namespace {

constexpr double seconds = 2.0;
constexpr int steps = 60;

/// Travels 2.4 m in two seconds and sways, from `first` on.
glm::vec3 stride(double time) {
  const double turn = 2.0 * std::numbers::pi * time / seconds;
  return {0.05 * std::sin(turn), 1.0 + 0.02 * std::cos(2.0 * turn), 1.2 * time};
}

/// A branching rig whose root strides and whose limbs swing, with its first key at `first` seconds.
Model walker(double begin) {
  const auto first = static_cast<double>(static_cast<float>(begin));  // as a file holds it
  Model model = synthetic_model(20, 1);
  Clip clip{.name = "walk", .start = first, .duration = first + seconds, .tracks = {}};
  clip.data_keys = {{.time = first + 0.25, .name = "left"}, {.time = first + seconds, .name = "end"}};
  for (int bone = 0; bone < 5; ++bone) {
    BoneTracks tracks;
    tracks.bone = bone;
    for (int step = 0; step <= steps; ++step) {
      const double time = seconds * step / steps;
      const double angle = 0.3 * std::sin(2.0 * std::numbers::pi * time / seconds + bone);
      tracks.rotation.times.push_back(static_cast<float>(first + time));
      tracks.rotation.values.push_back(glm::angleAxis(static_cast<float>(angle), glm::vec3(1.0F, 0.0F, 0.0F)));
      if (bone == 0) tracks.translation.values.push_back(stride(time));
    }
    if (bone == 0) tracks.translation.times = tracks.rotation.times;
    clip.tracks.push_back(std::move(tracks));
  }
  model.clips.assign(1, clip);
  return model;
}

class LateClip : public testing::TestWithParam<double> {
 protected:
  Model model_ = walker(GetParam());
  Character character_ = bake_character(model_);
  const BakedClip& clip_ = character_.clips.front();
};

TEST_P(LateClip, IsAsLongAsFromItsFirstKeyToItsLast) {
  EXPECT_NEAR(to_seconds(clip_.duration), seconds, 1e-4);
  EXPECT_TRUE(clip_.loops) << "first and last key agree";
}

TEST_P(LateClip, IsSampledAtItsOwnKeysAlone) {
  ASSERT_NE(clip_.sampled(), nullptr) << clip_.note;
  EXPECT_EQ(clip_.sampled_rate, 30.0);
  EXPECT_EQ(clip_.sampled()->step_count, steps);
}

TEST_P(LateClip, ShowsThePosesOfItsFile) {
  // Floats of seconds are coarse far from 0: 16 microseconds at 200 s, in which the root moves 20 micrometres.
  EXPECT_LT(error_by_definition(model_, model_.clips.front(), clip_, 300), clip_.error_bound + 5e-5);
}

TEST_P(LateClip, TravelsAtItsOwnSpeed) {
  EXPECT_NEAR(glm::length(clip_.loop_displacement), 2.4, 1e-4);
  EXPECT_NEAR(character_.clips[0].ground_speed(), 1.2, 1e-3);
  EXPECT_EQ(clip_.root_motion.duration, clip_.duration);
}

TEST_P(LateClip, HasItsDataKeysAtTheSamePoses) {
  ASSERT_EQ(clip_.data_keys.size(), 2U);
  EXPECT_NEAR(to_seconds(clip_.data_keys[0].time), 0.25, 1e-4);
  EXPECT_EQ(clip_.data_keys[1].time, clip_.duration);
}

TEST_P(LateClip, IsSurveyedWhereItMoves) {
  const Character from_zero = bake_character(walker(0.0));
  EXPECT_NEAR(character_.bounds.reach, from_zero.bounds.reach, 1e-3);
  for (std::size_t level = 0; level < from_zero.bone_lod.level_error_metres.size(); ++level) {
    EXPECT_NEAR(character_.bone_lod.level_error_metres[level], from_zero.bone_lod.level_error_metres[level], 1e-3);
  }
  for (std::size_t span = 0; span < SkipError::spans.size(); ++span) {
    EXPECT_NEAR(character_.skip_errors[0].held[span], from_zero.skip_errors[0].held[span], 1e-3);
  }
}

TEST_P(LateClip, KeepsTheTimeOfItsFileWhereThatIsAskedFor) {
  const double first = model_.clips.front().start;
  const Character unchanged = bake_character(model_, {.take_root_motion = false, .as_in_the_file = true});
  const BakedClip& clip = unchanged.clips.front();
  EXPECT_EQ(clip.duration, key_ticks(first + seconds));
  EXPECT_EQ(clip.data_keys.front().time, key_ticks(first + 0.25));
  ExactPoses poses(*clip.keyframe());
  std::vector<BoneFrame> frames(model_.skeleton.bones.size());
  const double time = first + 0.7;
  compute_frames(model_.skeleton, poses.at(key_ticks(time)), frames);
  const auto expected = frames_by_definition(model_, model_.clips.front(), time);
  EXPECT_LT(glm::distance(frames.back().origin, expected.back().origin), 1e-5);
}

INSTANTIATE_TEST_SUITE_P(FirstKeys, LateClip, testing::Values(0.0, 1.0 / 24.0, 1.0 / 30.0, 100.0, 200.0),
                         [](const auto& first) {
                           return "At" + std::to_string(static_cast<int>(first.param * 1000.0)) + "ms";
                         });

TEST(ClipWithoutLength, StandsInItsOnlyPose) {
  Model model = walker(0.0);
  Clip& clip = model.clips.front();
  clip.start = clip.duration = 5.0;
  for (BoneTracks& tracks : clip.tracks) {
    tracks.translation = {};
    tracks.rotation = {Interpolation::linear, {5.0F}, {glm::angleAxis(0.5F, glm::vec3(0.0F, 0.0F, 1.0F))}};
  }
  const Character character = bake_character(model);
  const BakedClip& baked = character.clips.front();
  EXPECT_EQ(baked.duration, Ticks{});
  ASSERT_NE(baked.sampled(), nullptr) << baked.note;
  EXPECT_LT(error_by_definition(model, clip, baked, 1), baked.error_bound);
}

TEST(ClipOfADayAndMore, PlaysItsTwoSeconds) {
  const Model model = walker(200'000.0);
  EXPECT_NEAR(to_seconds(bake_character(model).clips.front().duration), seconds, 0.05);
}

}  // namespace
}  // namespace throng::anim::late_clip_test
