// Two-bone IK of many characters at once.

#include <array>
#include <vector>

#include <gtest/gtest.h>

#include "engine/anim/asset/bone_mask.h"
#include "engine/anim/kernel/kernels.h"
#include "tests/anim/kernel/limb/two_bone_ik_reference.h"
#include "tests/anim/kernel/pose/held_pose.h"
#include "tests/anim/rig/named_skeleton.h"

namespace throng::anim::two_bone_ik_strip_test {
namespace {

constexpr std::size_t characters = widest_strip;

/// Characters who reach with one arm, each for a place of its own.
class Reachers {
 public:
  explicit Reachers(unsigned seed) : random_(seed) {
    for (std::size_t i = 0; i < characters; ++i) poses_.emplace_back(skeleton_);
  }

  /// A frame of the animation, before anyone reaches.
  void pose() {
    for (std::size_t i = 0; i < characters; ++i) {
      poses_[i] = HeldPose(skeleton_);
      poses_[i].shake(random_, 0.5F);
      const glm::vec3 shoulder = joint_by_definition(skeleton_, poses_[i].view(), "upper_arm.L").position;
      jobs_[i] = {.limb = &limb_,
                  .pose = poses_[i].view(),
                  .target = shoulder + random_between(random_, 0.05F, 0.9F) * random_direction(random_),
                  .pole = i % 3 == 0 ? random_direction(random_) : glm::vec3(0.0F),
                  .weight = i % 4 == 1 ? 0.6F : 1.0F,
                  .softness = i % 5 == 0 ? 0.1F : 0.005F,
                  .turn_end = i % 2 == 0,
                  .end_rotation = glm::angleAxis(random_between(random_, -2.0F, 2.0F), random_direction(random_))};
    }
  }
  std::span<const TwoBoneIkJob> jobs() const { return jobs_; }
  TwoBoneIkJob& job(std::size_t character) { return jobs_[character]; }
  const std::vector<float>& floats(std::size_t character) const { return poses_[character].floats(); }

 private:
  std::mt19937 random_;
  Skeleton skeleton_ = named_skeleton(person_joints());
  TwoBoneLimb limb_ =
      make_two_bone_limb(skeleton_, find_bone(skeleton_, "upper_arm.L"), find_bone(skeleton_, "forearm.L"),
                         find_bone(skeleton_, "hand.L"), {0.0F, 0.0F, -1.0F})
          .value();
  std::vector<HeldPose> poses_;
  std::array<TwoBoneIkJob, characters> jobs_{};
};

TEST(TwoBoneIkStrip, AgreesWithTheDefinitionOnEveryTarget) {
  for (const Kernels& kernels : runnable_kernels()) {
    Reachers strip(7);
    Reachers defined(7);
    std::array<float, characters> missed_by{};
    for (int frame = 0; frame < 60; ++frame) {
      strip.pose();
      defined.pose();
      kernels.two_bone_ik(strip.jobs(), missed_by.data());
      for (std::size_t i = 0; i < characters; ++i) {
        EXPECT_NEAR(missed_by[i], two_bone_ik_by_definition(defined.job(i)), 1e-5F) << kernels.target << " " << i;
        EXPECT_LT(largest_difference(strip.floats(i), defined.floats(i)), limb_rotation_tolerance)
            << kernels.target << " " << i;
      }
    }
  }
}

TEST(TwoBoneIkStrip, IsTheSameToTheBitWhoeverTheNeighboursAre) {
  for (const Kernels& kernels : runnable_kernels()) {
    Reachers together(8);
    Reachers alone(8);
    std::array<float, characters> missed_by{};
    for (int frame = 0; frame < 10; ++frame) {
      together.pose();
      alone.pose();
      kernels.two_bone_ik(together.jobs(), missed_by.data());
      for (std::size_t i = 0; i < characters; ++i) {
        float missed_alone = -1.0F;
        kernels.two_bone_ik({&alone.job(i), 1}, &missed_alone);
        EXPECT_EQ(together.floats(i), alone.floats(i)) << kernels.target << " " << i;
        EXPECT_EQ(missed_by[i], missed_alone) << kernels.target << " " << i;
      }
    }
  }
}

TEST(TwoBoneIkStrip, IsTheSameToTheBitAmongTargetsThatFuse) {
  for (const Kernels& kernels : runnable_kernels()) {
    if (kernels.fused_multiply_add != best_kernels().fused_multiply_add) continue;
    Reachers best(9);
    Reachers other(9);
    std::array<float, characters> missed_by{};
    for (int frame = 0; frame < 10; ++frame) {
      best.pose();
      other.pose();
      best_kernels().two_bone_ik(best.jobs(), missed_by.data());
      kernels.two_bone_ik(other.jobs(), missed_by.data());
      for (std::size_t i = 0; i < characters; ++i) EXPECT_EQ(other.floats(i), best.floats(i)) << kernels.target;
    }
  }
}

TEST(TwoBoneIkStrip, PassesByThoseWhoDoNotReach) {
  for (const Kernels& kernels : runnable_kernels()) {
    Reachers some(10);
    some.pose();
    some.job(3).weight = 0.0F;
    some.job(5).target = glm::vec3(1e20F);
    some.job(6).pose.bone_count = 2;
    std::array<std::vector<float>, 3> before{some.floats(3), some.floats(5), some.floats(6)};
    std::array<float, characters> missed_by{};
    kernels.two_bone_ik(some.jobs(), missed_by.data());
    EXPECT_EQ(some.floats(3), before[0]) << kernels.target;
    EXPECT_EQ(some.floats(5), before[1]) << kernels.target;
    EXPECT_EQ(some.floats(6), before[2]) << kernels.target;
    EXPECT_GT(missed_by[3], 0.0F);
    EXPECT_EQ(missed_by[5], 0.0F);
    EXPECT_EQ(missed_by[6], 0.0F);
    EXPECT_LT(missed_by[4], 1.0F);
  }
}

}  // namespace
}  // namespace throng::anim::two_bone_ik_strip_test
