#include "engine/anim/retarget/retarget.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/anim/asset/bone_mask.h"
#include "engine/anim/asset/reference_pose.h"
#include "engine/anim/retarget/body_pose.h"
#include "tests/anim/retarget/figures.h"

namespace throng::anim::retarget_test {
namespace {

using figures::Build;
using testing::ElementsAre;
using testing::IsEmpty;

/// A clip of one figure on another, and poses of both.
class Pair {
 public:
  Pair(const Build& from, const Build& to, double metres = 0.0)
      : from_(figures::person(from)),
        to_(figures::person(to)),
        clip_(figures::knee_bend(from_, metres)),
        retargeter_(from_, to_),
        result_(retargeter_.retarget(clip_)) {}
  Pair(const Pair&) = delete;
  Pair& operator=(const Pair&) = delete;

  const RetargetedClip& result() const { return result_; }
  const Clip& clip() const { return clip_; }
  const Skeleton& to() const { return to_; }
  const RigMap& rig() const { return retargeter_.match().to; }
  double scale() const { return retargeter_.plan().scale; }
  BodyPose source(double seconds) const { return pose_of(reference_pose(from_, &clip_, seconds).globals); }
  BodyPose own(double seconds) const { return pose_of(reference_pose(to_, &result_.clip, seconds).globals); }
  int source_of(int bone) const { return retargeter_.match().source_of[static_cast<std::size_t>(bone)]; }
  glm::dvec3 source_place(BodyRole role, double seconds) const {
    return source(seconds).place(retargeter_.match().from.at(role));
  }
  glm::dvec3 own_place(BodyRole role, double seconds) const { return own(seconds).place(rig().at(role)); }
  glm::dvec3 own_way(BodyRole a, BodyRole b, double seconds) const {
    return glm::normalize(own_place(b, seconds) - own_place(a, seconds));
  }
  glm::dvec3 source_way(BodyRole a, BodyRole b, double seconds) const {
    return glm::normalize(source_place(b, seconds) - source_place(a, seconds));
  }

 private:
  Skeleton from_;
  Skeleton to_;
  Clip clip_;
  Retargeter retargeter_;
  RetargetedClip result_;
};

/// Both feet are as high as the source's, scaled, and the hips too. All figures' ankles are 8 cm high in the bind pose.
void expect_contact(const Pair& pair) {
  constexpr double ankle = 0.08;
  for (int i = 0; i <= 40; ++i) {
    const double seconds = i / 40.0;
    for (const BodyRole foot : {BodyRole::left_foot, BodyRole::right_foot}) {
      const double lifted = pair.source_place(foot, seconds).y - ankle;
      EXPECT_NEAR(pair.own_place(foot, seconds).y - ankle, lifted * pair.scale(), 0.01) << seconds;
    }
    const auto hips = [&](auto place) {
      return 0.5 * (place(BodyRole::left_upper_leg).y + place(BodyRole::right_upper_leg).y);
    };
    const double expected = pair.scale() * hips([&](BodyRole role) { return pair.source_place(role, seconds); });
    EXPECT_NEAR(hips([&](BodyRole role) { return pair.own_place(role, seconds); }), expected, 0.02 * expected);
  }
}

/// Knees bend forward, by no more than a person's.
void expect_knees_in_range(const Pair& pair) {
  const glm::dvec3 forward(pair.rig().limbs.forward);
  for (int i = 0; i <= 40; ++i) {
    const glm::dvec3 thigh = pair.own_way(BodyRole::left_upper_leg, BodyRole::left_lower_leg, i / 40.0);
    const glm::dvec3 shin = pair.own_way(BodyRole::left_lower_leg, BodyRole::left_foot, i / 40.0);
    EXPECT_GT(glm::dot(thigh - shin, forward), -0.02) << i;
    EXPECT_GT(glm::dot(thigh, shin), std::cos(2.6)) << i;
  }
}

TEST(Retarget, LeavesOutMorphsWhichAreThoseOfAnotherSurface) {
  const Skeleton from = figures::person({}), to = figures::person({.legs = 1.5});
  const Retargeter retargeter(from, to);
  Clip clip = figures::knee_bend(from, 0.0);
  clip.morph_tracks = {{.interpolation = Interpolation::linear, .morphs = {0}, .times = {0.0F}, .weights = {1.0F}}};
  EXPECT_THAT(retargeter.retarget(clip).clip.morph_tracks, IsEmpty());
  clip.tracks.clear();
  EXPECT_THAT(retargeter.retarget(clip).clip.tracks, IsEmpty()) << "a clip that moves no bone";
}

TEST(Retarget, CopiesKeysThatFit) {
  const Pair pair({}, {});
  EXPECT_TRUE(pair.result().as_it_was);
  ASSERT_EQ(pair.result().clip.tracks.size(), pair.clip().tracks.size());
  for (std::size_t i = 0; i < pair.clip().tracks.size(); ++i) {
    EXPECT_EQ(pair.result().clip.tracks[i].bone, pair.clip().tracks[i].bone);
    EXPECT_EQ(pair.result().clip.tracks[i].rotation.values, pair.clip().tracks[i].rotation.values);
  }
  EXPECT_THAT(pair.result().lost, IsEmpty());
}

TEST(Retarget, KeepsFeetOnTheGroundWhateverTheLegs) {
  for (const double legs : {0.6, 0.8, 1.3, 2.0}) {
    const Pair pair({}, {.legs = legs, .hips = 1.4, .prefix = "mixamorig:"});
    EXPECT_FALSE(pair.result().as_it_was);
    expect_contact(pair);
    expect_knees_in_range(pair);
  }
}

TEST(Retarget, KeepsFeetOnTheGroundThatStandApart) {
  const Pair onto({}, {.legs = 1.2, .feet_apart = true});
  EXPECT_TRUE(onto.rig().limbs.left_leg->end_stands_apart);
  expect_contact(onto);
  expect_knees_in_range(onto);
}

TEST(Retarget, PointsArmsWhereTheSourcePointsThem) {
  const Pair pair({}, {.arms_out = true});
  for (const double seconds : {0.0, 0.3, 0.5}) {
    for (const auto& [bone, end] : {std::pair(BodyRole::left_upper_arm, BodyRole::left_lower_arm),
                                    std::pair(BodyRole::right_lower_arm, BodyRole::right_hand)}) {
      EXPECT_LT(glm::distance(pair.own_way(bone, end, seconds), pair.source_way(bone, end, seconds)), 0.01);
    }
  }
}

TEST(Retarget, TurnsFiguresThatFaceTheOtherWay) {
  const Pair pair({}, {.backwards = true}, 1.0);
  EXPECT_NEAR(pair.own_place(BodyRole::hips, 1.0).z - pair.own_place(BodyRole::hips, 0.0).z, -1.0, 0.01);
  expect_contact(pair);
  expect_knees_in_range(pair);
}

TEST(Retarget, ScalesRootMotionByTheLegs) {
  const Pair pair({}, {.legs = 1.5, .trunk = 0.8}, 2.0);
  const double expected = 2.0 * pair.scale();
  EXPECT_GT(pair.scale(), 1.3);
  EXPECT_NEAR(pair.own_place(BodyRole::hips, 1.0).z - pair.own_place(BodyRole::hips, 0.0).z, expected, 0.01);
  const int root = find_bone(pair.to(), "root");
  EXPECT_NEAR(pair.own(1.0).place(root).z - pair.own(0.0).place(root).z, expected, 0.01) << "the root carries it";
}

/// Makes a pose of a clip the reference pose, as a file without a skin has it.
Skeleton resting_in(Skeleton skeleton, const Clip& clip, double seconds) {
  const ReferencePose pose = reference_pose(skeleton, &clip, seconds);
  for (std::size_t b = 0; b < skeleton.bones.size(); ++b) {
    skeleton.bones[b].rest.rotation = glm::quat(pose.locals[b].rotation);
    skeleton.bones[b].rest.translation = glm::vec3(pose.locals[b].position);
    skeleton.references[b] = {.rotation = rotation_of(pose.globals[b]), .origin = glm::dvec3(pose.globals[b][3])};
  }
  return skeleton;
}

TEST(Retarget, NeedsNoReferencePoseWhereJointsHaveTheSameAxes) {
  const Skeleton person = figures::person();
  Clip clip = figures::knee_bend(person);
  const auto foot = static_cast<std::size_t>(find_bone(person, "foot.L"));
  for (glm::quat& turned : clip.tracks[foot].rotation.values) {
    turned = turned * glm::angleAxis(0.6F, glm::vec3(1.0F, 0.0F, 0.0F));  // so that it does not rest flat
  }
  const Skeleton from = resting_in(person, clip, 0.2);
  const Skeleton to = figures::person({.legs = 1.3});
  const Retargeter expected(person, to), retargeter(from, to);
  EXPECT_NEAR(retargeter.plan().scale, expected.plan().scale, 0.01);
  const Clip one = expected.retarget(clip).clip, other = retargeter.retarget(clip).clip;
  for (const double seconds : {0.0, 0.25, 0.5}) {
    const BodyPose a = pose_of(reference_pose(to, &one, seconds).globals);
    const BodyPose b = pose_of(reference_pose(to, &other, seconds).globals);
    for (int bone = 0; bone < to.bone_count(); ++bone) {
      EXPECT_LT(glm::distance(a.place(bone), b.place(bone)), 0.015) << to.bones[static_cast<std::size_t>(bone)].name;
    }
  }
}

/// Holds the left leg of a clip up behind the body, with its toes pointing back, and the right foot on its toes.
Clip with_a_leg_in_the_air(const Skeleton& person, Clip clip) {
  for (const auto& [name, angle] : {std::pair("thigh.L", 1.5F), {"shin.L", 1.2F}, {"foot.L", 0.4F}, {"foot.R", 1.0F}}) {
    const int bone = find_bone(person, name);
    const ReferenceFrame& frame = person.references[static_cast<std::size_t>(bone)];
    const auto axis = glm::vec3(glm::conjugate(frame.rotation) * glm::dvec3(1.0, 0.0, 0.0));
    for (glm::quat& turned : std::ranges::find(clip.tracks, bone, &BoneTracks::bone)->rotation.values) {
      turned = turned * glm::angleAxis(angle, axis);
    }
  }
  return clip;
}

TEST(Retarget, KnowsTheLegsOfASourceThatRestsWithOneInTheAir) {
  const Skeleton person = figures::person();
  const Clip clip = with_a_leg_in_the_air(person, figures::knee_bend(person));
  const Skeleton from = resting_in(person, clip, 0.0);
  for (const Build& build : {Build{.legs = 1.3}, Build{.legs = 1.3, .arms_out = true}}) {
    const Skeleton to = figures::person(build);
    const Retargeter expected(person, to), retargeter(from, to);
    EXPECT_EQ(retargeter.plan().legs.size(), 2U);
    EXPECT_NEAR(retargeter.plan().scale, expected.plan().scale, 0.03) << "on tiptoe an ankle is a little higher";
    EXPECT_NEAR(retargeter.plan().source_origin.y, 0.0, 1e-9);
  }
}

TEST(Retarget, NamesTheBonesWhoseMotionIsLost) {
  Skeleton from = figures::person();
  const int tail = from.bone_count();
  from.bones.push_back(from.bones.back());
  from.bones.back().name = "tail";
  from.bones.back().parent = find_bone(from, "hips");
  from.references.push_back(from.references.back());
  from.palette.push_back({.bone = tail});
  const Skeleton to = figures::person({.legs = 1.2});
  EXPECT_THAT(Retargeter(from, to).retarget(figures::knee_bend(from)).lost, ElementsAre("tail"));
}

TEST(Retarget, KeepsNameDurationAndDataKeys) {
  const Skeleton from = figures::person();
  const Skeleton to = figures::person({.legs = 1.2});
  Clip clip = figures::knee_bend(from);
  clip.data_keys = {{0.5, "down"}};
  clip.curves = {{.name = "glow", .times = {0.5F}, .values = {1.0F}}};
  const Clip result = Retargeter(from, to).retarget(clip).clip;
  EXPECT_EQ(result.name, clip.name);
  EXPECT_EQ(result.duration, clip.duration);
  ASSERT_EQ(result.data_keys.size(), 1U);
  EXPECT_EQ(result.data_keys.front().name, "down");
  ASSERT_EQ(result.curves.size(), 1U);
  EXPECT_EQ(result.curves.front().name, "glow");
}

TEST(Retarget, PosesWhoeverHasNoLegs) {
  const Skeleton from = figures::person();
  Skeleton to = figures::person();
  std::erase_if(to.bones, [](const Bone& bone) { return bone.parent >= 0; });
  to.references.resize(1);
  to.palette.resize(1);
  const RetargetedClip result = Retargeter(from, to).retarget(figures::knee_bend(from, 1.0));
  ASSERT_EQ(result.clip.tracks.size(), 1U);
  EXPECT_FALSE(result.lost.empty());
}

}  // namespace
}  // namespace throng::anim::retarget_test
