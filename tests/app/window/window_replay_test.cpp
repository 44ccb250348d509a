#include "app/window/window_replay.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/show/show.h"
#include "app/show/show_view.h"
#include "app/show/stage/stage.h"
#include "tests/app/show/recording/recorded_run.h"

namespace throng::app::window_replay_test {
namespace {

using test::change;
using test::demo;
using test::show_of;
using testing::HasSubstr;

constexpr double a_frame = 1.0 / 60;

void expect_done(const Status& status) { EXPECT_TRUE(status) << status.error().message; }

void reorder_bones(Show& show) {
  const anim::Skeleton& skeleton = show.stage().people()[0].character->skeleton;
  std::vector<int> parents;
  for (const anim::Bone& bone : skeleton.bones) parents.push_back(bone.parent);
  const BoneLodChoice present = present_bone_lod(skeleton.bones.size(), skeleton.level_bone_counts);
  expect_done(show.take(SetBones{0, with_bone_moved(parents, present, parents.size() - 1, 3)}));
}

/// What somebody does before each of 60 frames: everything that a replay has to take back to begin anew.
void act(Show& show, int frame) {
  show.view().camera.position.x += 0.02F;
  if (frame == 10) test::ask(show, Select{3});
  if (frame == 12) expect_done(show.take(test::push_of_selected(show)));
  if (frame == 20) change(show, [](Tuning& tuning) { tuning.agents = 25; });
  if (frame == 25) change(show, [](Tuning& tuning) { tuning.paused = true; });
  if (frame == 28) change(show, [](Tuning& tuning) { tuning.paused = false; });
  if (frame == 30) change(show, [](Tuning& tuning) { tuning.scene = Scene::film; });
  if (frame == 40) {
    RoleClips clips = show.stage().people()[0].roles.clips;
    clips[index_of(Role::walk)] = clips[index_of(Role::run)];
    EXPECT_TRUE(show.take(SetRoles{0, clips}));
  }
  if (frame == 50) reorder_bones(show);
}

class ReplayInAWindow : public test::RecordedRun {
 protected:
  void open(int frames = 60, const Act& what = act) {
    record(*show_of(demo("--agents 15 --pus 1")), frames, what);
    open_file();
  }
  void open_file() {
    auto opened = Replay::open(file_);
    ASSERT_TRUE(opened) << opened.error().message;
    replay_ = std::move(*opened);
    show_ = show_of(replay_->options(demo("--replay " + file_.string())));
    ASSERT_TRUE(replay_->begin(*show_));
    window_.emplace(*replay_);
  }
  const ReplayReport& now() const { return window_->report(); }
  void pass(int frames = 1) {
    for (int i = 0; i < frames; ++i) window_->advance(*show_, a_frame);
  }
  void go_to(std::uint64_t frame) {
    window_->take(SeekReplay{frame});
    for (int i = 0; i < 1000 && now().sought; ++i) pass();
  }
  void pass_until_the_end() {
    for (int i = 0; i < 1000 && !now().ended; ++i) pass();
  }
  std::uint64_t pose_hash() const { return show_->stage().system().figures().pose_hash(); }

  std::unique_ptr<Replay> replay_;
  std::unique_ptr<Show> show_;
  std::optional<WindowReplay> window_;
};

TEST_F(ReplayInAWindow, StaysAtItsEndAndSaysThatAllWereEqual) {
  open();
  EXPECT_EQ(now().frames, 60U);
  pass();
  EXPECT_EQ(now().frame, 1U);
  EXPECT_FALSE(now().ended);
  pass_until_the_end();
  const std::uint64_t last = pose_hash();
  pass(10);
  EXPECT_TRUE(now().ended);
  EXPECT_EQ(now().frame, 60U);
  EXPECT_FALSE(now().differs);
  EXPECT_EQ(pose_hash(), last) << "the last frame stays";
  EXPECT_THAT(now().outcome, HasSubstr("all 60 frames are equal"));
  EXPECT_TRUE(window_->outcome());
}

TEST_F(ReplayInAWindow, GoesToAnyFrameForthAndBack) {
  open();
  std::vector<std::uint64_t> hashes{0};
  for (std::uint64_t frame = 1; frame <= 60; ++frame) {
    go_to(frame);
    hashes.push_back(pose_hash());
  }
  for (const std::uint64_t frame : {60U, 10U, 55U, 41U, 1U, 29U, 22U, 60U}) {
    go_to(frame);
    EXPECT_EQ(now().frame, frame) << now().outcome;
    EXPECT_EQ(pose_hash(), hashes[frame]) << frame;
  }
  EXPECT_TRUE(now().ended);
  EXPECT_TRUE(window_->outcome()) << now().outcome;
}

TEST_F(ReplayInAWindow, GoesBackToTheCharactersThatWereThereBeforeOthersCame) {
  open(30, [](Show& show, int frame) {
    const std::string other = THRONG_SOURCE_DIR "/tests/data/features/linear-trs.glb";
    if (frame == 10) expect_done(show.take(LoadModels{{other}}));
  });
  for (const std::uint64_t frame : {30U, 5U, 20U, 1U, 30U}) {
    go_to(frame);
    EXPECT_EQ(now().frame, frame) << now().outcome;
    EXPECT_EQ(show_->stage().people().front().file.empty(), frame < 10) << frame;
  }
}

TEST_F(ReplayInAWindow, PausesAndGoesFrameByFrame) {
  open();
  go_to(20);
  window_->take(ToggleReplayPause{});
  pass(30);
  EXPECT_EQ(now().frame, 20U);
  for (const int step : {1, 1, -1}) {
    window_->take(StepReplay{step});
    for (int i = 0; i < 1000 && now().sought; ++i) pass();
  }
  EXPECT_EQ(now().frame, 21U);
  EXPECT_TRUE(now().paused);
  window_->take(ToggleReplayPause{});
  pass(10);
  EXPECT_GT(now().frame, 25U);
}

TEST_F(ReplayInAWindow, StopsAtAStep) {
  open();
  pass(5);
  window_->take(StepReplay{1});
  pass(20);
  EXPECT_TRUE(now().paused);
  EXPECT_LT(now().frame, 10U);
}

TEST_F(ReplayInAWindow, PlaysAtTheSpeedOfTheRecordingOrAnother) {
  open(60, [](Show&, int) {});
  pass();
  const auto frames_in = [&](float speed, int window_frames) {
    go_to(1);
    window_->take(SetReplaySpeed{speed});
    pass(window_frames);
    return static_cast<double>(now().frame) - 1;
  };
  EXPECT_NEAR(frames_in(1.0F, 24), 24, 2);
  EXPECT_NEAR(frames_in(0.25F, 40), 10, 2);
  EXPECT_NEAR(frames_in(4.0F, 8), 32, 4);
}

TEST_F(ReplayInAWindow, BeginsAnewAtItsEndIfItLoops) {
  open();
  window_->take(ToggleReplayLoop{});
  pass_until_the_end();
  pass(5);
  EXPECT_LT(now().frame, 20U);
  EXPECT_GT(now().frame, 0U);
  EXPECT_FALSE(now().ended);
}

TEST_F(ReplayInAWindow, BeginsAnewWhenToldToPlayAtItsEnd) {
  open();
  pass_until_the_end();
  window_->take(ToggleReplayPause{});
  pass(5);
  EXPECT_LT(now().frame, 20U);
  EXPECT_FALSE(now().paused);
}

TEST_F(ReplayInAWindow, StaysAtTheFirstFrameThatDiffersAndNamesIt) {
  record(*show_of(demo("--agents 4 --lod off")), 5, [](Show&, int) {});
  constexpr std::size_t end_item = 5 + 8 + 8, frame_item = 5 + 8 + 24 + 8 + 8 + 4 + 1 + 4 * 2;
  std::string other = bytes();
  char& hash_of_agent_2 = other[other.size() - end_item - 2 * frame_item - 2 * 2];
  hash_of_agent_2 = static_cast<char>(hash_of_agent_2 ^ 1);
  put(test::with_true_checksum(other));
  open_file();
  pass_until_the_end();
  EXPECT_EQ(now().frame, 3U);
  EXPECT_TRUE(now().differs);
  EXPECT_THAT(now().outcome, HasSubstr("frame 3: is the first that differs, in agent 2"));
  go_to(5);
  EXPECT_EQ(now().frame, 3U) << "what comes after it follows from it";
  go_to(2);
  EXPECT_EQ(now().frame, 2U);
  EXPECT_FALSE(window_->outcome()) << "the program ends with it all the same";
}

TEST_F(ReplayInAWindow, GoesAsFarAsARecordingThatWasCutShort) {
  record(*show_of(demo("--agents 4")), 8, [](Show&, int) {});
  std::filesystem::resize_file(file_, std::filesystem::file_size(file_) - 30);
  open_file();
  EXPECT_EQ(now().frames, 7U);
  pass_until_the_end();
  EXPECT_EQ(now().frame, 7U);
  EXPECT_THAT(now().outcome, HasSubstr("is cut short after frame 7"));
}

}  // namespace
}  // namespace throng::app::window_replay_test
