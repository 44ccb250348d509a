// Options that say what a run writes of each of its frames.
#include <gtest/gtest.h>

#include "tests/app/commands/command_line/command_words.h"

namespace throng::app::options_output_test {
namespace {

DemoOptions options_of(const std::string& line) {
  const ParsedCommand command = parse_command_line(words(line));
  const auto* const error = std::get_if<UsageError>(&command);
  EXPECT_EQ(error, nullptr) << error->message;
  return error == nullptr ? std::get<DemoOptions>(command) : DemoOptions();
}

TEST(OutputOptionsOfALine, DrawEveryFrame) {
  for (const char* const line : {"--headless --video a.mp4", "--headless --pictures p", "--headless --labels l"}) {
    EXPECT_EQ(drawn_frames(options_of(line)), DrawWhich::all) << line;
  }
}

TEST(OutputOptionsOfALine, LetTheRateSayTheStepUnlessTheStepIsSaid) {
  EXPECT_EQ(options_of("--headless --video a.mp4 --fps-out 25").dt, 0.04);
  EXPECT_EQ(options_of("--headless --video a.mp4 --fps-out 25 --dt 0.01").dt, 0.01);
  EXPECT_FALSE(options_of("--headless --video a.mp4").dt.has_value());
}

TEST(OutputOptionsOfALine, TakeARateAsTelevisionWritesIt) {
  EXPECT_EQ(options_of("--headless --video a.mp4 --fps-out 30000/1001").output.frames_per_second, 30000.0 / 1001.0);
}

TEST(OutputOptionsOfALine, LetSecondsSayTheLength) {
  EXPECT_EQ(options_of("--headless --seconds 2").frames, 120);
  EXPECT_EQ(options_of("--headless --seconds 2 --dt 0.1").frames, 20);
  EXPECT_EQ(options_of("--headless --video a.mp4 --fps-out 30 --seconds 2").frames, 60);
  EXPECT_EQ(options_of("--headless --seconds 0.0001").frames, 1);
}

TEST(OutputOptionsOfALine, PoseEverybodyExactlyForLabels) {
  const DemoOptions options = options_of("--headless --labels l --mesh-lod 2");
  EXPECT_EQ(options.tuning.lod.rule, LodRule::off);
  EXPECT_FALSE(options.tuning.lod.smooth);
  EXPECT_FALSE(options.tuning.lod.bone_lod);
  EXPECT_EQ(options.tuning.mesh_lod, 2);
}

TEST(OutputOptionsOfALine, NameTheRunByWhatIsDrawnAlone) {
  const auto run = [](const std::string& line) { return options_of("--headless --pictures p " + line).output.run; };
  const auto plain = run("--agents 20");
  EXPECT_EQ(plain, run("--agents 20 --frames 100 --stats s.json --pus 2"));
  EXPECT_EQ(plain, run("--video a.mp4 --agents 20 --seconds 3"));
  EXPECT_NE(plain, run("--agents 21"));
  EXPECT_NE(plain, run("--agents 20 --seed 2"));
  EXPECT_NE(plain, run("--agents 20 --labels l"));
  EXPECT_NE(plain, run("--agents 20 --video a.mp4 --fps-out 30"));
}

class OutputRefusal : public testing::TestWithParam<Refused> {};

TEST_P(OutputRefusal, NamesTheOptionAndARemedy) { EXPECT_EQ(refusal(GetParam().line), GetParam().message); }

INSTANTIATE_TEST_SUITE_P(
    OfOptions, OutputRefusal,
    testing::Values(
        Refused{"AWindow", "--video a.mp4", "--video: a window runs as fast as it is drawn; add --headless"},
        Refused{"NoContext", "--headless=none --pictures p",
                "--pictures: --headless=none draws nothing; use --headless"},
        Refused{"AnotherEnding", "--headless --video a.avi",
                "--video a.avi: must be a file name that ends in .mp4 or .webm"},
        Refused{"AnOddWidth", "--headless --video a.mp4 --size 641x480",
                "--video: the sides of a video are even; ask for --size 642x480"},
        Refused{"AnOddHeight", "--headless --video a.webm --size 64x47",
                "--video: the sides of a video are even; ask for --size 64x48"},
        Refused{"TheLastFrameAlone", "--headless --labels l --draw last",
                "--labels: takes each frame; leave out --draw"},
        Refused{"ARateOfNothing", "--headless --fps-out 30", "--fps-out: goes with --video"},
        Refused{"AWindowUnseen", "--after 2", "--after: goes with --headless"},
        Refused{"ProgressOfAWindow", "--progress", "--progress: goes with --headless"},
        Refused{"NoRate", "--headless --video a.mp4 --fps-out 0",
                "--fps-out 0: must be a number, 0.1 to 1000, or two whole ones with / between them, such as "
                "30000/1001"},
        Refused{
            "ARateOverNothing", "--headless --video a.mp4 --fps-out 30/0",
            "--fps-out 30/0: must be a number, 0.1 to 1000, or two whole ones with / between them, such as 30000/1001"},
        Refused{"ARateBelowTheLeast", "--headless --video a.mp4 --fps-out 1/100",
                "--fps-out 1/100: must be a number, 0.1 to 1000, or two whole ones with / between them, such as "
                "30000/1001"},
        Refused{"TwoLengths", "--headless --seconds 1 --frames 60",
                "--seconds: --frames says it too; give one of them"},
        Refused{"SecondsOfAWindow", "--seconds 1", "--seconds: a window goes by the clock; add --headless"},
        Refused{"LabelsOfOne", "--headless --labels l --view", "--labels: are of a crowd; leave out --view"},
        Refused{"LabelsOfTooMany", "--headless --labels l --agents 65535",
                "--labels: the mask names 65534 agents at most; ask for fewer"},
        Refused{"LabelsOfARecording", "--headless --labels l --replay r.rec",
                "--labels: the recording says it; leave it out with --replay"},
        Refused{"ALens", "--headless --focus 4 --screenshot s.png --pictures p",
                "--focus: is for stills; use --headless and --screenshot"},
        Refused{"NoFolder", "--headless --pictures -", "--pictures -: must be the name of a folder"}),
    name_of);

}  // namespace
}  // namespace throng::app::options_output_test
