#include "app/people/crowd/groups.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace throng::app::groups_test {
namespace {

constexpr double side = 150.0, cell = 10.0;
constexpr std::size_t people = 3000;

/// Returns how many stand in each cell of the ground, the fewest first.
std::vector<int> counts(std::uint32_t seed) {
  const GroupGround ground{.side = side, .spacing = 1.0, .viewpoint = {75.0, 75.0}, .lanes = {}, .obstacles = {}};
  const auto columns = static_cast<std::size_t>(side / cell);
  std::vector<int> found(columns * columns);
  for (const StanderStart& place : place_groups(people, ground, Random(seed, 3))) {
    const auto column = [](double at) {
      return static_cast<std::size_t>(std::clamp((at + side / 2.0) / cell, 0.0, side / cell - 0.5));
    };
    ++found[column(place.position.y) * columns + column(place.position.x)];
  }
  std::ranges::sort(found);
  return found;
}

TEST(Groups, StandCloserHereAndFartherApartThere) {
  for (const std::uint32_t seed : {1U, 2U, 3U}) {
    const std::vector<int> found = counts(seed);
    const std::size_t tenth = found.size() / 10;
    EXPECT_LE(found[tenth], 6) << seed << ": an even crowd has 13 in each";
    EXPECT_GE(found[found.size() - tenth], 22) << seed;
    EXPECT_GE(found[found.size() / 4], 2) << seed << ": but no large part is empty";
  }
}

}  // namespace
}  // namespace throng::app::groups_test
