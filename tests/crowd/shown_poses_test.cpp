#include "engine/crowd/shown_poses.h"

#include <gtest/gtest.h>

#include "throng/heap_pages.h"

namespace throng::shown_poses_test {
namespace {

constexpr std::uint32_t entries = 64;
constexpr std::size_t palette_bytes = anim::palette_stride(entries, PaletteFormat::matrices);
constexpr std::uint32_t frame_time = 16'667;  // microseconds

/// Gives `pages` pages of a few slots each and then no more.
class FewPages final : public render::PalettePageSource {
 public:
  FewPages(std::size_t slots, int pages) : heap_(slots * palette_bytes), left_(pages) {}
  render::PalettePage add_page() override { return left_-- > 0 ? heap_.add_page() : render::PalettePage{}; }

 private:
  HeapPageSource heap_;
  int left_;
};

struct ShownPosesTest : testing::Test {
  FewPages pages{3, 2};
  PaletteSlots slots{pages, {palette_bytes}};
  ShownPoses shown{slots};

  ShownPosesTest() { shown.reset(8, 0); }
  std::byte* show(std::uint32_t agent, std::uint32_t now, std::uint32_t pose_time) {
    return shown.show({.agent = agent, .level = 0, .entries = entries, .time = pose_time}, now, 0);
  }
};

TEST_F(ShownPosesTest, BlendFromThePoseShownSoFarToTheNewOne) {
  ASSERT_NE(show(0, 0, 0), nullptr);
  EXPECT_EQ(shown.pose(0).from_time, shown.pose(0).to_time) << "the first pose is shown at once";
  ASSERT_NE(show(0, 0, 4 * frame_time), nullptr);
  EXPECT_EQ(shown.pose(0).from_time, 0U);
  EXPECT_EQ(shown.pose(0).to_time, 4 * frame_time);
  EXPECT_NE(shown.pose(0).from.first_line, shown.pose(0).to.first_line);
}

TEST_F(ShownPosesTest, MoveToAnotherPageWhenTheirsIsFull) {
  ASSERT_NE(show(0, 0, 0), nullptr);
  for (std::uint32_t frame = 0; frame < 4; ++frame) {  // nothing is reclaimed, so each pose takes a slot of its own
    ASSERT_NE(show(0, frame * frame_time, (frame + 1) * frame_time), nullptr) << frame;
  }
  EXPECT_EQ(shown.pose(0).to.page, 1U);
  EXPECT_EQ(shown.pose(0).from.page, 1U) << "a draw reads both from one page";
  EXPECT_EQ(shown.pose(0).to_time, 4 * frame_time);
  EXPECT_FALSE(shown.out_of_memory());
}

TEST_F(ShownPosesTest, AskForThePoseOfNowWhereThereIsNoneToBlendFromOnTheSamePage) {
  std::uint32_t now = 0;
  ASSERT_NE(show(0, now, now), nullptr);
  while (shown.pose(0).to.page == 0) {
    now += frame_time;
    ASSERT_NE(show(0, now, now + 4 * frame_time), nullptr);
  }
  EXPECT_EQ(shown.pose(0).from_time, now);
  EXPECT_EQ(shown.pose(0).to_time, now);
}

TEST_F(ShownPosesTest, SayWhenNoMemoryIsLeft) {
  for (std::uint32_t agent = 0; agent < 6; ++agent) EXPECT_NE(show(agent, 0, 0), nullptr) << agent;
  EXPECT_FALSE(shown.out_of_memory());
  EXPECT_EQ(show(6, 0, 0), nullptr);
  EXPECT_FALSE(shown.pose(6).shown());
  EXPECT_TRUE(shown.out_of_memory());
}

TEST_F(ShownPosesTest, SayWhichOfTheirSlotsIsPacked) {
  PaletteSlots both(pages, {palette_bytes, anim::palette_stride(entries, PaletteFormat::packed)});
  ShownPoses poses(both);
  poses.reset(1, 0);
  poses.show({.agent = 0, .level = 0, .entries = entries, .time = 0}, 0, 0);
  poses.show({.agent = 0, .level = 0, .entries = entries, .time = frame_time, .format = PaletteFormat::packed}, 0, 0);
  const ShownPose& pose = poses.pose(0);
  EXPECT_EQ(pose.from_word(), pose.from.first_line);
  EXPECT_EQ(pose.to_word(), pose.to.first_line | render::packed_slot);
}

TEST_F(ShownPosesTest, TakeAThirdOfTheRoomWherePacked) {
  const std::size_t packed_bytes = anim::palette_stride(entries, PaletteFormat::packed);
  PaletteSlots both(pages, {palette_bytes, packed_bytes});
  ShownPoses poses(both);
  poses.reset(1, 0);
  poses.show({.agent = 0, .level = 0, .entries = entries, .time = 0, .format = PaletteFormat::packed}, 0, 0);
  EXPECT_EQ(both.bytes_in_use(), packed_bytes);
  EXPECT_NEAR(static_cast<double>(both.bytes_in_use()), static_cast<double>(palette_bytes) / 3.0,
              2.0 * render::palette_line_bytes);  // each is rounded up to an odd number of lines
}

TEST_F(ShownPosesTest, StartAnewWithANewCrowd) {
  for (std::uint32_t agent = 0; agent < 7; ++agent) show(agent, 0, 0);
  ASSERT_TRUE(shown.out_of_memory());
  shown.reset(8, 1);
  slots.reclaim(1);
  EXPECT_FALSE(shown.out_of_memory());
  EXPECT_EQ(slots.slots_in_use(), 0U);
  EXPECT_NE(show(0, 0, 0), nullptr);
}

}  // namespace
}  // namespace throng::shown_poses_test
