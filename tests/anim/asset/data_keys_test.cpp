#include "engine/anim/asset/data_keys.h"

#include <algorithm>
#include <random>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

namespace throng::anim::data_keys_test {
namespace {

constexpr Ticks second = ticks_per_second;
constexpr FineTicks fine_second = second * fine_ticks_per_tick;

struct Met {
  FineTicks position;
  std::uint32_t name;
  bool operator==(const Met&) const = default;
};
std::ostream& operator<<(std::ostream& out, const Met& met) { return out << met.name << " at " << met.position; }

std::vector<Met> meet(const std::vector<DataKey>& keys, Ticks duration, bool looping, FineTicks from, FineTicks to) {
  std::vector<Met> met;
  for_each_data_key(keys, duration, looping, from, to, [&](const DataKey& key, FineTicks position) {
    met.push_back({position, key.name});
    return true;
  });
  return met;
}

std::vector<std::uint32_t> names(const std::vector<Met>& met) {
  std::vector<std::uint32_t> result;
  for (const Met& one : met) result.push_back(one.name);
  return result;
}

using Names = std::vector<std::uint32_t>;

/// Keys 0 to 3 at the start, at 0.25 s, at 0.75 s and at the end of one second.
const std::vector<DataKey> four_keys{{.time = {}, .name = 0},
                                     {.time = second / 4, .name = 1},
                                     {.time = second * 3 / 4, .name = 2},
                                     {.time = second, .name = 3}};

TEST(DataKeys, AreMetInTheOrderOfTheMotion) {
  EXPECT_EQ(names(meet(four_keys, second, true, fine_second / 8, fine_second * 7 / 8)), (Names{1, 2}));
  EXPECT_EQ(names(meet(four_keys, second, true, fine_second * 7 / 8, fine_second / 8)), (Names{2, 1}));
}

TEST(DataKeys, OfTheSeamOfALoopAreBothMetTheEndFirst) {
  EXPECT_EQ(names(meet(four_keys, second, true, fine_second * 7 / 8, fine_second * 9 / 8)), (Names{3, 0}));
  EXPECT_EQ(names(meet(four_keys, second, true, fine_second * 9 / 8, fine_second * 7 / 8)), (Names{0, 3}));
}

TEST(DataKeys, OfTheSeamAreSharedByAStepThatEndsThereAndOneThatBeginsThere) {
  EXPECT_EQ(names(meet(four_keys, second, true, fine_second * 7 / 8, fine_second)), (Names{3}));
  EXPECT_EQ(names(meet(four_keys, second, true, fine_second, fine_second * 9 / 8)), (Names{0}));
  EXPECT_EQ(names(meet(four_keys, second, true, fine_second * 9 / 8, fine_second)), (Names{0}));
  EXPECT_EQ(names(meet(four_keys, second, true, fine_second, fine_second * 7 / 8)), (Names{3}));
}

TEST(DataKeys, AreMetAsTheMotionLeavesThem) {
  const FineTicks key = fine_second / 4;
  EXPECT_EQ(names(meet(four_keys, second, true, key - 1, key)), Names{});
  EXPECT_EQ(names(meet(four_keys, second, true, key, key + 1)), (Names{1}));
  EXPECT_EQ(names(meet(four_keys, second, true, key + 1, key)), Names{});
  EXPECT_EQ(names(meet(four_keys, second, true, key, key - 1)), (Names{1}));
}

TEST(DataKeys, AreNotMetByStandingStill) {
  for (const FineTicks position : {FineTicks{0}, fine_second / 4, fine_second, -fine_second}) {
    EXPECT_EQ(names(meet(four_keys, second, true, position, position)), Names{});
    EXPECT_EQ(names(meet(four_keys, second, false, position, position)), Names{});
  }
}

TEST(DataKeys, AtAnEndThatIsHeldAreMetOnceOnArrival) {
  EXPECT_EQ(names(meet(four_keys, second, false, 0, 5 * fine_second)), (Names{0, 1, 2, 3}));
  EXPECT_EQ(names(meet(four_keys, second, false, fine_second * 7 / 8, fine_second)), (Names{3}));
  EXPECT_EQ(names(meet(four_keys, second, false, fine_second, 5 * fine_second)), Names{});
  EXPECT_EQ(names(meet(four_keys, second, false, fine_second, -fine_second)), (Names{3, 2, 1, 0}));
  EXPECT_EQ(names(meet(four_keys, second, false, 0, -fine_second)), Names{});
}

TEST(DataKeys, AtOneTimeKeepTheirOrderAndTurnItBackwards) {
  const std::vector<DataKey> twins{{.time = second / 2, .name = 4}, {.time = second / 2, .name = 5}};
  EXPECT_EQ(names(meet(twins, second, true, 0, fine_second)), (Names{4, 5}));
  EXPECT_EQ(names(meet(twins, second, true, fine_second, 0)), (Names{5, 4}));
}

TEST(DataKeys, OfAClipWithoutDurationAreNeverMet) {
  const std::vector<DataKey> key{{.time = {}, .name = 0}};
  EXPECT_EQ(names(meet(key, Ticks{}, true, 0, fine_second)), Names{});
  EXPECT_EQ(names(meet(key, Ticks{}, false, 0, fine_second)), Names{});
}

TEST(DataKeys, TellWhereTheyWereMet) {
  EXPECT_EQ(meet(four_keys, second, true, 2 * fine_second + 1, 3 * fine_second - 1),
            (std::vector<Met>{{2 * fine_second + fine_second / 4, 1}, {2 * fine_second + fine_second * 3 / 4, 2}}));
}

TEST(DataKeys, StopWhenTheVisitorHasEnough) {
  int visits = 0;
  for_each_data_key(four_keys, second, true, 0, 100 * fine_second,
                    [&](const DataKey&, FineTicks) { return ++visits < 3; });
  EXPECT_EQ(visits, 3);
}

/// The definition, key by key and loop by loop: every key has a place on a line of half fine ticks, those at the ends
/// of the clip half a tick inside of it; a motion meets [from, to) or (to, from] of them.
std::vector<Met> meet_by_definition(const std::vector<DataKey>& keys, Ticks duration, FineTicks from, FineTicks to) {
  const FineTicks length = duration * fine_ticks_per_tick;
  const auto [low, high] = std::minmax(from, to);
  std::vector<std::tuple<FineTicks, std::size_t, Met>> places;
  for (FineTicks loop = low / length - 2; loop <= high / length + 2; ++loop) {
    for (std::size_t k = 0; k < keys.size(); ++k) {
      const FineTicks position = loop * length + keys[k].time * fine_ticks_per_tick;
      const FineTicks inside = keys[k].time == Ticks{} ? 1 : (keys[k].time == duration ? -1 : 0);
      const FineTicks place = 2 * position + inside;
      const bool met = from < to ? place >= 2 * from && place < 2 * to : place > 2 * to && place <= 2 * from;
      if (met) places.emplace_back(place, k, Met{position, keys[k].name});
    }
  }
  std::ranges::sort(places, [](const auto& a, const auto& b) {
    return std::tie(std::get<0>(a), std::get<1>(a)) < std::tie(std::get<0>(b), std::get<1>(b));
  });
  if (from > to) std::ranges::reverse(places);
  std::vector<Met> met;
  for (const auto& place : places) met.push_back(std::get<2>(place));
  return met;
}

/// Forward, backward, by whole loops, by single fine ticks, and not at all; now and then exactly onto a key.
class RandomSteps {
 public:
  explicit RandomSteps(FineTicks length) : length_(length) {}
  FineTicks next(FineTicks from, const std::vector<DataKey>& keys) {
    const auto any = [&](FineTicks limit) {
      return static_cast<FineTicks>(random_() % static_cast<std::uint64_t>(limit));
    };
    const FineTicks sign = random_() % 2 == 0 ? 1 : -1;
    switch (random_() % 6) {
      case 0:
        return from;
      case 1:
        return from + sign * any(3);
      case 2:
        return from + sign * any(length_ * 20);
      case 3:
        return from + sign * length_ * any(4);
      case 4: {
        const DataKey& key = keys[static_cast<std::size_t>(any(static_cast<FineTicks>(keys.size())))];
        return (whole_loops(from, length_) + sign) * length_ + key.time * fine_ticks_per_tick;
      }
      default:
        return from + sign * any(length_ / 10);
    }
  }

 private:
  FineTicks length_;
  std::mt19937_64 random_{11};
};

TEST(DataKeys, AreNeitherLostNorRepeatedInTenThousandRandomSteps) {
  const Ticks duration = second * 7 / 5 + Ticks{3};
  const std::vector<DataKey> keys{{.time = {}, .name = 0},
                                  {.time = Ticks{1}, .name = 1},
                                  {.time = duration / 3, .name = 2},
                                  {.time = duration / 3, .name = 3},
                                  {.time = duration - Ticks{1}, .name = 4},
                                  {.time = duration, .name = 5}};
  RandomSteps steps(duration * fine_ticks_per_tick);
  FineTicks position = 0;
  for (int i = 0; i < 10'000; ++i) {
    const FineTicks next = steps.next(position, keys);
    ASSERT_EQ(meet(keys, duration, true, position, next), meet_by_definition(keys, duration, position, next))
        << "step " << i << " from " << position << " to " << next;
    position = next;
  }
}

TEST(DataKeys, OfAMotionInPiecesAreThoseOfTheWhole) {
  const Ticks duration = second + Ticks{1};
  std::mt19937_64 random(3);
  for (const FineTicks sign : {1, -1}) {
    for (const bool looping : {true, false}) {
      const FineTicks from = sign > 0 ? 0 : duration * fine_ticks_per_tick;
      FineTicks position = from;
      std::vector<Met> pieces;
      for (int i = 0; i < 2'000; ++i) {
        const FineTicks next = position + sign * static_cast<FineTicks>(random() % (fine_second / 3));
        const std::vector<Met> piece = meet(four_keys, duration, looping, position, next);
        pieces.insert(pieces.end(), piece.begin(), piece.end());
        position = next;
      }
      EXPECT_EQ(pieces, meet(four_keys, duration, looping, from, position));
      EXPECT_GE(pieces.size(), 3U);
    }
  }
}

}  // namespace
}  // namespace throng::anim::data_keys_test
