// Things in the hands of people who follow a recorded crowd.
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>
#include <gtest/gtest.h>

#include "app/show/camera/fly_camera.h"
#include "app/show/stage/stage.h"
#include "tests/app/show/stage/hand_height.h"
#include "tests/app/show/stage/tracks_stage.h"

namespace throng::app::recorded_hands_test {
namespace {

constexpr int people_who_walk = 4, people_who_stand = 2;

/// Four who walk side by side towards +Z at speeds of their own, and two who stand.
std::shared_ptr<const Trajectories> some_people() {
  Trajectories all;
  for (int person = 0; person < people_who_walk + people_who_stand; ++person) {
    PersonTrack track{.id = std::to_string(person), .rows = {}};
    const float speed = person < people_who_walk ? 1.0F + 0.15F * static_cast<float>(person) : 0.0F;
    for (int row = 0; row <= 100; ++row) {
      const float seconds = 0.1F * static_cast<float>(row);
      track.rows.push_back(
          {.seconds = 0.1 * row, .x = 1.5F * static_cast<float>(person), .z = speed * seconds - 8.0F, .heading = 0.0F});
    }
    all.row_count += track.rows.size();
    all.persons.push_back(std::move(track));
  }
  all.rows_a_second = 10.0;
  all.last_seconds = 10.0;
  all.file = "people";
  return std::make_shared<const Trajectories>(std::move(all));
}

class RecordedHands : public TracksStage {
 protected:
  RecordedHands()
      : TracksStage(some_people(), {.x = 4, .y = 5, .z = 12, .yaw = 0, .pitch = -15}, ticks_per_second / 30) {
    begin(2);
  }
  void begin(int pus) {
    open({.scene = Scene::tracks, .lod = {.rule = LodRule::off, .smooth = true}, .system = {.pus = pus, .hash = true}});
    EXPECT_TRUE(stage_->posed().keep_joints(stage_->animated().system()));
  }
  void give(HeldThing thing) {
    stage_->animated().give(std::vector<HeldThing>(people_who_walk + people_who_stand, thing));
  }
  std::uint64_t hash() const { return stage_->system().figures().pose_hash(); }

  float height_of(std::uint32_t agent, glm::vec3 at_rest) const {
    return test::height_in_hand(*stage_, agent, at_rest);
  }
};

TEST_F(RecordedHands, HoldUmbrellasUpWhoeverWalksOrStands) {
  give(HeldThing::umbrella);
  pass(30);
  for (std::uint32_t agent = 0; agent < people_who_walk + people_who_stand; ++agent) {
    EXPECT_GT(height_of(agent, glm::vec3(0)), 1.0F) << agent;
    EXPECT_TRUE(stage_->animated().details().held_arms().shows_thing(stage_->crowd(), agent));
  }
}

TEST_F(RecordedHands, SetASticksTipDownInStepWithTheWalk) {
  const glm::vec3 tip(0.711F, -0.635F, 0.0F);  // as held_arms_test.cpp has it
  give(HeldThing::stick);
  pass(30);
  int down = 0, lifted = 0;
  for (int i = 0; i < 120; ++i) {
    pass(1);
    for (std::uint32_t agent = 0; agent < people_who_walk; ++agent) {
      const float height = height_of(agent, tip);
      down += std::abs(height) < 0.035F ? 1 : 0;
      lifted += height > 0.04F ? 1 : 0;
      EXPECT_GT(height, -0.08F) << agent;
    }
  }
  EXPECT_GT(down, 120);
  EXPECT_GT(lifted, 40) << "a stick that keeps no step stays down";
}

TEST_F(RecordedHands, GiveTheSamePosesForAnyNumberOfPus) {
  give(HeldThing::phone);
  pass(40);
  const std::uint64_t two = hash();
  begin(1);
  give(HeldThing::phone);
  pass(40);
  EXPECT_EQ(hash(), two);
}

TEST_F(RecordedHands, KeepTheirThingsWhenTheClockJumps) {
  give(HeldThing::umbrella);
  pass(30);
  go_to(1.0);
  pass(2);
  go_to(8.0);
  pass(2);
  for (std::uint32_t agent = 0; agent < people_who_walk + people_who_stand; ++agent) {
    EXPECT_GT(height_of(agent, glm::vec3(0)), 1.0F) << agent;
  }
}

}  // namespace
}  // namespace throng::app::recorded_hands_test
