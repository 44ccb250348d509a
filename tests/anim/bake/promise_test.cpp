// A sampled clip is never farther off its keys than 0.2 mm for a person of 1.8 m.
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/anim/asset/encode_rows.h"
#include "engine/anim/asset/synthetic_model.h"
#include "engine/anim/bake/character.h"
#include "engine/anim/bake/rounding.h"
#include "engine/anim/bake/sampled.h"
#include "engine/anim/bake/sampled_error.h"
#include "tests/anim/asset/clip_fixtures.h"
#include "tests/anim/bake/definition_error.h"

namespace throng::anim::promise_test {
namespace {

using testing::HasSubstr;

constexpr int joints = 60;

/// A chain of 60 joints, 1.8 m long in all, like a tail.
Model tail() {
  Model model = one_bone_model();
  Skeleton& skeleton = model.skeleton;
  constexpr double length = 1.8 / joints;
  for (int joint = 1; joint < joints; ++joint) {
    Bone bone{.name = std::to_string(joint), .parent = joint - 1, .rest = {}};
    bone.rest.translation = glm::vec3(0.0F, static_cast<float>(length), 0.0F);
    skeleton.bones.push_back(bone);
    skeleton.references.push_back({.origin = {0.0, length * joint, 0.0}});
    skeleton.palette.push_back({.bone = joint});
  }
  skeleton.level_bone_counts = {joints};
  return model;
}

/// Every joint turns slowly about an axis of its own, in keys at 30 Hz.
Clip slow_waves() {
  std::mt19937 random(7);
  const auto part = [&] { return static_cast<float>(random() % 1000U) / 1000.0F - 0.5F; };
  Clip clip{.name = "waves", .duration = 1.0, .tracks = {}};
  for (int joint = 0; joint < joints; ++joint) {
    BoneTracks tracks;
    tracks.bone = joint;
    const glm::vec3 axis = glm::normalize(glm::vec3(part(), part(), part()) + glm::vec3(0.01F));
    for (int frame = 0; frame <= 30; ++frame) {
      const double turn = 2.0 * std::numbers::pi * frame / 30.0;
      tracks.rotation.times.push_back(static_cast<float>(frame) / 30.0F);
      tracks.rotation.values.push_back(glm::angleAxis(0.03F * static_cast<float>(std::sin(turn + joint)), axis));
    }
    clip.tracks.push_back(std::move(tracks));
  }
  return clip;
}

/// A rod of 1.8 m that swings there and back in `frames` keys at 30 Hz.
Model swinging_rod(double reach, int frames) {
  Model model = rod_model();
  BoneTracks tracks;
  for (int frame = 0; frame <= frames; ++frame) {
    tracks.rotation.times.push_back(static_cast<float>(frame) / 30.0F);
    tracks.rotation.values.push_back(
        glm::angleAxis(static_cast<float>(frame % 2 == 0 ? 0.0 : reach), glm::vec3(1.0F, 0.0F, 0.0F)));
  }
  model.clips.push_back(one_bone_clip(tracks, frames / 30.0));
  return model;
}

TEST(Promise, IsKeptByALongChainThatRoundingBends) {
  Model model = tail();
  model.clips.push_back(slow_waves());
  const Character character = bake_character(model);
  const BakedClip& clip = character.clips.front();
  ASSERT_NE(clip.sampled(), nullptr) << clip.note;
  EXPECT_EQ(clip.sampled_rate, 30.0) << "finer sampling does not mend rounding";
  EXPECT_EQ(clip.sampled_rounding, Rounding::carried);
  EXPECT_LE(clip.sampled_error, clip.error_bound);
  EXPECT_LE(error_by_definition(model, model.clips.front(), clip, 1200), clip.error_bound);
}

TEST(Promise, IsKeptByATurnThatNeedsMoreThan120Hz) {
  const Model model = swinging_rod(1.4, 8);
  const Character character = bake_character(model);
  const BakedClip& clip = character.clips.front();
  ASSERT_NE(clip.sampled(), nullptr) << clip.note;
  EXPECT_GT(clip.sampled_rate, 120.0);
  EXPECT_LE(error_by_definition(model, model.clips.front(), clip, 4000), clip.error_bound);
}

TEST(Promise, IsKeptFromKeysWhereNoRateDoes) {
  const Model model = swinging_rod(3.0, 8);
  const Character character = bake_character(model);
  const BakedClip& clip = character.clips.front();
  EXPECT_EQ(clip.sampled(), nullptr);
  EXPECT_THAT(clip.note, HasSubstr("sampled at up to 240 Hz it would be at least"));
  EXPECT_LE(error_by_definition(model, model.clips.front(), clip, 4000), 0.01 * clip.error_bound);
}

TEST(Promise, IsMeasuredAtTheWorstInstant) {
  for (const double reach : {0.3, 0.45, 0.6, 0.75, 0.9}) {
    const Model model = swinging_rod(reach, 8);
    const Character character = bake_character(model);
    const BakedClip& clip = character.clips.front();
    ASSERT_NE(clip.sampled(), nullptr) << clip.note;
    EXPECT_GE(clip.sampled_error, 0.995 * error_by_definition(model, model.clips.front(), clip, 20'000)) << reach;
  }
}

TEST(CarriedRounding, ErrsLessThanHalfAsMuchAtTheEndOfAChain) {
  Model model = tail();
  model.clips.push_back(slow_waves());
  const Character character = bake_character(model);
  const BakedClip& clip = character.clips.front();
  const SurfaceProxy proxy = make_surface_proxy(model);
  const SampleSource source{character.skeleton, proxy, *clip.keyframe(), {}, clip.error_bound};
  const auto error = [&](Rounding rounding) {
    const AlignedBytes block = sample_as(source, *clip.sampled(), rounding);
    return measure_error(source, *reinterpret_cast<const SampledStream*>(block.get()));
  };
  EXPECT_LT(error(Rounding::carried), 0.5 * error(Rounding::nearest));
}

TEST(CarriedRounding, HoldsOnTheGeneralPathToo) {
  Model model = general_model(40);
  model.clips.assign(1, wild_clip(model.skeleton, Interpolation::linear, 1.0, 3));
  const AlignedBytes keys = build_keyframe_stream(model.skeleton, model.clips.front());
  const SurfaceProxy proxy = make_surface_proxy(model);
  const SampleSource source{model.skeleton, proxy, stream_in(keys), {}, 0.0002};
  SampledRows rows{.bone_count = 40,
                   .components = general_components,
                   .step = ticks_per_second / 240,
                   .row_count = 241,
                   .gaps = {},
                   .rows = {}};
  ExactPoses poses(source.exact);
  for (int row = 0; row < rows.row_count; ++row) {
    const auto pose = poses.at(row * rows.step);
    rows.rows.insert(rows.rows.end(), pose.begin(), pose.end());
  }
  const AlignedBytes block = encode_rows(rows, ticks_per_second);
  auto& stream = *reinterpret_cast<SampledStream*>(block.get());
  const auto on_rows = [&] {
    double worst = 0.0;
    std::vector<BoneFrame> expected(40), shown(40);
    alignas(64) std::array<float, 3 * general_components * packet_bones> pose{};
    for (int row = 0; row < rows.row_count; ++row) {
      const Ticks time = row * rows.step;
      compute_frames(model.skeleton, poses.at(time), expected);
      for (int packet = 0; packet < 3; ++packet) {
        float* const out = pose.data() + packet * general_components * packet_bones;
        scalar_kernels().sample({.stream = &stream, .point = locate(stream, time), .packet = packet, .pose = out});
      }
      compute_frames(model.skeleton, pose, shown);
      worst = std::max(worst, largest_distance(proxy, expected, shown));
    }
    return worst;
  };
  const double nearest = on_rows();
  carry_rounding(model.skeleton, rows, stream);
  EXPECT_LT(on_rows(), 0.9 * nearest);
}

}  // namespace
}  // namespace throng::anim::promise_test
