#include <array>

#include <gtest/gtest.h>

#include "app/window/panel/controls/numbers.h"

namespace throng::app::number_scale_test {
namespace {

constexpr std::array<int, 4> stops = {0, 16, 32, 64};
const NumberScale logarithmic = {.lowest = 1, .highest = 100'000, .logarithmic = true};
const NumberScale metres = {.lowest = 0, .highest = 100, .decimals = 1, .suffix = " m"};
const NumberScale with_stops = {.highest = 64, .zero_word = "auto", .suffix = " KiB", .stops = stops};

TEST(NumberScale, AValueComesBackFromItsPlace) {
  for (const double value : {1.0, 10.0, 1000.0, 100'000.0}) {
    EXPECT_DOUBLE_EQ(value_at(logarithmic, place_of(logarithmic, value)), value);
  }
  for (const double value : {0.0, 12.5, 100.0}) EXPECT_DOUBLE_EQ(value_at(metres, place_of(metres, value)), value);
  for (const int stop : stops) EXPECT_EQ(value_at(with_stops, place_of(with_stops, stop)), stop);
}

TEST(NumberScale, PlacesBeyondTheTrackAreItsEnds) {
  EXPECT_EQ(value_at(metres, -3), 0);
  EXPECT_EQ(value_at(metres, 3), 100);
  EXPECT_EQ(place_of(metres, 1e9), 1);
  EXPECT_EQ(place_of(logarithmic, 0), 0);
}

TEST(NumberScale, WritesUnitsAndWords) {
  EXPECT_EQ(written(metres, 12.5), "12.5 m");
  EXPECT_EQ(written(with_stops, 0), "auto");
  EXPECT_EQ(written(with_stops, 32), "32 KiB");
}

TEST(NumberScale, WritesThousandsApartAsAllTextsOfThePanelDo) {
  EXPECT_EQ(written(logarithmic, 158'000), "158,000");
  EXPECT_EQ(written({.lowest = -5000, .decimals = 1, .suffix = " m"}, -1234.5), "-1,234.5 m");
  for (const double value : {-123'456.0, -4321.0, 999.0, 1'000'000.0}) {
    const NumberScale scale{.lowest = -1e9, .highest = 1e9, .decimals = 2};
    EXPECT_EQ(meant(scale, written(scale, value)), value);
  }
}

TEST(NumberScale, ReadsWhatPeopleType) {
  EXPECT_EQ(meant(metres, "7"), 7);
  EXPECT_EQ(meant(metres, " 7.25m "), 7.3);
  EXPECT_EQ(meant(logarithmic, "12,345"), 12345);
  EXPECT_EQ(meant(with_stops, "auto"), 0);
  EXPECT_EQ(meant(with_stops, "30"), 32);
}

TEST(NumberScale, TakesAllThatAValueMayBeWhereTheTrackShowsAPartOfIt) {
  const NumberScale seed = scale_of("seed");
  EXPECT_EQ(value_at(seed, 1), 9999);
  EXPECT_EQ(meant(seed, "4294967295"), 4'294'967'295.0);
  EXPECT_EQ(meant(seed, "4,294,967,295"), 4'294'967'295.0);
  EXPECT_EQ(meant(seed, "9999999999"), 4'294'967'295.0) << "the most that a seed can be";
  EXPECT_EQ(written(seed, 4'294'967'295.0), "4,294,967,295");
}

TEST(NumberScale, ReadsACommaAsThePointWhereItSeparatesNoThousands) {
  EXPECT_EQ(meant(metres, "3,5"), 3.5);
  EXPECT_EQ(meant(metres, "7,25 m"), 7.3);
  EXPECT_EQ(meant(logarithmic, "2,500"), 2500);
  EXPECT_EQ(meant(logarithmic, "1,2345"), 1) << "1.2345, and whole";
  EXPECT_FALSE(meant(metres, "1,2,3"));
}

TEST(NumberScale, RefusesWhatIsNoNumber) {
  for (const char* const text : {"", "m", "7 feet", "nan", "inf", "--1", "auto"}) {
    EXPECT_FALSE(meant(metres, text)) << text;
  }
}

TEST(NumberScale, AStepIsOneOfTheLastDigitTheNextStopOrAHundredthOfALogarithmicTrack) {
  EXPECT_NEAR(stepped({.highest = 8, .decimals = 2}, 1, 1), 1.01, 1e-9);
  EXPECT_NEAR(stepped({.highest = 8, .decimals = 2}, 1, -10), 0.9, 1e-9);
  EXPECT_EQ(stepped({.highest = 8}, 8, 1), 8);
  EXPECT_EQ(stepped(with_stops, 16, 1), 32);
  EXPECT_EQ(stepped(with_stops, 16, -10), 0);
  EXPECT_NEAR(stepped(logarithmic, 1000, 1), 1122, 1);
  EXPECT_EQ(stepped(logarithmic, 1, 1), 2) << "at least one";
  EXPECT_EQ(stepped(logarithmic, 100'000, 1), 100'000);
}

}  // namespace
}  // namespace throng::app::number_scale_test
