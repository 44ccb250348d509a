// Another size and place of a character, while its crowd runs: it is loaded anew, and all else stays.
#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/character/bone_lod.h"
#include "app/show/show.h"
#include "app/show/stage/stage.h"
#include "tests/app/show/recording/recorded_run.h"

namespace throng::app::placement_test {
namespace {

using anim::PlacementChoice;
using test::demo;
using test::show_of;
using testing::HasSubstr;

constexpr PlacementChoice twice{.scale = 2.0};

class Placements : public test::RecordedRun {
 protected:
  Placements() {
    std::filesystem::copy_file(THRONG_SOURCE_DIR "/assets/mannequin.glb", folder_ / "person.glb");
    std::filesystem::copy_file(THRONG_SOURCE_DIR "/tests/data/features/plain.glb", folder_ / "plain.glb");
  }
  std::string cast() const {
    return "--agents 20 --cast " + (folder_ / "person.glb").string() + "*3," + (folder_ / "plain.glb").string();
  }
  static const CharacterSource& person(const Show& show) { return show.stage().people()[0]; }
};

void place(Show& show, CharacterNumber character, const PlacementChoice& choice) {
  const Status placed = show.take(SetPlacement{character, choice});
  ASSERT_TRUE(placed) << placed.error().message;
}

TEST_F(Placements, MakeACharacterLarger) {
  const auto show = show_of(demo(cast()));
  const double height = person(*show).character->bounds.height;
  place(*show, 0, twice);
  EXPECT_NEAR(person(*show).character->bounds.height, 2.0 * height, 1e-3);
  EXPECT_THAT(show->notice(), HasSubstr("3.6 m tall: scaled by 2 as asked"));
  place(*show, 0, {});
  EXPECT_NEAR(person(*show).character->bounds.height, height, 1e-6) << "as it is guessed";
  for (int frame = 0; frame < 3; ++frame) show->animate(test::sixtieth);
}

TEST_F(Placements, KeepRolesSharesAndOrdersOfAll) {
  const auto show = show_of(demo(cast()));
  RoleClips clips = person(*show).roles.clips;
  clips[index_of(Role::walk)] = clips[index_of(Role::run)];
  EXPECT_TRUE(show->take(SetRoles{0, clips}));
  EXPECT_TRUE(show->take(SetShare{1, 5.0}));
  std::vector<int> order(person(*show).character->skeleton.bones.size());
  for (std::size_t bone = 0; bone < order.size(); ++bone) order[bone] = static_cast<int>(bone);
  ASSERT_TRUE(show->take(SetBones{0, {.bones = order, .level_counts = {static_cast<int>(order.size()), 5}}}));
  place(*show, 0, twice);
  EXPECT_EQ(person(*show).roles.clips, clips);
  EXPECT_EQ(person(*show).roles.share, 3.0);
  EXPECT_EQ(person(*show).character->skeleton.level_bone_counts.back(), 5);
  EXPECT_EQ(show->stage().people()[1].roles.share, 5.0);
  EXPECT_EQ(show->stage().people()[1].placement.choice, PlacementChoice{});
}

TEST_F(Placements, OfTheBuiltInCharacterAreTakenToo) {
  const auto show = show_of(demo("--agents 5"));
  place(*show, 0, twice);
  EXPECT_NEAR(person(*show).character->bounds.height, 3.6, 0.01);
  EXPECT_TRUE(person(*show).file.empty());
}

TEST_F(Placements, ThatCannotBeChangeNothing) {
  const auto show = show_of(demo(cast()));
  const double height = person(*show).character->bounds.height;
  const auto refused = show->take(SetPlacement{0, {.scale = 1e12}});
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("no height, or one beyond all measure"));
  std::filesystem::remove(folder_ / "person.glb");
  const auto gone = show->take(SetPlacement{0, twice});
  ASSERT_FALSE(gone);
  EXPECT_THAT(gone.error().message, HasSubstr("person.glb"));
  EXPECT_EQ(person(*show).character->bounds.height, height);
  EXPECT_EQ(person(*show).placement.choice, PlacementChoice{});
}

TEST_F(Placements, AreRepeatedWithARecording) {
  record(*show_of(demo(cast() + " --scale plain=0.5")), 20, [](Show& show, int frame) {
    if (frame == 5) place(show, 0, {.scale = 1.5, .ground = anim::GroundRule::feet});
    if (frame == 10) place(show, 1, {.up = anim::UpAxis::z});
  });
  EXPECT_EQ(repeated(""), file_.string() + ": all 20 frames are equal, the last of 20 agents");
}

TEST_F(Placements, OfEachCharacterAreRepeatedWithFilesThatStandIn) {
  record(*show_of(demo(cast() + " --scale person=2,plain=0.5")), 5, [](Show&, int) {});
  for (const char* const name : {"person", "plain"}) {
    std::filesystem::rename(folder_ / (std::string(name) + ".glb"), folder_ / (std::string(name) + "-moved.glb"));
  }
  const std::string moved = (folder_ / "person-moved.glb").string() + " " + (folder_ / "plain-moved.glb").string();
  EXPECT_EQ(repeated(moved), file_.string() + ": all 5 frames are equal, the last of 20 agents");
}

}  // namespace
}  // namespace throng::app::placement_test
