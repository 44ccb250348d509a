// The parts of a character's body, chosen while its crowd runs, kept for the next run, recorded and repeated.
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/character/body_parts.h"
#include "app/character/role_table.h"
#include "app/show/kept_choices.h"
#include "app/show/show.h"
#include "app/show/show_view.h"
#include "app/show/stage/stage.h"
#include "tests/app/show/recording/recorded_run.h"

namespace throng::app::body_test {
namespace {

using test::demo;
using test::show_of;
using testing::HasSubstr;
using testing::Not;
using Part = anim::BodyRole;

// The built-in character's left foot ends at its toes.
const std::vector<RigChoice> long_foot{{Part::left_foot, "toe.L"}};

std::string ankle(const Show& show) {
  const auto& feet = show.stage().animated().rigs(0).foot_placement();
  if (!feet) return "(no feet)";
  const anim::JointChain& chain = feet->legs.front().limb.chain;
  const auto& bones = show.stage().characters()[0].character->skeleton.bones;
  return bones[static_cast<std::size_t>(chain.bones.at(static_cast<std::size_t>(chain.tip())))].name;
}

BodyParts parts_of(const Show& show) {
  return body_parts(show.stage().characters()[0], show.stage().animated().rigs(0));
}

class Bodies : public test::RecordedRun {
 protected:
  Bodies() { std::filesystem::copy_file(THRONG_SOURCE_DIR "/assets/mannequin.glb", model_); }
  std::unique_ptr<Show> show() const { return show_of(demo("--agents 20 " + model_.string())); }

  const std::filesystem::path model_ = folder_ / "person.glb";
};

TEST_F(Bodies, StandOnTheFootThatAPersonChoseWhileTheCrowdRuns) {
  const auto show = this->show();
  EXPECT_EQ(ankle(*show), "foot.L");
  show->animate(test::sixtieth);
  ASSERT_TRUE(show->take(SetBody{0, long_foot}));
  EXPECT_EQ(ankle(*show), "toe.L");
  for (int frame = 0; frame < 5; ++frame) show->animate(test::sixtieth);
  EXPECT_EQ(show->stage().crowd().size(), 20U);
  ASSERT_TRUE(show->take(SetBody{0, {}}));
  EXPECT_EQ(ankle(*show), "foot.L");
}

TEST_F(Bodies, SayWhatIsGuessedAndWhatFollows) {
  const auto show = this->show();
  EXPECT_EQ(parts_of(*show).follows, "Feet are placed; it can look at things; it falls as a person.");
  ASSERT_TRUE(show->take(SetBody{0, long_foot}));
  const BodyParts longer = parts_of(*show);
  EXPECT_EQ(longer.chosen, long_foot);
  EXPECT_EQ(longer.guessed[anim::index_of(Part::left_foot)], "foot.L");
  EXPECT_EQ(longer.bones.size(), 62U);
  ASSERT_TRUE(show->take(SetBody{0, {{Part::left_upper_leg, "hand.R"}}}));
  EXPECT_THAT(parts_of(*show).follows, HasSubstr("it falls, but not as a person"));
  EXPECT_THAT(parts_of(*show).follows, Not(HasSubstr("skeleton '")));
}

TEST_F(Bodies, ChangeNothingWhereAPersonContradictsTheSkeleton) {
  const auto show = this->show();
  ASSERT_TRUE(show->take(SetBody{0, long_foot}));
  const auto refusal = [&](const std::vector<RigChoice>& choices) {
    const Status set = show->take(SetBody{0, choices});
    return set ? "(taken)" : set.error().message;
  };
  EXPECT_EQ(refusal({{Part::left_foot, "toe.L"}, {Part::right_foot, "toe.L"}}),
            "toe.L cannot be both the left foot and the right foot; choose another bone for one of them");
  EXPECT_EQ(refusal({{Part::left_foot, "thigh.L"}, {Part::left_lower_leg, "shin.L"}}),
            "thigh.L cannot be the left foot: it is above shin.L, the left lower leg");
  EXPECT_EQ(refusal({{Part::right_foot, "hips"}}),
            "hips cannot be the right foot: it is above thigh.R, the right upper leg")
      << "what is guessed counts too";
  EXPECT_EQ(refusal({{Part::right_foot, "thigh.R"}}),
            "thigh.R cannot be the right foot: it is above shin.R, the right lower leg")
      << "though the thigh is no longer known then, nor the shin below it";
  EXPECT_EQ(refusal({{Part::right_lower_leg, "toe.R"}}),
            "toe.R cannot be the right lower leg: it is below foot.R, the right foot");
  EXPECT_THAT(refusal({{Part::head, "heed"}}), HasSubstr("the skeleton has no such bone; nearest are head"));
  EXPECT_EQ(show->stage().characters()[0].rig, long_foot);
  EXPECT_EQ(ankle(*show), "toe.L");
}

TEST_F(Bodies, AreKeptBesideTheModelAndLeaveItsClipsAsTheyAre) {
  const std::filesystem::path kept = folder_ / "person.glb.throng.json";
  std::ofstream(kept) << R"({"version": 1, "clips": {"walk": "run"}})";
  {
    const auto show = this->show();
    ASSERT_TRUE(show->take(SetBody{0, long_foot}));
    const auto written = save_rig(show->stage().characters()[0]);
    ASSERT_TRUE(written) << written.error().message;
    EXPECT_EQ(*written, kept);
  }
  EXPECT_EQ(*RoleFile(model_).read(), (std::vector<RoleChoice>{{Role::walk, "run"}}));
  const auto again = show();
  EXPECT_EQ(again->stage().characters()[0].rig, long_foot);
  EXPECT_EQ(ankle(*again), "toe.L");
  ASSERT_TRUE(again->take(SetBody{0, {}}));
  ASSERT_TRUE(save_rig(again->stage().characters()[0]));
  EXPECT_EQ(ankle(*show()), "foot.L") << "a person took the word back";
}

TEST_F(Bodies, OfTheBuiltInCharacterAreThePersonsOwn) {
  setenv("XDG_CONFIG_HOME", folder_.c_str(), 1);
  const auto built_in = [] { return show_of(demo("--agents 2")); };
  {
    const auto show = built_in();
    ASSERT_TRUE(show->take(SetBody{0, long_foot}));
    EXPECT_EQ(*save_rig(show->stage().characters()[0]), folder_ / "throng" / "mannequin.throng.json");
  }
  EXPECT_EQ(ankle(*built_in()), "toe.L");
  unsetenv("XDG_CONFIG_HOME");
}

TEST_F(Bodies, AreRepeatedAsTheyWereRecorded) {
  const auto show = show_of(demo("--agents 20 --lod off"));
  ASSERT_TRUE(show->take(SetBody{0, long_foot})) << "before the recording begins";
  record(*show, 40, [](Show& recorded, int frame) {
    recorded.view().camera.position.x += 0.05F;
    if (frame == 15) {
      ASSERT_TRUE(recorded.take(SetBody{0, {{Part::right_foot, "toe.R"}, {Part::head, "neck"}}}));
    }
  });
  EXPECT_EQ(repeated(""), file_.string() + ": all 40 frames are equal, the last of 20 agents");
}

}  // namespace
}  // namespace throng::app::body_test
