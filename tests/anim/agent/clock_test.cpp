// Ten million frames, which are two days at 60 Hz. A sum of floats would be seconds off.
#include <cstdint>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "tests/anim/agent/crowd_rig.h"

namespace throng::anim::clock_test {
namespace {

constexpr int ten_millions = 10'000'000;

/// Lengths of frames that jitter as those of a window do: from none at all to a tenth of a second, with any fraction.
std::vector<Ticks> lengths_that_jitter() {
  std::mt19937 random(7);
  std::vector<Ticks> lengths{Ticks{}, Ticks{1}, to_ticks(0.1)};
  while (lengths.size() < 1000) lengths.push_back(to_ticks(1e-8 * static_cast<double>(random() % 1'700'000)));
  return lengths;
}

Ticks sum_of(const std::vector<Ticks>& lengths) {
  Ticks sum{};
  for (const Ticks length : lengths) sum += length;
  return sum;
}

TEST(Clock, IsTheExactSumOfTenMillionFramesOfASixtieth) {
  const CrowdRig crowd;
  for (int frame = 0; frame < ten_millions; ++frame) crowd->advance(to_ticks(1.0 / 60.0));
  EXPECT_EQ(crowd->clock(), ticks_per_second * ten_millions / 60) << "a sixtieth is a whole number of ticks";
}

TEST(Clock, IsTheExactSumOfTenMillionFramesThatJitter) {
  const CrowdRig crowd;
  const std::vector<Ticks> lengths = lengths_that_jitter();
  const std::int64_t times = ten_millions / static_cast<std::int64_t>(lengths.size());
  for (std::int64_t time = 0; time < times; ++time) {
    for (const Ticks length : lengths) crowd->advance(length);
  }
  EXPECT_EQ(crowd->clock(), sum_of(lengths) * times);
}

// Each agent is posed now and then on the way, which cuts its clip's time into parts. In one part, a player goes on for
// 27 hours at most (distance() in entity/player.h).
TEST(Clock, LeadsToTheSamePoseInTenMillionFramesAsInOne) {
  CrowdRig slow({}, 3), at_once({}, 3);
  const double speeds[] = {1.0, 1.1, -0.37};
  for (std::uint32_t agent = 0; agent < 3; ++agent) {
    for (CrowdRig* const crowd : {&slow, &at_once}) {
      (*crowd)->agent(agent).play({.clip = static_cast<int>(agent), .speed = speeds[agent]});
    }
  }
  const std::vector<Ticks> lengths = lengths_that_jitter();
  const std::int64_t times = ten_millions / static_cast<std::int64_t>(lengths.size());
  for (std::int64_t time = 0; time < times; ++time) {
    for (const Ticks length : lengths) slow->advance(length);
    if (time % 500 == 0) slow.step();
  }
  at_once->advance(slow->clock());
  slow.step();
  at_once.step();
  ASSERT_EQ(slow->clock(), at_once->clock());
  for (std::uint32_t agent = 0; agent < 3; ++agent) EXPECT_TRUE(slow.bones_unlike(at_once, agent).empty()) << agent;
}

}  // namespace
}  // namespace throng::anim::clock_test
