// From a CrowdView to throng::render.
#include "throng/drawing.h"

#include <algorithm>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace throng::drawing_test {
namespace {

Character mannequin(bool with_surface) {
  return load(THRONG_SOURCE_DIR "/assets/mannequin.glb", {.keep_meshes = with_surface})->characters.front();
}

TEST(MeshDataOfACharacter, HasItsSurfaceItsLevelsAndPosesOfItsClips) {
  const Character person = mannequin(true);
  const auto data = mesh_data(person);
  ASSERT_TRUE(data) << data.error().message;
  EXPECT_EQ(data->parts.size(), person.mesh_count());
  ASSERT_EQ(data->entry_at_level.size(), static_cast<std::size_t>(person.level_count()));
  for (int level = 0; level < person.level_count(); ++level) {
    EXPECT_EQ(data->entry_at_level[static_cast<std::size_t>(level)], person.entries_at_level(level));
  }
  EXPECT_GT(data->poses.size(), person.clip_count());
  EXPECT_LE(data->poses.size(), 48U);
  EXPECT_TRUE(std::ranges::count(data->face_entries, 1) > 0);
}

TEST(MeshDataOfACharacter, IsRefusedWithoutASurface) {
  const auto data = mesh_data(mannequin(false));
  ASSERT_FALSE(data);
  EXPECT_EQ(data.error().message, "the character has no surface: load it with LoadOptions::keep_meshes");
}

TEST(EntriesAtLevel, NameEntriesOfTheLevelAlone) {
  const Character person = mannequin(false);
  for (int level = 0; level < person.level_count(); ++level) {
    for (const std::uint16_t entry : person.entries_at_level(level)) EXPECT_LT(entry, person.palette_entries(level));
  }
  EXPECT_TRUE(person.entries_at_level(-1).empty());
  EXPECT_TRUE(person.entries_at_level(person.level_count()).empty());
}

TEST(LookFrom, SetsWhatLevelOfDetailAndTheMeterRead) {
  const glm::vec3 place(1.0F, 2.0F, 3.0F);
  const render::CameraView eye{.position = place,
                               .view = glm::lookAt(place, place + glm::vec3(1.0F, 0.0F, 0.0F), {0.0F, 1.0F, 0.0F}),
                               .projection = glm::perspective(1.0F, 2.0F, 0.1F, 100.0F)};
  ViewFrame frame;
  look_from(frame, eye, {800, 400});
  EXPECT_EQ(frame.camera.position, (Vec3{1.0F, 2.0F, 3.0F}));
  EXPECT_NEAR(frame.camera.forward.x, 1.0F, 1e-6F);
  EXPECT_NEAR(frame.camera.pixels_per_unit, 200.0F * eye.projection[1][1], 1e-3F);
  EXPECT_EQ(frame.width, 800.0F);
  EXPECT_EQ(frame.projection, to_mat4(&eye.projection[0][0]));
}

TEST(CrowdFrameOfDraws, ShowsAllThatTheDrawsHave) {
  const render::InstanceRecord record{};
  const render::CrowdBatch batch{.count = 1};
  const std::uint32_t drawn = 0;
  const float weight = 0.5F;
  const CrowdDraws draws{.instances = {&record, 1},
                         .batches = {&batch, 1},
                         .drawn = {&drawn, 1},
                         .runs = {&batch, 1},
                         .morph_weights = {&weight, 1},
                         .now = 7};
  const render::CrowdFrame frame = crowd_frame({}, draws);
  EXPECT_EQ(frame.instances.data(), &record);
  EXPECT_EQ(frame.batches.data(), &batch);
  EXPECT_EQ(frame.drawn.data(), &drawn);
  EXPECT_EQ(frame.runs.data(), &batch);
  EXPECT_EQ(frame.morph_weights.data(), &weight);
  EXPECT_EQ(frame.now, 7U);
}

}  // namespace
}  // namespace throng::drawing_test
