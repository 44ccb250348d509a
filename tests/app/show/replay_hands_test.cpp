// What a person does to a crowd by hand while it is recorded, and that a replay does the same.
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/show/kept_choices.h"
#include "app/show/replay.h"
#include "app/show/show.h"
#include "app/show/stage/rewind.h"
#include "app/show/stage/stage.h"
#include "tests/app/show/recording/recorded_run.h"

namespace throng::app::replay_hands_test {
namespace {

namespace fs = std::filesystem;
using test::change;
using test::demo;
using test::show_of;
using test::sixtieth;
using testing::HasSubstr;

const std::string other_model = THRONG_SOURCE_DIR "/tests/data/features/linear-trs.glb";

void expect_done(const Status& status) { EXPECT_TRUE(status) << status.error().message; }

void show_level_1(Show& show) {
  change(show, [](Tuning& tuning) { tuning.inspection.forced_bone_level = 1; });
}

/// Everybody shows their level 1, which from here on keeps half of the bones that it kept before, and the last one.
void reorder_bones(Show& show) {
  show_level_1(show);
  const anim::Skeleton& skeleton = show.stage().people()[0].character->skeleton;
  std::vector<int> parents;
  for (const anim::Bone& bone : skeleton.bones) parents.push_back(bone.parent);
  const BoneLodChoice present = present_bone_lod(skeleton.bones.size(), skeleton.level_bone_counts);
  BoneLodChoice choice = with_bone_moved(parents, present, parents.size() - 1, 3);
  choice.level_counts = {present.level_counts[0], present.level_counts[1] / 2};
  expect_done(show.take(SetBones{0, choice}));
}

class ReplaysOfHands : public test::RecordedRun {
 protected:
  std::unique_ptr<Show> plaza() const { return show_of(demo("--agents 40 --seed 3 --pus 1")); }
};

TEST_F(ReplaysOfHands, GiveRolesOtherClipsWhileTheCrowdGoesOn) {
  record(*plaza(), 90, [](Show& show, int frame) {
    if (frame != 30 && frame != 60) return;
    RoleClips clips = show.stage().people()[0].roles.clips;
    std::swap(clips[index_of(Role::walk)], clips[index_of(Role::run)]);
    std::swap(clips[index_of(Role::stand)], clips[index_of(Role::wave)]);
    EXPECT_TRUE(show.take(SetRoles{0, clips}));
  });
  EXPECT_EQ(repeated_in_any_schedule(), "(as recorded)");
}

TEST_F(ReplaysOfHands, HoldAClipAndLetItGo) {
  record(*plaza(), 60, [](Show& show, int frame) {
    if (frame == 5) test::ask(show, Select{7});
    if (frame >= 10 && frame < 20) {
      test::ask(show, Hold{show.stage().selected(), 0.05F * static_cast<float>(frame)});
    }
    if (frame == 30) test::ask(show, Hold{});
    if (frame == 35) test::ask(show, Hold{show.stage().selected(), 0.5F});
    if (frame == 45) test::ask(show, Select{8});  // lets go
    if (frame == 50) test::ask(show, Hold{show.stage().selected(), 0.25F});
  });
  EXPECT_EQ(repeated_in_any_schedule(), "(as recorded)");
}

TEST_F(ReplaysOfHands, GoBackInTimeToTheSameMoments) {
  record(*plaza(), 200, [](Show& show, int frame) {
    if (frame == 20) change(show, [](Tuning& tuning) { tuning.paused = true; });
    if (frame == 25) change(show, [](Tuning& tuning) { tuning.paused = false; });
    if (frame == 40) test::ask(show, Select{7});
    if (frame == 41) expect_done(show.take(test::push_of_selected(show)));
    if (frame == 80 || frame == 81 || frame == 120 || frame == 199) expect_done(show.take(GoBack{}));
    if (frame == 110) change(show, [](Tuning& tuning) { tuning.system.schedule = anim::Schedule::levels; });
  });
  EXPECT_EQ(repeated_in_any_schedule(), "(as recorded)");
}

TEST_F(ReplaysOfHands, GoBackNoFurtherThanToTheBeginOfTheRecording) {
  const auto show = plaza();
  show->keep_moments();
  for (int frame = 0; frame < 100; ++frame) show->animate(sixtieth);
  ASSERT_EQ(show->moments().count(), 4U);
  record(*show, 50, [](Show& recorded, int frame) {
    if (frame == 1) {
      EXPECT_FALSE(recorded.take(GoBack{})) << "what was before is not in the recording";
    }
    if (frame == 45) {
      expect_done(recorded.take(GoBack{}));
      expect_done(recorded.take(GoBack{}));
      EXPECT_FALSE(recorded.take(GoBack{}));
    }
  });
  EXPECT_EQ(repeated_in_any_schedule(), "(as recorded)");
}

TEST_F(ReplaysOfHands, GoBackToTheMomentThatWasAskedFor) {
  record(*plaza(), 160, [](Show& show, int frame) {
    if (frame != 150) return;
    ASSERT_EQ(show.moments().count(), 5U);
    const Ticks kept = show.stage().system().clock() - show.moments().age(show.stage(), 2);
    expect_done(show.take(GoBack{2}));
    EXPECT_EQ(show.stage().system().clock(), kept);
    EXPECT_EQ(show.moments().count(), 2U) << "it and all newer ones are behind";
  });
  EXPECT_EQ(repeated_in_any_schedule(), "(as recorded)");
}

TEST_F(ReplaysOfHands, OrderBonesAnew) {
  record(*plaza(), 40, [](Show& show, int frame) {
    if (frame == 10 || frame == 20) reorder_bones(show);
    if (frame == 30) {
      EXPECT_FALSE(show.take(SetBones{0, {}})) << "and what cannot be is not recorded";
    }
  });
  EXPECT_EQ(repeated_in_any_schedule(), "(as recorded)");
}

TEST_F(ReplaysOfHands, BeginWithTheOrderOfBonesThatTheRecordingBeganWith) {
  const auto show = plaza();
  for (int frame = 0; frame < 50; ++frame) {
    if (frame == 10) reorder_bones(*show);
    show->animate(sixtieth);
  }
  record(*show, 60, [](Show& recorded, int frame) {
    if (frame == 20) reorder_bones(recorded);
  });
  EXPECT_EQ(repeated_in_any_schedule(), "(as recorded)");
}

TEST_F(ReplaysOfHands, LoadOtherCharacters) {
  record(*plaza(), 60, [](Show& show, int frame) {
    const std::string models[] = {other_model, THRONG_SOURCE_DIR "/assets/mannequin.glb"};
    if (frame == 10) expect_done(show.take(LoadModels{{models[0]}}));
    if (frame == 20) {
      EXPECT_FALSE(show.take(LoadModels{std::vector<std::string>{"none.glb"}})) << "is not recorded";
    }
    if (frame == 30) expect_done(show.take(LoadModels{{models[0], models[1]}}));
    if (frame == 40)
      expect_done(
          show.take(SetBones{1, present_bone_lod(show.stage().people()[1].character->skeleton.bones.size(),
                                                 show.stage().people()[1].character->skeleton.level_bone_counts)}));
  });
  EXPECT_EQ(repeated_in_any_schedule(), "(as recorded)");
}

TEST_F(ReplaysOfHands, ChangeNothingWhenAnotherOrderOfBonesIsKeptLater) {
  const std::string model = folder_ / "person.glb";
  fs::copy_file(THRONG_SOURCE_DIR "/assets/mannequin.glb", model);
  const auto show = show_of(demo("--agents 12 " + model));
  record(*show, 30, [&](Show& recorded, int frame) {
    if (frame == 1) show_level_1(recorded);
    if (frame == 15) expect_done(recorded.take(LoadModels{{model}}));
  });
  reorder_bones(*show);
  const auto kept = save_bone_lod(show->stage().characters()[0]);
  ASSERT_TRUE(kept);
  ASSERT_EQ(kept->parent_path(), folder_) << "beside the model, where the replay finds it";
  EXPECT_EQ(repeated_in_any_schedule(), "(as recorded)");
}

class ReplaysOfADroppedModel : public ReplaysOfHands {
 protected:
  void SetUp() override {
    fs::copy_file(other_model, model_);
    record(*show_of(demo("--agents 3")), 5, [&](Show& show, int frame) {
      if (frame == 3) expect_done(show.take(LoadModels{{model_.string()}}));
    });
  }

  const fs::path model_ = folder_ / "dropped.glb";
};

TEST_F(ReplaysOfADroppedModel, SayThatItIsMissing) {
  fs::remove(model_);
  EXPECT_THAT(repeated(""), HasSubstr("run.rec: frame 3: " + model_.string()));
}

TEST_F(ReplaysOfADroppedModel, RefuseAnother) {
  fs::copy_file(THRONG_SOURCE_DIR "/tests/data/features/plain.glb", model_, fs::copy_options::overwrite_existing);
  EXPECT_THAT(repeated(""), HasSubstr("run.rec: frame 3: " + model_.string() + " is not the character"));
}

TEST_F(ReplaysOfADroppedModel, WithAByteDamagedSaySoBeforeTheirFirstFrame) {
  const std::string whole = bytes();
  for (std::size_t byte = 96; byte < whole.size(); byte += 97) {
    std::string damaged = whole;
    damaged[byte] = static_cast<char>(damaged[byte] ^ 1);
    put(damaged);
    const auto replay = Replay::open(file_);
    ASSERT_FALSE(replay) << byte;
    EXPECT_EQ(replay.error().message,
              file_.string() + ": is damaged: its bytes do not add up to its checksum; record it again");
  }
}

/// Moves a foot, which everybody places, to the end of the order. No level drops a bone.
void move_feet_last(Show& show) {
  const anim::Skeleton& skeleton = show.stage().people()[0].character->skeleton;
  std::vector<int> parents;
  for (const anim::Bone& bone : skeleton.bones) parents.push_back(bone.parent);
  const BoneLodChoice present = present_bone_lod(skeleton.bones.size(), skeleton.level_bone_counts);
  const auto foot = std::ranges::find(skeleton.bones, "foot.L", &anim::Bone::name);
  ASSERT_NE(foot, skeleton.bones.end());
  const auto place = static_cast<std::size_t>(foot - skeleton.bones.begin());
  BoneLodChoice choice = with_bone_moved(parents, present, place, parents.size() - 1);
  choice.level_counts = {present.level_counts[0]};
  expect_done(show.take(SetBones{0, choice}));
}

TEST_F(ReplaysOfHands, ThatMovedFeetToTheEndOfTheOrderAreEqual) {
  record(*plaza(), 60, [](Show& show, int frame) {
    if (frame == 20) move_feet_last(show);
  });
  for (const std::string scheduling : {"", "--pus 3", "--schedule levels --tile 1"}) {
    EXPECT_THAT(repeated(scheduling), testing::HasSubstr("all 60 frames are equal")) << scheduling;
  }
}

}  // namespace
}  // namespace throng::app::replay_hands_test
