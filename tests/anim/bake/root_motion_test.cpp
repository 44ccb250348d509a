#include <cmath>
#include <cstring>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "engine/anim/asset/reference_pose.h"
#include "engine/anim/asset/synthetic_model.h"
#include "engine/anim/bake/character.h"
#include "engine/anim/bake/surface.h"
#include "engine/anim/kernel/kernels.h"
#include "tests/anim/asset/clip_fixtures.h"
#include "tests/anim/bake/walker_in_place.h"

namespace throng::anim::root_motion_test {
namespace {

constexpr double duration = 2.0;
const glm::dvec3 travel(0.6, 0.0, 2.4);

/// Travels over the ground with a bob and a sway that come back.
glm::vec3 stride(float time) {
  const float turn = 2.0F * std::numbers::pi_v<float> * time / static_cast<float>(duration);
  return glm::vec3(travel) * time / static_cast<float>(duration) +
         glm::vec3(0.03F * std::sin(turn), 1.0F + 0.02F * std::cos(2.0F * turn), 0.05F * std::sin(2.0F * turn));
}

glm::vec3 stride_slope(float time) { return (stride(time + 1e-3F) - stride(time - 1e-3F)) / 2e-3F; }

Track<glm::vec3> cubic_stride(double rate, int steps) {
  const Track<glm::vec3> plain = sampled_track(stride, rate, steps);
  Track<glm::vec3> track{.interpolation = Interpolation::cubic_spline, .times = plain.times, .values = {}};
  for (const float time : track.times) {
    track.values.insert(track.values.end(), {stride_slope(time), stride(time), stride_slope(time)});
  }
  return track;
}

/// The synthetic rig, whose `bone` strides.
Model striding_model(Model model, int bone, const Track<glm::vec3>& track) {
  Clip clip;
  clip.name = "stride";
  clip.duration = duration;
  BoneTracks tracks;
  tracks.bone = bone;
  tracks.translation = track;
  clip.tracks.push_back(tracks);
  model.clips.assign(1, clip);
  return model;
}

/// Largest distance of any joint from where the file puts it, less what the root motion has come to.
double distance_from_pose_in_place(const Model& model, const BakedClip& clip, bool sampled) {
  const Skeleton& skeleton = model.skeleton;
  const std::size_t size = pose_bytes(skeleton.bone_count(), skeleton.components());
  const AlignedBytes bytes = allocate_aligned(size);
  const std::span pose(reinterpret_cast<float*>(bytes.get()), size / sizeof(float));
  TestPlayer player(*clip.keyframe());
  std::vector<BoneFrame> frames(skeleton.bones.size());
  double worst = 0.0;
  for (int i = 0; i <= 400; ++i) {
    const Ticks time = clip.duration * i / 400;
    if (sampled) {
      for (int packet = 0; packet < packets_for(skeleton.bone_count()); ++packet) {
        float* out = pose.data() + static_cast<std::ptrdiff_t>(packet) * skeleton.components() * packet_bones;
        scalar_kernels().sample({clip.sampled(), locate(*clip.sampled(), time), packet, out});
      }
    } else {
      std::ranges::copy(player.pose_at(time), pose.begin());
    }
    compute_frames(skeleton, pose, frames);
    const ReferencePose reference = reference_pose(skeleton, &model.clips.front(), to_seconds(time));
    const glm::dvec3 drift = displacement(clip.root_motion, 0, time * fine_ticks_per_tick, false).translation;
    for (std::size_t bone = 0; bone < frames.size(); ++bone) {
      worst = std::max(worst, glm::distance(frames[bone].origin, glm::dvec3(reference.globals[bone][3]) - drift));
    }
  }
  return worst;
}

class RootMotion : public testing::TestWithParam<bool> {
 protected:
  Model model_ = GetParam() ? synthetic_model(20, 1) : general_model(20);
};

TEST_P(RootMotion, OfALinearTrackIsTakenOutOfBothStreamsExactly) {
  const Model model = striding_model(model_, 0, sampled_track(stride, 30.0, 60));
  const Character character = bake_character(model);
  const BakedClip& clip = character.clips.front();
  EXPECT_LT(glm::distance(clip.loop_displacement, travel), 1e-5);
  EXPECT_TRUE(clip.loops) << "root motion aside, the clip closes";
  EXPECT_LT(distance_from_pose_in_place(model, clip, false), 5e-6);
  ASSERT_NE(clip.sampled(), nullptr) << clip.note;
  EXPECT_LT(distance_from_pose_in_place(model, clip, true), clip.error_bound);
}

TEST_P(RootMotion, OfACubicTrackIsTakenOutOfItsTangentsToo) {
  const Model model = striding_model(model_, 0, cubic_stride(10.0, 20));
  const Character character = bake_character(model);
  const BakedClip& clip = character.clips.front();
  EXPECT_LT(glm::distance(clip.loop_displacement, travel), 1e-5);
  EXPECT_LT(distance_from_pose_in_place(model, clip, false), 5e-6);
  ASSERT_NE(clip.sampled(), nullptr) << clip.note;
  EXPECT_LT(distance_from_pose_in_place(model, clip, true), clip.error_bound);
}

TEST_P(RootMotion, GoesOnWhereTheTrackHoldsItsFirstAndLastKey) {
  const Model model = striding_model(model_, 0, sampled_track(stride, 30.0, 30, 0.51));
  const Character character = bake_character(model);
  const BakedClip& clip = character.clips.front();
  EXPECT_GT(glm::length(clip.loop_displacement), 0.5);
  EXPECT_LT(distance_from_pose_in_place(model, clip, false), 5e-6);
  ASSERT_NE(clip.sampled(), nullptr) << clip.note;
  EXPECT_LT(distance_from_pose_in_place(model, clip, true), clip.error_bound);
}

TEST_P(RootMotion, OfABoneBelowAStillRootIsTakenOutOfTheRoot) {
  Model model = striding_model(model_, 1, sampled_track(stride, 30.0, 60));
  for (std::size_t bone = 2; bone < model.skeleton.bones.size(); ++bone) model.skeleton.bones[bone].parent = 1;
  if (model.skeleton.rigid) {
    for (std::size_t bone = 2; bone < model.skeleton.bones.size(); ++bone) {
      const ReferenceFrame& parent = model.skeleton.references[1];
      const Bone& own = model.skeleton.bones[bone];
      model.skeleton.references[bone].origin = parent.origin + parent.rotation * glm::dvec3(own.rest.translation);
    }
  }
  const Character character = bake_character(model);
  const BakedClip& clip = character.clips.front();
  EXPECT_GT(glm::length(clip.loop_displacement), 2.0);
  EXPECT_LT(distance_from_pose_in_place(model, clip, false), 5e-6);
}

TEST_P(RootMotion, StaysInThePoseWhereItIsNotToBeTaken) {
  const Model model = striding_model(model_, 0, sampled_track(stride, 30.0, 60));
  const Character character = bake_character(model, {.take_root_motion = false});
  EXPECT_EQ(character.clips.front().loop_displacement, glm::dvec3(0.0));
  EXPECT_LT(distance_from_pose_in_place(model, character.clips.front(), false), 5e-6);
}

std::string path_name(const testing::TestParamInfo<bool>& path) { return path.param ? "Rigid" : "General"; }

INSTANTIATE_TEST_SUITE_P(Paths, RootMotion, testing::Bool(), path_name);

TEST(RootMotionOf, ALoopIsWhereTheCurveEnds) {
  const BakedClip clip = std::move(
      bake_character(striding_model(synthetic_model(20, 1), 0, sampled_track(stride, 30.0, 60))).clips.front());
  const FineTicks loop = clip.duration * fine_ticks_per_tick;
  const auto motion = displacement(clip.root_motion, loop / 3, loop / 3 + 5 * loop, true);
  EXPECT_LT(glm::distance(motion.translation, 5.0 * clip.loop_displacement), 1e-12);
  EXPECT_EQ(motion.yaw, 0.0);
}

TEST(RootMotionOf, SmallSwayIsLeftInThePose) {
  const auto sway = [](float time) { return glm::vec3(0.02F * time, 1.0F, 0.0F); };
  const Model model = striding_model(synthetic_model(20, 1), 0, sampled_track(sway, 30.0, 60));
  EXPECT_EQ(bake_character(model).clips.front().loop_displacement, glm::dvec3(0.0));
}

TEST(RootMotionOf, AnArmIsNone) {
  const Model model = striding_model(synthetic_model(20, 1), 19, sampled_track(stride, 30.0, 60));
  EXPECT_EQ(bake_character(model).clips.front().loop_displacement, glm::dvec3(0.0));
}

TEST(RootMotionOf, AStepTrackStaysInThePose) {
  Track<glm::vec3> track = sampled_track(stride, 30.0, 60);
  track.interpolation = Interpolation::step;
  const Model model = striding_model(synthetic_model(20, 1), 0, track);
  EXPECT_EQ(bake_character(model).clips.front().loop_displacement, glm::dvec3(0.0));
}

TEST(GroundSpeed, IsThatOfTheRootMotion) {
  const Character character =
      bake_character(striding_model(synthetic_model(20, 1), 0, sampled_track(stride, 30.0, 60)));
  EXPECT_NEAR(character.clips.front().ground_speed(), glm::length(travel) / duration, 1e-5);
}

TEST(GroundSpeed, OfAStandingClipIsNone) {
  EXPECT_EQ(bake_character(synthetic_model(62, 1)).clips.front().ground_speed(), 0.0);
}

TEST(GroundSpeed, OfAWalkInPlaceIsThatOfTheStandingFoot) {
  for (const float speed : {0.8F, 1.4F, 3.0F}) {
    EXPECT_NEAR(bake_character(walker_in_place(speed)).clips.front().ground_speed(), static_cast<double>(speed), 0.02)
        << speed;
  }
}

/// Returns the walk with feet that end so many metres behind where they began.
Model walker_that_ends_behind(float metres) {
  Model model = walker_in_place(1.4F);
  for (BoneTracks& foot : model.clips.front().tracks) {
    const auto last = static_cast<float>(foot.translation.values.size() - 1);
    for (std::size_t key = 0; key < foot.translation.values.size(); ++key) {
      foot.translation.values[key].z -= metres * static_cast<float>(key) / last;
    }
  }
  return model;
}

TEST(GroundSpeed, OfAClipThatEndsInAnotherPoseIsNone) {
  EXPECT_EQ(bake_character(walker_that_ends_behind(0.8F)).clips.front().ground_speed(), 0.0)
      << "a person who sits down";
}

TEST(GroundSpeed, OfAWalkThatHardlyLoopsIsThatOfTheStandingFootToo) {
  const Character character = bake_character(walker_that_ends_behind(0.03F));
  EXPECT_FALSE(character.clips.front().loops);
  EXPECT_NEAR(character.clips.front().ground_speed(), 1.43, 0.02);
}

TEST(GroundSpeed, OfAWalkWhoseHandsSwingLowerThanItsFeetIsThatOfTheFeet) {
  Model model = walker_in_place(1.4F);
  Skeleton& skeleton = model.skeleton;
  skeleton.bones.push_back({.name = "hand", .parent = 0, .rest = {}});
  skeleton.references.push_back({.origin = {0.0, 0.8, 0.0}});
  skeleton.palette.push_back({.bone = 3});
  skeleton.level_bone_counts = {4};
  const auto swing = [](float time) {
    return glm::vec3(0.3F, -1.1F, 0.6F * std::sin(2.0F * std::numbers::pi_v<float> * time));
  };
  BoneTracks hand;
  hand.bone = 3;
  hand.translation = sampled_track(swing, 30.0, 30);
  model.clips.front().tracks.push_back(hand);
  EXPECT_NEAR(bake_character(model).clips.front().ground_speed(), 1.4, 0.02);
}

TEST(TravelBySteps, MovesAWalkInPlaceForwardAndLeavesItsPoses) {
  const Character in_place = bake_character(walker_in_place(1.4F));
  Character travels = bake_character(walker_in_place(1.4F));
  travel_by_steps(travels);
  const BakedClip& walk = travels.clips.front();
  EXPECT_NEAR(walk.loop_displacement.x, 0.0, 1e-3);
  EXPECT_NEAR(walk.loop_displacement.z, 1.4, 0.02);
  EXPECT_EQ(walk.loop_displacement, whole_motion(walk.root_motion).translation);
  EXPECT_EQ(walk.ground_speed(), in_place.clips.front().ground_speed());
  EXPECT_EQ(
      std::memcmp(walk.keyframe_block.get(), in_place.clips.front().keyframe_block.get(), walk.keyframe()->total_size),
      0);
}

TEST(TravelBySteps, LeavesClipsThatTravelOrStand) {
  Character strides = bake_character(striding_model(synthetic_model(20, 1), 0, sampled_track(stride, 30.0, 60)));
  const glm::dvec3 before = strides.clips.front().loop_displacement;
  travel_by_steps(strides);
  EXPECT_EQ(strides.clips.front().loop_displacement, before);
  Character strolls = bake_character(walker_in_place(1.4F));
  strolls.clips.front().root_motion = straight_root_curve(strolls.clips.front().duration, {0.0, 0.0, 5.0});
  travel_by_steps(strolls);
  EXPECT_EQ(whole_motion(strolls.clips.front().root_motion).translation.z, 5.0);
  Character stands = bake_character(synthetic_model(62, 1));
  travel_by_steps(stands);
  EXPECT_TRUE(stands.clips.front().root_motion.keys.empty());
}

std::vector<std::pair<std::string, double>> named_data_keys(const Character& character) {
  std::vector<std::pair<std::string, double>> keys;
  for (const DataKey& key : character.clips.front().data_keys) {
    keys.emplace_back(character.data_key_names[key.name], to_seconds(key.time));
  }
  return keys;
}

TEST(Footsteps, AreDataKeysWhereAFootComesToStand) {
  const auto keys = named_data_keys(bake_character(walker_in_place(1.4F)));
  constexpr double instant = 1.0 / 96.0;
  ASSERT_EQ(keys.size(), 2U);
  EXPECT_EQ(keys[0].first, "footstep_left");
  EXPECT_NEAR(keys[0].second, 0.0, instant);
  EXPECT_EQ(keys[1].first, "footstep_right");
  EXPECT_NEAR(keys[1].second, 0.5, instant);
}

TEST(Footsteps, AreNotAddedToTheDataKeysOfAFile) {
  Model model = walker_in_place(1.4F);
  model.clips.front().data_keys = {{.time = 0.3, .name = "whistle"}};
  EXPECT_EQ(named_data_keys(bake_character(model)).size(), 1U);
}

TEST(Footsteps, AreNoneWhereFeetDoNotTakeTurns) {
  Model hopping = walker_in_place(1.4F);
  std::vector<BoneTracks>& feet = hopping.clips.front().tracks;
  feet[1].translation = feet[0].translation;
  for (glm::vec3& value : feet[1].translation.values) value.x = -value.x;
  EXPECT_TRUE(named_data_keys(bake_character(hopping)).empty());
}

TEST(Footsteps, AreNoneWhereACharacterStands) {
  EXPECT_TRUE(bake_character(synthetic_model(62, 1)).data_key_names.empty());
}

}  // namespace
}  // namespace throng::anim::root_motion_test
