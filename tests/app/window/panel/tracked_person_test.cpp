// The card of a selected person of a recorded crowd.
#include <memory>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/window/panel/selected_name.h"
#include "tests/app/window/panel/overlay_driver.h"

namespace throng::app::tracked_person_test {
namespace {

std::shared_ptr<TrackedPerson> a_person() {
  auto person = std::make_shared<TrackedPerson>();
  person->id = "17";
  person->presence = {10.0, 30.0};
  person->rows = 201;
  person->stature = 1.8F;
  person->speeds = {0.0F, 2.0F, 1.0F};
  person->ways = {0.0F, 10.0F, 25.0F};
  person->footfalls = {{.seconds = 11.0, .is_left = true}, {.seconds = 11.5}, {.seconds = 12.0, .is_left = true}};
  person->has_all_footfalls = true;
  return person;
}

class TrackedPersonCard : public testing::Test {
 protected:
  TrackedPersonCard() {
    Trajectories all;
    all.persons.push_back({.id = "17", .rows = {{.seconds = 0.0}, {.seconds = 40.0}}});
    all.last_seconds = 40.0;
    all.rows_a_second = 10.0;
    person_.report.tracks = TracksReport{.clock = {.seconds = 15.0, .first = 0.0, .last = 40.0},
                                         .people = std::make_shared<const PeopleOverTime>(all)};
    person_.report.selected = SelectionReport{.agent = 3, .role = Role::walk, .entities = {}, .tracked = a_person()};
    person_.frames();
  }
  double seconds() const { return person_.report.tracks->clock.seconds; }

  OverlayDriver person_;
};

TEST(TrackedPersonOverTime, HasValuesBetweenThoseThatAreKept) {
  const auto person = a_person();
  EXPECT_FLOAT_EQ(person->speed_at(10.0), 0.0F);
  EXPECT_FLOAT_EQ(person->speed_at(15.0), 1.0F);
  EXPECT_FLOAT_EQ(person->speed_at(30.0), 1.0F);
  EXPECT_FLOAT_EQ(person->way_at(25.0), 17.5F);
  EXPECT_FLOAT_EQ(person->way_at(99.0), 25.0F);
  EXPECT_FLOAT_EQ(person->fastest(), 2.0F);
  EXPECT_EQ(person->steps_until(10.9), 0U);
  EXPECT_EQ(person->steps_until(11.5), 2U);
  EXPECT_EQ(person->steps_until(40.0), 3U);
}

TEST_F(TrackedPersonCard, CallsThePersonByTheNameOfTheFileEverywhere) {
  EXPECT_EQ(name_of(*person_.report.selected), "person 17");
  person_.click("tab:Agent");
  EXPECT_TRUE(person_.sees("View alone"));
  person_.report.selected->tracked = nullptr;
  person_.report.selected->agent = 1234;
  EXPECT_EQ(name_of(*person_.report.selected), "agent 1,234");
}

TEST_F(TrackedPersonCard, GoesToTheTimeThatIsPressedInItsGraph) {
  ASSERT_TRUE(person_.sees("Selected.speed"));
  person_.click("Selected.speed");
  EXPECT_NEAR(seconds(), 20.0, 0.1) << "the middle of the time in which it is there";
  person_.drag("Selected.speed", 1.0F);
  EXPECT_NEAR(seconds(), 30.0, 0.1);
}

TEST_F(TrackedPersonCard, GoesNoFartherThanThePartThatIsPlayed) {
  person_.report.tracks->clock.last = 18.0;
  person_.click("Selected.speed");
  EXPECT_EQ(seconds(), 18.0);
}

TEST_F(TrackedPersonCard, StaysWhileThePersonIsNotThere) {
  for (const double time : {0.0, 40.0}) {
    person_.report.tracks->clock.seconds = time;
    person_.frames();
    EXPECT_TRUE(person_.sees("Selected.speed"));
    EXPECT_FALSE(asked<Select>(person_.click("Deselect")).agent);
  }
}

TEST_F(TrackedPersonCard, ShowsAPersonOfOneRowOrOfALongTime) {
  auto moment = a_person();
  moment->presence = {10.0, 10.0};
  moment->footfalls.clear();
  auto day = a_person();
  day->presence = {0.0, 60'000.0};
  day->footfalls.resize(120'000);
  for (const auto& person : {moment, day}) {
    person_.report.selected->tracked = person;
    person_.frames();
    person_.click("Selected.speed");
    EXPECT_TRUE(person_.sees("Selected.speed"));
  }
}

TEST_F(TrackedPersonCard, IsInTheMapByTheIdOfTheFile) {
  const auto map = nlohmann::json::parse(to_json(person_.overlay.ui_map(), person_.tuning, person_.report));
  EXPECT_EQ(map["report"]["selected"]["tracked"]["id"], "17");
  EXPECT_EQ(map["report"]["selected"]["tracked"]["footfalls"], 3);
}

}  // namespace
}  // namespace throng::app::tracked_person_test
