// A recorded crowd as a table of its measures.

#include "app/people/measure/measure_table.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace throng::app::measure_table_test {
namespace {

using testing::ElementsAre;

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines(1);
  for (const char letter : text) {
    if (letter == '\n') {
      lines.emplace_back();
    } else {
      lines.back() += letter;
    }
  }
  lines.pop_back();
  return lines;
}

/// Two people on an open floor, 10 m apart. The first person goes along x at 1.5 m/s. The file's place (100, 50) is
/// the origin.
Trajectories two_people() {
  Trajectories all;
  all.origin = {100.0, 50.0};
  all.rows_a_second = 2.0;
  for (int person = 0; person < 2; ++person) {
    PersonTrack track{.id = person == 0 ? "7" : "a, b", .rows = {}};
    for (int row = 0; row < 3; ++row) {
      const float way = person == 0 ? 0.75F * static_cast<float>(row) : 0.0F;
      track.rows.push_back({.seconds = 0.5 * row, .x = way, .z = -10.0F * static_cast<float>(person)});
    }
    all.persons.push_back(std::move(track));
  }
  return all;
}

TEST(MeasureTable, HasALineForEachRowOfTheFileWithPedPysColumns) {
  EXPECT_THAT(lines_of(measure_table(two_people(), 0.0, 0.5, 1.0F)),
              ElementsAre("id,frame,time,x,y,speed,density", "7,0,0.000,100.0000,50.0000,1.5000,0.3333",
                          "\"a, b\",0,0.000,100.0000,60.0000,0.0000,0.3333", "7,1,0.500,100.7500,50.0000,1.5000,0.3333",
                          "\"a, b\",1,0.500,100.0000,60.0000,0.0000,0.3333"));
}

TEST(MeasureTable, HasNoLineOutsideOfThePart) {
  EXPECT_THAT(lines_of(measure_table(two_people(), 0.9, 2.0, 1.0F)),
              ElementsAre("id,frame,time,x,y,speed,density", "7,2,1.000,101.5000,50.0000,1.5000,0.3333",
                          "\"a, b\",2,1.000,100.0000,60.0000,0.0000,0.3333"));
}

TEST(MeasureTable, LeavesADensityEmptyThatIsNotKnown) {
  Trajectories all = two_people();
  all.plan.floors.push_back({.outline = {{-3, -3}, {5, -3}, {5, 3}, {-3, 3}}, .holes = {}});  // the second is beside it
  EXPECT_EQ(lines_of(measure_table(all, 0.0, 0.0, 1.0F)).back(), "\"a, b\",0,0.000,100.0000,60.0000,0.0000,");
}

}  // namespace
}  // namespace throng::app::measure_table_test
