#include "app/show/replay.h"

#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/commands/command_line/options.h"
#include "app/settings/tuning_values.h"
#include "app/show/show.h"
#include "app/show/show_view.h"
#include "app/show/stage/stage.h"
#include "tests/app/commands/command_line/command_words.h"
#include "tests/app/program_run.h"
#include "tests/app/show/recording/recorded_run.h"

namespace throng::app::replay_test {
namespace {

namespace fs = std::filesystem;
using anim::StreamKind;
using test::change;
using test::demo;
using test::show_of;
using test::sixtieth;
using testing::HasSubstr;

void push_selected(Show& show) {
  const Status pushed = show.take(test::push_of_selected(show));
  EXPECT_TRUE(pushed) << pushed.error().message;
}

/// What somebody does at the window before each of 120 frames.
void act(Show& show, int frame) {
  show.view().camera.position.x += 0.05F;
  show.view().camera.yaw += 0.002F;
  if (frame == 10) change(show, [](Tuning& tuning) { tuning.lod.full_rate_distance = 3.0F; });
  if (frame == 15) change(show, [](Tuning& tuning) { tuning.lod.rule = LodRule::distance; });
  if (frame == 20) change(show, [](Tuning& tuning) { tuning.lod.largest_interval = 3; });
  if (frame == 30) test::ask(show, Select{4});
  if (frame == 31) push_selected(show);
  if (frame == 40) change(show, [](Tuning& tuning) { tuning.lod.level_distances[0] = 5.0F; });
  if (frame == 50) change(show, [](Tuning& tuning) { tuning.paused = true; });
  if (frame == 55) change(show, [](Tuning& tuning) { tuning.paused = false; });
  if (frame == 60) change(show, [](Tuning& tuning) { tuning.agents = 45; });
  if (frame == 70) change(show, [](Tuning& tuning) { tuning.scene = Scene::film; });
  if (frame == 90) change(show, [](Tuning& tuning) { tuning.system.schedule = anim::Schedule::levels; });
  if (frame == 95) change(show, [](Tuning& tuning) { tuning.scene = Scene::parade; });
  if (frame == 100) {
    RoleClips clips = show.stage().people()[0].roles.clips;
    clips[index_of(Role::walk)] = clips[index_of(Role::run)];
    EXPECT_TRUE(show.take(SetRoles{0, clips}));
  }
  if (frame == 110) show.view().width = 800;
}

using Replays = test::RecordedRun;

StreamKind other(StreamKind stream) {
  return stream == StreamKind::sampled ? StreamKind::keyframe : StreamKind::sampled;
}

/// Goes back to before another stream was chosen, then asks for values that are refused.
void ask_for_what_is_refused(Show& show, int frame) {
  if (frame == 32) change(show, [](Tuning& tuning) { tuning.system.stream = other(tuning.system.stream); });
  if (frame == 34) test::ask(show, GoBack{});
  if (frame != 40) return;
  Tuning tuning = show.stage().tuning();
  tuning.system.stream = other(tuning.system.stream);
  tuning.system.local_store_bytes = 2048;
  EXPECT_FALSE(show.take(Apply{tuning}));
}

TEST_F(Replays, OfARunInWhichSomethingWasRefusedAreEqual) {
  for (const std::string stream : {"sampled", "keyframe"}) {
    record(*show_of(demo("--agents 60 --pus 1 --stream " + stream)), 60, ask_for_what_is_refused);
    EXPECT_THAT(repeated(""), HasSubstr("all 60 frames are equal")) << stream;
  }
}

TEST_F(Replays, OfARunWithChangesAreEqual) {
  record(*show_of(demo("--agents 30 --seed 5 --pus 1")), 120, act);
  const std::string equal = file_.string() + ": all 120 frames are equal, the last of 45 agents";
  EXPECT_EQ(repeated(""), equal);
  EXPECT_EQ(repeated("--pus 3 --schedule levels --grain 0"), equal);
  EXPECT_EQ(repeated("--pus 2 --schedule fused --tile 2 --local-store 128 --double-buffer off --size 320x200"), equal);
}

TEST_F(Replays, BeginWhereARecordingBeganInTheMiddleOfARun) {
  const auto show = show_of(demo("--agents 20"));
  for (int frame = 0; frame < 7; ++frame) show->animate(sixtieth);
  record(*show, 20, act);
  EXPECT_EQ(repeated(""), file_.string() + ": all 20 frames are equal, the last of 20 agents");
}

TEST_F(Replays, BeginWhereARecordingBeganWithFewerPeopleThanBefore) {
  const auto show = show_of(demo("--agents 50"));
  show->animate(sixtieth);
  change(*show, [](Tuning& tuning) { tuning.agents = 20; });
  record(*show, 20, act);
  EXPECT_EQ(repeated(""), file_.string() + ": all 20 frames are equal, the last of 20 agents");
}

// Frames of another length, agents and orders of bones: nothing that level of detail has learnt of them stays.
TEST_F(Replays, KnowNothingOfWhatWasBeforeTheRecordingBegan) {
  const auto show = show_of(demo("--agents 150"));
  for (int frame = 0; frame < 90; ++frame) {
    if (frame == 30) change(*show, [](Tuning& tuning) { tuning.agents = 400; });
    show->animate(sixtieth * 6 / 5);
  }
  record(*show, 90, [](Show&, int) {});
  EXPECT_EQ(repeated(""), file_.string() + ": all 90 frames are equal, the last of 400 agents");
}

// Frame 3's hash of agent 2, which is posed in each frame, is the third of the values at that frame's end.
TEST_F(Replays, NameTheFirstFrameAndAgentThatDiffer) {
  const auto show = show_of(demo("--agents 4 --lod off"));
  ASSERT_TRUE(show->start_recording(file_));
  for (int frame = 1; frame <= 5; ++frame) show->animate(sixtieth);
  ASSERT_TRUE(show->stop_recording());
  constexpr std::size_t end_item = 5 + 8 + 8, frame_item = 5 + 8 + 24 + 8 + 8 + 4 + 1 + 4 * 2;
  std::string other = bytes();
  char& hash_of_agent_2 = other[other.size() - end_item - 2 * frame_item - 2 * 2];
  hash_of_agent_2 = static_cast<char>(hash_of_agent_2 ^ 1);
  put(test::with_true_checksum(other));
  EXPECT_THAT(repeated(""), HasSubstr("run.rec: frame 3: is the first that differs, in agent 2, mannequin (built in); "
                                      "in all, 1 of 4 agents"));
}

// A replay whose command line names other roles begins with characters made anew.
TEST_F(Replays, SumUpTheEventsThatTheRecordedRunSummedUp) {
  const auto recorded = show_of(demo("--agents 5 --events --clips run=none"));
  record(*recorded, 60, [](Show&, int) {});
  const auto replay = Replay::open(file_);
  ASSERT_TRUE(replay);
  const auto show = show_of((*replay)->options(demo("--events --replay " + file_.string())));
  ASSERT_TRUE((*replay)->begin(*show));
  while (*(*replay)->step(*show)) continue;
  const auto& sums = show->stage().animated().event_sums();
  ASSERT_TRUE(sums.has_value());
  EXPECT_EQ(sums->place_hash(), recorded->stage().animated().event_sums()->place_hash());
}

TEST_F(Replays, RefuseAnotherCharacter) {
  record(*show_of(demo("--agents 2")), 1, act);
  EXPECT_THAT(repeated(THRONG_SOURCE_DIR "/tests/data/features/linear-trs.glb"), HasSubstr("is not the character"));
}

TEST_F(Replays, TakeFromTheCommandLineOnlyWhatPosesDoNotDependOn) {
  const auto refusal = [](const std::string& line) {
    const ParsedCommand command = parse_command_line(words(line));
    const auto* const error = std::get_if<UsageError>(&command);
    return error == nullptr ? "(taken)" : error->message;
  };
  EXPECT_EQ(refusal("--replay a.rec --pus 2 --size 10x10 --frames 5 --headless"), "(taken)");
  for (const char* const option : {"--agents 5", "--scene grid", "--lod off", "--camera front", "--dt 1", "--record b",
                                   "--set agents=5", "--stream keyframe"}) {
    EXPECT_THAT(refusal(std::string("--replay a.rec ") + option), HasSubstr("leave it out with --replay")) << option;
  }
}

TEST_F(Replays, KeepTheValuesOfTheCommandLineThatOnlySchedule) {
  record(*show_of(demo("--agents 5")), 1, act);
  const auto tuning = [this](const std::string& line) {
    return (*Replay::open(file_))->options(demo("--replay " + file_.string() + line)).tuning;
  };
  const Tuning recorded = tuning("");
  const Tuning kept = tuning(" --pus 3 --schedule levels --tile 2 --local-store 128 --double-buffer off --grain 0");
  for (const TuningValue& value : tuning_values()) {
    EXPECT_EQ(value.text(kept) != value.text(recorded), value.only_schedules) << value.key;
  }
}

TEST_F(Replays, EndTheProgramWithWhatTheyFound) {
  const std::vector<std::string> record{"--headless=none", "--agents",    "5", "--frames", "8",
                                        "--record",        file_.string()};
  ASSERT_EQ(run_program(record).exit_status, 0);
  const ProgramRun equal = run_program({"--headless=none", "--replay", file_.string(), "--pus", "2"});
  EXPECT_EQ(equal.exit_status, 0) << equal.errors;
  EXPECT_EQ(equal.output, file_.string() + ": all 8 frames are equal, the last of 5 agents\n");

  fs::resize_file(file_, fs::file_size(file_) - 40);
  const ProgramRun cut = run_program({"--headless=none", "--replay", file_.string()});
  EXPECT_EQ(cut.exit_status, 1);
  EXPECT_EQ(cut.errors, "throng: " + file_.string() +
                            ": is cut short after frame 7; record it again, and let that run end by itself\n");
}

}  // namespace
}  // namespace throng::app::replay_test
