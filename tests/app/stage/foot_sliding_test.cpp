// Planted feet stand still on the ground, measured on the poses that are drawn: a minute of a scene.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/stage/stage.h"
#include "app/view/fly_camera.h"
#include "app/view/scenes.h"
#include "engine/anim/rig/limbs.h"

namespace throng::app::foot_sliding_test {
namespace {

constexpr anim::Ticks frame = anim::ticks_per_second / 60;

/// Palette memory that can be looked at.
class KeptPages final : public render::PalettePageSource {
 public:
  render::PalettePage add_page() override {
    pages_.push_back(source_.add_page());
    return pages_.back();
  }
  const anim::PaletteMatrix* palette(const render::PaletteSlot& slot) const {
    const std::byte* const memory = pages_[slot.page].memory + slot.first_line * render::palette_line_bytes;
    return reinterpret_cast<const anim::PaletteMatrix*>(memory);
  }

 private:
  render::HeapPageSource source_{std::size_t{16} << 20};
  std::vector<render::PalettePage> pages_;
};

glm::dvec3 transformed(const anim::PaletteMatrix& matrix, const glm::dvec3& point) {
  glm::dvec3 moved(0.0);
  for (int row = 0; row < 3; ++row) {
    const float* m = matrix.rows[row];
    moved[row] = static_cast<double>(m[0]) * point.x + static_cast<double>(m[1]) * point.y +
                 static_cast<double>(m[2]) * point.z + static_cast<double>(m[3]);
  }
  return moved;
}

/// The ball of a foot: it stays down longest, while the heel comes and goes.
struct Ball {
  anim::JointPlace place;
  double planted_below;  ///< metres in the model: how high it is when it stands
};

class Feet {
 public:
  explicit Feet(const anim::Skeleton& skeleton) {
    const anim::Limbs limbs = anim::find_limbs(skeleton);
    for (const auto& leg : {limbs.left_leg, limbs.right_leg}) {
      const anim::JointPlace place = anim::joint_place(skeleton, leg.value().tip);
      constexpr double roll = 0.02;  // of a shoe's tip
      balls_.push_back({place, place.position.y + roll});
    }
  }

  /// Adds how fast each planted ball moves over the ground.
  void measure(const Stage& stage, const KeptPages& pages) {
    const Crowd& crowd = stage.crowd();
    last_.resize(crowd.size() * balls_.size());
    for (std::uint32_t agent = 0; agent < crowd.size(); ++agent) {
      const ShownPose& shown = stage.shown().pose(agent);
      for (std::size_t foot = 0; foot < balls_.size(); ++foot) {
        Standing& last = last_[agent * balls_.size() + foot];
        const Standing now = shown.shown() ? standing(crowd, agent, balls_[foot], pages.palette(shown.to)) : Standing{};
        if (now.planted && last.planted) {
          slid_ += std::hypot(now.x - last.x, now.z - last.z);
          seconds_ += anim::to_seconds(frame);
        }
        last = now;
      }
    }
  }

  double metres_a_second() const { return slid_ / seconds_; }
  double seconds() const { return seconds_; }

 private:
  struct Standing {
    bool planted = false;
    double x = 0.0, z = 0.0;
  };

  static Standing standing(const Crowd& crowd, std::uint32_t agent, const Ball& ball,
                           const anim::PaletteMatrix* palette) {
    const glm::dvec3 in_model = transformed(palette[ball.place.entry], ball.place.position);
    const glm::dvec3 position(crowd.positions()[agent]);
    const auto scale = static_cast<double>(crowd.scales()[agent]);
    const auto cosine = static_cast<double>(crowd.headings()[agent].cosine);
    const auto sine = static_cast<double>(crowd.headings()[agent].sine);
    EXPECT_TRUE(std::isfinite(in_model.x + in_model.y + in_model.z));
    return {.planted = in_model.y < ball.planted_below,
            .x = position.x + scale * (cosine * in_model.x + sine * in_model.z),
            .z = position.z + scale * (cosine * in_model.z - sine * in_model.x)};
  }

  std::vector<Ball> balls_;
  std::vector<Standing> last_;  // [agent][foot]
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
                      .lod = {.rule = anim::LodRule::off, .bone_lod = false, .smooth = false},
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
