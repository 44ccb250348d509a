// Feet of many characters at once.

#include <array>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "engine/anim/asset/bone_mask.h"
#include "engine/anim/kernel/kernels.h"
#include "tests/anim/kernel/limb/foot_placement_reference.h"
#include "tests/anim/kernel/limb/two_bone_ik_reference.h"
#include "tests/anim/kernel/pose/held_pose.h"
#include "tests/anim/rig/named_skeleton.h"

namespace throng::anim::foot_placement_strip_test {
namespace {

constexpr std::size_t characters = widest_strip;

/// Characters who walk over ground that changes under them, lift their feet and set them down, each by numbers of its
/// own.
class Walkers {
 public:
  explicit Walkers(unsigned seed) : random_(seed) {
    for (std::size_t i = 0; i < characters; ++i) {
      poses_.emplace_back(skeleton_);
      bodies_[i].options.lock.enabled = i % 5 != 2;
      bodies_[i].options.lock.farthest = i % 2 == 0 ? 0.4F : 0.1F;
      bodies_[i].options.least_tilt_cosine = i % 3 == 0 ? 0.76F : 0.98F;
      if (i == 7) bodies_[i].options.drop_smooth_seconds = 0.0F;
    }
  }

  /// A frame of the animation, before feet are placed.
  void pose() {
    for (std::size_t i = 0; i < characters; ++i) {
      poses_[i] = HeldPose(skeleton_);
      poses_[i].shake(random_, 0.2F);
      PlacedBody& body = bodies_[i];
      body.model_in_world.rotation =
          glm::angleAxis(random_between(random_, -0.02F, 0.02F), glm::vec3(0.0F, 1.0F, 0.0F)) *
          body.model_in_world.rotation;
      body.model_in_world.position += random_between(random_, 0.0F, 0.05F) * glm::vec3(0.6F, 0.0F, 0.8F);
      for (PlacedFoot& foot : feet_[i]) {
        if (random_() % 8U == 0) {
          foot.ground.normal = glm::normalize(glm::vec3(0.0F, 2.0F, 0.0F) + random_direction(random_));
          foot.ground.place = body.model_in_world.position + 0.2F * random_direction(random_);
        }
        if (random_() % 6U == 0) foot.planted = random_() % 3U == 0 ? planted_by_pose : random_between(random_, 0, 1);
      }
      jobs_[i] = {.rig = &rig_,
                  .body = &body,
                  .feet = feet_[i].data(),
                  .pose = poses_[i].view(),
                  .seconds = random_between(random_, 0.0F, 0.05F),
                  .weight = i % 4 == 1 ? 0.6F : 1.0F};
    }
  }
  std::span<const FootPlacementJob> jobs() const { return jobs_; }
  FootPlacementJob& job(std::size_t character) { return jobs_[character]; }
  const PlacedBody& body(std::size_t character) const { return bodies_[character]; }
  const std::array<PlacedFoot, 2>& feet(std::size_t character) const { return feet_[character]; }
  const std::vector<float>& floats(std::size_t character) const { return poses_[character].floats(); }

  /// A foot may come down, on its way back, farther away than it is held: then it is let go by the next update.
  void never_let_go() {
    for (PlacedBody& body : bodies_) body.options.lock.farthest = 100.0F;
  }
  /// After it was copied.
  void point_jobs() {
    for (std::size_t i = 0; i < characters; ++i) {
      jobs_[i].rig = &rig_;
      jobs_[i].body = &bodies_[i];
      jobs_[i].feet = feet_[i].data();
      jobs_[i].pose = poses_[i].view();
    }
  }
  /// What a definition left, for whoever begins the next frame with it.
  void take_state(const Walkers& other, std::size_t character) {
    bodies_[character] = other.bodies_[character];
    feet_[character] = other.feet_[character];
  }

 private:
  LegBones leg_bones(const std::string& side) const {
    return {find_bone(skeleton_, "thigh" + side), find_bone(skeleton_, "shin" + side),
            find_bone(skeleton_, "foot" + side), find_bone(skeleton_, "toe" + side)};
  }

  std::mt19937 random_;
  Skeleton skeleton_ = named_skeleton(person_joints());
  FootPlacementRig rig_ = make_foot_placement_rig(skeleton_, std::array{leg_bones(".L"), leg_bones(".R")}).value();
  std::vector<HeldPose> poses_;
  std::array<PlacedBody, characters> bodies_{};
  std::array<std::array<PlacedFoot, 2>, characters> feet_{};
  std::array<FootPlacementJob, characters> jobs_{};
};

void expect_alike(const FootLock& lock, const FootLock& defined) {
  EXPECT_EQ(lock.flags, defined.flags);
  EXPECT_LT(glm::distance(lock.place, defined.place), 1e-5F);
  EXPECT_LT(glm::distance(lock.normal, defined.normal), 1e-5F);
  EXPECT_LT(glm::distance(lock.offset, defined.offset), 1e-5F);
  EXPECT_LT(glm::distance(lock.last_ball, defined.last_ball), 1e-4F);
  EXPECT_NEAR(lock.slid, defined.slid, 1e-4F);
  EXPECT_NEAR(lock.standing_seconds, defined.standing_seconds, 1e-5F);
  EXPECT_FLOAT_EQ(lock.released_for, defined.released_for);
}

TEST(FootPlacementStrip, AgreesWithTheDefinitionOnEveryTarget) {
  for (const Kernels& kernels : runnable_kernels()) {
    Walkers strip(7);
    Walkers defined(7);
    std::uint32_t seen = 0;
    for (int frame = 0; frame < 200; ++frame) {
      strip.pose();
      defined.pose();
      kernels.place_feet(strip.jobs());
      for (std::size_t i = 0; i < characters; ++i) {
        SCOPED_TRACE(testing::Message() << kernels.target << ", frame " << frame << ", character " << i);
        place_feet_by_definition(defined.job(i));
        EXPECT_LT(largest_difference(strip.floats(i), defined.floats(i)), limb_rotation_tolerance);
        EXPECT_NEAR(strip.body(i).drop.value, defined.body(i).drop.value, 1e-5F);
        for (std::size_t leg = 0; leg < 2; ++leg) {
          const PlacedFoot& foot = strip.feet(i)[leg];
          EXPECT_NEAR(foot.missed_by, defined.feet(i)[leg].missed_by, 2e-5F);
          EXPECT_NEAR(foot.reached, defined.feet(i)[leg].reached, 1e-4F);
          EXPECT_LT(glm::distance(foot.ankle, defined.feet(i)[leg].ankle), 1e-6F);
          expect_alike(foot.lock, defined.feet(i)[leg].lock);
          seen |= foot.lock.flags;
        }
        strip.take_state(defined, i);
        if (HasFailure()) return;
      }
    }
    EXPECT_EQ(seen, FootLock::is_locked | FootLock::is_overstretched | FootLock::is_standing | FootLock::is_stepping)
        << "what there is to see";
  }
}

TEST(FootPlacementStrip, IsTheSameToTheBitWhoeverTheNeighboursAre) {
  for (const Kernels& kernels : runnable_kernels()) {
    Walkers together(8);
    Walkers alone(8);
    for (int frame = 0; frame < 20; ++frame) {
      together.pose();
      alone.pose();
      kernels.place_feet(together.jobs());
      for (std::size_t i = 0; i < characters; ++i) {
        kernels.place_feet({&alone.job(i), 1});
        EXPECT_EQ(together.floats(i), alone.floats(i)) << kernels.target << " " << i;
        EXPECT_EQ(together.body(i).drop.velocity, alone.body(i).drop.velocity) << kernels.target << " " << i;
        EXPECT_EQ(together.feet(i)[1].lock.slid, alone.feet(i)[1].lock.slid) << kernels.target << " " << i;
        EXPECT_EQ(together.feet(i)[1].missed_by, alone.feet(i)[1].missed_by) << kernels.target << " " << i;
      }
    }
  }
}

TEST(FootPlacementStrip, IsTheSameToTheBitAmongTargetsThatFuse) {
  for (const Kernels& kernels : runnable_kernels()) {
    if (kernels.fused_multiply_add != best_kernels().fused_multiply_add) continue;
    Walkers best(9);
    Walkers other(9);
    for (int frame = 0; frame < 20; ++frame) {
      best.pose();
      other.pose();
      best_kernels().place_feet(best.jobs());
      kernels.place_feet(other.jobs());
      for (std::size_t i = 0; i < characters; ++i) EXPECT_EQ(other.floats(i), best.floats(i)) << kernels.target;
    }
  }
}

TEST(FootPlacementStrip, PlacesTheSamePoseAgainToTheBitWhileNoTimePasses) {
  for (const Kernels& kernels : runnable_kernels()) {
    Walkers first(11);
    first.never_let_go();
    for (int frame = 0; frame < 100; ++frame) {
      first.pose();
      Walkers again = first;
      kernels.place_feet(first.jobs());
      again.point_jobs();
      for (std::size_t i = 0; i < characters; ++i) {
        again.take_state(first, i);
        again.job(i).seconds = 0.0F;
      }
      kernels.place_feet(again.jobs());
      for (std::size_t i = 0; i < characters; ++i) {
        EXPECT_EQ(again.floats(i), first.floats(i)) << kernels.target << ", frame " << frame << ", character " << i;
      }
    }
  }
}

TEST(FootPlacementStrip, PassesByThoseWhoAreNotPlaced) {
  for (const Kernels& kernels : runnable_kernels()) {
    Walkers some(10);
    Walkers all(10);
    for (int frame = 0; frame < 3; ++frame) {
      some.pose();
      all.pose();
      some.job(3).weight = 0.0F;
      some.job(5).pose.bone_count = 2;
      const std::vector<float> without_weight = some.floats(3);
      const std::vector<float> without_legs = some.floats(5);
      kernels.place_feet(some.jobs());
      kernels.place_feet(all.jobs());
      EXPECT_EQ(some.floats(3), without_weight) << kernels.target;
      EXPECT_EQ(some.floats(5), without_legs) << kernels.target;
      EXPECT_EQ(some.feet(3)[0].ankle, all.feet(3)[0].ankle) << "where to look for the ground";
      for (const std::size_t forgotten : {std::size_t{3}, std::size_t{5}}) {
        EXPECT_FALSE(some.body(forgotten).started);
        EXPECT_EQ(some.feet(forgotten)[1].lock.flags, 0U);
      }
      for (const std::size_t i : {std::size_t{2}, std::size_t{4}, std::size_t{15}}) {
        EXPECT_EQ(some.floats(i), all.floats(i)) << kernels.target << " " << i;
      }
    }
  }
}

}  // namespace
}  // namespace throng::anim::foot_placement_strip_test
