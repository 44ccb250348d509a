#include "engine/render/palette/palette_buffer.h"

#include <cstdint>
#include <cstring>

#include <gtest/gtest.h>

#include "engine/render/palette/frame_fences.h"
#include "tests/gl/gl_test.h"

namespace throng::render::test::palette_buffer_test {
namespace {

class PalettePages : public SoftwareGlTest {};
class Fences : public SoftwareGlTest {};

TEST_F(PalettePages, AreAlignedWritableToTheLastByteAndGrow) {
  PaletteBuffer buffer(std::size_t{1} << 20U);
  const PalettePage first = buffer.add_page();
  const PalettePage second = buffer.add_page();
  EXPECT_EQ(first.size, std::size_t{1} << 20U);
  EXPECT_EQ(second.size, std::size_t{2} << 20U);
  for (const PalettePage& page : {first, second}) {
    ASSERT_NE(page.memory, nullptr);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(page.memory) % 64, 0U);
    std::memset(page.memory, 0, page.size);
  }
}

TEST_F(PalettePages, AreNeverLargerThanTheDevicesStorageBlock) {
  PaletteBuffer buffer(PaletteBuffer::largest_page_bytes * 4);
  const PalettePage page = buffer.add_page();
  ASSERT_NE(page.memory, nullptr);
  EXPECT_LE(page.size, PaletteBuffer::largest_page_bytes);
}

TEST_F(Fences, CompleteFramesInOrderAndForgetThem) {
  FrameFences fences;
  EXPECT_EQ(fences.poll(), 0U);
  for (std::uint64_t frame = 1; frame <= 3; ++frame) fences.insert(frame);
  glFinish();
  EXPECT_EQ(fences.poll(), 3U);
  EXPECT_EQ(fences.frames_in_flight(), 0U);
}

TEST_F(Fences, CompleteAFrameThatIsDrawnAgainWhenItsLastDrawIs) {
  FrameFences fences;
  fences.insert(1);
  fences.insert(2);
  fences.insert(2);
  EXPECT_EQ(fences.frames_in_flight(), 2U);
  glFinish();
  EXPECT_EQ(fences.poll(), 2U);
  fences.insert(2);
  EXPECT_EQ(fences.frames_in_flight(), 1U);
  glFinish();
  EXPECT_EQ(fences.poll(), 2U);
}

}  // namespace
}  // namespace throng::render::test::palette_buffer_test
