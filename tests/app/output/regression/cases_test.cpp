#include "app/output/regression/cases.h"

#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/own_folder.h"

namespace throng::app::cases_test {
namespace {

using testing::ElementsAre;
using testing::EndsWith;
using testing::IsEmpty;
using testing::StartsWith;

RegressionCases good(const std::string& text) {
  const auto cases = parse_cases(text, "folder");
  EXPECT_TRUE(cases) << cases.error().message;
  return cases ? *cases : RegressionCases();
}

TEST(Cases, AreOptionsThatDrawThem) {
  const RegressionCases all = good(R"({"cases": [{"name": "one", "models": ["a.glb", "b.glb"], "preset": "mine.json",
      "scene": "grid", "agents": 9, "frame": 13, "camera": "close", "size": "64x36", "options": ["--sun", "night"]}]})");
  ASSERT_EQ(all.cases.size(), 1U);
  EXPECT_THAT(all.cases[0].words,
              ElementsAre("a.glb", "b.glb", "--preset", "mine.json", "--scene", "grid", "--agents", "9", "--frames",
                          "13", "--camera", "close", "--size", "64x36", "--sun", "night"));
}

TEST(Cases, RepeatARecording) {
  const RegressionCases all = good(R"({"cases": [{"name": "one", "recording": "run.rec", "frame": 3}]})");
  EXPECT_THAT(all.cases[0].words, ElementsAre("--replay", "run.rec", "--frames", "3"));
}

TEST(Cases, ShowARecordedCrowd) {
  const RegressionCases all =
      good(R"({"cases": [{"name": "one", "trajectories": "people.csv", "options": ["--fps", "25"]}]})");
  EXPECT_THAT(all.cases[0].words, ElementsAre("--trajectories", "people.csv", "--fps", "25"));
}

TEST(Cases, OfAFileHaveItsSceneAndItsPeople) {
  const RegressionCases all = good(R"({"defaults": {"scene": "grid", "agents": 4}, "cases": [
      {"name": "one", "trajectories": "people.csv"}, {"name": "two", "recording": "run.rec"}, {"name": "three"}]})");
  EXPECT_THAT(all.cases[0].words, ElementsAre("--trajectories", "people.csv"));
  EXPECT_THAT(all.cases[1].words, ElementsAre("--replay", "run.rec"));
  EXPECT_THAT(all.cases[2].words, ElementsAre("--scene", "grid", "--agents", "4"));
}

TEST(Cases, HaveWhatTheyLeaveOpenFromTheDefaults) {
  const RegressionCases all = good(R"({"defaults": {"agents": 4, "size": "8x8", "context": "both", "models": "a.glb"},
                                       "cases": [{"name": "one"}, {"name": "two", "agents": 5, "context": "osmesa"}]})");
  EXPECT_THAT(all.cases[0].words, ElementsAre("a.glb", "--agents", "4", "--size", "8x8"));
  EXPECT_THAT(all.cases[0].contexts, ElementsAre(ContextKind::egl, ContextKind::osmesa));
  EXPECT_THAT(all.cases[1].words, ElementsAre("a.glb", "--agents", "5", "--size", "8x8"));
  EXPECT_THAT(all.cases[1].contexts, ElementsAre(ContextKind::osmesa));
}

TEST(Cases, SayNothingAndAreDrawnInEglInEightBits) {
  const RegressionCases all = good(R"({"cases": [{"name": "one"}]})");
  EXPECT_THAT(all.cases[0].words, IsEmpty());
  EXPECT_THAT(all.cases[0].contexts, ElementsAre(ContextKind::egl));
  EXPECT_EQ(all.bits, 8);
  EXPECT_FALSE(all.cases[0].tolerance.mean || all.cases[0].tolerance.worst_block || all.cases[0].tolerance.share);
}

TEST(Cases, FindExpectedPicturesFromWhereTheFileLies) {
  EXPECT_EQ(good(R"({"cases": [{"name": "one"}]})").cases[0].expected, "folder/expected/one.png");
  EXPECT_EQ(good(R"({"pictures": "p", "cases": [{"name": "one"}]})").cases[0].expected, "folder/p/one.png");
  EXPECT_EQ(good(R"({"cases": [{"name": "one", "expected": "x/y.png"}]})").cases[0].expected, "folder/x/y.png");
}

TEST(Cases, HaveATolerancePerFigureEachWithItsReason) {
  const RegressionCases all =
      good(R"({"bits": 6, "defaults": {"tolerance": {"mean": {"most": 0.8, "because": "outlines"},
      "worst_block": {"most": 9, "because": "hands"}, "share": {"most": 0.01, "because": "leaves"}}},
      "cases": [{"name": "one"}, {"name": "two", "tolerance": {"mean": {"most": 2, "because": "clouds"}}}]})");
  EXPECT_EQ(all.bits, 6);
  EXPECT_EQ(all.tolerance.worst_block->most, 9);
  EXPECT_EQ(all.cases[0].tolerance.share->because, "leaves");
  EXPECT_EQ(all.cases[1].tolerance.mean->most, 2);
  EXPECT_FALSE(all.cases[1].tolerance.worst_block) << "a tolerance of a case is all of it";
}

struct Wrong {
  const char* what;
  const char* text;
  const char* complaint;
};

class WrongCases : public testing::TestWithParam<Wrong> {};

TEST_P(WrongCases, AreRefusedWithPlaceAndRemedy) {
  const auto cases = parse_cases(GetParam().text, "");
  ASSERT_FALSE(cases);
  EXPECT_THAT(cases.error().message, StartsWith(GetParam().complaint));
}

#define CASE(rest) R"({"cases": [{"name": "a"}, {"name": "b", )" rest R"(}]})"

INSTANTIATE_TEST_SUITE_P(
    All, WrongCases,
    testing::Values(
        Wrong{"NoJson", "{\"cases\": [\n{]}", "is not JSON at line 2, column 2; mend it there"},
        Wrong{"NoObject", "[]", "it must be an object with \"cases\""},
        Wrong{"NoCases", "{}", "\"cases\" must be a list of 1 to 10000 cases"},
        Wrong{"EmptyCases", R"({"cases": []})", "\"cases\" must be a list of 1 to 10000 cases"},
        Wrong{"UnknownKeyOfTheFile", R"({"case": []})", "unknown key \"case\"; is \"cases\" meant?"},
        Wrong{"FarKey", R"({"cases": [], "weather": 1})",
              "unknown key \"weather\"; the keys are pictures, bits, defaults, cases"},
        Wrong{"Bits", R"({"bits": 9, "cases": [{"name": "a"}]})", "\"bits\" must be a whole number, 1 to 8"},
        Wrong{"CaseIsNoObject", R"({"cases": [3]})", "case 1: it must be an object"},
        Wrong{"NoName", R"({"cases": [{}]})", "case 1: \"name\" is missing"},
        Wrong{"NameIsAPath", R"({"cases": [{"name": "../a"}]})",
              "case 1 \"../a\": \"name\" must be 1 to 100 letters, digits, -, _ and ., with a letter or digit first"},
        Wrong{"DoubledName", R"({"cases": [{"name": "a"}, {"name": "a"}]})",
              "case 2 \"a\": another case has that name; give each its own"},
        Wrong{"UnknownKeyOfACase", CASE(R"("scenne": "grid")"),
              "case 2 \"b\": unknown key \"scenne\"; is \"scene\" meant?"},
        Wrong{"Scene", CASE(R"("scene": "moon")"), "case 2 \"b\": \"scene\" must be plaza, parade, "},
        Wrong{"Agents", CASE(R"("agents": 0)"), "case 2 \"b\": \"agents\" must be a whole number, 1 to 100000"},
        Wrong{"AgentsInTheDefaults", R"({"defaults": {"agents": 0}, "cases": [{"name": "a"}]})",
              "defaults: \"agents\" must be a whole number, 1 to 100000"},
        Wrong{"NameInTheDefaults", R"({"defaults": {"name": "a"}, "cases": [{"name": "a"}]})",
              "defaults: \"name\" is for single cases; leave it out"},
        Wrong{"Frame", CASE(R"("frame": 1.5)"), "case 2 \"b\": \"frame\" must be a text or a whole number"},
        Wrong{"Context", CASE(R"("context": "glx")"), "case 2 \"b\": \"context\" must be egl, osmesa or both"},
        Wrong{"Models", CASE(R"("models": [1])"), "case 2 \"b\": \"models\" must be a text, or a list of texts"},
        Wrong{"OwnOption", CASE(R"("options": ["--headless=egl"])"),
              "case 2 \"b\": \"options\" must not have --headless, which throng check gives by itself"},
        Wrong{"Expected", CASE(R"("expected": "a.jpg")"),
              "case 2 \"b\": \"expected\" must be a file that ends in .png"},
        Wrong{"ToleranceWithoutReason", CASE(R"("tolerance": {"mean": {"most": 1}})"),
              "case 2 \"b\": \"mean\": \"because\" must say why it is as large as that"},
        Wrong{"ToleranceIsANumber", CASE(R"("tolerance": {"mean": 1})"),
              "case 2 \"b\": \"mean\" must be an object with \"most\" and \"because\""},
        Wrong{"ToleranceTooLarge", CASE(R"("tolerance": {"share": {"most": 2, "because": "x"}})"),
              "case 2 \"b\": \"share\": \"most\" must be a number, 0 to 1"},
        Wrong{"UnknownFigure", CASE(R"("tolerance": {"worst": {"most": 2, "because": "x"}})"),
              "case 2 \"b\": unknown key \"worst\"; the keys are mean, worst_block, share"}),
    [](const auto& run) { return run.param.what; });

#undef CASE

TEST(CasesFile, BeginsComplaintsWithItsName) {
  const throng::test::OwnFolder folder;
  const std::string file = folder.path() / "cases.json";
  EXPECT_EQ(read_cases(file).error().message, file + ": there is no such file; check the path");
  std::ofstream(file) << R"({"cases": [{"name": "a", "agent": 3}]})";
  EXPECT_EQ(read_cases(file).error().message, file + ": case 1 \"a\": unknown key \"agent\"; is \"agents\" meant?");
}

TEST(CasesFile, OfOurGoldenPicturesIsGood) {
  const auto cases = read_cases(THRONG_SOURCE_DIR "/tests/golden/cases.json");
  ASSERT_TRUE(cases) << cases.error().message;
  EXPECT_EQ(cases->bits, 6);
  EXPECT_THAT(cases->cases.front().expected.string(), EndsWith("tests/golden/pictures/plaza.png"));
}

}  // namespace
}  // namespace throng::app::cases_test
