#include <algorithm>
#include <cstdlib>

#include <gtest/gtest.h>

#include "engine/render/light/shadow_uniforms.h"
#include "tests/gl/doll_crowd.h"
#include "tests/gl/gl_test.h"
#include "tests/gl/picture_tolerance.h"

namespace throng::render::test::crowd_picture_test {
namespace {

constexpr std::size_t crowd_size = 15;

bool are_apart(const Image& a, const Image& b, int x, int y) {
  return !std::equal(a.pixel(x, y), a.pixel(x, y) + 3, b.pixel(x, y));
}

/// Draws the crowd correctly, and once more with a fault in the renderer's input.
class CrowdPicture : public SoftwareGlTest {
 protected:
  void SetUp() override {
    SoftwareGlTest::SetUp();
    crowd_ = std::make_unique<DollCrowd>(context());
    crowd_->stand(crowd_size);
    crowd_->write_palettes();
    meant_ = crowd_->picture();
  }
  void TearDown() override {
    crowd_.reset();
    SoftwareGlTest::TearDown();
  }

  DollCrowd& crowd() { return *crowd_; }
  const Image& meant() const { return meant_; }
  PictureDifference difference_now() { return *measure_difference(meant_, crowd().picture()); }

 private:
  std::unique_ptr<DollCrowd> crowd_;
  Image meant_;
};

TEST_F(CrowdPicture, IsTheSameWhenDrawnAgain) {
  const PictureDifference difference = difference_now();
  EXPECT_EQ(difference.mean, 0.0);
  EXPECT_EQ(difference.worst_block, 0.0);
}

TEST_F(CrowdPicture, ShowsAMissingAgent) {
  crowd().instances.erase(crowd().instances.begin() + 7);
  EXPECT_FALSE(looks_the_same(difference_now()));
}

TEST_F(CrowdPicture, ShowsSwappedTintRegions) {
  for (AgentLook& look : crowd().looks) std::swap(look.tints[2], look.tints[3]);
  EXPECT_FALSE(looks_the_same(difference_now()));
}

TEST_F(CrowdPicture, HasNewLooksOnlyWithANewNumber) {
  CrowdFrame frame = crowd().frame();
  crowd().renderer().draw(frame);
  for (AgentLook& look : crowd().looks) std::swap(look.tints[2], look.tints[3]);
  crowd().renderer().draw(frame);
  EXPECT_EQ(measure_difference(meant(), crowd().renderer().read_image())->worst_block, 0.0);
  frame.looks_number = new_looks_number();
  crowd().renderer().draw(frame);
  EXPECT_FALSE(looks_the_same(*measure_difference(meant(), crowd().renderer().read_image())));
}

TEST_F(CrowdPicture, ShowsPlainAgentsWithoutLooks) {
  std::ranges::fill(crowd().looks, plain_look());
  const Image plain = crowd().picture();
  CrowdFrame without = crowd().frame();
  without.looks = {};
  without.looks_number = 0;
  crowd().renderer().draw(without);
  EXPECT_EQ(measure_difference(plain, crowd().renderer().read_image())->worst_block, 0.0);
}

TEST_F(CrowdPicture, ShowsNoShadeOnWhatATintColours) {
  for (AgentLook& look : crowd().looks) look.shade = 0x7F7F7FU;
  EXPECT_EQ(difference_now().worst_block, 0.0);
}

TEST_F(CrowdPicture, ShowsAPaletteOffByOneBone) {
  for (DollPalette& palette : crowd().to) std::rotate(palette.begin(), palette.begin() + 1, palette.end());
  crowd().write_palettes();
  EXPECT_FALSE(looks_the_same(difference_now()));
}

TEST_F(CrowdPicture, ShowsInstancesOffByOneSlot) {
  auto& instances = crowd().instances;
  for (std::size_t i = 0; i + 1 < instances.size(); ++i) instances[i].palette_to = instances[i + 1].palette_to;
  EXPECT_FALSE(looks_the_same(difference_now()));
}

TEST_F(CrowdPicture, ShowsTransposedMatrices) {
  for (DollPalette& palette : crowd().to) {
    for (PaletteRows& joint : palette) {
      for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < row; ++column) std::swap(joint.rows[row][column], joint.rows[column][row]);
      }
    }
  }
  crowd().write_palettes();
  EXPECT_FALSE(looks_the_same(difference_now()));
}

TEST_F(CrowdPicture, ShowsADebugColorAsFarAsItsAlphaSays) {
  for (InstanceRecord& record : crowd().instances) record.debug_color = 0x000000FFU;
  EXPECT_EQ(difference_now().worst_block, 0.0);
  for (InstanceRecord& record : crowd().instances) record.debug_color = 0xFF0000FFU;
  EXPECT_FALSE(looks_the_same(difference_now()));
}

TEST_F(CrowdPicture, ShowsADebugColorAsItIsInTheLegendWhereItFacesTheSun) {
  constexpr int red = 30, green = 155, blue = 138;
  for (InstanceRecord& record : crowd().instances) record.debug_color = 0xFF000000U | blue << 16U | green << 8U | red;
  crowd().renderer().draw(crowd().frame());
  const Image image = crowd().renderer().read_image();
  int nearest = 255;
  for (std::size_t at = 0; at + 3 < image.rgba.size(); at += 4) {
    const int off = std::max(
        {std::abs(image.rgba[at] - red), std::abs(image.rgba[at + 1] - green), std::abs(image.rgba[at + 2] - blue)});
    nearest = std::min(nearest, off);
  }
  EXPECT_LE(nearest, 12) << "the haze leaves most of it";
}

/// Returns how many pixels are plainly yellow.
std::size_t yellow_pixels(const Image& image) {
  std::size_t count = 0;
  for (std::size_t at = 0; at + 3 < image.rgba.size(); at += 4) {
    const int red = image.rgba[at], green = image.rgba[at + 1], blue = image.rgba[at + 2];
    count += red > 100 && 3 * green > 2 * red && red > 2 * blue ? 1 : 0;
  }
  return count;
}

TEST_F(CrowdPicture, ShowsInYellowWhatFollowsAWeighedEntry) {
  for (AgentLook& look : crowd().looks) look = plain_look();
  const auto yellow_with = [&](WeighedEntries weighed) {
    CrowdFrame frame = crowd().frame();
    frame.weighed = weighed;
    crowd().renderer().draw(frame);
    return yellow_pixels(crowd().renderer().read_image());
  };
  EXPECT_EQ(yellow_with({}), 0U);
  const std::size_t of_legs = yellow_with({legs, 1}), of_head = yellow_with({head, 1});
  EXPECT_GT(of_head, 20U);
  EXPECT_GT(of_legs, of_head);
  EXPECT_GT(yellow_with({0, doll_joints}), of_legs + of_head) << "everything follows all of them together";
  EXPECT_EQ(yellow_with({65536, 1}), 0U) << "nothing follows it";
}

TEST_F(CrowdPicture, TakesAsManyDrawCallsForManyAgentsAsForFew) {
  const DrawCounts few = crowd().renderer().draw(crowd().frame());
  crowd().stand(60);
  crowd().write_palettes();
  CrowdFrame frame = crowd().frame();
  std::vector<CrowdBatch> batches(frame.batches.begin(), frame.batches.end());
  batches.back().mesh_lod = 1;  // a larger crowd may also have more mesh LODs
  frame.batches = batches;
  const DrawCounts many = crowd().renderer().draw(frame);
  EXPECT_EQ(many.draw_calls, few.draw_calls);
  EXPECT_GT(many.triangles, few.triangles * 2);
}

TEST_F(CrowdPicture, CountsNoTriangleTwice) {
  CrowdFrame frame = crowd().frame();
  frame.shadows = frame.crowd_shade = false;
  const DrawCounts counts = crowd().renderer().draw(frame);
  const std::uint64_t surface = crowd().renderer().mesh_lods(0).triangles[0];
  constexpr std::uint64_t ground = 3, contact_spot = 2;  // two triangles of ground, one of sky
  EXPECT_EQ(counts.triangles, ground + crowd_size * (contact_spot + surface));
  EXPECT_EQ(counts.draw_calls, 4U);  // ground, sky, spots, and the crowd, although it comes in two batches
}

TEST_F(CrowdPicture, ShowsBonesOverTheCharacters) {
  CrowdFrame frame = crowd().frame();
  const DrawCounts usual = crowd().renderer().draw(frame);
  frame.bones_as_lines = true;
  EXPECT_EQ(crowd().renderer().draw(frame).triangles, usual.triangles) << "the characters are drawn as always";
  const Image with_bones = crowd().renderer().read_image();
  crowd().instances.clear();
  const Image nobody = crowd().picture();
  std::size_t of_characters = 0, of_bones = 0;
  for (int y = 0; y < DollCrowd::height; ++y) {
    for (int x = 0; x < DollCrowd::width; ++x) {
      of_characters += are_apart(meant(), nobody, x, y);
      of_bones += are_apart(meant(), nobody, x, y) && are_apart(meant(), with_bones, x, y);
    }
  }
  EXPECT_GT(of_bones, of_characters / 100) << "a body does not hide its own bones";
  EXPECT_LT(of_bones, of_characters / 4);
}

TEST_F(CrowdPicture, SurvivesAnotherSizeAndBack) {
  ASSERT_TRUE(crowd().renderer().set_size({64, 400}));
  EXPECT_EQ(crowd().picture().height, 400);
  ASSERT_TRUE(crowd().renderer().set_size({DollCrowd::width, DollCrowd::height}));
  EXPECT_EQ(difference_now().worst_block, 0.0);
}

TEST_F(CrowdPicture, SmoothsEdgesWithSamplesAndKeepsEverythingElse) {
  DollCrowd smooth(context(), 4);
  smooth.stand(crowd_size);
  smooth.write_palettes();
  const PictureDifference difference = *measure_difference(meant(), smooth.picture());
  EXPECT_GT(difference.mean, 0.0);
  EXPECT_LT(difference.mean, 6.0);
}

TEST_F(CrowdPicture, OfNobodyIsTheGround) {
  crowd().instances.clear();
  const DrawCounts counts = crowd().renderer().draw({crowd().frame().camera, {}, {}, 0, false});
  EXPECT_EQ(counts.draw_calls, 2U) << "and the sky";
}

// Both characters have the doll's surface, each in buffers of its own, so a run looks the same with either.
TEST_F(CrowdPicture, IsTheSameWhicheverOfTwoEqualCharactersEachRunIs) {
  CrowdFrame frame = crowd().frame();
  std::vector<CrowdBatch> batches(frame.batches.begin(), frame.batches.end());
  batches.back().character = 1;
  frame.batches = batches;
  const DrawCounts two = crowd().renderer().draw(frame);
  const PictureDifference difference = *measure_difference(meant(), crowd().renderer().read_image());
  EXPECT_EQ(difference.worst_block, 0.0);
  const DrawCounts one = crowd().renderer().draw(crowd().frame());
  EXPECT_GT(two.draw_calls, one.draw_calls);
  EXPECT_LE(two.draw_calls, one.draw_calls + 1 + cascade_count) << "one call more for its surface, one a shadow map";
  EXPECT_EQ(two.triangles, one.triangles);
}

}  // namespace
}  // namespace throng::render::test::crowd_picture_test
