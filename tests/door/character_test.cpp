// Loading a character and asking what it has.

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/door/door_crowd.h"

namespace throng::character_test {
namespace {

using door_test::mannequin;
using testing::HasSubstr;

TEST(DoorCharacter, KnowsItsClipsByName) {
  const ClipId walk = mannequin().find_clip("walk");
  ASSERT_TRUE(walk.valid());
  EXPECT_EQ(mannequin().clip(walk).name, "walk");
  EXPECT_TRUE(mannequin().clip(walk).loops);
  EXPECT_NEAR(mannequin().clip(walk).ground_speed, 1.4, 0.3);
  EXPECT_FALSE(mannequin().find_clip("no such clip").valid());
  EXPECT_EQ(mannequin().clip({}).name, "");
}

TEST(DoorCharacter, KnowsItsBones) {
  const auto hand = mannequin().find_bone("hand.R");
  ASSERT_TRUE(hand.has_value());
  EXPECT_EQ(mannequin().bone_name(*hand), "hand.R");
  EXPECT_LT(mannequin().bone_parent(*hand), *hand);
  EXPECT_EQ(mannequin().bone_parent(-7), -1);
  EXPECT_EQ(mannequin().bone_name(1 << 20), "");
  EXPECT_GT(mannequin().palette_entries(0), mannequin().palette_entries(mannequin().level_count() - 1));
}

TEST(DoorCharacter, HasItsSurfaceIfThatIsAskedFor) {
  ASSERT_GT(mannequin().mesh_count(), 0U);
  const MeshView mesh = mannequin().mesh(0);
  ASSERT_FALSE(mesh.positions.empty());
  EXPECT_EQ(mesh.weights.size(), mesh.positions.size());
  EXPECT_EQ(mesh.palette_entries.size(), mesh.positions.size());
  for (const auto& weights : mesh.weights) EXPECT_NEAR(weights[0] + weights[1] + weights[2] + weights[3], 1.0F, 1e-4F);
  EXPECT_EQ(load(THRONG_SOURCE_DIR "/assets/mannequin.glb")->characters.front().mesh_count(), 0U);
}

TEST(DoorCharacter, AnEmptyOneHasNothing) {
  const Character empty;
  EXPECT_FALSE(empty);
  EXPECT_EQ(empty.clip_count(), 0U);
  EXPECT_EQ(empty.bone_count(), 0);
  EXPECT_EQ(empty.palette_entries(), 0U);
  EXPECT_EQ(empty.mesh_count(), 0U);
  EXPECT_TRUE(empty.missing_rigs().empty());
}

TEST(DoorCharacter, SaysWhyAFileIsNone) {
  EXPECT_THAT(load("no-such-model.glb").error().message, HasSubstr("no-such-model.glb"));
  EXPECT_THAT(load("x.glb", {.scale = -1.0}).error().message, HasSubstr("LoadOptions::scale"));
}

TEST(DoorCharacter, OfAFileThatTakesMoreMemoryThanItMayIsNone) {
  const auto file = load(THRONG_SOURCE_DIR "/assets/mannequin.glb", {.memory_limit = 1'000'000});
  ASSERT_FALSE(file);
  EXPECT_THAT(file.error().message, HasSubstr("mannequin.glb: the file needs "));
}

}  // namespace
}  // namespace throng::character_test
