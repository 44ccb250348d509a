// The list of bones, which is searched and dragged, and the lines at which levels end.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/window/panel/bone_list.h"
#include "tests/app/window/panel/overlay_driver.h"

namespace throng::app::bones_test {
namespace {

/// A pelvis with two legs of two bones each, in three levels: 5, 3 and 1 bones.
FrameReport two_legs() {
  FrameReport report;
  report.characters = {"legs"};
  report.level_bone_counts = {5, 3, 1};
  report.bones = {{.name = "pelvis", .depth = 0, .parent = -1, .lod = {.bone = 0, .error_metres = 0.080F, .level = 2}},
                  {.name = "thigh_l", .depth = 1, .parent = 0, .lod = {.bone = 1, .error_metres = 0.030F, .level = 1}},
                  {.name = "thigh_r", .depth = 1, .parent = 0, .lod = {.bone = 2, .error_metres = 0.029F, .level = 1}},
                  {.name = "shin_l", .depth = 2, .parent = 1, .lod = {.bone = 3, .error_metres = 0.009F, .level = 0}},
                  {.name = "shin_r", .depth = 2, .parent = 2, .lod = {.bone = 4, .error_metres = 0.008F, .level = 0}}};
  return report;
}

struct BoneListTest : testing::Test {
  BoneListTest() {
    driver.report = two_legs();
    driver.click("tab:Per-bone LOD");
    driver.point_at(1100, 300);
    driver.frames();
    driver.input.push({.kind = InputEvent::Kind::wheel, .wheel = -100});
    driver.frames();
  }
  OverlayDriver driver;
};

TEST_F(BoneListTest, HasEveryBoneAndTheLineWhereEachLevelEnds) {
  for (const std::string bone : {"Bone 0", "Bone 1", "Bone 2", "Bone 3", "Bone 4"}) {
    EXPECT_TRUE(driver.sees(bone)) << bone;
  }
  EXPECT_TRUE(driver.sees("Border 1"));
  EXPECT_TRUE(driver.sees("Border 2"));
  EXPECT_FALSE(driver.sees("Border 3"));
}

TEST_F(BoneListTest, ABoneIsDraggedToAnotherPlace) {
  const auto moved = asked<SetBones>(driver.drag_to("Bone 2", "Bone 1"));
  EXPECT_EQ(moved.character, 0U);
  EXPECT_EQ(moved.choice.bones, (std::vector<int>{0, 2, 1, 3, 4}));
  EXPECT_EQ(moved.choice.level_counts, (std::vector<int>{5, 3, 1}));
}

TEST_F(BoneListTest, TheBorderOfALevelIsDraggedToABone) {
  const auto moved = asked<SetBones>(driver.drag_to("Border 1", "Bone 3"));
  EXPECT_EQ(moved.choice.level_counts, (std::vector<int>{5, 4, 1}));
  EXPECT_EQ(moved.choice.bones, (std::vector<int>{0, 1, 2, 3, 4}));
}

TEST_F(BoneListTest, ABoneThatIsLetGoInItsOwnPlaceChangesNothing) {
  EXPECT_FALSE(asks<SetBones>(driver.drag_to("Bone 2", "Bone 2")));
}

TEST_F(BoneListTest, UndoIsAskedForOnlyWhereTheLastChangeWasOneOfBones) {
  EXPECT_FALSE(asks<Undo>(driver.click("Undo")));
  ASSERT_NE(driver.why_idle("Undo"), nullptr);
  EXPECT_EQ(*driver.why_idle("Undo"), "the last change was none of bones");
  driver.report.can_undo_bones = true;
  driver.frames();
  EXPECT_EQ(driver.why_idle("Undo"), nullptr);
  const Requests undone = driver.click("Undo");
  EXPECT_TRUE(asks<Undo>(undone));
  EXPECT_FALSE(asks<SetBones>(undone)) << "the order of before is kept elsewhere";
}

TEST_F(BoneListTest, ASearchShowsTheBonesWhoseNamesHaveIt) {
  driver.click("Search.field");
  driver.type("SHIN");
  driver.frames();
  EXPECT_FALSE(driver.sees("Bone 1"));
  EXPECT_TRUE(driver.sees("Bone 3"));
  EXPECT_TRUE(driver.sees("Bone 4"));
  EXPECT_FALSE(asks<SetBones>(driver.drag_to("Bone 4", "Bone 3"))) << "rows in between are not seen";
}

TEST_F(BoneListTest, IsSavedAndExported) {
  EXPECT_TRUE(asks<SaveBones>(driver.click("Save order")));
  EXPECT_TRUE(asks<ExportLod>(driver.click("Export LOD")));
}

TEST_F(BoneListTest, ALevelIsPreviewed) {
  driver.point_at(1100, 400);
  driver.frames();
  driver.input.push({.kind = InputEvent::Kind::wheel, .wheel = 100});
  driver.frames();
  driver.click("Preview level:2");
  EXPECT_EQ(driver.tuning.inspection.forced_bone_level, 2);
}

TEST(BoneOrderEdit, BordersStayInOrderAndNoLevelIsEmpty) {
  const BoneLodChoice choice{.bones = {0, 1, 2, 3, 4, 5}, .level_counts = {6, 4, 2, 1}};
  EXPECT_EQ(with_border_moved(choice, 1, 2).level_counts, (std::vector<int>{6, 3, 2, 1}));
  EXPECT_EQ(with_border_moved(choice, 3, 5).level_counts, (std::vector<int>{6, 5, 4, 3}));
  EXPECT_EQ(with_border_moved(choice, 2, 0).level_counts, (std::vector<int>{6, 4, 2, 1}));
  EXPECT_EQ(with_border_moved(choice, 1, 6).level_counts, (std::vector<int>{6, 5, 2, 1}));
}

}  // namespace
}  // namespace throng::app::bones_test
