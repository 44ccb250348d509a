// Boxes of the surface that each palette entry moves.
#include "engine/anim/survey/entry_boxes.h"

#include <vector>

#include <gtest/gtest.h>

#include "engine/anim/asset/synthetic_model.h"

namespace throng::anim::entry_boxes_test {
namespace {

constexpr PaletteMatrix stay{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
constexpr PaletteMatrix turn_and_rise{{{0, 0, 1, 0}, {0, 1, 0, 5}, {-1, 0, 0, 0}}};

Model two_vertices() {
  Model model = synthetic_model(3, 1);
  SkinnedMesh& mesh = model.meshes.emplace_back();
  mesh.positions = {{0.0F, 0.0F, 0.0F}, {4.0F, 1.0F, 2.0F}};
  mesh.palette_entries = {{0, 0, 0, 0}, {0, 1, 0, 0}};
  mesh.weights = {{1.0F, 0.0F, 0.0F, 0.0F}, {0.5F, 0.5F, 0.0F, 0.0F}};
  return model;
}

TEST(EntryBoxes, HoldTheVerticesThatEachEntryMoves) {
  const std::vector<Box> boxes = entry_boxes(two_vertices());
  ASSERT_EQ(boxes.size(), 3U);
  EXPECT_EQ(boxes[0].low, glm::dvec3(0.0));
  EXPECT_EQ(boxes[0].high, glm::dvec3(4.0, 1.0, 2.0));
  EXPECT_EQ(boxes[1].low, glm::dvec3(4.0, 1.0, 2.0));
  EXPECT_TRUE(boxes[2].is_empty()) << "it moves no vertex";
}

TEST(EntryBoxes, AreTurnedAndMovedByThePalette) {
  const Box box = posed_box(entry_boxes(two_vertices()), std::vector{stay, turn_and_rise, turn_and_rise});
  EXPECT_EQ(box.low, glm::dvec3(0.0, 0.0, -4.0));
  EXPECT_EQ(box.high, glm::dvec3(4.0, 6.0, 2.0));
}

TEST(EntryBoxes, GrowWithAPaletteThatScales) {
  constexpr PaletteMatrix grow{{{3, 0, 0, 0}, {0, -2, 0, 0}, {0, 0, 1, 0}}};
  const Box box = posed_box(entry_boxes(two_vertices()), std::vector{grow, grow, grow});
  EXPECT_EQ(box.low, glm::dvec3(0.0, -2.0, 0.0));
  EXPECT_EQ(box.high, glm::dvec3(12.0, 0.0, 2.0));
}

TEST(EntryBoxes, OfAModelWithoutSurfaceAreThoseOfItsJoints) {
  const std::vector<Box> boxes = entry_boxes(synthetic_model(3, 1));
  for (const Box& box : boxes) EXPECT_FALSE(box.is_empty());
  EXPECT_EQ(boxes[0].size(), glm::dvec3(0.0));
}

}  // namespace
}  // namespace throng::anim::entry_boxes_test
