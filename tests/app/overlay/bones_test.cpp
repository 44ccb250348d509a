// The list of bones: searched, dragged, taken back; and the lines at which levels end.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/overlay/bone_list.h"
#include "tests/app/overlay/overlay_driver.h"

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
  const OverlayCommands moved = driver.drag_to("Bone 2", "Bone 1");
  ASSERT_TRUE(moved.bone_lod);
  EXPECT_EQ(moved.bone_lod->bones, (std::vector<int>{0, 2, 1, 3, 4}));
  EXPECT_EQ(moved.bone_lod->level_counts, (std::vector<int>{5, 3, 1}));
}

TEST_F(BoneListTest, TheBorderOfALevelIsDraggedToABone) {
  const OverlayCommands moved = driver.drag_to("Border 1", "Bone 3");
  ASSERT_TRUE(moved.bone_lod);
  EXPECT_EQ(moved.bone_lod->level_counts, (std::vector<int>{5, 4, 1}));
  EXPECT_EQ(moved.bone_lod->bones, (std::vector<int>{0, 1, 2, 3, 4}));
}

TEST_F(BoneListTest, WhatIsLetGoWhereItWasChangesNothing) {
  EXPECT_FALSE(driver.drag_to("Bone 2", "Bone 2").bone_lod);
  EXPECT_FALSE(driver.click("Undo").bone_lod) << "there is nothing to take back";
}

TEST_F(BoneListTest, AChangeIsTakenBackOnce) {
  driver.drag_to("Bone 2", "Bone 1");
  const OverlayCommands undone = driver.click("Undo");
  ASSERT_TRUE(undone.bone_lod);
  EXPECT_EQ(undone.bone_lod->bones, (std::vector<int>{0, 2, 1, 3, 4})) << "the two change places again";
  EXPECT_FALSE(driver.click("Undo").bone_lod);
}

TEST_F(BoneListTest, ASearchShowsWhatHasItInItsName) {
  driver.click("Search.field");
  driver.type("SHIN");
  driver.frames();
  EXPECT_FALSE(driver.sees("Bone 1"));
  EXPECT_TRUE(driver.sees("Bone 3"));
  EXPECT_TRUE(driver.sees("Bone 4"));
  EXPECT_FALSE(driver.drag_to("Bone 4", "Bone 3").bone_lod) << "rows in between are not seen";
}

TEST_F(BoneListTest, IsSavedAndExported) {
  EXPECT_TRUE(driver.click("Save order").save_bone_lod);
  EXPECT_TRUE(driver.click("Export LOD").export_lod);
}

TEST_F(BoneListTest, ALevelIsPreviewed) {
  driver.point_at(1100, 400);
  driver.frames();
  driver.input.push({.kind = InputEvent::Kind::wheel, .wheel = 100});
  driver.frames();
  driver.click("Preview level:2");
  EXPECT_EQ(driver.tuning.inspection.forced_bone_level, 2);
}

TEST(BoneOrderEdit, TakenBackIsTheInverse) {
  const BoneLodChoice choice{.bones = {2, 0, 3, 1}, .level_counts = {4, 2}};
  const BoneLodChoice back = taken_back(choice, {4, 3});
  for (std::size_t place = 0; place < 4; ++place) {
    EXPECT_EQ(choice.bones[static_cast<std::size_t>(back.bones[place])], static_cast<int>(place));
  }
  EXPECT_EQ(back.level_counts, (std::vector<int>{4, 3}));
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
