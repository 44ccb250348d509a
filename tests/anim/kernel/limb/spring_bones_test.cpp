// Hair on springs: what swing_bones promises.

#include "engine/anim/kernel/limb/spring_bones.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "tests/anim/kernel/pose/held_pose.h"
#include "tests/anim/kernel/validity.h"
#include "tests/anim/rig/named_skeleton.h"

namespace throng::anim::spring_bones_test {
namespace {

constexpr float frame = 1.0F / 60.0F;
constexpr float segment = 0.1F;

/// A head at 1.5 m with a plait of four bones of 10 cm that sticks out behind it.
std::vector<NamedJoint> head_with_plait() {
  return {{"body", "", {0.0F, 1.0F, 0.0F}},
          {"head", "body", {0.0F, 1.5F, 0.0F}},
          {"plait.1", "head", {0.0F, 1.5F, -0.1F}},
          {"plait.2", "plait.1", {0.0F, 1.5F, -0.2F}},
          {"plait.3", "plait.2", {0.0F, 1.5F, -0.3F}},
          {"plait.4", "plait.3", {0.0F, 1.5F, -0.4F}}};
}

/// A plait, its rig and its state.
class Plait {
 public:
  explicit Plait(const SpringOptions& options, const std::vector<SpringCollider>& colliders = {})
      : rig_(make_spring_rig(
                 skeleton_,
                 std::vector<SpringChain>{{.first = "plait.1", .last = "plait.4", .options = options, .tip = segment}},
                 colliders)
                 .value()),
        carriers_(1 + colliders.size()),
        joints_(4) {}

  SpringBonesJob job(float seconds) {
    return {
        .rig = &rig_, .body = &body, .carriers = carriers_, .joints = joints_, .pose = pose.view(), .seconds = seconds};
  }
  /// Makes an update of the bind pose.
  void update(float seconds = frame) {
    pose = HeldPose(skeleton_);
    swing_bones(job(seconds));
  }
  void update_for(int frames) {
    for (int i = 0; i < frames; ++i) update();
  }
  /// The end of the plait in model space, by the definition of the pose.
  glm::vec3 end() {
    const JointMotion last = joint_by_definition(skeleton_, pose.view(), "plait.4");
    return last.position + last.rotation * glm::vec3(0.0F, 0.0F, -segment);
  }
  glm::vec3 tail(std::size_t joint) const { return joints_[joint].tail; }

  Skeleton skeleton_ = named_skeleton(head_with_plait());
  HeldPose pose{skeleton_};
  SpringBody body;

 private:
  SpringRig rig_;
  std::vector<JointMotion> carriers_;
  std::vector<SpringJointState> joints_;
};

constexpr SpringOptions weightless{.gravity = glm::vec3(0.0F)};
constexpr glm::vec3 posed_end{0.0F, 1.5F, -0.5F};

TEST(SpringBones, AreValidAsTheirCommentsSay) {
  Plait plait(weightless);
  expect_validity<SpringBonesJob>(
      plait.job(frame),
      {{false, "no rig", [](SpringBonesJob& job) { job.rig = nullptr; }},
       {false, "no body", [](SpringBonesJob& job) { job.body = nullptr; }},
       {false, "a joint too few", [](SpringBonesJob& job) { job.joints = job.joints.first(3); }},
       {false, "no carrier", [](SpringBonesJob& job) { job.carriers = {}; }},
       {false, "a pose with scale", [](SpringBonesJob& job) { job.pose.components = general_components; }},
       {true, "no time", [](SpringBonesJob& job) { job.seconds = 0.0F; }},
       {false, "time that goes back", [](SpringBonesJob& job) { job.seconds = -frame; }},
       {false, "weight above 1", [](SpringBonesJob& job) { job.weight = 1.1F; }},
       {false, "weight not a number", [](SpringBonesJob& job) { job.weight = std::nanf(""); }}});
}

TEST(SpringBones, RestInTheirPose) {
  Plait plait(weightless);
  plait.update_for(120);
  EXPECT_LT(glm::distance(plait.end(), posed_end), 1e-5F);
}

TEST(SpringBones, HangDownTheFurtherTheHeavierTheyAre) {
  float last = posed_end.y;
  for (const float gravity : {1.0F, 3.0F, 9.0F, 30.0F}) {
    Plait plait({.gravity = {0.0F, -gravity, 0.0F}});
    plait.update_for(600);
    EXPECT_LT(plait.end().y, last - 0.005F) << gravity;
    last = plait.end().y;
    const glm::vec3 before = plait.end();
    plait.update();
    EXPECT_LT(glm::distance(plait.end(), before), 1e-4F) << "and come to rest";
  }
  EXPECT_LT(last, 1.2F);
}

TEST(SpringBones, LagBehindABodyThatStartsAndSwingBackWhenItStops) {
  Plait plait(weightless);
  plait.update();
  const auto walk = [&](float speed, int frames) {
    float least = 0.0F;
    for (int i = 0; i < frames; ++i) {
      plait.body.model_in_world.position.x += speed * frame;
      plait.update();
      least = std::min(least, plait.end().x);
    }
    return least;
  };
  EXPECT_LT(walk(2.0F, 20), -0.05F);
  float most = 0.0F;
  for (int i = 0; i < 60; ++i) {
    plait.update();
    most = std::max(most, plait.end().x);
  }
  EXPECT_GT(most, 0.02F) << "it overshoots";
  plait.update_for(300);
  EXPECT_LT(glm::distance(plait.end(), posed_end), 1e-3F);
}

TEST(SpringBones, KeepTheLengthsOfBonesWhateverTheBodyDoes) {
  std::mt19937 random(4);
  Plait plait({});
  for (int i = 0; i < 500; ++i) {
    plait.body.model_in_world = {.rotation = glm::normalize(glm::quat(1.0F, 0.3F * random_direction(random))),
                                 .position = 3.0F * random_direction(random)};
    plait.pose = HeldPose(plait.skeleton_);
    plait.pose.shake(random, 0.3F);
    swing_bones(plait.job(random_between(random, 0.0F, 0.1F)));
    ASSERT_TRUE(plait.pose.is_finite());
    for (std::size_t joint = 1; joint < 4; ++joint) {
      EXPECT_NEAR(glm::distance(plait.tail(joint), plait.tail(joint - 1)), segment, 0.02F)
          << "a centimetre at each end is the shaken pose's";
    }
  }
}

TEST(SpringBones, AreWhereTheyWouldBeIfNobodyHadSkippedUpdates) {
  for (const int every : {2, 3, 6}) {
    Plait each({});
    Plait skipped({});
    float farthest = 0.0F;
    float swing = 0.0F;
    for (int i = 0; i < 240; ++i) {
      const float time = static_cast<float>(i) * frame;
      const JointMotion placement{
          .rotation = glm::angleAxis(0.5F * std::sin(2.0F * time), glm::vec3(0.0F, 1.0F, 0.0F)),
          .position = {0.3F * std::sin(4.0F * time), 0.05F * std::sin(8.0F * time), 1.5F * time}};
      each.body.model_in_world = skipped.body.model_in_world = placement;
      each.update();
      if (i % every != 0) continue;
      skipped.update(i == 0 ? frame : static_cast<float>(every) * frame);
      farthest = std::max(farthest, glm::distance(each.end(), skipped.end()));
      swing = std::max(swing, glm::distance(each.end(), posed_end));
    }
    EXPECT_GT(swing, 0.1F);
    EXPECT_LT(farthest, (every == 6 ? 0.05F : 0.01F) * swing) << every;
  }
}

TEST(SpringBones, StayOutsideTheBody) {
  const std::vector<SpringCollider> back{
      {.bone = "body", .from = {0.0F, -0.5F, -0.3F}, .to = {0.0F, 0.4F, -0.3F}, .radius = 0.08F}};
  Plait plait({.gravity = {0.0F, -20.0F, 0.0F}, .radius = 0.01F}, back);
  for (int i = 0; i < 300; ++i) {
    plait.body.model_in_world.position.x = 0.1F * std::sin(0.2F * static_cast<float>(i));
    plait.update();
    for (std::size_t joint = 0; joint < 4; ++joint) {
      const glm::vec3 tail = plait.tail(joint) - plait.body.model_in_world.position;
      const glm::vec3 axis(0.0F, std::clamp(tail.y, 0.5F, 1.4F), -0.3F);
      EXPECT_GT(glm::distance(tail, axis), 0.08F) << "frame " << i << ", joint " << joint;
    }
  }
}

TEST(SpringBones, LieOnTheGround) {
  Plait plait({.stiffness = 1.0F, .gravity = {0.0F, -9.8F, 0.0F}, .radius = 0.02F});
  plait.body.ground = 1.4F;
  plait.update_for(300);
  EXPECT_NEAR(plait.tail(3).y, 1.42F, 2e-3F);
}

TEST(SpringBones, LeaveThePoseToTheBitWithoutWeightOrBones) {
  Plait plait({});
  const std::vector<float> before = plait.pose.floats();
  SpringBonesJob job = plait.job(frame);
  job.weight = 0.0F;
  swing_bones(job);
  EXPECT_EQ(plait.pose.floats(), before);
  EXPECT_FALSE(plait.body.started);
  job.weight = 1.0F;
  job.pose.bone_count = 3;
  swing_bones(job);
  EXPECT_EQ(plait.pose.floats(), before);
}

TEST(SpringBones, StartAnewAtRestWhenTheyAreToldToAndAfterALongTime) {
  const auto distance_after = [](const std::function<float(Plait&)>& jump) {
    Plait plait(weightless);
    plait.update_for(10);
    plait.body.model_in_world.position.x = 30.0F;
    plait.update(jump(plait));
    return glm::distance(plait.end(), posed_end);
  };
  EXPECT_GT(distance_after([](Plait&) { return frame; }), 0.1F);
  EXPECT_LT(distance_after([](Plait& plait) { return ++plait.body.restarts, frame; }), 1e-5F);
  EXPECT_LT(distance_after([](Plait&) { return 1.0F; }), 1e-5F);
}

TEST(SpringBones, StayWhereTheyAreWhileNoTimePasses) {
  Plait plait({});
  for (int i = 0; i < 30; ++i) {
    plait.body.model_in_world.position.x += 0.05F;
    plait.update();
    const glm::vec3 end = plait.end();
    plait.update(0.0F);
    EXPECT_LT(glm::distance(plait.end(), end), 1e-5F);
  }
}

TEST(SpringBones, ComeBackFromAPlacementThatIsNotANumber) {
  Plait plait(weightless);
  plait.update_for(3);
  plait.body.model_in_world.position.x = std::numeric_limits<float>::quiet_NaN();
  plait.update();
  plait.body.model_in_world.position.x = 0.0F;
  plait.update_for(3);
  EXPECT_LT(glm::distance(plait.end(), posed_end), 1e-3F);
}

TEST(SpringBones, AreSoundHoweverStiffAndHoweverLongAStepIs) {
  for (const float stiffness : {0.0F, 1.0F, 1e4F, 1e8F}) {
    for (const float seconds : {1e-5F, 0.013F, 0.5F}) {
      Plait plait({.stiffness = stiffness});
      for (int i = 0; i < 50; ++i) {
        plait.body.model_in_world.position.x = i % 2 == 0 ? 1.0F : 0.0F;
        plait.update(seconds);
        EXPECT_TRUE(plait.pose.is_finite());
        EXPECT_NEAR(glm::distance(plait.tail(3), plait.tail(2)), segment, 1e-4F);
      }
    }
  }
}

}  // namespace
}  // namespace throng::anim::spring_bones_test
