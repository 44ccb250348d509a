#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/anim/asset/reference_pose.h"
#include "engine/anim/asset/synthetic_model.h"
#include "engine/anim/bake/character.h"
#include "engine/anim/bake/surface.h"
#include "engine/anim/kernel/kernels.h"
#include "tests/anim/asset/clip_fixtures.h"

namespace throng::anim::bake_test {
namespace {

using testing::HasSubstr;

BakedClip bake_one(Model model, const BoneTracks& tracks, double seconds, const BakeOptions& options = {}) {
  model.clips.push_back(one_bone_clip(tracks, seconds));
  return std::move(bake_character(model, options).clips.front());
}

/// Swings the bone about x, whole times in `frames` keys at 30 Hz.
BoneTracks swing(float reach, int frames, Interpolation interpolation = Interpolation::linear) {
  BoneTracks tracks;
  tracks.rotation.interpolation = interpolation;
  for (int frame = 0; frame <= frames; ++frame) {
    const float turn = static_cast<float>(frame % frames) / static_cast<float>(frames);
    tracks.rotation.times.push_back(static_cast<float>(frame) / 30.0F);
    tracks.rotation.values.push_back(
        glm::angleAxis(reach * std::sin(2.0F * std::numbers::pi_v<float> * turn), glm::vec3(1.0F, 0.0F, 0.0F)));
  }
  return tracks;
}

TEST(Bake, MeasuresHeightOnTheSurface) { EXPECT_NEAR(bake_character(rod_model()).height, 1.8, 1e-6); }

TEST(Bake, MeasuresHeightOnJointsWhereThereIsNoSurface) {
  EXPECT_NEAR(bake_character(synthetic_model(62, 1)).height, 1.8, 0.4);
}

TEST(Bake, GivesAModelWithoutClipsItsRestPose) {
  const Character character = bake_character(rod_model());
  ASSERT_EQ(character.clips.size(), 1U);
  EXPECT_EQ(character.clips.front().name, "rest");
  EXPECT_EQ(character.clips.front().duration, Ticks{});
  ASSERT_NE(character.clips.front().sampled(), nullptr);
  EXPECT_EQ(character.clips.front().sampled()->row_count, 1);
}

TEST(Bake, KeepsDataKeysByTimeAndEachNameOnceForTheCharacter) {
  Model model = rod_model();
  for (int clip = 0; clip < 2; ++clip) model.clips.push_back(one_bone_clip(swing(0.1F, 30), 1.0));
  model.clips[0].data_keys = {{.time = 0.25, .name = "left"}, {.time = 0.75, .name = "right"}};
  model.clips[1].data_keys = {{.time = 0.5, .name = "right"}, {.time = 1.0, .name = "clap"}};
  const Character character = bake_character(model);
  EXPECT_EQ(character.data_key_names, (std::vector<std::string>{"left", "right", "clap"}));
  ASSERT_EQ(character.clips[1].data_keys.size(), 2U);
  EXPECT_EQ(character.clips[0].data_keys[1].name, 1U);
  EXPECT_EQ(character.clips[1].data_keys[0].name, 1U);
  EXPECT_EQ(character.clips[1].data_keys[0].time, ticks_per_second / 2);
  EXPECT_EQ(character.clips[1].data_keys[1].time, character.clips[1].duration);
}

TEST(Bake, SamplesAtTheClipsOwnGrid) {
  const BakedClip clip = bake_one(rod_model(), swing(0.1F, 30), 1.0);
  EXPECT_EQ(clip.sampled_rate, 30.0);
  ASSERT_NE(clip.sampled(), nullptr);
  EXPECT_EQ(clip.sampled()->step_count, 30);
  EXPECT_EQ(Ticks{clip.sampled()->step_ticks}, ticks_per_second / 30);
  EXPECT_LE(clip.sampled_error, clip.error_bound);
  EXPECT_NEAR(clip.error_bound, 0.0002, 1e-9);
  EXPECT_EQ(clip.note, "");
}

TEST(Bake, PutsRowsOnThePhaseOfTheKeys) {
  BoneTracks tracks = swing(0.1F, 30);
  for (float& time : tracks.rotation.times) time += 0.0123F;
  const BakedClip clip = bake_one(rod_model(), tracks, 1.0123);
  ASSERT_NE(clip.sampled(), nullptr);
  EXPECT_EQ(clip.sampled_rate, 30.0);
  EXPECT_NEAR(to_seconds(clip.sampled()->first_row), 0.0123, 1e-6);
}

TEST(Bake, SamplesFastTurnsMoreOftenThanTheirKeys) {
  const BakedClip clip = bake_one(rod_model(), swing(1.2F, 10), 10.0 / 30.0);
  EXPECT_GT(clip.sampled_rate, 30.0);
  EXPECT_EQ(std::fmod(clip.sampled_rate, 30.0), 0.0);
  EXPECT_LE(clip.sampled_error, clip.error_bound) << clip.note;
}

/// The largest distance of the rod's ends between the sampled stream and the definition, seen at many times.
double error_by_definition(const Model& model, const BakedClip& clip) {
  const SampledStream& stream = *clip.sampled();
  alignas(64) float pose[rigid_components * packet_bones];
  double worst = 0.0;
  for (int i = 0; i <= 5000; ++i) {
    const Ticks time = clip.duration * i / 5000;
    scalar_kernels().sample({.stream = &stream, .point = locate(stream, time), .packet = 0, .pose = pose});
    std::vector<BoneFrame> frame(1);
    compute_frames(model.skeleton, pose, frame);
    const glm::dvec3 end = frame[0].origin + frame[0].axes * glm::dvec3(0.0, 1.8, 0.0);
    const ReferencePose reference = reference_pose(model.skeleton, &model.clips.front(), to_seconds(time));
    worst = std::max(worst, glm::distance(end, glm::dvec3(reference.globals[0] * glm::dvec4(0.0, 1.8, 0.0, 1.0))));
  }
  return worst;
}

TEST(Bake, ReportsTheErrorThatThereIs) {
  for (const float reach : {0.05F, 0.4F, 1.0F}) {
    Model model = rod_model();
    model.clips.push_back(one_bone_clip(swing(reach, 20), 20.0 / 30.0));
    const Character character = bake_character(model);
    const BakedClip& clip = character.clips.front();
    ASSERT_NE(clip.sampled(), nullptr);
    const double measured = error_by_definition(model, clip);
    EXPECT_NEAR(clip.sampled_error, measured, 0.1 * measured + 2e-6) << reach;
  }
}

TEST(Bake, PlaysMovingStepTracksFromTheirKeys) {
  const BakedClip clip = bake_one(rod_model(), swing(0.3F, 30, Interpolation::step), 1.0);
  EXPECT_EQ(clip.sampled(), nullptr);
  EXPECT_THAT(clip.note, HasSubstr("a STEP track moves it by"));
}

TEST(Bake, PlaysUnevenKeysFromTheirKeys) {
  BoneTracks tracks = swing(0.3F, 30);
  for (float& time : tracks.rotation.times) time = std::sqrt(time);
  const BakedClip clip = bake_one(rod_model(), tracks, 1.0);
  EXPECT_EQ(clip.sampled(), nullptr);
  EXPECT_THAT(clip.note, HasSubstr("no grid"));
}

TEST(Bake, PlaysJumpsBetweenNeighbouringInstantsFromTheirKeys) {
  BoneTracks tracks;
  tracks.translation = {Interpolation::linear,
                        {0.0F, 0.5F, std::nextafter(0.5F, 1.0F), 1.0F},
                        {glm::vec3(0.0F), glm::vec3(0.0F), glm::vec3(0.0F, 1.0F, 0.0F), glm::vec3(0.0F)}};
  const BakedClip clip = bake_one(rod_model(), tracks, 1.0);
  EXPECT_EQ(clip.sampled(), nullptr);
  EXPECT_THAT(clip.note, HasSubstr("keyframe stream"));
}

TEST(Bake, KeepsAStillClipInOneRow) {
  BoneTracks tracks;
  tracks.translation = sampled_track([](float) { return glm::vec3(0.1F, 0.2F, 0.3F); }, 30.0, 30);
  const BakedClip clip = bake_one(rod_model(), tracks, 1.0);
  ASSERT_NE(clip.sampled(), nullptr);
  EXPECT_EQ(clip.sampled()->row_count, 1);
  EXPECT_LT(clip.sampled_error, 1e-7);
}

/// The rod, swinging, with a position that trembles by `tremble` metres around `x`.
const SampledStream& swing_at(float x, float tremble, BakedClip& clip) {
  BoneTracks tracks = swing(0.1F, 30);
  tracks.translation = sampled_track(
      [=](float seconds) { return glm::vec3(x + tremble * std::sin(20.0F * seconds), 0.0F, 0.0F); }, 30.0, 30);
  clip = bake_one(rod_model(), tracks, 1.0);
  return *clip.sampled();
}

TEST(Bake, TakesAMicrometreOffTheBindPoseForTheRoundingOfKeys) {
  BakedClip clip;
  EXPECT_EQ(swing_at(0.5e-6F, 0.5e-6F, clip).displaced_quads, 0U);
  EXPECT_GT(clip.sampled_error, 0.0);
}

TEST(Bake, KeepsBonesThatRoundingMovesWhereTheyStand) {
  BakedClip clip;
  const SampledPacket& packet = swing_at(0.1F, 0.5e-6F, clip).packets()[0];
  EXPECT_LT(packet.position_offset[0], 0);
  EXPECT_NEAR(packet.at<QuadRange>(packet.position_range[0]).base[0], 0.1F, 1e-6F);
}

TEST(Bake, KeepsATwentiethOfAMillimetre) {
  BakedClip clip;
  EXPECT_EQ(swing_at(5e-5F, 0.0F, clip).displaced_quads, 1U);
  EXPECT_GE(swing_at(0.0F, 5e-5F, clip).packets()[0].position_offset[0], 0);
}

TEST(Bake, KnowsALoopByItsSeam) { EXPECT_TRUE(bake_one(rod_model(), swing(0.3F, 30), 1.0).loops); }

TEST(Bake, SaysThatALastKeyOneStepEarlyMakesNoLoop) {
  BoneTracks tracks = swing(0.3F, 30);
  tracks.rotation.times.pop_back();
  tracks.rotation.values.pop_back();
  const BakedClip clip = bake_one(rod_model(), tracks, 29.0 / 30.0);
  EXPECT_FALSE(clip.loops);
  EXPECT_THAT(clip.note, HasSubstr("one step before its first"));
}

TEST(Bake, TakesAFallForNoLoop) {
  BoneTracks tracks = swing(1.5F, 120);
  tracks.rotation.times.resize(31);
  tracks.rotation.values.resize(31);
  const BakedClip clip = bake_one(rod_model(), tracks, 1.0);
  EXPECT_FALSE(clip.loops);
  EXPECT_EQ(clip.note, "");
}

}  // namespace
}  // namespace throng::anim::bake_test
