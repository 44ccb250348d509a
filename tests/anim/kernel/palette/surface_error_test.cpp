#include "engine/anim/kernel/palette/surface_error.h"

#include <array>
#include <vector>

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "tests/anim/kernel/validity.h"

namespace throng::anim::surface_error_test {
namespace {

PaletteMatrix moved_by(const glm::vec3& offset) {
  return {.rows = {{1, 0, 0, offset.x}, {0, 1, 0, offset.y}, {0, 0, 1, offset.z}}};
}

/// One point a position, each of an entry of its own.
SurfacePoints points_at(std::span<const glm::vec3> positions) {
  SurfacePoints points{.influences = {}, .firsts = {0}};
  for (const glm::vec3& position : positions) {
    points.influences.push_back({glm::vec4(position, 1.0F), static_cast<std::uint32_t>(points.influences.size())});
    points.firsts.push_back(static_cast<std::uint32_t>(points.influences.size()));
  }
  return points;
}

/// 1000 x 500 pixels, 90 degrees high; looks along -Z.
ModelOnScreen wide_screen() {
  return {.model_to_clip = glm::perspective(glm::radians(90.0F), 2.0F, 0.1F, 100.0F), .half_size = {500.0F, 250.0F}};
}

SurfaceErrors errors_of(const glm::vec3& at, const glm::vec3& off_by) {
  const SurfacePoints points = points_at({&at, 1});
  const PaletteMatrix shown = moved_by(off_by), exact = moved_by({});
  SurfaceErrors errors;
  measure_surface(points, {&shown, 1}, {&exact, 1}, wide_screen(), errors);
  return errors;
}

TEST(ShownPaletteJob, IsValidAsItsCommentsSay) {
  static std::array<PaletteMatrix, 3> matrices{};
  static constexpr std::uint16_t kept[] = {0, 2, 2};
  static const std::array<PackingFrame, 3> frames{};
  alignas(16) static std::array<std::byte, 3 * sizeof(PaletteMatrix)> palette;
  const PaletteDestination memory(palette.data());
  const ShownPaletteJob job{.from = memory, .to = memory, .blend = 0.5F, .kept_entries = kept, .shown = matrices};
  expect_validity<ShownPaletteJob>(
      job,
      {{false, "nothing to come from", [](ShownPaletteJob& job) { job.from = nullptr; }},
       {false, "nothing to go to", [](ShownPaletteJob& job) { job.to = nullptr; }},
       {false, "a palette off the alignment",
        [](ShownPaletteJob& job) { job.to = PaletteDestination(palette.data() + 4); }},
       {false, "fewer entries shown than kept", [](ShownPaletteJob& job) { job.shown = job.shown.first(2); }},
       {true, "packed", [](ShownPaletteJob& job) { job.packing = frames; }},
       {false, "an entry that nothing unpacks", [](ShownPaletteJob& job) { job.packing = std::span(frames).first(2); }},
       {true, "blend 0", [](ShownPaletteJob& job) { job.blend = 0.0F; }},
       {true, "blend 1", [](ShownPaletteJob& job) { job.blend = 1.0F; }},
       {false, "blend below 0", [](ShownPaletteJob& job) { job.blend = -0.01F; }},
       {false, "blend above 1", [](ShownPaletteJob& job) { job.blend = 1.01F; }},
       {false, "blend not a number", [](ShownPaletteJob& job) { job.blend = std::nanf(""); }}});
}

TEST(MeasureSurface, SeesADistanceAsManyPixelsAsItCovers) {
  // A metre at 10 m covers 25 of 250 pixels.
  EXPECT_NEAR(errors_of({0, 0, -10}, {0, 0.2F, 0}).largest, 5.0F, 1e-3F);
  EXPECT_NEAR(errors_of({0, 0, -10}, {0.2F, 0, 0}).largest, 5.0F, 1e-3F);
  EXPECT_NEAR(errors_of({0, 0, -20}, {0, 0.2F, 0}).largest, 2.5F, 1e-3F);
}

TEST(MeasureSurface, DoesNotSeeWhatIsInLineWithTheEye) {
  EXPECT_NEAR(errors_of({0, 0, -10}, {0, 0, 1}).largest, 0.0F, 1e-4F);
}

TEST(MeasureSurface, LeavesOutWhatIsOutsideThePictureAndBehindTheCamera) {
  EXPECT_EQ(errors_of({0, 50, -10}, {0, 1, 0}).largest, 0.0F);
  EXPECT_EQ(errors_of({0, 0, 10}, {0, 1, 0}).largest, 0.0F);
}

TEST(MeasureSurface, CountsAPointThatShouldHaveBeenInThePicture) {
  EXPECT_GT(errors_of({0, 9, -10}, {0, 5, 0}).largest, 100.0F);
}

TEST(MeasureSurface, SkinsByAllInfluences) {
  SurfacePoints points{.influences = {{glm::vec4(0, 0, -7.5F, 0.75F), 0}, {glm::vec4(0, 0, -2.5F, 0.25F), 1}},
                       .firsts = {0, 2}};
  const std::array shown{moved_by({}), moved_by({0, 0.4F, 0})};
  const std::array exact{moved_by({}), moved_by({})};
  SurfaceErrors errors;
  measure_surface(points, shown, exact, wide_screen(), errors);
  EXPECT_NEAR(errors.largest, 0.25F * 10.0F, 1e-3F);
}

TEST(LargestChange, IsThatOfTheVectorAndNotOfItsLength) {
  const SurfaceErrors up = errors_of({0, 0, -10}, {0, 0.2F, 0}), down = errors_of({0, 0, -10}, {0, -0.2F, 0});
  EXPECT_NEAR(up.largest, down.largest, 1e-3F);
  EXPECT_NEAR(largest_change(up, down), 10.0F, 1e-3F);
  EXPECT_EQ(largest_change(up, up), 0.0F);
}

TEST(LargestChange, LeavesOutPointsThatWereNotInThePicture) {
  EXPECT_EQ(largest_change(errors_of({0, 0, 10}, {0, 1, 0}), errors_of({0, 0, -10}, {0, 1, 0})), 0.0F);
}

TEST(BlendShownPalette, IsTheBlendOfBothSlotsThroughTheEntriesThatTheLevelKeeps) {
  std::array from{moved_by({1, 0, 0}), moved_by({9, 9, 9})};
  std::array to{moved_by({3, 0, 0}), moved_by({9, 9, 9})};
  const std::array<std::uint16_t, 2> kept{0, 0};
  std::array<PaletteMatrix, 2> shown;
  blend_shown_palette({.from = from.data(), .to = to.data(), .blend = 0.25F, .kept_entries = kept, .shown = shown});
  for (const PaletteMatrix& entry : shown) EXPECT_FLOAT_EQ(entry.rows[0][3], 1.5F);
}

TEST(BlendShownPalette, UnpacksWhatIsPackedAsTheShaderDoes) {
  constexpr std::uint32_t unit_w = 32700U << 16U;  // the rotation that turns nothing
  std::array<PackedPaletteEntry, 1> from{{{{0, unit_w, 2, 0}}}}, to{{{{0, unit_w, 6, 0}}}};
  const std::array packing{PackingFrame{.pivot = {0, 0, 0}, .step = 0.5F}};
  const std::array<std::uint16_t, 2> kept{0, 0};
  std::array<PaletteMatrix, 2> shown;
  blend_shown_palette(
      {.from = from.data(), .to = to.data(), .packing = packing, .blend = 0.25F, .kept_entries = kept, .shown = shown});
  for (const PaletteMatrix& entry : shown) EXPECT_FLOAT_EQ(entry.rows[0][3], 1.5F);
}

TEST(BlendOf, GoesFromOneSlotToTheOtherAndStaysThere) {
  EXPECT_EQ(blend_of(100, 50, 100), 0.0F);
  EXPECT_EQ(blend_of(100, 50, 125), 0.5F);
  EXPECT_EQ(blend_of(100, 50, 150), 1.0F);
  EXPECT_EQ(blend_of(100, 0, 100), 1.0F);
  EXPECT_EQ(blend_of(UINT32_MAX - 9, 40, 10), 0.5F) << "the clock wraps";
}

}  // namespace
}  // namespace throng::anim::surface_error_test
