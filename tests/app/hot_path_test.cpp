// The whole frame but drawing: crowd, level of detail, slots, animation.

#include <memory>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "app/fly_camera.h"
#include "app/stage.h"
#include "tests/counting/hot_path_counter.h"

namespace throng::app {
namespace {

constexpr anim::Ticks frame = anim::ticks_per_second / 60;
constexpr int warm_up_frames = 300;
constexpr int counted_frames = 120;

// By distance nobody comes near enough for placed feet, whose first time makes a graph anew.
TEST(FrameOfTheDemo, NeitherAllocatesNorLocks) {
  for (const Scene scene : {Scene::plaza, Scene::parade, Scene::stadium, Scene::grid, Scene::film}) {
    render::HeapPageSource pages(std::size_t{4} << 20U);
    auto character = load_character(THRONG_SOURCE_DIR "/assets/mannequin.glb", "mannequin");
    ASSERT_TRUE(character.has_value());
    std::vector<CharacterSource> characters;
    characters.push_back(std::move(*character));
    auto stage = Stage::create(std::move(characters),
                               {.scene = scene, .agents = 150, .lod = LodRule::distance, .pus = 2}, pages);
    ASSERT_TRUE(stage.has_value());
    const render::Camera camera = camera_at({.x = 0, .y = 12, .z = 25, .yaw = 0, .pitch = -25});
    const auto pass = [&](int frames) {
      for (int i = 0; i < frames; ++i) {
        (*stage)->move(frame);
        (*stage)->pose(camera, 1280, 720, frame, (*stage)->frame());
      }
    };
    pass(warm_up_frames);
    const HotPathCounts before = hot_path_counts();
    pass(counted_frames);
    const HotPathCounts counts = hot_path_counts() - before;
    EXPECT_EQ(counts.allocations, 0U) << "scene " << static_cast<int>(scene);
    EXPECT_EQ(counts.locks, 0U) << "scene " << static_cast<int>(scene);
  }
}

}  // namespace
}  // namespace throng::app
