#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "engine/anim/agent/targeted_processes.h"
#include "tests/anim/agent/person_crowd.h"

namespace throng::anim::look_at_process_test {
namespace {

class PersonWhoIsTold : public testing::Test {
 protected:
  glm::vec3 facing() const { return crowd_.joint("head").rotation * glm::vec3(0.0F, 0.0F, 1.0F); }
  PersonCrowd crowd_{{.schedule = Schedule::levels}};
};

class PersonWhoIsToldToLook : public PersonWhoIsTold {
 protected:
  PersonWhoIsToldToLook() {
    EXPECT_TRUE(crowd_.system().agent(0).add_post_process(std::make_unique<LookAtProcess>(*crowd_.kinds().look_at)));
  }
  template <typename Change>
  void tell(Change&& change) {
    EXPECT_TRUE(crowd_.system().agent(0).change_process<LookAtProcess>({0}, change));
  }
};

TEST_F(PersonWhoIsToldToLook, LooksAtTheTargetAndAwayAgainWithoutAJump) {
  tell([](auto& look) { look.look_at({2.0F, 1.5F, 2.0F}, ticks_per_second / 2); });
  glm::vec3 last = facing();
  float largest_turn = 0.0F;
  const auto watch = [&](int frames) {
    for (int frame = 0; frame < frames; ++frame) {
      crowd_.step();
      largest_turn = std::max(largest_turn, glm::distance(facing(), last));
      last = facing();
    }
  };
  watch(1);
  watch(120);
  EXPECT_LT(crowd_.system().agent(0).post_process<LookAtProcess>({0})->remaining(crowd_.system().characters().pools(0)),
            0.03F);
  EXPECT_GT(facing().x, 0.6F);
  tell([](auto& look) { look.look_away(ticks_per_second / 2); });
  watch(60);
  EXPECT_LT(std::fabs(facing().x), 0.11F) << "the march itself turns the spine by 0.1";
  EXPECT_LT(largest_turn, 0.12F) << "radians a frame: 7 a second";
}

TEST_F(PersonWhoIsToldToLook, FollowsATargetThatMovesFromFrameToFrame) {
  for (int frame = 0; frame < 200; ++frame) {
    const float side = std::sin(0.02F * static_cast<float>(frame));
    tell([&](auto& look) { look.look_at({2.0F * side, 1.5F, 2.0F}); });
    crowd_.step();
    if (frame < 100) continue;
    EXPECT_LT(
        crowd_.system().agent(0).post_process<LookAtProcess>({0})->remaining(crowd_.system().characters().pools(0)),
        0.2F)
        << frame;
  }
}

TEST_F(PersonWhoIsTold, ReachesForAPlaceWithAHand) {
  const auto arm = *person_rigs().limb(CharacterRigs::Limb::right_arm);
  const glm::vec3 target(-0.35F, 1.25F, 0.25F);
  auto reach = std::make_unique<ReachProcess>(*crowd_.kinds().limbs, ReachProcess::Settings{.limb = arm});
  reach->set_target(target);
  reach->set_weight(1.0F, ticks_per_second / 4);
  ASSERT_TRUE(crowd_.system().agent(0).add_post_process(std::move(reach)));
  crowd_.step(1);
  EXPECT_GT(glm::distance(crowd_.joint("hand.R").position, target), 0.1F);
  crowd_.step(20);
  EXPECT_LT(glm::distance(crowd_.joint("hand.R").position, target), 1e-3F);
  EXPECT_LT(crowd_.system().agent(0).post_process<ReachProcess>({0})->missed_by(crowd_.system().characters().pools(0)),
            1e-3F);
}

}  // namespace
}  // namespace throng::anim::look_at_process_test
