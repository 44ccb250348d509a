#include "engine/anim/asset/closed_loops.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace throng::anim::closed_loops_test {
namespace {

using testing::ElementsAre;

Track<glm::vec3> moved(std::vector<float> times) {
  Track<glm::vec3> track{.interpolation = Interpolation::linear, .times = std::move(times), .values = {}};
  for (const float time : track.times) track.values.emplace_back(time, 0.0F, 0.0F);
  return track;
}

Clip clip_of(Track<glm::vec3> track) {
  Clip clip;
  clip.duration = 0.75;
  BoneTracks tracks;
  tracks.translation = std::move(track);
  clip.tracks.push_back(std::move(tracks));
  return clip;
}

TEST(CloseLoop, ComesBackToTheFirstKeyOneStepLater) {
  Clip clip = clip_of(moved({0.0F, 0.25F, 0.5F, 0.75F}));
  close_loop(clip, 0.25);
  EXPECT_THAT(clip.tracks[0].translation.times, ElementsAre(0.0F, 0.25F, 0.5F, 0.75F, 1.0F));
  EXPECT_EQ(clip.tracks[0].translation.values.back(), clip.tracks[0].translation.values.front());
  EXPECT_EQ(clip.duration, 1.0);
}

TEST(CloseLoop, LetsATrackThatEndsEarlyStandStillUntilThen) {
  Clip clip = clip_of(moved({0.0F, 0.25F}));
  close_loop(clip, 0.25);
  EXPECT_THAT(clip.tracks[0].translation.times, ElementsAre(0.0F, 0.25F, 0.75F, 1.0F));
  EXPECT_EQ(clip.tracks[0].translation.values[2], clip.tracks[0].translation.values[1]);
  EXPECT_EQ(clip.tracks[0].translation.values[3], clip.tracks[0].translation.values[0]);
}

TEST(CloseLoop, RepeatsTheTangentsOfACubicKeyAndTheWeightsOfMorphs) {
  Track<glm::vec3> track{.interpolation = Interpolation::cubic_spline, .times = {0.0F, 0.75F}, .values = {}};
  for (int value = 0; value < 6; ++value) track.values.emplace_back(static_cast<float>(value));
  Clip clip = clip_of(std::move(track));
  clip.morph_tracks = {{.morphs = {0, 1}, .times = {0.0F, 0.75F}, .weights = {1.0F, 2.0F, 3.0F, 4.0F}}};
  clip.curves = {{.name = "glow", .times = {0.0F, 0.75F}, .values = {5.0F, 6.0F}}};
  close_loop(clip, 0.25);
  ASSERT_EQ(clip.tracks[0].translation.values.size(), 9U);
  EXPECT_EQ(clip.tracks[0].translation.values[6].x, 0.0F);
  EXPECT_EQ(clip.tracks[0].translation.values[8].x, 2.0F);
  EXPECT_THAT(clip.morph_tracks[0].weights, ElementsAre(1.0F, 2.0F, 3.0F, 4.0F, 1.0F, 2.0F));
  EXPECT_THAT(clip.curves[0].values, ElementsAre(5.0F, 6.0F, 5.0F));
}

TEST(CloseLoop, ClosesRotationsAndScalesToo) {
  Clip clip = clip_of({});
  clip.tracks[0].scale = moved({0.0F, 0.75F});
  clip.tracks[0].rotation = {.interpolation = Interpolation::linear, .times = {0.0F, 0.75F}, .values = {{}, {}}};
  close_loop(clip, 0.25);
  EXPECT_THAT(clip.tracks[0].scale.times, ElementsAre(0.0F, 0.75F, 1.0F));
  EXPECT_THAT(clip.tracks[0].rotation.times, ElementsAre(0.0F, 0.75F, 1.0F));
}

TEST(CloseLoop, LeavesBonesWithoutKeysAlone) {
  Clip clip = clip_of({});
  close_loop(clip, 0.25);
  EXPECT_TRUE(clip.tracks[0].translation.empty());
}

}  // namespace
}  // namespace throng::anim::closed_loops_test
