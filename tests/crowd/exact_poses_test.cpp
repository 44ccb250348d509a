#include "engine/crowd/exact_poses.h"

#include <gtest/gtest.h>

#include "throng/heap_pages.h"

namespace throng::exact_poses_test {
namespace {

constexpr std::uint32_t all_bones = 8;  // of a palette

struct ExactPosesTest : testing::Test {
  ExactPosesTest() { exact.reset(3, 0); }

  HeapPageSource pages{std::size_t{1} << 16U};
  PaletteSlots slots{pages, {anim::palette_stride(all_bones, PaletteFormat::matrices)}};
  ExactPoses exact{slots};
  ShownPose shown{.from = {.page = 0, .first_line = 400, .lines = 3},
                  .to = {.page = 0, .first_line = 403, .lines = 3},
                  .from_level = 2,
                  .to_level = 2,
                  .from_time = 10,
                  .to_time = 20};
};

TEST_F(ExactPosesTest, HaveASlotOfTheirOwnWithAllBonesAndNothingToBlend) {
  exact.add(1, shown, all_bones);
  const ShownPose& pose = exact.pose(1);
  EXPECT_TRUE(slots.is_acquired(pose.to));
  EXPECT_EQ(pose.from.first_line, pose.to.first_line);
  EXPECT_EQ(pose.from_time, pose.to_time);
  EXPECT_EQ(pose.level(), 0);
}

TEST_F(ExactPosesTest, AreWhatIsShownWhereTheExactPoseIsNotKnown) {
  exact.add(1, shown, 0);
  EXPECT_EQ(exact.pose(1).to_word(), shown.to_word());
  EXPECT_EQ(exact.pose(1).level(), 2);
  EXPECT_EQ(slots.slots_in_use(), 0U);
}

TEST_F(ExactPosesTest, GiveTheirSlotsBackOnceTheFrameIsDrawn) {
  constexpr std::uint64_t frame = 7;
  exact.add(0, shown, all_bones);
  exact.add(2, shown, all_bones);
  EXPECT_EQ(slots.slots_in_use(), 2U);
  exact.give_back(frame);
  slots.reclaim(frame - 1);
  EXPECT_EQ(slots.slots_in_use(), 2U) << "the device may still read them";
  slots.reclaim(frame);
  EXPECT_EQ(slots.slots_in_use(), 0U);
  exact.give_back(frame + 1);
}

}  // namespace
}  // namespace throng::exact_poses_test
