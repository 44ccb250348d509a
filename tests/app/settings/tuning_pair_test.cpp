#include "app/settings/tuning_pair.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace throng::app::tuning_pair_test {
namespace {

TEST(TuningPair, DoesNothingWhereNoneWaits) {
  TuningPair pair;
  Tuning tuning;
  tuning.agents = 5;
  pair.change_places(tuning);
  EXPECT_EQ(tuning.agents, 5);
  EXPECT_FALSE(pair.shows_b());
}

TEST(TuningPair, WhatIsPausedStaysPausedAndWhatIsLookedAtStaysWhenTheyChangePlaces) {
  TuningPair pair;
  Tuning tuning;
  pair.copy_to_other(tuning);
  tuning.paused = true;
  tuning.inspection.thresholds = true;
  tuning.agents = 5;
  pair.change_places(tuning);
  EXPECT_TRUE(tuning.paused);
  EXPECT_TRUE(tuning.inspection.thresholds);
  EXPECT_EQ(tuning.agents, Tuning().agents);
}

TEST(TuningPair, DiffersInValuesWithTheirUnits) {
  Tuning first, second;
  EXPECT_TRUE(differences(first, second).empty());
  second.error_px = 4;
  second.system.cost.least_task += 1;
  second.scene = Scene::parade;
  second.system.tile = 8;
  second.paused = true;
  second.inspection.forced_interval = 3;
  std::string said;
  for (const TuningDifference& each : differences(first, second)) {
    said += std::string(each.key) + " " + each.first + " | " + each.second + "\n";
  }
  EXPECT_THAT(said, testing::StartsWith("scene plaza | parade\nerror_px 1 px | 4 px\ntile auto | 8\n"));
  EXPECT_THAT(said, testing::EndsWith(" ns\n"));
}

TEST(TuningPair, ComesBackFromJson) {
  TuningPair pair;
  EXPECT_FALSE(from_json(to_json(pair), pair));
  EXPECT_EQ(pair, TuningPair());
  Tuning tuning;
  tuning.agents = 9;
  pair.take_other(tuning, "far");
  pair.names[0] = "with \"quotes\"";
  pair.change_places(tuning);
  TuningPair read;
  EXPECT_FALSE(from_json(to_json(pair), read));
  EXPECT_EQ(read, pair);
  EXPECT_TRUE(read.shows_b());
}

TEST(TuningPair, RefusesWhatItDoesNotUnderstandAndStays) {
  struct Case {
    std::string text, said;
  };
  const Case cases[] = {{"[]", "object"},
                        {R"({"in_use": "C"})", "A or B"},
                        {R"({"in_use": "B"})", "\"other\" is missing"},
                        {R"({"in_use": 1})", "in_use"},
                        {R"({"names": ["a"]})", "two texts"},
                        {R"({"names": ["a", "b\nc"]})", "two texts of a line"},
                        {R"({"names": ["a", ")" + std::string(64, 'b') + R"("]})", "63 bytes"},
                        {R"({"other": {"agents": "many"}})", "agents"},
                        {R"({"third": {}})", "third"}};
  TuningPair before;
  before.take_other(Tuning(), "kept");
  for (const Case& bad : cases) {
    TuningPair pair = before;
    const Complaint complaint = from_json(*parse_json(bad.text), pair);
    ASSERT_TRUE(complaint) << bad.text;
    EXPECT_THAT(*complaint, testing::HasSubstr(bad.said)) << bad.text;
    EXPECT_EQ(pair, before) << bad.text;
  }
}

}  // namespace
}  // namespace throng::app::tuning_pair_test
