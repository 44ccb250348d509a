#include "engine/anim/base/units.h"

#include <chrono>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

#include <gtest/gtest.h>

#include "engine/anim/agent/animation_system.h"

namespace throng::anim::units_test {
namespace {

using namespace std::chrono_literals;

template <typename Time>
concept Advances = requires(AnimationSystem& system, Time time) {
  system.advance(time);
};
template <typename Number>
concept Scales = requires(Ticks ticks, Number number) {
  ticks* number;
}
|| requires(Ticks ticks, Number number) { number* ticks; }
|| requires(Ticks ticks, Number number) { ticks / number; };
template <typename Number>
concept Seconds = requires(Number number) {
  to_ticks(number);
};

TEST(Ticks, AreTakenForNoNumberAndNoNumberForThem) {
  static_assert(Advances<Ticks>);
  static_assert(!Advances<double>, "advance(1.0 / 60) would advance by nothing");
  static_assert(!Advances<int>, "advance(16) would not be 16 ms");
  static_assert(!Advances<FineTicks>, "a position in a clip is no time");
  static_assert(!std::is_convertible_v<Ticks, FineTicks> && !std::is_convertible_v<Ticks, double>);
  static_assert(!std::is_convertible_v<Ticks, bool>);
  static_assert(std::constructible_from<Ticks, std::int64_t> && !std::constructible_from<Ticks, double>);
  static_assert(!std::equality_comparable_with<Ticks, int>);
}

TEST(Ticks, AreScaledByWholeNumbersAlone) {
  static_assert(Scales<int> && Scales<std::uint32_t>);
  static_assert(!Scales<double> && !Scales<float>, "times 0.5 would be times 0");
  static_assert(3 * ticks_per_second / 3 == ticks_per_second);
  static_assert(ticks_per_second * 2 / (ticks_per_second / 60) == 120);
  static_assert(5 * ticks_per_second % (2 * ticks_per_second) == ticks_per_second);
  static_assert(-(Ticks{3} - Ticks{5}) + Ticks{1} == Ticks{3});
}

TEST(Ticks, ComeFromDurationsThatAreWholeTicks) {
  static_assert(Ticks{1s} == ticks_per_second);
  static_assert(Ticks{16ms}.count() == 16 * 705'600);
  static_assert(Ticks{-1h} == -3600 * ticks_per_second);
  static_assert(Ticks{std::chrono::duration<int, std::ratio<1, 60>>(1)} == ticks_per_second / 60);
  static_assert(Advances<std::chrono::milliseconds> && Advances<std::chrono::hours>);
  static_assert(250ms < ticks_per_second && ticks_per_second - 250ms == 750ms);
}

TEST(Ticks, ComeFromShorterDurationsByTheNearestTick) {
  static_assert(Ticks{16us}.count() == 11'290 && Ticks{5us}.count() == 3'528);  // 11,289.6 and 3,528
  static_assert(Ticks{1ns}.count() == 1 && Ticks{-1ns}.count() == -1);          // 0.7056
  static_assert(Ticks{2ns}.count() == 1 && Ticks{-2ns}.count() == -1);          // 1.4112
  static_assert(Ticks{24h + 1ns} == 24 * 3600 * ticks_per_second + Ticks{1});
  static_assert(Advances<std::chrono::steady_clock::duration>);
}

TEST(Ticks, DoNotComeFromDurationsThatAreFloats) {
  static_assert(!std::constructible_from<Ticks, std::chrono::duration<double>>);
  static_assert(!std::constructible_from<Ticks, std::chrono::duration<float, std::milli>>);
}

TEST(Ticks, FromDurationsEndAtTheLongestTime) {
  static_assert(Ticks{std::chrono::seconds::max()} == longest_time);
  static_assert(Ticks{std::chrono::hours::min()} == -longest_time);
  static_assert(Ticks{std::chrono::nanoseconds::max()} == longest_time, "it is 292 years, of 207 at most");
  static_assert(Ticks{std::chrono::years{200}} < longest_time);
}

TEST(Ticks, AreBytesOfABlockAndZeroBytesAreNoTime) {
  static_assert(sizeof(Ticks) == 8 && std::is_trivial_v<Ticks> && std::is_standard_layout_v<Ticks>);
  Ticks ticks{1};
  std::memset(&ticks, 0, sizeof(ticks));
  EXPECT_EQ(ticks, Ticks{});
}

TEST(Ticks, EndWhereTheirIntegersEnd) {
  EXPECT_EQ(std::numeric_limits<Ticks>::max().count(), std::numeric_limits<std::int64_t>::max());
  EXPECT_EQ(std::numeric_limits<Ticks>::lowest().count(), std::numeric_limits<std::int64_t>::min());
}

TEST(Ticks, AreReadAsTheirNumber) { EXPECT_EQ(testing::PrintToString(Ticks{-705}), "-705 ticks"); }

TEST(ToTicks, RoundsToTheNearestTick) {
  EXPECT_EQ(to_ticks(1.0 / 60.0), ticks_per_second / 60);
  EXPECT_EQ(to_ticks(0.6 / 705'600'000.0), Ticks{1});
  EXPECT_EQ(to_ticks(-0.25), -ticks_per_second / 4);
  EXPECT_EQ(to_ticks(2), 2 * ticks_per_second);
  EXPECT_EQ(to_seconds(to_ticks(0.125)), 0.125);
}

TEST(ToTicks, GivesATimeForAnySeconds) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(to_ticks(std::numeric_limits<double>::quiet_NaN()), Ticks{});
  EXPECT_EQ(to_ticks(infinity), longest_time);
  EXPECT_EQ(to_ticks(-infinity), -longest_time);
  EXPECT_EQ(to_ticks(1e30), longest_time);
  EXPECT_EQ(to_ticks(-std::numeric_limits<double>::max()), -longest_time);
  constexpr double year = 365.25 * 24 * 3600;
  EXPECT_LT(to_ticks(206.0 * year), longest_time);
  EXPECT_GT(to_ticks(206.0 * year), Ticks{});
}

TEST(ToTicks, TakesNoPositionForSeconds) { static_assert(Seconds<double> && Seconds<int> && !Seconds<FineTicks>); }

TEST(FineTicks, LeadToTicksAndBack) {
  static_assert(Ticks{3} * fine_ticks_per_tick == FineTicks{3 * 65536});
  static_assert((Ticks{3} * fine_ticks_per_tick + 65535) / fine_ticks_per_tick == Ticks{3});
  static_assert(FineTicks{-65535} / fine_ticks_per_tick == Ticks{});
}

}  // namespace
}  // namespace throng::anim::units_test
