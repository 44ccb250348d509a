// A crowd that goes on unseen before the first frame is the crowd of later frames.
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/app/program_run.h"

namespace throng::app::unseen_run_test {
namespace {

nlohmann::json statistics_of(const std::vector<std::string>& length) {
  std::vector<std::string> words{"--headless=none", "--agents", "40",       "--dt",    "0.05",
                                 "--lod",           "off",      "--events", "--stats", "-"};
  words.insert(words.end(), length.begin(), length.end());
  const ProgramRun run = run_program(words);
  EXPECT_EQ(run.exit_status, 0) << run.errors;
  return nlohmann::json::parse(run.output);
}

TEST(UnseenRun, LeadsToTheCrowdThatFramesLeadTo) {
  const nlohmann::json unseen = statistics_of({"--after", "3", "--frames", "20"});
  const nlohmann::json seen = statistics_of({"--frames", "80"});
  EXPECT_EQ(unseen.at("pose_hash"), seen.at("pose_hash"));
  EXPECT_EQ(unseen.at("place_hash"), seen.at("place_hash"));
  EXPECT_NE(unseen.at("place_hash"), statistics_of({"--frames", "20"}).at("place_hash"));
}

TEST(UnseenRun, SaysHowFarItsFramesAreInLines) {
  const ProgramRun run = run_program({"--headless=none", "--agents", "3", "--frames", "7", "--progress"});
  EXPECT_TRUE(run.errors.starts_with("frame 1 of 7, ")) << run.errors;
  EXPECT_NE(run.errors.find("\nframe 7 of 7, "), std::string::npos) << run.errors;
}

}  // namespace
}  // namespace throng::app::unseen_run_test
