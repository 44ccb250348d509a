#include "engine/anim/kernel/keyframe/keyframe_player.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "engine/anim/asset/reference_pose.h"
#include "engine/anim/asset/synthetic_model.h"
#include "tests/anim/asset/clip_fixtures.h"

namespace throng::anim::keyframe_player_test {
namespace {

constexpr double seconds = 3.0;

bool same_bits(std::span<const float> a, std::span<const float> b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
}

/// Largest distance of rotations (as chords) and of positions and scales, over all bones.
double distance_from_definition(const Skeleton& skeleton, const Clip& clip, std::span<const float> pose, double time) {
  double worst = 0.0;
  for (int bone = 0; bone < skeleton.bone_count(); ++bone) {
    const auto b = static_cast<std::size_t>(bone);
    const StateTransform expected = to_state(skeleton, bone, sample_bone(skeleton.bones[b], &clip.tracks[b], time));
    const auto actual = [&](int c) { return static_cast<double>(component_of(pose, skeleton.components(), bone, c)); };
    const glm::dvec4 rotation(actual(0), actual(1), actual(2), actual(3));
    const glm::dvec4 wanted(expected.rotation.x, expected.rotation.y, expected.rotation.z, expected.rotation.w);
    worst = std::max(worst, std::min(glm::length(rotation - wanted), glm::length(rotation + wanted)));
    worst = std::max(worst, glm::length(glm::dvec3(actual(4), actual(5), actual(6)) - expected.position));
    if (skeleton.rigid) continue;
    worst = std::max(worst, glm::length(glm::dvec3(actual(7), actual(8), actual(9)) - expected.scale));
  }
  return worst;
}

struct Rig {
  bool rigid;
  Interpolation interpolation;
};

class EveryInterpolation : public testing::TestWithParam<Rig> {
 protected:
  /// Wild tangents take a spline close to the zero quaternion, where normalising magnifies rounding.
  static double tolerance() { return GetParam().interpolation == Interpolation::cubic_spline ? 1e-5 : 2e-6; }

  Model model_ = GetParam().rigid ? synthetic_model(37, 1) : general_model(37);
  Clip clip_ = wild_clip(model_.skeleton, GetParam().interpolation, seconds, 7);
  AlignedBytes block_ = build_keyframe_stream(model_.skeleton, clip_);
  const KeyframeStream& stream_ = stream_in(block_);
};

TEST_P(EveryInterpolation, AgreesWithTheDefinitionAllAlong) {
  TestPlayer player(stream_);
  for (int i = 0; i <= 997; ++i) {
    const Ticks time = stream_.duration * i / 997;
    ASSERT_LT(distance_from_definition(model_.skeleton, clip_, player.pose_at(time), to_seconds(time)), tolerance())
        << i;
  }
}

TEST_P(EveryInterpolation, ShowsEachKeyAtItsTime) {
  TestPlayer player(stream_);
  for (const float time : clip_.tracks[5].rotation.times) {
    const auto at = static_cast<double>(time);
    EXPECT_LT(distance_from_definition(model_.skeleton, clip_, player.pose_at(to_ticks(at)), at), tolerance());
  }
}

TEST_P(EveryInterpolation, DependsOnTimeAloneWhateverThePath) {
  std::mt19937 random(11);
  TestPlayer wanderer(stream_);
  Ticks time{};
  for (int step = 0; step < 1000; ++step) {
    const auto dice = random() % 8U;
    if (dice < 4) time += Ticks{static_cast<std::int64_t>(random() % 20'000'000U)};   // on, by some frames
    if (dice == 4) time -= Ticks{static_cast<std::int64_t>(random() % 20'000'000U)};  // back a little
    if (dice == 5) time = Ticks{static_cast<std::int64_t>(random())} % (stream_.duration + Ticks{1});  // anywhere
    if (dice == 6) time = stream_.duration;
    if (time > stream_.duration) time -= stream_.duration;  // a loop
    time = std::clamp(time, Ticks{}, stream_.duration);
    TestPlayer fresh(stream_);
    ASSERT_TRUE(same_bits(wanderer.pose_at(time), fresh.pose_at(time))) << "step " << step << ", tick " << time;
    ASSERT_TRUE(std::ranges::equal(wanderer.interpolations(), fresh.interpolations())) << "step " << step;
  }
}

TEST_P(EveryInterpolation, KeepsRotationsUnit) {
  TestPlayer player(stream_);
  for (int i = 0; i <= 200; ++i) {
    const std::vector<float> pose = player.pose_at(stream_.duration * i / 200);
    for (int bone = 0; bone < packets_for(stream_.bone_count) * packet_bones; ++bone) {
      double norm = 0.0;
      for (int c = 0; c < 4; ++c) norm += std::pow(component_of(pose, stream_.components, bone, c), 2);
      ASSERT_NEAR(norm, 1.0, 2e-6);
    }
  }
}

TEST_P(EveryInterpolation, PlaysTheSameFromAnotherPlaceInMemory) {
  const AlignedBytes moved = allocate_aligned(stream_.total_size);
  std::memcpy(moved.get(), block_.get(), stream_.total_size);
  TestPlayer player(stream_);
  TestPlayer elsewhere(stream_in(moved));
  for (int i = 0; i <= 50; ++i) {
    const Ticks time = stream_.duration * i / 50;
    ASSERT_TRUE(same_bits(player.pose_at(time), elsewhere.pose_at(time)));
  }
}

std::string rig_name(const testing::TestParamInfo<Rig>& info) {
  constexpr const char* names[] = {"Step", "Linear", "CubicSpline"};
  return std::string(info.param.rigid ? "Rigid" : "General") + names[static_cast<int>(info.param.interpolation)];
}

INSTANTIATE_TEST_SUITE_P(KeyframePlayer, EveryInterpolation,
                         testing::Values(Rig{true, Interpolation::step}, Rig{true, Interpolation::linear},
                                         Rig{true, Interpolation::cubic_spline}, Rig{false, Interpolation::step},
                                         Rig{false, Interpolation::linear}, Rig{false, Interpolation::cubic_spline}),
                         rig_name);

TEST(KeyframePlayer, NeedsAtMostEightyBytesABone) {
  for (const int bones : {1, 16, 17, 62, 1024}) {
    const auto padded = static_cast<std::size_t>(packets_for(bones) * packet_bones);
    EXPECT_LE(interpolation_bytes(bones, rigid_components), 80 * padded);
    EXPECT_LE(interpolation_bytes(bones, general_components), 128 * padded);
  }
}

/// Two rotation keys a second apart.
BoneTracks turn(const glm::quat& from, const glm::quat& to) {
  BoneTracks tracks;
  tracks.rotation = {.interpolation = Interpolation::linear, .times = {0.0F, 1.0F}, .values = {from, to}};
  return tracks;
}

/// Largest chord between the player's rotation and the definition's, along a turn.
double error_of_turn(const glm::quat& from, const glm::quat& to) {
  const Model model = one_bone_model();
  const Clip clip = one_bone_clip(turn(from, to), 1.0);
  const AlignedBytes block = build_keyframe_stream(model.skeleton, clip);
  TestPlayer player(stream_in(block));
  double worst = 0.0;
  for (int i = 0; i <= 100; ++i) {
    const Ticks time = ticks_per_second * i / 100;
    worst = std::max(worst, distance_from_definition(model.skeleton, clip, player.pose_at(time), to_seconds(time)));
  }
  return worst;
}

TEST(KeyframePlayer, TurnsThroughEveryAngleAsSlerpDoes) {
  const glm::vec3 axis = glm::normalize(glm::vec3(1.0F, 2.0F, -0.5F));
  for (float degrees = 1e-5F; degrees < 359.0F; degrees = degrees * 1.07F + 1e-5F) {
    const glm::quat to = glm::angleAxis(glm::radians(degrees), axis);
    ASSERT_LT(error_of_turn(glm::quat(1.0F, 0.0F, 0.0F, 0.0F), to), 4e-7) << degrees;
  }
}

TEST(KeyframePlayer, TakesTheShorterArcBetweenAKeyAndItsNegative) {
  const glm::quat key = glm::angleAxis(0.3F, glm::vec3(0.0F, 1.0F, 0.0F));
  const glm::quat near = glm::angleAxis(0.3001F, glm::vec3(0.0F, 1.0F, 0.0F));
  EXPECT_LT(error_of_turn(key, -near), 4e-7);
  EXPECT_LT(error_of_turn(-key, near), 4e-7);
}

TEST(KeyframePlayer, CountsAZeroDotProductAsPositive) {
  const glm::quat none(1.0F, 0.0F, 0.0F, 0.0F);
  EXPECT_LT(error_of_turn(none, glm::quat(0.0F, 1.0F, 0.0F, 0.0F)), 4e-7);
  EXPECT_LT(error_of_turn(none, glm::quat(0.0F, -1.0F, 0.0F, 0.0F)), 4e-7);
}

TEST(KeyframePlayer, HoldsTheNearestKeyOutsideATrack) {
  const Model model = one_bone_model();
  BoneTracks tracks;
  tracks.translation = {.interpolation = Interpolation::linear,
                        .times = {0.5F, 0.75F},
                        .values = {glm::vec3(1.0F, 2.0F, 3.0F), glm::vec3(4.0F, 5.0F, 6.0F)}};
  const AlignedBytes block = build_keyframe_stream(model.skeleton, one_bone_clip(tracks, 1.0));
  TestPlayer player(stream_in(block));
  EXPECT_EQ(component_of(player.pose_at(Ticks{}), rigid_components, 0, 4), 1.0F);
  EXPECT_EQ(component_of(player.pose_at(ticks_per_second), rigid_components, 0, 6), 6.0F);
}

TEST(KeyframePlayer, JumpsBetweenKeysThatShareAnInstant) {
  const Model model = one_bone_model();
  const float late = 0.001F;
  BoneTracks tracks;
  tracks.translation = {.interpolation = Interpolation::linear,
                        .times = {0.0F, late, std::nextafter(late, 1.0F), 1.0F},
                        .values = {glm::vec3(0.0F), glm::vec3(0.0F), glm::vec3(5.0F), glm::vec3(5.0F)}};
  const AlignedBytes block = build_keyframe_stream(model.skeleton, one_bone_clip(tracks, 1.0));
  TestPlayer player(stream_in(block));
  EXPECT_FLOAT_EQ(component_of(player.pose_at(to_ticks(0.0009)), rigid_components, 0, 4), 0.0F);
  EXPECT_FLOAT_EQ(component_of(player.pose_at(to_ticks(0.0011)), rigid_components, 0, 4), 5.0F);
}

TEST(KeyframePlayer, PlaysHoursWithoutLosingKeys) {
  const Model model = one_bone_model();
  const auto ramp = [](float time) { return glm::vec3(std::fmod(time, 7.0F), 0.0F, 0.0F); };
  BoneTracks tracks;
  tracks.translation = sampled_track(ramp, 0.1, 1000);
  const AlignedBytes block = build_keyframe_stream(model.skeleton, one_bone_clip(tracks, 10'000.0));
  TestPlayer player(stream_in(block));
  for (int key = 0; key <= 1000; key += 37) {
    const float time = tracks.translation.times[static_cast<std::size_t>(key)];
    const float shown = component_of(player.pose_at(to_ticks(static_cast<double>(time))), rigid_components, 0, 4);
    EXPECT_NEAR(shown, ramp(time).x, 1e-5F);
  }
}

}  // namespace
}  // namespace throng::anim::keyframe_player_test
