// Counts the people of a recorded crowd at each time.
#include "app/people/crowd/people_over_time.h"

#include <gtest/gtest.h>

namespace throng::app::people_over_time_test {
namespace {

PersonTrack there(double first, double last) {
  PersonTrack person{.id = "1", .rows = {{.seconds = first}}};
  if (last > first) person.rows.push_back({.seconds = last});
  return person;
}

Trajectories crowd(std::vector<PersonTrack> persons, double first, double last, double rows_a_second = 10.0) {
  Trajectories all;
  all.persons = std::move(persons);
  all.first_seconds = first;
  all.last_seconds = last;
  all.rows_a_second = rows_a_second;
  return all;
}

TEST(PeopleOverTime, AreThereFromTheirFirstRowToTheirLast) {
  const PeopleOverTime people(crowd({there(2, 6), there(4, 8), there(4, 5)}, 2, 8));
  EXPECT_EQ(people.at(1.9), 0U);
  EXPECT_EQ(people.at(2.0), 1U);
  EXPECT_EQ(people.at(4.0), 3U);
  EXPECT_EQ(people.at(5.0), 3U);
  EXPECT_EQ(people.at(5.1), 2U);
  EXPECT_EQ(people.at(8.0), 1U);
  EXPECT_EQ(people.at(8.1), 0U);
  EXPECT_EQ(people.most(), 3U);
  EXPECT_EQ(people.people(), 3U);
}

TEST(PeopleOverTime, WhoHasASingleRowIsThereForAsLongAsARowLasts) {
  const PeopleOverTime people(crowd({there(2, 2), there(0, 9)}, 0, 9));
  EXPECT_EQ(people.at(2.0), 2U);
  EXPECT_EQ(people.at(2.05), 2U);
  EXPECT_EQ(people.at(2.2), 1U);
}

TEST(PeopleOverTime, AColumnHasItsFullestTimeHoweverShort) {
  const PeopleOverTime people(
      crowd({there(0, 60'000), there(30'000.5, 30'000.6), there(30'000.5, 30'000.7)}, 0, 60'000));
  const auto columns = people.most_by_column();
  EXPECT_EQ(columns.front(), 1U);
  EXPECT_EQ(columns[PeopleOverTime::columns / 2], 3U);
  EXPECT_EQ(columns[PeopleOverTime::columns / 2 + 1], 1U);
  EXPECT_EQ(columns.back(), 1U);
}

TEST(PeopleOverTime, OfTheLastMomentAreInTheLastColumn) {
  const PeopleOverTime people(crowd({there(0, 10), there(10, 10)}, 0, 10));
  EXPECT_EQ(people.most_by_column().back(), 2U);
  EXPECT_EQ(people.most(), 2U);
}

TEST(PeopleOverTime, AFileOfOneRowIsAMoment) {
  const PeopleOverTime people(crowd({there(7, 7)}, 7, 7, 0.0));
  EXPECT_EQ(people.first(), people.last());
  EXPECT_EQ(people.at(7.0), 1U);
  EXPECT_EQ(people.most(), 1U);
  EXPECT_GT(people.row(), 0.0);
}

TEST(PeopleOverTime, ThereMayBeNobodyAtATime) {
  const PeopleOverTime people(crowd({there(0, 1), there(9, 10)}, 0, 10));
  EXPECT_EQ(people.at(5.0), 0U);
  EXPECT_EQ(people.most_by_column()[PeopleOverTime::columns / 2], 0U);
}

}  // namespace
}  // namespace throng::app::people_over_time_test
