#include "engine/crowd/palette_slots.h"

#include <cstdint>
#include <set>

#include <gtest/gtest.h>

#include "throng/heap_pages.h"

namespace throng::palette_slots_test {
namespace {

constexpr std::size_t bytes_of(std::size_t lines) { return lines * render::palette_line_bytes; }

/// Gives `pages` pages, and then no more.
class LimitedPages final : public render::PalettePageSource {
 public:
  LimitedPages(std::size_t page_lines, int pages) : heap_(bytes_of(page_lines)), left_(pages) {}
  render::PalettePage add_page() override { return left_-- > 0 ? heap_.add_page() : render::PalettePage{}; }

 private:
  HeapPageSource heap_;
  int left_;
};

TEST(PaletteSlots, StartOnCacheLines) {
  HeapPageSource pages(bytes_of(4096));
  PaletteSlots slots(pages, {bytes_of(62), bytes_of(21)});
  for (const std::uint32_t lines : {62U, 21U, 62U, 21U}) {
    const PaletteSlot slot = slots.acquire(bytes_of(lines));
    ASSERT_TRUE(slot.valid());
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(slots.memory(slot)) % render::palette_line_bytes, 0U);
  }
}

TEST(PaletteSlots, NeverOverlap) {
  HeapPageSource pages(bytes_of(640));
  PaletteSlots slots(pages, {bytes_of(62), bytes_of(21)});
  std::set<std::byte*> lines;
  for (int i = 0; i < 40; ++i) {
    const PaletteSlot slot = slots.acquire(bytes_of(i % 2 == 0 ? 62 : 21));
    ASSERT_TRUE(slot.valid());
    for (std::uint32_t line = 0; line < slot.lines; ++line) {
      EXPECT_TRUE(lines.insert(slots.memory(slot) + bytes_of(line)).second);
    }
  }
}

TEST(PaletteSlots, HoldWhatTheirLevelNeeds) {
  HeapPageSource pages(bytes_of(4096));
  PaletteSlots slots(pages, {bytes_of(62), bytes_of(21)});
  EXPECT_EQ(slots.acquire(bytes_of(62)).lines, 62U);
  EXPECT_EQ(slots.acquire(bytes_of(21)).lines, 21U);
}

TEST(PaletteSlots, OfASizeThatWasNotAnnouncedAreOfTheNextLarger) {
  HeapPageSource source(std::size_t{1} << 16U);
  PaletteSlots slots(source, {bytes_of(64), bytes_of(24)});
  EXPECT_EQ(slots.acquire(bytes_of(40)).lines, 64U);
  EXPECT_EQ(slots.acquire(bytes_of(21)).lines, 24U);
  EXPECT_EQ(slots.acquire(bytes_of(3)).lines, 24U);
}

TEST(PaletteSlots, RetiredOneIsNotReusedBeforeItsLastFrameCompleted) {
  LimitedPages pages(64, 1);
  PaletteSlots slots(pages, {bytes_of(64)});
  const PaletteSlot first = slots.acquire(bytes_of(64));
  slots.retire(first, 7);
  EXPECT_FALSE(slots.acquire(bytes_of(64)).valid());
  slots.reclaim(6);
  EXPECT_FALSE(slots.acquire(bytes_of(64)).valid());
  slots.reclaim(7);
  const PaletteSlot second = slots.acquire(bytes_of(64));
  ASSERT_TRUE(second.valid());
  EXPECT_EQ(second.first_line, first.first_line);
}

TEST(PaletteSlots, RetiredOneIsNoLongerAcquired) {
  HeapPageSource pages(bytes_of(256));
  PaletteSlots slots(pages, {bytes_of(64)});
  const PaletteSlot slot = slots.acquire(bytes_of(64));
  EXPECT_TRUE(slots.is_acquired(slot));
  slots.retire(slot, 1);
  EXPECT_FALSE(slots.is_acquired(slot));
}

#ifndef NDEBUG
TEST(PaletteSlotsDeathTest, WriteToARetiredSlotIsCaught) {
  HeapPageSource pages(bytes_of(256));
  PaletteSlots slots(pages, {bytes_of(64)});
  const PaletteSlot slot = slots.acquire(bytes_of(64));
  slots.retire(slot, 1);
  EXPECT_DEATH(slots.memory(slot), "is_acquired");
}

TEST(PaletteSlotsDeathTest, RetiringTwiceIsCaught) {
  HeapPageSource pages(bytes_of(256));
  PaletteSlots slots(pages, {bytes_of(64)});
  const PaletteSlot slot = slots.acquire(bytes_of(64));
  slots.retire(slot, 1);
  EXPECT_DEATH(slots.retire(slot, 2), "is_acquired");
}
#endif

TEST(PaletteSlots, SecondSlotOfAnAgentLiesOnThePageOfItsFirst) {
  HeapPageSource pages(bytes_of(640));
  PaletteSlots slots(pages, {bytes_of(64)});
  for (int agent = 0; agent < 10; ++agent) {
    const PaletteSlot first = slots.acquire(bytes_of(64));
    const PaletteSlot second = slots.acquire(bytes_of(64), first.page);
    ASSERT_TRUE(second.valid());
    EXPECT_EQ(second.page, first.page);
  }
  EXPECT_GT(slots.page_count(), 1U);
}

TEST(PaletteSlots, NewcomersLeaveRoomForTheSecondSlotsOfAgentsThere) {
  HeapPageSource pages(bytes_of(1200));
  PaletteSlots slots(pages, {bytes_of(40)});
  int on_first_page = 0;
  while (slots.acquire(bytes_of(40)).page == 0) ++on_first_page;
  int second_slots = 0;
  while (slots.acquire(bytes_of(40), 0).valid()) ++second_slots;
  EXPECT_EQ(on_first_page, 10);
  EXPECT_EQ(second_slots, 20);
}

TEST(PaletteSlots, AreInvalidWhenThePageAskedForIsFull) {
  LimitedPages pages(128, 1);
  PaletteSlots slots(pages, {bytes_of(64)});
  const PaletteSlot first = slots.acquire(bytes_of(64));
  EXPECT_TRUE(slots.acquire(bytes_of(64), first.page).valid());
  EXPECT_FALSE(slots.acquire(bytes_of(64), first.page).valid());
}

TEST(PaletteSlots, FillEveryPageToTheEndWhenTheDeviceHasNoMore) {
  LimitedPages pages(256, 1);
  PaletteSlots slots(pages, {bytes_of(64)});
  for (int i = 0; i < 4; ++i) EXPECT_TRUE(slots.acquire(bytes_of(64)).valid()) << i;
  EXPECT_FALSE(slots.acquire(bytes_of(64)).valid());
}

TEST(PaletteSlots, SmallPoseTakesALargerFreeSlotRatherThanNone) {
  LimitedPages pages(64, 1);
  PaletteSlots slots(pages, {bytes_of(64), bytes_of(24)});
  slots.retire(slots.acquire(bytes_of(64)), 1);
  slots.reclaim(1);
  const PaletteSlot slot = slots.acquire(bytes_of(24));
  ASSERT_TRUE(slot.valid());
  EXPECT_EQ(slot.lines, 64U);
}

TEST(PaletteSlots, CountWhatIsInUseUntilItIsReclaimed) {
  HeapPageSource pages(bytes_of(4096));
  PaletteSlots slots(pages, {bytes_of(64)});
  const PaletteSlot slot = slots.acquire(bytes_of(64));
  EXPECT_EQ(slots.slots_in_use(), 1U);
  EXPECT_EQ(slots.bytes_in_use(), bytes_of(64));
  slots.retire(slot, 3);
  EXPECT_EQ(slots.slots_in_use(), 1U);
  slots.reclaim(3);
  EXPECT_EQ(slots.slots_in_use(), 0U);
  EXPECT_EQ(slots.bytes_in_use(), 0U);
}

TEST(PaletteSlots, ThousandAgentsThatMoveOnEveryFrameKeepToOnePage) {
  HeapPageSource pages(std::size_t{16} << 20U);
  PaletteSlots slots(pages, {bytes_of(62)});
  std::vector<PaletteSlot> shown;
  for (int agent = 0; agent < 1000; ++agent) shown.push_back(slots.acquire(bytes_of(62)));
  for (std::uint64_t frame = 3; frame < 100; ++frame) {
    slots.reclaim(frame - 2);
    for (PaletteSlot& slot : shown) {
      const PaletteSlot next = slots.acquire(bytes_of(62), slot.page);
      ASSERT_TRUE(next.valid());
      slots.retire(slot, frame - 1);
      slot = next;
    }
  }
  EXPECT_EQ(slots.page_count(), 1U);
}

}  // namespace
}  // namespace throng::palette_slots_test
