// Options of a recorded crowd.
#include "tests/app/commands/command_line/command_words.h"

namespace throng::app::options_trajectories_test {
namespace {

DemoOptions options_of(const std::string& line) {
  const ParsedCommand command = parse_command_line(words(line));
  EXPECT_TRUE(std::holds_alternative<DemoOptions>(command)) << refusal(line);
  return std::holds_alternative<DemoOptions>(command) ? std::get<DemoOptions>(command) : DemoOptions();
}

TEST(TrajectoryOptionsOfALine, MakeTheSceneThatOfTheFile) {
  const DemoOptions options = options_of("--trajectories walk.csv --fps 16 --unit cm --start 2.5 --lenient");
  EXPECT_EQ(options.tuning.scene, Scene::tracks);
  EXPECT_EQ(options.trajectories.file, "walk.csv");
  EXPECT_EQ(options.trajectories.start, 2.5);
  EXPECT_EQ(options.trajectories.reading.fps, 16.0);
  EXPECT_EQ(options.trajectories.reading.metres_a_unit, 0.01);
  EXPECT_TRUE(options.trajectories.reading.lenient);
}

TEST(TrajectoryOptionsOfALine, OverruleWhatAFileMeans) {
  const TrackReading reading =
      options_of("--trajectories walk.csv --time-unit ms --unit 0.02 --angle north --height none").trajectories.reading;
  EXPECT_EQ(reading.times_a_second, 1000.0);
  EXPECT_EQ(reading.metres_a_unit, 0.02);
  EXPECT_EQ(reading.angle, TrackAngle::north);
  EXPECT_EQ(reading.height, TrackHeight::none);
}

TEST(TrajectoryOptionsOfALine, AreThoseOfInspectToo) {
  const ParsedCommand command =
      parse_command_line(words("inspect walk.csv --walls w.wkt --fps 16 --unit km --angle none --up y --lenient"));
  ASSERT_TRUE(std::holds_alternative<InspectOptions>(command));
  const TrackReading& reading = std::get<InspectOptions>(command).tracks.reading;
  EXPECT_EQ(reading.walls, "w.wkt");
  EXPECT_EQ(reading.fps, 16.0);
  EXPECT_EQ(reading.metres_a_unit, 1000.0);
  EXPECT_EQ(reading.angle, TrackAngle::none);
  EXPECT_EQ(reading.up, TrackUp::y);
  EXPECT_TRUE(reading.lenient);
}

TEST(TrajectoryOptionsOfALine, TakeARateAsTelevisionWritesIt) {
  EXPECT_EQ(options_of("--trajectories walk.csv --fps 30000/1001").trajectories.reading.fps, 30000.0 / 1001.0);
}

TEST(TrajectoryOptionsOfALine, SayHowItsTimeIsPlayed) {
  const DemoOptions options =
      options_of("--trajectories walk.csv --track-rate -0.5 --track-part 40,12.5 --track-repeat");
  EXPECT_EQ(options.trajectories.rate, -0.5);
  ASSERT_TRUE(options.trajectories.part);
  EXPECT_EQ(*options.trajectories.part, std::pair(40.0, 12.5));
  EXPECT_TRUE(options.trajectories.repeats);
}

TEST(TrajectoryOptionsOfALine, TakeTheAxisThatIsTheirs) {
  EXPECT_EQ(options_of("--trajectories walk.csv --up y").trajectories.reading.up, TrackUp::y);
  const DemoOptions both = options_of("man.glb --trajectories walk.csv --up walk=y,man=z");
  EXPECT_EQ(both.trajectories.reading.up, TrackUp::y);
  ASSERT_EQ(both.placements.size(), 1U);
  EXPECT_EQ(both.placements.front().model, "man");
  EXPECT_EQ(options_of("man.glb --trajectories walk.csv --up y").trajectories.reading.up, TrackUp::z);
}

TEST(TrajectoryOptionsOfALine, HavePlacesForRowsThatCome) {
  EXPECT_EQ(options_of("--trajectories -").tuning.agents, 1000);
  EXPECT_EQ(options_of("--trajectories - --agents 70").tuning.agents, 70);
}

class TrajectoryRefusal : public testing::TestWithParam<Refused> {};

TEST_P(TrajectoryRefusal, NamesTheOptionAndWhatIsAllowed) { EXPECT_EQ(refusal(GetParam().line), GetParam().message); }

INSTANTIATE_TEST_SUITE_P(
    OfOptions, TrajectoryRefusal,
    testing::Values(
        Refused{"WallsAlone", "--walls w.wkt", "--walls: goes with --trajectories"},
        Refused{"StartAlone", "--start 2", "--start: goes with --trajectories"},
        Refused{"AnotherScene", "--trajectories a.csv --scene plaza", "--scene: does not go with --trajectories"},
        Refused{"OtherAgents", "--trajectories a.csv --agents 9", "--agents: does not go with --trajectories"},
        Refused{"ARecording", "--trajectories a.csv --record r", "--record: does not go with --trajectories"},
        Refused{"NoUnit", "--trajectories a.csv --unit px",
                "--unit px: must be m, cm, mm, km, ft or the metres of a unit, 0.000001 to 1000000"},
        Refused{"RateAlone", "--track-rate 2", "--track-rate: goes with --trajectories"},
        Refused{"NoRate", "--trajectories a.csv --track-rate 0",
                "--track-rate 0: must be a number, -100 to 100, and not 0"},
        Refused{"HalfAPart", "--trajectories a.csv --track-part 4",
                "--track-part 4: must be two numbers of seconds, 12.5,40"},
        Refused{"AnAxisAside", "--trajectories a.csv --up x", "--up: of trajectories it is y or z"},
        Refused{"StartOfLiveRows", "--trajectories - --start 2",
                "--start: rows of standard input are shown as they come; leave it out"}),
    name_of);

}  // namespace
}  // namespace throng::app::options_trajectories_test
