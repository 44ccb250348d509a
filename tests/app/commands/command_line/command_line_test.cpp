// The real program, given what it must refuse: one line on stderr, the right exit status, nothing left behind.
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/app/program_run.h"
#include "tests/app/temporary_folder.h"

namespace throng::app::command_line_test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class CommandLine : public test::TemporaryFolder {
 protected:
  fs::path noise_named_glb() const {
    const fs::path file = folder_ / "noise.glb";
    std::ofstream stream(file, std::ios::binary);
    for (unsigned i = 0, bits = 1; i < 4096; ++i)
      stream.put(static_cast<char>((bits = bits * 1664525U + 1013904223U) >> 24));
    return file;
  }

  bool is_empty() const { return fs::is_empty(folder_); }
};

MATCHER(IsOneLine, "is one line that names the program") {
  return arg.starts_with("throng: ") && arg.find('\n') == arg.size() - 1;
}

void expect_refusal(const std::vector<std::string>& arguments, int exit_status, const std::string& part) {
  const ProgramRun run = run_program(arguments);
  EXPECT_EQ(run.exit_status, exit_status) << run.errors;
  EXPECT_THAT(run.errors, IsOneLine());
  EXPECT_THAT(run.errors, HasSubstr(part));
  EXPECT_EQ(run.output, "");
}

TEST_F(CommandLine, RefusesWrongUsage) {
  expect_refusal({"--pus", "0"}, 2, "--pus 0");
  expect_refusal({"--agents", "-1"}, 2, "--agents -1");
  expect_refusal({"--size", "0x0"}, 2, "--size 0x0");
  expect_refusal({"--colour", "red"}, 2, "--colour");
  expect_refusal({"--headless", "--scene", "moon"}, 2, "--scene moon");
  expect_refusal({"--headless=none", "--clips", "walk=moonwalk"}, 2, "walk=moonwalk");
  expect_refusal({"--headless", "--camera", "nowhere"}, 2, "nowhere");
  expect_refusal({"--headless=none", "--agents", "5", "--select", "5"}, 2, "--select 5: the crowd has agents 0 to 4");
  expect_refusal({"bake", "model.glb"}, 2, "-o");
}

TEST_F(CommandLine, RefusesAWordWithALineBreakInOneLine) { expect_refusal({"--scene", "a\nb"}, 2, "--scene a b"); }

TEST_F(CommandLine, SaysThatThereIsNoDisplayAndNamesHeadless) { expect_refusal({}, 1, "--headless"); }

TEST_F(CommandLine, RefusesAnAbsentFile) {
  const std::string file = (folder_ / "absent.glb").string();
  expect_refusal({file, "--headless=none"}, 1, "absent.glb");
  expect_refusal({"inspect", file}, 1, "absent.glb");
  expect_refusal({"bench", file}, 1, "absent.glb");
}

TEST_F(CommandLine, RefusesAFolderAsAModel) {
  expect_refusal({folder_.string(), "--headless=none"}, 1, folder_.string());
  expect_refusal({"inspect", folder_.string()}, 1, folder_.string());
}

TEST_F(CommandLine, RefusesNoiseNamedGlb) {
  const std::string file = noise_named_glb().string();
  expect_refusal({file, "--headless=none"}, 1, "noise.glb");
  expect_refusal({"inspect", file}, 1, "noise.glb");
}

TEST_F(CommandLine, RefusesAModelThatTakesMoreMemoryThanItMay) {
  const std::string file = THRONG_SOURCE_DIR "/assets/mannequin.glb";
  const std::string what = "mannequin.glb: the file needs ";
  expect_refusal({file, "--headless=none", "--memory-limit", "1MB"}, 1, what);
  expect_refusal({"inspect", file, "--memory-limit", "1MB"}, 1, what);
  expect_refusal({"lod", file, "--memory-limit", "1MB"}, 1, what);
  expect_refusal({"bench", file, "--memory-limit", "1MB"}, 1, what);
  expect_refusal({"bake", file, "--memory-limit", "1MB", "-o", (folder_ / "a.pack").string()}, 1, what);
  expect_refusal({"pose", file, "--clip", "0", "--time", "0", "--json", "-", "--memory-limit", "1MB"}, 1, what);
  EXPECT_TRUE(is_empty());
}

TEST_F(CommandLine, WritesNothingWhenTheModelIsRefused) {
  expect_refusal({"absent.glb", "--headless=none", "--stats", (folder_ / "a.json").string()}, 1, "absent.glb");
  expect_refusal({"pose", "absent.glb", "--clip", "0", "--time", "0", "--json", (folder_ / "b.json").string()}, 1,
                 "absent.glb");
  EXPECT_TRUE(is_empty());
}

TEST_F(CommandLine, RefusesAPictureInAFolderThatIsNotThere) {
  expect_refusal({"--headless", "--screenshot", (folder_ / "absent" / "a.png").string()}, 1, "--screenshot");
  EXPECT_TRUE(is_empty());
}

TEST_F(CommandLine, RefusesAFolderAsAFile) {
  expect_refusal({"--headless=none", "--stats", folder_.string()}, 1, "--stats");
  EXPECT_TRUE(is_empty());
}

TEST_F(CommandLine, RefusesALocalStoreTooSmallForOneCharacter) {
  expect_refusal({"--headless=none", "--agents", "2", "--frames", "1", "--local-store", "1"}, 2, "--local-store");
}

TEST_F(CommandLine, RefusesABenchThatDoesNotFitBeforeItsFirstRound) {
  const std::string model = THRONG_SOURCE_DIR "/assets/mannequin.glb";
  expect_refusal({"bench", model, "--agents", "2", "--local-store", "1"}, 2, "--local-store");
  expect_refusal({"bench", model, "--agents", "2", "--local-store", "16", "--tile", "16"}, 2, "--tile");
  expect_refusal({"bench", "--agents", "2", "--local-store", "1"}, 2, "--local-store");
}

TEST_F(CommandLine, SaysNothingButFiguresWhenABenchSucceeds) {
  const ProgramRun run = run_program({"bench", "--agents", "2", "--frames", "1", "--json", "-"});
  EXPECT_EQ(run.exit_status, 0);
  EXPECT_EQ(run.errors, "") << "rounds are counted at a terminal only";
  EXPECT_TRUE(nlohmann::json::accept(run.output)) << run.output;
}

TEST_F(CommandLine, MeasuresATableAndDrawsIt) {
  const fs::path plot = folder_ / "plot.svg";
  const ProgramRun run = run_program({"bench", "--agents", "2,4", "--bones", "8", "--pus", "1,2", "--frames", "5",
                                      "--json", "-", "--plot", plot.string()});
  EXPECT_EQ(run.exit_status, 0) << run.errors;
  const nlohmann::json table = nlohmann::json::parse(run.output, nullptr, false);
  ASSERT_TRUE(table.is_object()) << run.output;
  ASSERT_EQ(table["rows"].size(), 4U);
  EXPECT_EQ(table["rows"][0]["agents"], 2);
  EXPECT_EQ(table["rows"][3]["pus"], 2);
  EXPECT_EQ(table["rows"][0]["ns_per_bone_over_first_row"], 1.0);
  for (const auto& row : table["rows"]) {
    EXPECT_EQ(row["rounds"], 5);
    EXPECT_GT(row["ns_per_bone_over_first_row"], 0.0);
    EXPECT_EQ(row["pose_hash"].get<std::string>().size(), 16U);
  }
  EXPECT_EQ(table["rows"][2]["pose_hash"], table["rows"][3]["pose_hash"]) << "whatever the number of PUs";
  EXPECT_TRUE(fs::exists(plot));
}

TEST_F(CommandLine, HoldsMainMemoryOfAnAgentToAKibibyte) {
  const ProgramRun run = run_program({"bench", "--agents", "500", "--frames", "1", "--json", "-"});
  const nlohmann::json figures = nlohmann::json::parse(run.output, nullptr, false);
  ASSERT_TRUE(figures.is_object()) << run.output;
  EXPECT_LE(figures["bytes_per_agent"], 1024.0);
  EXPECT_GT(figures["stream_bytes_per_frame"], 0);
}

TEST_F(CommandLine, ShowsHelpOnStandardOutput) {
  const ProgramRun run = run_program({"--help"});
  EXPECT_EQ(run.exit_status, 0);
  EXPECT_EQ(run.errors, "");
  EXPECT_THAT(run.output, testing::StartsWith("Throng: a crowd"));
}

TEST_F(CommandLine, WritesStatisticsWithoutGl) {
  const fs::path file = folder_ / "stats.json";
  const ProgramRun run = run_program({"--headless=none", "--agents", "3", "--frames", "2", "--stats", file.string()});
  EXPECT_EQ(run.exit_status, 0) << run.errors;
  EXPECT_TRUE(fs::exists(file));
}

TEST_F(CommandLine, WritesStatisticsToStandardOutput) {
  const ProgramRun run = run_program({"--headless=none", "--agents", "3", "--frames", "2", "--stats", "-"});
  EXPECT_EQ(run.exit_status, 0) << run.errors;
  const nlohmann::json statistics = nlohmann::json::parse(run.output, nullptr, false);
  ASSERT_TRUE(statistics.is_object()) << run.output;
  EXPECT_EQ(statistics["agents"], 3);
  EXPECT_FALSE(fs::exists("-"));
}

}  // namespace
}  // namespace throng::app::command_line_test
