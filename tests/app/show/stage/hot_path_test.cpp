// The whole frame but drawing: crowd, level of detail, slots, animation.

#include <memory>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "throng/heap_pages.h"

#include "app/show/camera/camera_path.h"
#include "app/show/camera/fly_camera.h"
#include "app/show/stage/stage.h"
#include "tests/counting/hot_path_counter.h"

namespace throng::app::hot_path_test {
namespace {

constexpr Ticks frame = ticks_per_second / 60;
constexpr int warm_up_frames = 300;
constexpr int counted_frames = 200;

/// A crowd of 150 that a camera flies around, near enough for some to get placed feet, and to lose them.
class FilmedCrowd {
 public:
  explicit FilmedCrowd(Scene scene) : had_feet_(agents) {
    std::vector<CharacterSource> characters;
    characters.push_back(*load_character(THRONG_SOURCE_DIR "/assets/mannequin.glb", "mannequin"));
    stage_ = std::move(
        *Stage::create(std::move(characters), {.scene = scene, .agents = agents, .system = {.pus = 2}}, pages_));
  }

  void pass_frame() {
    stage_->move(frame);
    stage_->pose(along(CameraPath::orbit, start_, 5 * to_seconds(frame) * passed_++), 1280, 720, frame,
                 stage_->posed().frame());
    for (std::uint32_t agent = 0; agent < agents; ++agent) {
      const bool has_feet = stage_->system().agent(agent).post_process_count() > 0;
      feet_given_ += static_cast<int>(has_feet && !had_feet_[agent]);
      feet_taken_ += static_cast<int>(!has_feet && had_feet_[agent]);
      had_feet_[agent] = has_feet;
    }
  }

  int feet_given() const { return feet_given_; }
  int feet_taken() const { return feet_taken_; }

 private:
  static constexpr int agents = 150;

  HeapPageSource pages_{std::size_t{4} << 20U};
  std::unique_ptr<Stage> stage_;
  render::Camera start_ = camera_at({.x = 0, .y = 2, .z = 12, .yaw = 0, .pitch = -5});
  int passed_ = 0;
  std::vector<bool> had_feet_;  // [agent]
  int feet_given_ = 0, feet_taken_ = 0;
};

TEST(FrameOfTheDemo, NeitherAllocatesNorLocks) {
  for (const Scene scene : {Scene::plaza, Scene::parade, Scene::stadium, Scene::grid, Scene::film}) {
    FilmedCrowd crowd(scene);
    const auto pass = [&](int frames) {
      for (int i = 0; i < frames; ++i) crowd.pass_frame();
    };
    pass(warm_up_frames);
    const int given = crowd.feet_given(), taken = crowd.feet_taken();
    const HotPathCounts before = hot_path_counts();
    pass(counted_frames);
    const HotPathCounts counts = hot_path_counts() - before;
    EXPECT_EQ(counts.allocations, 0U) << "scene " << static_cast<int>(scene);
    EXPECT_EQ(counts.locks, 0U) << "scene " << static_cast<int>(scene);
    EXPECT_GT(crowd.feet_given(), given) << "scene " << static_cast<int>(scene);
    EXPECT_GT(crowd.feet_taken(), taken) << "scene " << static_cast<int>(scene);
  }
}

}  // namespace
}  // namespace throng::app::hot_path_test
