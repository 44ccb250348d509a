// Gazes of many characters at once.

#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "engine/anim/asset/bone_mask.h"
#include "engine/anim/kernel/kernels.h"
#include "tests/anim/kernel/limb/look_at_reference.h"
#include "tests/anim/kernel/pose/held_pose.h"
#include "tests/anim/rig/named_skeleton.h"

namespace throng::anim::look_at_strip_test {
namespace {

constexpr std::size_t characters = widest_strip;

/// Characters who stand, look and are told otherwise, each by numbers of its own.
class Onlookers {
 public:
  explicit Onlookers(unsigned seed) : random_(seed) {
    for (std::size_t i = 0; i < characters; ++i) {
      poses_.emplace_back(skeleton_);
      look_elsewhere(i);
      jobs_[i].limits.smooth_seconds = i % 5 == 0 ? 0.0F : 0.15F;
      jobs_[i].weight = i % 4 == 1 ? 0.6F : 1.0F;
    }
  }

  /// A frame of the animation, before anyone looks.
  void pose() {
    for (std::size_t i = 0; i < characters; ++i) {
      poses_[i] = HeldPose(skeleton_);
      poses_[i].shake(random_, 0.4F);
      if (random_() % 16U == 0) look_elsewhere(i);
      jobs_[i].rig = &rig_;
      jobs_[i].state = &states_[i];
      jobs_[i].pose = poses_[i].view();
      jobs_[i].seconds = random_between(random_, 0.0F, 0.05F);
    }
  }
  std::span<LookAtJob> jobs() { return jobs_; }
  LookAtJob& job(std::size_t character) { return jobs_[character]; }
  const LookAtState& state(std::size_t character) const { return states_[character]; }
  const std::vector<float>& floats(std::size_t character) const { return poses_[character].floats(); }

 private:
  void look_elsewhere(std::size_t character) {
    jobs_[character].target = 3.0F * random_direction(random_) + glm::vec3(0.0F, 1.5F, 0.0F);
  }

  std::mt19937 random_;
  Skeleton skeleton_ = named_skeleton(person_joints());
  LookAtRig rig_ = make_look_at_rig(skeleton_,
                                    std::array{LookBone{find_bone(skeleton_, "spine"), 1.0F},
                                               LookBone{find_bone(skeleton_, "neck"), 2.0F},
                                               LookBone{find_bone(skeleton_, "head"), 4.0F}},
                                    {0.6F, 0.0F, 0.8F}, {0.0F, 0.1F, 0.08F})
                       .value();
  std::vector<HeldPose> poses_;
  std::array<LookAtState, characters> states_{};
  std::array<LookAtJob, characters> jobs_{};
};

TEST(LookAtStrip, AgreesWithTheDefinitionOnEveryTarget) {
  for (const Kernels& kernels : runnable_kernels()) {
    Onlookers strip(7);
    Onlookers defined(7);
    for (int frame = 0; frame < 60; ++frame) {
      strip.pose();
      defined.pose();
      kernels.look_at(strip.jobs());
      for (std::size_t i = 0; i < characters; ++i) {
        EXPECT_NEAR(strip.state(i).remaining, look_at_by_definition(defined.job(i)), 2e-5F)
            << kernels.target << " " << i;
        EXPECT_LT(largest_difference(strip.floats(i), defined.floats(i)), 5e-6F) << kernels.target << " " << i;
        EXPECT_NEAR(strip.state(i).yaw.value, defined.state(i).yaw.value, 1e-5F) << kernels.target << " " << i;
        EXPECT_NEAR(strip.state(i).pitch.value, defined.state(i).pitch.value, 1e-5F) << kernels.target << " " << i;
      }
    }
  }
}

TEST(LookAtStrip, IsTheSameToTheBitWhoeverTheNeighboursAre) {
  for (const Kernels& kernels : runnable_kernels()) {
    Onlookers together(8);
    Onlookers alone(8);
    for (int frame = 0; frame < 10; ++frame) {
      together.pose();
      alone.pose();
      kernels.look_at(together.jobs());
      for (LookAtJob& job : alone.jobs()) kernels.look_at({&job, 1});
      for (std::size_t i = 0; i < characters; ++i) {
        EXPECT_EQ(together.floats(i), alone.floats(i)) << kernels.target << " " << i;
        EXPECT_EQ(together.state(i).remaining, alone.state(i).remaining) << kernels.target << " " << i;
        EXPECT_EQ(together.state(i).yaw.velocity, alone.state(i).yaw.velocity) << kernels.target << " " << i;
      }
    }
  }
}

TEST(LookAtStrip, IsTheSameToTheBitAmongTargetsThatFuse) {
  for (const Kernels& kernels : runnable_kernels()) {
    if (kernels.fused_multiply_add != best_kernels().fused_multiply_add) continue;
    Onlookers best(9);
    Onlookers other(9);
    for (int frame = 0; frame < 10; ++frame) {
      best.pose();
      other.pose();
      best_kernels().look_at(best.jobs());
      kernels.look_at(other.jobs());
      for (std::size_t i = 0; i < characters; ++i) EXPECT_EQ(other.floats(i), best.floats(i)) << kernels.target;
    }
  }
}

TEST(LookAtStrip, PassesByThoseWhoDoNotLook) {
  for (const Kernels& kernels : runnable_kernels()) {
    Onlookers some(10);
    Onlookers all(10);
    some.pose();
    all.pose();
    const std::vector<float> before = some.floats(3);
    const std::vector<float> before_no_place = some.floats(5);
    some.job(3).weight = 0.0F;
    some.job(5).target = glm::vec3(1e20F);
    kernels.look_at(some.jobs());
    kernels.look_at(all.jobs());
    EXPECT_EQ(some.floats(3), before) << kernels.target;
    EXPECT_EQ(some.floats(5), before_no_place) << kernels.target;
    EXPECT_FALSE(some.state(3).started);
    EXPECT_EQ(some.state(5).remaining, 0.0F);
    for (const std::size_t i : {std::size_t{2}, std::size_t{4}, std::size_t{15}}) {
      EXPECT_EQ(some.floats(i), all.floats(i)) << kernels.target << " " << i;
    }
  }
}

}  // namespace
}  // namespace throng::anim::look_at_strip_test
