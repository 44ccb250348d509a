// What a person changed is taken back and made again, a change at a time, through states that were there.
#include "app/show/request_history.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "app/show/show.h"
#include "app/show/stage/stage.h"
#include "tests/app/show/recording/recorded_run.h"

namespace throng::app::request_history_test {
namespace {

class Undone : public test::TemporaryFolder {
 protected:
  void take(const CrowdRequest& request) {
    const auto answer = answer_to(request, show_->stage(), show_->stage().tuning());
    const Status taken = show_->take(request);
    ASSERT_TRUE(taken) << taken.error().message;
    if (answer) history_.add(request, *answer, change_);
  }
  void take_alone(const CrowdRequest& request) {
    ++change_;
    take(request);
  }
  void undo() {
    ASSERT_NE(history_.last(), nullptr);
    for (const CrowdRequest& back : history_.last()->back) ASSERT_TRUE(show_->take(back));
    history_.took_back();
  }
  void redo() {
    ASSERT_NE(history_.next(), nullptr);
    for (const CrowdRequest& forth : history_.next()->forth) ASSERT_TRUE(show_->take(forth));
    history_.made_again();
  }
  CrowdRequest agents(int count) const {
    Apply values{show_->stage().tuning()};
    values.tuning.agents = count;
    return values;
  }
  const CharacterSource& person() const { return show_->stage().people().front(); }
  std::vector<ChosenCharacter> people() const { return exactly(show_->stage().people()); }

  const std::unique_ptr<Show> show_ = test::show_of(test::demo("--agents 5"));
  RequestHistory history_;
  std::uint64_t change_ = 0;
};

TEST_F(Undone, ValuesComeBackOneChangeAtATime) {
  take_alone(agents(10));
  take_alone(agents(20));
  undo();
  EXPECT_EQ(show_->stage().tuning().agents, 10);
  undo();
  EXPECT_EQ(show_->stage().tuning().agents, 5);
  EXPECT_EQ(history_.last(), nullptr);
  redo();
  redo();
  EXPECT_EQ(show_->stage().tuning().agents, 20);
  EXPECT_EQ(history_.next(), nullptr);
}

TEST_F(Undone, ADragIsOneChange) {
  ++change_;
  for (int count = 6; count < 30; ++count) take(agents(count));
  EXPECT_EQ(history_.last()->forth.size(), 1U);
  undo();
  EXPECT_EQ(show_->stage().tuning().agents, 5);
  redo();
  EXPECT_EQ(show_->stage().tuning().agents, 29);
}

TEST_F(Undone, AnotherChangeForgetsWhatWasTakenBack) {
  take_alone(agents(10));
  undo();
  take_alone(agents(30));
  EXPECT_EQ(history_.next(), nullptr);
}

TEST_F(Undone, WhatWasChosenForACharacterComesBack) {
  const std::vector<ChosenCharacter> before = people();
  RoleClips clips = person().roles.clips;
  std::swap(clips[index_of(Role::walk)], clips[index_of(Role::run)]);
  const std::size_t bones = person().character->skeleton.bones.size();
  std::vector<int> parents;
  for (const anim::Bone& bone : person().character->skeleton.bones) parents.push_back(bone.parent);
  const BoneLodChoice present = present_bone_lod(bones, person().character->skeleton.level_bone_counts);
  take_alone(SetRoles{0, clips});
  take_alone(SetShare{0, 3.0});
  take_alone(SetBones{0, with_bone_moved(parents, present, bones - 1, 3)});
  take_alone(SetBody{0, {{anim::BodyRole::left_foot, "toe.L"}}});
  take_alone(SetPlacement{0, {.scale = 1.5}});
  const std::vector<ChosenCharacter> changed = people();
  for (int step = 0; step < 5; ++step) undo();
  EXPECT_EQ(people(), before);
  for (int step = 0; step < 5; ++step) redo();
  EXPECT_EQ(people(), changed);
}

TEST_F(Undone, OtherCharactersComeBackWithTheirValuesInOneStep) {
  const std::vector<ChosenCharacter> before = people();
  ++change_;
  take(LoadModels{{THRONG_SOURCE_DIR "/tests/data/features/plain.glb"}});
  take(agents(7));
  ASSERT_EQ(history_.last()->back.size(), 2U);
  undo();
  EXPECT_EQ(people(), before);
  EXPECT_EQ(show_->stage().tuning().agents, 5);
}

TEST_F(Undone, APushIsNoStep) {
  take_alone(Push{2, {1, 0, 0}});
  take_alone(Select{2});
  EXPECT_EQ(history_.last(), nullptr);
}

TEST_F(Undone, TheFirstOfManyStepsAreForgotten) {
  for (std::size_t step = 0; step < RequestHistory::most_steps + 5; ++step) {
    take_alone(SetShare{0, 1.0 + static_cast<double>(step)});
  }
  for (std::size_t step = 0; step < RequestHistory::most_steps; ++step) undo();
  EXPECT_EQ(history_.last(), nullptr);
  EXPECT_EQ(person().roles.share, 5.0);
}

}  // namespace
}  // namespace throng::app::request_history_test
