#include <array>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/commands/bench/plot.h"
#include "app/commands/bench/report.h"
#include "app/commands/bench/rounds.h"
#include "app/commands/bench/turns.h"

namespace throng::app::figures_test {
namespace {

using testing::HasSubstr;
using testing::Not;

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST(Figures, OfOneRowAreItsKeysAndValues) {
  const std::vector<Json> rows = {{{"agents", 10}, {"schedule", "fused"}, {"held", nullptr}}};
  EXPECT_EQ(count_of(figures_as_text(rows, {}), "\n"), 3U);
  EXPECT_EQ(figures_as_json(rows), rows.front());
}

TEST(Figures, OfSeveralRowsAreATableWithColumnsOfOneWidth) {
  const std::vector<Json> rows = {{{"agents", 10}, {"ns_per_bone_median", 12.34567}},
                                  {{"agents", 100000}, {"ns_per_bone_median", nullptr}}};
  const std::string text = figures_as_text(rows, std::array{"agents", "ns_per_bone_median"});
  EXPECT_EQ(text,
            "agents  ns_per_bone\n"
            "    10        12.35\n"
            "100000            -\n");
  EXPECT_EQ(figures_as_json(rows)["rows"].elements().size(), 2U);
}

TEST(Plot, HasALineAndANameForEachSeriesAndADotForEachPoint) {
  const std::string svg = lines_as_svg("Title", "agents", "ns",
                                       {{.name = "one", .x = {1000, 10000}, .y = {5, 6}},
                                        {.name = "floor", .x = {1000, 10000}, .y = {2, 2}, .dashed = true}});
  EXPECT_THAT(svg, testing::StartsWith("<svg "));
  EXPECT_THAT(svg, testing::EndsWith("</svg>\n"));
  EXPECT_EQ(count_of(svg, "<polyline"), 2U);
  EXPECT_EQ(count_of(svg, "<circle"), 2U) << "dashed lines have none";
  for (const char* const word : {">Title<", ">one<", ">floor<", ">agents<", ">ns<", ">1000<", ">10000<"}) {
    EXPECT_THAT(svg, HasSubstr(word));
  }
}

TEST(Plot, HasPowersOfTenWhereValuesLieFarApartAndNoNameBelowItsAxis) {
  std::vector<PlotLine> lines{{.name = "most", .x = {1000, 10000}, .y = {2000, 9000}}};
  for (int i = 0; i < 6; ++i) lines.push_back({.name = "least", .x = {1000, 10000}, .y = {0.02, 0.03}});
  const std::string svg = lines_as_svg("Title", "agents", "ms", lines, {.logarithmic = true, .note = "Note"});
  for (const char* const word : {">0.01<", ">1<", ">100<", ">10000<", ">Note<"}) EXPECT_THAT(svg, HasSubstr(word));
  for (std::size_t at = svg.find(">least<"); at != std::string::npos; at = svg.find(">least<", at + 1)) {
    const std::size_t y = svg.rfind(" y=\"", at) + 4;
    EXPECT_LE(std::stod(svg.substr(y)), 366.0) << "the axis lies at 48 + 18 + 300";
  }
}

TEST(Plot, DrawsBarsAsLongAsTheirValues) {
  const std::string svg = bars_as_svg("Title", "ns", {{"half", 5, false}, {"whole", 10, true}});
  EXPECT_THAT(svg, HasSubstr("width=\"210.0\" height=\"18.0\""));
  EXPECT_THAT(svg, HasSubstr("width=\"420.0\" height=\"18.0\""));
  EXPECT_THAT(svg, HasSubstr(">10 ns<"));
}

TEST(Plot, KeepsNamesFromBeingTakenForMarkup) {
  const std::string svg = bars_as_svg("a < b & c", "ns", {{"x", 1, false}});
  EXPECT_THAT(svg, HasSubstr("a &lt; b &amp; c"));
}

TEST(Plot, OfValuesThatAreAllZeroHasNoNumbersThatAreNone) {
  const std::string svg = lines_as_svg("t", "x", "y", {{.name = "n", .x = {1}, .y = {0}}});
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
  EXPECT_THAT(svg, Not(HasSubstr("inf")));
}

TEST(Rounds, RunEachSubjectInEachRoundInItsTurn) {
  BenchRounds rounds;
  std::string order;
  for (const char* const name : {"a", "b"}) {
    rounds.add({name, [&order, name] { order += order.ends_with(name) ? "" : name; }});
  }
  rounds.run(2, "");
  EXPECT_EQ(order, "ababab") << "one round to warm up, two that count";
  EXPECT_GT(rounds.times().median("a"), 0.0);
}

BenchTimes times_of(const char* key, const std::vector<double>& nanoseconds) {
  BenchTimes times;
  for (const double round : nanoseconds) times.add(key, round);
  return times;
}

TEST(Times, HaveAMedianAndALeastAndAreZeroOfWhatWasNotTimed) {
  const BenchTimes times = times_of("a", {30, 10, 20});
  EXPECT_EQ(times.median("a"), 20.0);
  EXPECT_EQ(times.fastest("a"), 10.0);
  EXPECT_FALSE(times.has("b"));
  EXPECT_EQ(times.median("b"), 0.0);
  EXPECT_EQ(times.fastest("b"), 0.0);
  EXPECT_EQ(times.median_ratio("a", "b"), 0.0);
}

// The machine was three times as slow in the rounds in the middle: medians of the times would say 60 / 40.
TEST(Times, AreComparedRoundByRoundSoThatASlowMinuteMeetsBoth) {
  BenchTimes times = times_of("a", {20, 60, 60, 60, 20});
  times.append(times_of("b", {10, 30, 30, 40, 40}));
  EXPECT_EQ(times.median_ratio("a", "b"), 2.0);
  EXPECT_EQ(times.median_ratio("b", "a"), 0.5);
}

TEST(Times, OfALaterPassGoBehindThoseBefore) {
  BenchTimes times = times_of("a", {10, 20});
  times.append(times_of("a", {90}));
  EXPECT_EQ(times.median("a"), 20.0);
  EXPECT_EQ(times.median_ratio("a", times_of("b", {10, 10, 30, 1}), "b"), 2.0) << "of rounds that both have";
}

TEST(Turns, OfOneCaseAreOnePassAndOfSeveralFourRoundsEachAtMost) {
  using testing::ElementsAre;
  EXPECT_THAT(rounds_of_passes(60, 1), ElementsAre(60));
  EXPECT_THAT(rounds_of_passes(8, 3), ElementsAre(4, 4));
  EXPECT_THAT(rounds_of_passes(9, 2), ElementsAre(3, 3, 3));
  EXPECT_THAT(rounds_of_passes(10, 2), ElementsAre(4, 3, 3));
  EXPECT_THAT(rounds_of_passes(1, 2), ElementsAre(1));
}

TEST(Turns, AreOfAllCombinationsTheFirstListSlowest) {
  BenchOptions options;
  options.clips = {2, 24};
  options.agents = {100, 1000};
  std::vector<std::pair<int, int>> found;
  for (const BenchCase& bench : bench_cases(options)) found.emplace_back(bench.clips, bench.agents);
  EXPECT_THAT(found,
              testing::ElementsAre(std::pair(2, 100), std::pair(2, 1000), std::pair(24, 100), std::pair(24, 1000)));
}

}  // namespace
}  // namespace throng::app::figures_test
