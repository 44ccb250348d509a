// Tracks that hardly move are constants, whatever their interpolation: Blender writes STEP for all that stands still.
#include "engine/anim/bake/still_tracks.h"

#include <cmath>
#include <numbers>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/anim/asset/synthetic_model.h"
#include "engine/anim/bake/character.h"
#include "tests/anim/asset/clip_fixtures.h"
#include "tests/anim/bake/definition_error.h"

namespace throng::anim::still_tracks_test {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;

constexpr int frames = 30;
const glm::vec3 x_axis(1.0F, 0.0F, 0.0F);

/// Frames 0 to 30 at 30 Hz.
std::vector<float> frame_times() {
  std::vector<float> times;
  for (int frame = 0; frame <= frames; ++frame) times.push_back(static_cast<float>(frame) / 30.0F);
  return times;
}

/// Turns by a tenth of a radian and back.
Track<glm::quat> sway() {
  Track<glm::quat> track{.times = frame_times(), .values = {}};
  for (int frame = 0; frame <= frames; ++frame) {
    const double turn = 2.0 * std::numbers::pi * frame / frames;
    track.values.push_back(glm::angleAxis(static_cast<float>(0.1 * std::sin(turn)), x_axis));
  }
  return track;
}

/// Turns to and fro by `angle` from frame to frame.
Track<glm::quat> trembling(float angle, Interpolation interpolation = Interpolation::step) {
  Track<glm::quat> track{.interpolation = interpolation, .times = frame_times(), .values = {}};
  for (int frame = 0; frame <= frames; ++frame) {
    track.values.push_back(glm::angleAxis(frame % 2 == 0 ? 0.0F : angle, x_axis));
  }
  return track;
}

/// Moves to and fro by `metres` from frame to frame.
Track<glm::vec3> stepping(const glm::vec3& around, float metres) {
  Track<glm::vec3> track{.interpolation = Interpolation::step, .times = frame_times(), .values = {}};
  for (int frame = 0; frame <= frames; ++frame) {
    track.values.push_back(around + glm::vec3(frame % 2 == 0 ? 0.0F : metres, 0.0F, 0.0F));
  }
  return track;
}

/// A rig of 20 bones, 1.8 m tall or so, whose root sways, and whose last bone has `tracks`.
Model swaying(BoneTracks tracks) {
  Model model = synthetic_model(20, 1);
  Clip clip{.name = "sway", .duration = 1.0, .tracks = {}};
  clip.tracks.push_back({.bone = 0, .translation = {}, .rotation = sway(), .scale = {}});
  tracks.bone = 19;
  clip.tracks.push_back(std::move(tracks));
  model.clips.assign(1, clip);
  return model;
}

Model with_steps_of(float metres) {
  const glm::vec3 rest = synthetic_model(20, 1).skeleton.bones[19].rest.translation;
  return swaying({.translation = stepping(rest, metres), .rotation = {}, .scale = {}});
}

TEST(StillTracks, ThatStepByATenThousandthOfARadianAreSampled) {
  const Model model = swaying({.translation = {}, .rotation = trembling(1e-4F), .scale = {}});
  const Character character = bake_character(model);
  const BakedClip& clip = character.clips.front();
  ASSERT_NE(clip.sampled(), nullptr) << clip.note;
  EXPECT_EQ(clip.note, "");
  EXPECT_GT(clip.keyframe_error, 0.0);
  EXPECT_LE(error_by_definition(model, model.clips.front(), clip, 3000), clip.sampled_error + 2e-6);
}

TEST(StillTracks, AreConstantsInBothStreams) {
  const Character still = bake_character(swaying({}));
  for (const Interpolation interpolation : {Interpolation::step, Interpolation::linear}) {
    const Model model = swaying({.translation = {}, .rotation = trembling(5e-5F, interpolation), .scale = {}});
    const Character character = bake_character(model);
    EXPECT_EQ(character.clips[0].keyframe()->track_count, 1U);
    EXPECT_EQ(character.clips[0].sampled()->total_size, still.clips[0].sampled()->total_size);
  }
}

TEST(StillTracks, ThatFlatCubicSplinesMakeAreConstants) {
  Track<glm::quat> flat{.interpolation = Interpolation::cubic_spline, .times = frame_times(), .values = {}};
  for (int frame = 0; frame <= frames; ++frame) {
    const glm::quat tangent(0.0F, 1e-4F, 0.0F, 0.0F);  // a third of it in a thirtieth of a second is a microradian
    flat.values.insert(flat.values.end(), {tangent, glm::quat(1.0F, 0.0F, 0.0F, 0.0F), tangent});
  }
  const Character character = bake_character(swaying({.translation = {}, .rotation = flat, .scale = {}}));
  EXPECT_EQ(character.clips[0].keyframe()->track_count, 1U);
}

TEST(StillTracks, KeepCubicSplinesThatBulgeBetweenEqualKeys) {
  const Track<glm::quat> bulging{.interpolation = Interpolation::cubic_spline,
                                 .times = {0.0F, 1.0F},
                                 .values = {glm::quat(0, 0, 0, 0), glm::quat(1, 0, 0, 0), glm::quat(0, 1, 0, 0),
                                            glm::quat(0, 1, 0, 0), glm::quat(1, 0, 0, 0), glm::quat(0, 0, 0, 0)}};
  const Character character = bake_character(swaying({.translation = {}, .rotation = bulging, .scale = {}}));
  EXPECT_EQ(character.clips[0].keyframe()->track_count, 2U);
}

TEST(StillTracks, OfScalesThatAreOneEverywhereAreConstants) {
  Model model = general_model(20);
  Clip clip{.name = "sway", .duration = 1.0, .tracks = {}};
  const Track<glm::vec3> ones{
      .interpolation = Interpolation::step, .times = frame_times(), .values = std::vector(frames + 1, glm::vec3(1.0F))};
  clip.tracks.push_back({.bone = 0, .translation = {}, .rotation = sway(), .scale = ones});
  Track<glm::vec3> nearly = ones;
  for (std::size_t key = 0; key < nearly.values.size(); key += 2) nearly.values[key] *= 1.0F + 1e-5F;
  clip.tracks.push_back({.bone = 4, .translation = {}, .rotation = {}, .scale = nearly});
  model.clips.assign(1, clip);
  const Character character = bake_character(model);
  EXPECT_EQ(character.clips[0].keyframe()->track_count, 1U);
  EXPECT_NE(character.clips[0].sampled(), nullptr) << character.clips[0].note;
}

TEST(StillTracks, DoNotFreezeAHandWithoutAVertexOfItsOwn) {
  Model model = swaying({.translation = {}, .rotation = sway(), .scale = {}});
  SkinnedMesh mesh;  // skinned to the root alone
  mesh.positions = {glm::vec3(0.0F), glm::vec3(0.0F, 1.8F, 0.0F), glm::vec3(0.1F, 0.9F, 0.0F)};
  mesh.palette_entries.assign(3, glm::u16vec4(0));
  mesh.weights.assign(3, glm::vec4(1.0F, 0.0F, 0.0F, 0.0F));
  mesh.indices = {0, 1, 2};
  model.meshes.push_back(mesh);
  EXPECT_EQ(bake_character(model).clips[0].keyframe()->track_count, 2U);
}

TEST(StillTracks, DoNotFreezeWhatASmallScaleHidesAtFirst) {
  Model model = general_model(20);
  Clip clip{.name = "draws", .duration = 1.0, .tracks = {}};
  Track<glm::vec3> growing{.times = frame_times(), .values = {}};
  for (int frame = 0; frame <= frames; ++frame) {
    growing.values.push_back(glm::vec3(frame == 0 ? 1e-6F : static_cast<float>(frame) / 30.0F));
  }
  clip.tracks.push_back({.bone = 0, .translation = {}, .rotation = sway(), .scale = growing});
  model.clips.assign(1, clip);
  EXPECT_EQ(bake_character(model).clips[0].keyframe()->track_count, 2U);
}

TEST(StillTracks, TogetherMoveTheSurfaceByNoMoreThanTheyMay) {
  Model model = synthetic_model(20, 1);
  Clip clip{.name = "trembles", .duration = 1.0, .tracks = {}};
  for (int bone = 0; bone < 20; ++bone) {
    clip.tracks.push_back({.bone = bone, .translation = {}, .rotation = trembling(2e-5F), .scale = {}});
  }
  const SurfaceProxy proxy = make_surface_proxy(model);
  StateClip state = to_state_space(model.skeleton, clip);
  constexpr double most = 4e-5;
  const double moved = hold_still_tracks(model.skeleton, proxy, most, state);
  EXPECT_GT(moved, 0.0);
  EXPECT_LE(moved, most);
  EXPECT_GT(state.tracks.size(), 0U) << "all of them together move it farther";
  EXPECT_LT(state.tracks.size(), 20U);
}

TEST(StillTracks, OfARootDoNotHideTheTravelOfTheHips) {
  Model model = synthetic_model(20, 1);
  for (std::size_t bone = 2; bone < 20; ++bone) model.skeleton.bones[bone].parent = 1;
  Clip clip{.name = "walk", .duration = 1.0, .tracks = {}};
  const glm::vec3 root = model.skeleton.bones[0].rest.translation, hips = model.skeleton.bones[1].rest.translation;
  clip.tracks.push_back({.bone = 0, .translation = stepping(root, 1e-5F), .rotation = {}, .scale = {}});
  const auto walk = [&](float time) { return hips + glm::vec3(0.0F, 0.0F, 1.5F * time); };
  clip.tracks.push_back({.bone = 1, .translation = sampled_track(walk, 30.0, frames), .rotation = sway(), .scale = {}});
  model.clips.assign(1, clip);
  EXPECT_GT(glm::length(bake_character(model).clips[0].loop_displacement), 1.4);
}

TEST(StillTracks, KeepTheirKeysWhereTheFileIsAskedFor) {
  const Model model = swaying({.translation = {}, .rotation = trembling(1e-4F), .scale = {}});
  const Character character = bake_character(model, {.take_root_motion = false, .as_in_the_file = true});
  EXPECT_EQ(character.clips[0].keyframe()->track_count, 2U);
  EXPECT_EQ(character.clips[0].keyframe_error, 0.0);
}

TEST(Steps, WithinTheErrorBoundAreSampledAndMeasuredOnBothSides) {
  const Model model = with_steps_of(1e-4F);
  const Character character = bake_character(model);
  const BakedClip& clip = character.clips.front();
  ASSERT_NE(clip.sampled(), nullptr) << clip.note;
  EXPECT_GE(clip.sampled_error, 0.99e-4);
  EXPECT_LE(clip.sampled_error, clip.error_bound);
}

TEST(Steps, BeyondTheErrorBoundPlayFromKeysAndAreSaidInMillimetres) {
  const Character large = bake_character(with_steps_of(0.012F));
  EXPECT_EQ(large.clips[0].sampled(), nullptr);
  EXPECT_THAT(large.clips[0].note, HasSubstr("a STEP track moves it by 12 mm"));
  const Character small = bake_character(with_steps_of(4e-4F));
  EXPECT_EQ(small.clips[0].sampled(), nullptr);
  EXPECT_THAT(small.clips[0].note, ContainsRegex("sampled at up to 240 Hz it would be at least 0\\.4[0-9]* mm off"));
}

}  // namespace
}  // namespace throng::anim::still_tracks_test
