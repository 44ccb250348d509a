#include <cstddef>
#include <cstring>
#include <memory>

#include <gtest/gtest.h>

#include "tests/anim/kernel/ragdoll/ragdoll_stage.h"

namespace throng::anim::ragdoll_bits_test {
namespace {

using namespace ragdoll_stage;

class RagdollBits : public testing::Test {
 protected:
  RagdollState stepped(Ticks by, double seconds) const {
    RagdollState state = standing(rig_);
    const GroundPlane ground;
    for (Ticks left = to_ticks(seconds); left > Ticks{}; left -= by)
      ragdoll_step(rig_, {&ground, 1}, std::min(left, by), state);
    return state;
  }

  RagdollRig rig_ = rig_of(person());
};

TEST_F(RagdollBits, DoNotDependOnHowTimeIsSplit) {
  const RagdollState whole = fallen(rig_, 1.0);
  for (const Ticks by : {ticks_per_second / 60, ticks_per_second / 144, ticks_per_second / 7, Ticks{1'234'567}}) {
    EXPECT_TRUE(same_bits(stepped(by, 1.0), whole)) << by;
  }
}

TEST_F(RagdollBits, DoNotDependOnHowTimeIsSplitAcrossFallingAsleep) {
  ASSERT_EQ(fallen(rig_, 5.0).asleep, 1);
  EXPECT_TRUE(same_bits(stepped(ticks_per_second / 30, 5.0), fallen(rig_, 5.0)));
}

TEST_F(RagdollBits, GoOnTheSameFromACopyElsewhere) {
  RagdollState state = fallen(rig_, 0.5);
  alignas(RagdollState) std::byte copy[sizeof(RagdollState)];
  std::memcpy(copy, &state, sizeof state);
  run(rig_, 1.0, state);
  RagdollState resumed;
  std::memcpy(&resumed, copy, sizeof resumed);
  run(rig_, 1.0, resumed);
  EXPECT_TRUE(same_bits(resumed, state));
}

TEST_F(RagdollBits, WaitForAWholeStep) {
  RagdollState state = standing(rig_);
  const glm::vec3 before = state.bodies[0].position;
  const GroundPlane ground;
  ragdoll_step(rig_, {&ground, 1}, ragdoll_step_ticks - Ticks{1}, state);
  EXPECT_EQ(state.bodies[0].position, before);
  ragdoll_step(rig_, {&ground, 1}, Ticks{1}, state);
  EXPECT_NE(state.bodies[0].position, before);
}

}  // namespace
}  // namespace throng::anim::ragdoll_bits_test
