#include "app/people/crowd/steering/step_strip.h"

#include <array>
#include <vector>

#include <gtest/gtest.h>

#include "engine/base/random.h"
#include "tests/app/people/crowd/steering/plain_step.h"

namespace throng::app::step_strip_test {
namespace {

constexpr StepRules rules{.seconds = 1.0F / 60.0F, .spacing = 1.0F, .most_speed = 3.0F, .sight = 4.0F, .closing = 0.6F};

/// Walkers of a strip among bodies that are strewn over a square; the first bodies are the walkers.
class StripOfWalkers : public testing::Test {
 protected:
  void strew(std::uint32_t count, float half_side, std::size_t walkers) {
    bodies_.clear();
    wishes_.clear();
    for (std::uint32_t i = 0; i < count; ++i) {
      bodies_.push_back({.position = {random_.between(-half_side, half_side), random_.between(-half_side, half_side)},
                         .velocity = {random_.between(-1.5F, 1.5F), random_.between(-1.5F, 1.5F)},
                         .radius = random_.between(0.2F, 0.35F),
                         .agent = i,
                         .company = i / 2,
                         .moves = i % 3 != 0});
      const bool stands = i % 7 == 6;
      wishes_.push_back({.velocity = stands ? glm::vec2(0.0F) : glm::vec2(random_.between(-2.0F, 2.0F), 1.0F),
                         .most_speed = random_.between(0.5F, 2.5F)});
    }
    columns_.set_aside(bodies_.size());
    for (std::size_t i = 0; i < bodies_.size(); ++i) write_body(bodies_[i], i, columns_);
    strip_ = {};
    strip_.count = walkers;
    for (std::size_t lane = 0; lane < walkers; ++lane) {
      strip_.x[lane] = bodies_[lane].position.x;
      strip_.z[lane] = bodies_[lane].position.y;
      strip_.velocity_x[lane] = bodies_[lane].velocity.x;
      strip_.velocity_z[lane] = bodies_[lane].velocity.y;
      strip_.radius[lane] = bodies_[lane].radius;
      strip_.wish_x[lane] = wishes_[lane].velocity.x;
      strip_.wish_z[lane] = wishes_[lane].velocity.y;
      strip_.most_speed[lane] = wishes_[lane].most_speed;
      strip_.company[lane] = bodies_[lane].company;
      strip_.place[lane] = static_cast<std::uint32_t>(lane);
    }
  }

  /// Lets each lane see its own choice of the bodies, some of them in a second go.
  void see_some() {
    for (std::vector<std::uint32_t>& of_lane : seen_) of_lane.clear();
    for (int go = 0; go < 2; ++go) {
      FoundByLane found;
      for (std::size_t lane = 0; lane < strip_.count; ++lane) {
        for (std::uint32_t body = 0; body < bodies_.size() && found.count[lane] < NearBodies::most; ++body) {
          if (!random_.chance(0.6F)) continue;
          found.places[found.count[lane]++][lane] = body;
          seen_[lane].push_back(body);
        }
      }
      see({.bodies = &columns_, .found = &found, .rules = rules}, strip_);
    }
  }

  void expect_plain_steps() {
    take_step(rules, strip_);
    for (std::size_t lane = 0; lane < strip_.count; ++lane) {
      plain::PlainStep plain(bodies_[lane], wishes_[lane], rules);
      for (const std::uint32_t body : seen_[lane]) plain.see(bodies_[body]);
      const glm::vec2 velocity = plain.velocity();
      const glm::vec2 position = bodies_[lane].position + velocity * rules.seconds;
      EXPECT_EQ(glm::vec2(strip_.velocity_x[lane], strip_.velocity_z[lane]), velocity) << "lane " << lane;
      EXPECT_EQ(glm::vec2(strip_.x[lane], strip_.z[lane]), position) << "lane " << lane;
      turned_ += velocity != wishes_[lane].velocity ? 1 : 0;
      crowded_ += strip_.limit_count[lane] > StepStrip::most_limits ? 1 : 0;
    }
  }

  void expect_plain_steps_of(std::uint32_t bodies, float half_side, std::size_t walkers) {
    strew(bodies, half_side, walkers);
    see_some();
    expect_plain_steps();
  }

  Random random_{7, 1};
  std::vector<Body> bodies_;
  std::vector<Wish> wishes_;
  BodyColumns columns_;
  StepStrip strip_;
  std::array<std::vector<std::uint32_t>, StepStrip::lanes> seen_;
  int turned_ = 0, crowded_ = 0;
};

TEST_F(StripOfWalkers, StepsAsEachWouldAloneToTheBit) {
  for (int i = 0; i < 200; ++i) expect_plain_steps_of(40, 3.0F, StepStrip::lanes);
  EXPECT_GT(turned_, 2000) << "others matter";
}

TEST_F(StripOfWalkers, MayBePartlyEmpty) {
  for (const std::size_t walkers : {1U, 5U, 15U}) expect_plain_steps_of(30, 2.0F, walkers);
}

TEST_F(StripOfWalkers, StandsWhereMoreAreCloseThanCanBeToldApart) {
  for (int i = 0; i < 20; ++i) expect_plain_steps_of(60, 0.8F, StepStrip::lanes);
  EXPECT_GT(crowded_, 100);
}

TEST_F(StripOfWalkers, KeepsFartherFromObstaclesThanFromPeople) {
  strew(2, 0.0F, 1);
  bodies_[1] = {.position = bodies_[0].position + glm::vec2(0.0F, 1.5F), .radius = 0.5F, .agent = 1};
  write_body(bodies_[1], 1, columns_);
  FoundByLane found;
  found.count[0] = 1;
  found.places[0][0] = 1;
  see({.bodies = &columns_, .found = &found, .keeps = kept_from_obstacles, .rules = rules}, strip_);
  plain::PlainStep plain(bodies_[0], wishes_[0], rules);
  plain.see_obstacle(bodies_[1]);
  take_step(rules, strip_);
  EXPECT_EQ(glm::vec2(strip_.velocity_x[0], strip_.velocity_z[0]), plain.velocity());
}

}  // namespace
}  // namespace throng::app::step_strip_test
