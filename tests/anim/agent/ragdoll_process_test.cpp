#include "engine/anim/agent/ragdoll_process.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "tests/anim/agent/person_crowd.h"

namespace throng::anim::ragdoll_process_test {
namespace {

using Phase = RagdollProcess::Phase;

class PersonPushedOver : public testing::Test {
 protected:
  PersonPushedOver() {
    EXPECT_TRUE(crowd_.system().agent(0).add_post_process(std::make_unique<RagdollProcess>(*crowd_.kinds().ragdoll)));
    crowd_.step(2);
    joints_ = crowd_.joints();
  }
  void push(const glm::vec3& impulse = {0.0F, 0.0F, -40.0F}) {
    EXPECT_TRUE(crowd_.system().agent(0).change_process<RagdollProcess>({0}, [&](auto& ragdoll) {
      ragdoll.push(impulse, {0.0F, 1.3F, 0.0F});
    }));
  }
  void recover(Ticks fade = ticks_per_second) {
    EXPECT_TRUE(
        crowd_.system().agent(0).change_process<RagdollProcess>({0}, [&](auto& ragdoll) { ragdoll.recover(fade); }));
  }
  const RagdollProcess& ragdoll() { return *crowd_.system().agent(0).post_process<RagdollProcess>({0}); }
  /// The longest way that a joint goes from one frame to the next, in metres.
  double largest_step(int frames) {
    double largest = 0.0;
    for (int frame = 0; frame < frames; ++frame) {
      crowd_.step();
      const std::vector<glm::dvec3> now = crowd_.joints();
      for (std::size_t bone = 0; bone < now.size(); ++bone) {
        largest = std::max(largest, glm::distance(now[bone], joints_[bone]));
      }
      joints_ = now;
    }
    return largest;
  }

  PersonCrowd crowd_{{.schedule = Schedule::levels}};
  std::vector<glm::dvec3> joints_;
};

TEST_F(PersonPushedOver, FallsLiesStillAndComesBack) {
  push();
  crowd_.step(480);
  EXPECT_EQ(ragdoll().phase(), Phase::down);
  EXPECT_TRUE(ragdoll().is_asleep(crowd_.system().characters().pools(0)));
  EXPECT_LT(crowd_.joint("head").position.y, 0.5F);
  EXPECT_LT(ragdoll().hips(crowd_.system().characters().pools(0)).y, 0.4F);
  recover();
  crowd_.step(62);
  EXPECT_EQ(ragdoll().phase(), Phase::standing);
  EXPECT_NEAR(crowd_.joint("head").position.y, 1.565F, 0.01F);
  EXPECT_EQ(crowd_.system().characters().pools(0).pool(*crowd_.kinds().ragdoll).memory().bytes_alive, 0U);
}

// A joint of the march goes 3.6 cm in its fastest frame. At a switch none goes more than 2 cm farther than it might.
TEST_F(PersonPushedOver, MakesNoJumpOnTheWayDownNorOnTheWayUp) {
  const double marching = largest_step(60);
  push();
  EXPECT_LT(largest_step(10), marching + 0.02) << "from the animation to the rag-doll";
  EXPECT_LT(largest_step(470), 0.15) << "on the way down: 9 m/s";
  recover();
  EXPECT_LT(largest_step(5), 0.02) << "from the rag-doll to the animation";
  EXPECT_LT(largest_step(50), marching + 0.03);
  EXPECT_LT(largest_step(30), marching + 0.01) << "when the blend is over";
  EXPECT_EQ(ragdoll().phase(), Phase::standing);
}

TEST_F(PersonPushedOver, ShowsTheAnimationToTheBitUntilItIsLetGo) {
  PersonCrowd other({.schedule = Schedule::levels});
  other.step(2);
  push();
  for (int frame = 0; frame < 2; ++frame) {
    crowd_.step();
    other.step();
    EXPECT_EQ(crowd_.joints(), other.joints());
    EXPECT_EQ(ragdoll().phase(), Phase::letting_go);
  }
  crowd_.step();
  other.step();
  EXPECT_NE(crowd_.joints(), other.joints());
}

TEST_F(PersonPushedOver, FallsAgainFromWhereItIsWhenPushedWhileItGetsUp) {
  push();
  crowd_.step(300);
  recover();
  crowd_.step(30);
  joints_ = crowd_.joints();
  push({0.0F, 0.0F, 10.0F});
  EXPECT_EQ(ragdoll().phase(), Phase::down);
  EXPECT_LT(largest_step(3), 0.08) << "it came up at that speed";
  crowd_.step(300);
  EXPECT_LT(crowd_.joint("head").position.y, 0.5F);
}

TEST_F(PersonPushedOver, CanBeToldToRecoverBeforeItIsLetGo) {
  push();
  recover(ticks_per_second / 10);
  crowd_.step(30);
  EXPECT_EQ(ragdoll().phase(), Phase::standing);
  EXPECT_NEAR(crowd_.joint("head").position.y, 1.565F, 0.01F);
}

TEST_F(PersonPushedOver, GoesOnWithItsAnimationsClockWhileItLies) {
  PersonCrowd other({.schedule = Schedule::levels});
  other.step(2);
  push();
  crowd_.step(100);
  recover(Ticks{});
  crowd_.step(20);
  other.step(120);
  EXPECT_EQ(crowd_.joints(), other.joints());
}

TEST(PersonInASmallStore, StaysAsItIsWhereARagdollHasNoRoom) {
  std::size_t kib = 1;
  while (!AnimationSystem::create(person(), {.local_store_bytes = kib * 1024})) ++kib;
  PersonCrowd crowd({.local_store_bytes = kib * 1024});
  PersonCrowd other({.local_store_bytes = kib * 1024});
  ASSERT_TRUE(crowd.system().agent(0).add_post_process(std::make_unique<RagdollProcess>(*crowd.kinds().ragdoll)));
  const auto push = [](auto& ragdoll) { ragdoll.push({0.0F, 0.0F, -40.0F}, {0.0F, 1.3F, 0.0F}); };
  const Status pushed = crowd.system().agent(0).change_process<RagdollProcess>({0}, push);
  ASSERT_FALSE(pushed);
  EXPECT_NE(pushed.error().message.find("local store"), std::string::npos);
  EXPECT_EQ(crowd.system().agent(0).post_process<RagdollProcess>({0})->phase(), Phase::standing);
  crowd.step(10);
  other.step(10);
  EXPECT_EQ(crowd.system().figures().pose_hash(), other.system().figures().pose_hash());
}

TEST_F(PersonPushedOver, FallsTheWayItIsPushed) {
  push({0.0F, 0.0F, -60.0F});
  crowd_.step(300);
  EXPECT_LT(crowd_.joint("head").position.z, -0.4F);
}

}  // namespace
}  // namespace throng::anim::ragdoll_process_test
