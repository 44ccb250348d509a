// Planted feet stand still on the ground, measured on the poses that are drawn: a minute of a scene.

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/show/camera/fly_camera.h"
#include "app/show/camera/scenes.h"
#include "tests/app/show/stage/posed_feet.h"

namespace throng::app::foot_sliding_test {
namespace {

constexpr Ticks frame = ticks_per_second / 60;

constexpr double roll = 0.02;  // metres that the ball of a standing foot may be up: a shoe's tip

class Feet {
 public:
  explicit Feet(const anim::Skeleton& skeleton) : posed_(skeleton) {}

  /// Adds how fast each planted ball moves over the ground.
  void measure(const Stage& stage, const KeptPages& pages) {
    last_.resize(stage.crowd().size() * PosedFeet::feet);
    for (std::uint32_t agent = 0; agent < stage.crowd().size(); ++agent) {
      for (std::size_t foot = 0; foot < PosedFeet::feet; ++foot) {
        std::optional<PosedFeet::Ball>& last = last_[agent * PosedFeet::feet + foot];
        std::optional<PosedFeet::Ball> now = posed_.ball(stage, pages, agent, foot);
        EXPECT_TRUE(!now || std::isfinite(now->x + now->z + now->lift));
        if (now && now->lift >= roll) now.reset();
        if (now && last) {
          slid_ += std::hypot(now->x - last->x, now->z - last->z);
          seconds_ += to_seconds(frame);
        }
        last = now;
      }
    }
  }

  double metres_a_second() const { return slid_ / seconds_; }
  double seconds() const { return seconds_; }

 private:
  PosedFeet posed_;
  std::vector<std::optional<PosedFeet::Ball>> last_;  // [agent][foot] of those that stand
  double slid_ = 0.0;
  double seconds_ = 0.0;
};

class FootSliding : public testing::TestWithParam<Scene> {};

TEST_P(FootSliding, IsBelowTwoCentimetresASecondOnAverage) {
  auto character = load_character(THRONG_SOURCE_DIR "/assets/mannequin.glb", "mannequin");
  ASSERT_TRUE(character.has_value());
  Feet feet(character->character->skeleton);
  KeptPages pages;
  const Tuning tuning{.scene = GetParam(),
                      .agents = 500,
                      .lod = {.rule = LodRule::off, .bone_lod = false, .smooth = false},
                      .system = {.pus = 1}};
  std::vector<CharacterSource> characters;
  characters.push_back(std::move(*character));
  auto stage = Stage::create(std::move(characters), tuning, pages);
  ASSERT_TRUE(stage.has_value());
  const auto cameras = scene_cameras(tuning.scene, 500, common_roles(roles_of((*stage)->characters())));
  const render::Camera above = camera_at(find_camera(cameras, "above")->place);
  for (std::uint64_t i = 0; i < 3600; ++i) {
    (*stage)->move(frame);
    (*stage)->pose(above, 1280, 720, frame, i);
    feet.measure(**stage, pages);
  }
  EXPECT_GT(feet.seconds(), 10'000.0) << "the feet of most agents were on the ground, and in view";
  EXPECT_LT(feet.metres_a_second(), 0.02);
  RecordProperty("metres_a_second", std::to_string(feet.metres_a_second()));
}

std::string name_of(const testing::TestParamInfo<Scene>& tested) {
  constexpr const char* names[] = {"Plaza", "Parade", "Stadium", "Grid"};
  return names[static_cast<int>(tested.param)];
}

INSTANTIATE_TEST_SUITE_P(Scenes, FootSliding, testing::Values(Scene::plaza, Scene::parade, Scene::stadium, Scene::grid),
                         name_of);

}  // namespace
}  // namespace throng::app::foot_sliding_test
