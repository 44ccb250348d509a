// What a person is told of a change of the crowd, and how a change is taken back.
#include "app/window/crowd_editor.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/people/crowd/crowd.h"
#include "app/show/show.h"
#include "app/show/stage/stage.h"
#include "app/window/frame_reporter.h"
#include "tests/app/show/recording/recorded_run.h"
#include "tests/tracks/track_file.h"

namespace throng::app::crowd_editor_test {
namespace {

using testing::HasSubstr;
using testing::MatchesRegex;

class EditedCrowd : public testing::Test {
 protected:
  void pass() {
    show_->animate(test::sixtieth);
    reporter_.update(*show_, {}, 16.0);
  }
  const Message& last_message() { return reporter_.messages().all().back(); }
  Tuning with_agents(int agents) const {
    Tuning tuning = editor_.tuning();
    tuning.agents = agents;
    return tuning;
  }

  const std::unique_ptr<Show> show_ = test::show_of(test::demo("--agents 3"));
  FrameReporter reporter_{*show_};
  CrowdEditor editor_{*show_, reporter_};
};

TEST_F(EditedCrowd, SaysTheScaleOfAPlacedModel) {
  EXPECT_TRUE(editor_.take(SetPlacement{0, {.scale = 2.0}}));
  EXPECT_THAT(last_message().words, "mannequin (built in): 3.6 m tall: scaled by 2 as asked");
  EXPECT_FALSE(editor_.take(SetPlacement{0, {.scale = 1e12}}));
  EXPECT_THAT(last_message().words, HasSubstr("beyond all measure"));
  EXPECT_EQ(last_message().kind, Message::Kind::refused);
}

TEST_F(EditedCrowd, ReportsAnotherPlacementFromTheNextFrameOn) {
  EXPECT_EQ(reporter_.report().placement.scale, 1.0);
  EXPECT_EQ(reporter_.report().placement.guessed_scale, 1.0);
  EXPECT_TRUE(editor_.take(SetPlacement{0, {.scale = 0.5}}));
  pass();
  EXPECT_EQ(reporter_.report().placement.scale, 0.5);
  EXPECT_EQ(reporter_.report().placement.guessed_scale, 1.0);
  EXPECT_NEAR(reporter_.report().placement.units_tall, 1.8, 0.05);
  EXPECT_EQ(reporter_.report().placement.choice, (anim::PlacementChoice{.scale = 0.5}));
}

TEST_F(EditedCrowd, SaysInItsRowWhyABoneCannotBeThatPartOfTheBody) {
  const std::size_t before = reporter_.messages().all().size();
  EXPECT_FALSE(editor_.take(SetBody{0, {{anim::BodyRole::right_foot, "hips"}}}));
  EXPECT_EQ(reporter_.report().body.refused, anim::BodyRole::right_foot);
  EXPECT_EQ(reporter_.messages().all().size(), before);
}

TEST_F(EditedCrowd, GoesBackWithoutThePause) {
  EXPECT_TRUE(editor_.take(Apply{with_agents(10)}));
  editor_.end_change();
  Tuning paused = editor_.tuning();
  paused.paused = true;
  EXPECT_TRUE(editor_.take(Apply{paused}));
  editor_.end_change();
  editor_.undo();
  EXPECT_EQ(editor_.tuning().agents, 3);
  EXPECT_TRUE(editor_.tuning().paused);
  editor_.undo();
  EXPECT_EQ(editor_.tuning().agents, 3) << "there is no step before it";
  editor_.redo();
  EXPECT_EQ(show_->stage().tuning().agents, 10);
}

TEST_F(EditedCrowd, KeepsNoStepOfValuesThatWereRefused) {
  Tuning wrong = editor_.tuning();
  wrong.scene = Scene::tracks;
  EXPECT_FALSE(editor_.take(Apply{wrong}));
  EXPECT_THAT(last_message().words, HasSubstr("no file of trajectories is open"));
  editor_.undo();
  EXPECT_EQ(editor_.tuning(), show_->stage().tuning());
  EXPECT_EQ(editor_.tuning().scene, Scene::plaza);
}

TEST_F(EditedCrowd, TakesTheOtherOfTwoTuningsWithoutAStep) {
  EXPECT_TRUE(editor_.take_in_passing(with_agents(8)));
  editor_.undo();
  EXPECT_EQ(editor_.tuning().agents, 8);
}

std::shared_ptr<const Trajectories> walk_of(int people) {
  std::string text = "id,time,x,y\n";
  for (int person = 0; person < people; ++person) {
    for (const std::string row : {"0", "1", "2"}) text += std::to_string(person) + "," + row + "," + row + ",0\n";
  }
  auto read = read_as("walk.csv", text);
  return std::make_shared<const Trajectories>(std::move(*read));
}

TEST_F(EditedCrowd, GoesBackFromARecordedCrowdThatWasDroppedAndOnToIt) {
  ASSERT_TRUE(editor_.take(walk_of(5)));
  ASSERT_TRUE(show_->take(Seek{{.seconds = 1, .first = 0, .last = 2}}));
  ASSERT_TRUE(editor_.take(walk_of(2)));
  const auto people = [&] { return show_->stage().crowd().size(); };
  editor_.undo();
  EXPECT_EQ(people(), 5U);
  EXPECT_EQ(show_->stage().crowd().tracks()->clock().seconds, 1) << "at the time that was shown";
  editor_.undo();
  EXPECT_EQ(show_->stage().tuning().scene, Scene::plaza);
  EXPECT_EQ(people(), 3U);
  editor_.redo();
  editor_.redo();
  EXPECT_EQ(people(), 2U);
}

}  // namespace
}  // namespace throng::app::crowd_editor_test
