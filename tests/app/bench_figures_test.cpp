#include <array>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/bench_plot.h"
#include "app/bench_rounds.h"
#include "app/bench_table.h"

namespace throng::app {
namespace {

using Json = nlohmann::ordered_json;
using testing::HasSubstr;
using testing::Not;

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST(Figures, OfOneRowAreItsKeysAndValues) {
  const std::vector<Json> rows = {{{"agents", 10}, {"schedule", "fused"}, {"ozz", nullptr}}};
  EXPECT_EQ(count_of(figures_as_text(rows, {}), "\n"), 3U);
  EXPECT_EQ(Json::parse(figures_as_json(rows)), rows.front());
}

TEST(Figures, OfSeveralRowsAreATableWithColumnsOfOneWidth) {
  const std::vector<Json> rows = {{{"agents", 10}, {"ns_per_bone_median", 12.34567}},
                                  {{"agents", 100000}, {"ns_per_bone_median", nullptr}}};
  const std::string text = figures_as_text(rows, std::array{"agents", "ns_per_bone_median"});
  EXPECT_EQ(text,
            "agents  ns_per_bone\n"
            "    10        12.35\n"
            "100000            -\n");
  EXPECT_EQ(Json::parse(figures_as_json(rows))["rows"].size(), 2U);
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
  EXPECT_EQ(order, "abababab") << "two rounds to warm up, two that count";
  EXPECT_GT(rounds.median("a"), 0.0);
  EXPECT_GE(rounds.median("a"), rounds.fastest("a"));
  EXPECT_GT(rounds.median_ratio("a", "b"), 0.0);
  EXPECT_FALSE(rounds.has("c"));
  EXPECT_EQ(rounds.median("c"), 0.0);
}

}  // namespace
}  // namespace throng::app
