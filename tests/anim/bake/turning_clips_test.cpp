// Clips that turn or climb: what leaves the pose is in the root motion, and nothing else leaves it.

#include <cmath>
#include <functional>
#include <numbers>

#include <glm/gtc/quaternion.hpp>
#include <gtest/gtest.h>

#include "engine/anim/asset/synthetic_model.h"
#include "engine/anim/bake/character.h"
#include "tests/anim/asset/clip_fixtures.h"
#include "tests/anim/bake/definition_error.h"

namespace throng::anim::turning_clips_test {
namespace {

constexpr double pi = std::numbers::pi;
constexpr float seconds = 1.5F;

/// Where the hips are at a time, and which way they face.
struct Hips {
  glm::vec3 place{0.0F, 1.0F, 0.0F};
  double yaw = 0.0;
  double lean = 0.0;
};
using Path = std::function<Hips(float)>;

glm::quat about(const glm::vec3& axis, double angle) { return glm::angleAxis(static_cast<float>(angle), axis); }

/// Hips with a body of two bones above and two feet, all of which follow the path unless `feet_stay`.
Model body_on(const Path& path, bool feet_stay = false, float rate = 30.0F) {
  Model model = synthetic_model(1, 1);
  Skeleton& skeleton = model.skeleton;
  skeleton.bones.front().rest = {.translation = {0.0F, 1.0F, 0.0F}};
  skeleton.references.front() = {.origin = {0.0, 1.0, 0.0}};
  const glm::vec3 offsets[] = {{0.0F, 0.4F, 0.0F}, {0.3F, 0.5F, 0.1F}, {0.15F, -0.9F, 0.05F}, {-0.15F, -0.9F, 0.05F}};
  for (const glm::vec3& offset : offsets) {
    const int bone = skeleton.bone_count();
    skeleton.bones.push_back({.name = "part", .parent = 0, .rest = {.translation = offset}});
    skeleton.references.push_back({.origin = glm::dvec3(0.0, 1.0, 0.0) + glm::dvec3(offset)});
    skeleton.palette.push_back({.bone = bone});
  }
  skeleton.level_bone_counts = {5};
  Clip clip;
  clip.duration = static_cast<double>(seconds);
  BoneTracks hips;
  const auto steps = static_cast<int>(std::lround(seconds * rate));
  hips.translation = sampled_track([&](float time) { return path(time).place; }, static_cast<double>(rate), steps);
  hips.rotation.times = hips.translation.times;
  for (const float time : hips.rotation.times) {
    const Hips at = path(time);
    hips.rotation.values.push_back(about({0, 1, 0}, at.yaw) * about({1, 0, 0}, at.lean));
  }
  clip.tracks.push_back(hips);
  for (int foot = 3; feet_stay && foot < 5; ++foot) {
    BoneTracks tracks;
    tracks.bone = foot;
    tracks.translation.times = hips.translation.times;
    for (const float time : tracks.translation.times) {
      const Hips at = path(time);
      const glm::quat turn = about({0, 1, 0}, at.yaw) * about({1, 0, 0}, at.lean);
      const glm::vec3 planted = glm::vec3(0.0F, 1.0F, 0.0F) + offsets[foot - 1];
      tracks.translation.values.push_back(glm::conjugate(turn) * (planted - at.place));
    }
    clip.tracks.push_back(tracks);
  }
  model.clips.assign(1, clip);
  return model;
}

double part(float time) { return static_cast<double>(time) / static_cast<double>(seconds); }
double eased(float time) { return part(time) * part(time) * (3.0 - 2.0 * part(time)); }

/// Turns on the spot, unevenly, and leans on the way.
Hips turn_left(float time) { return {.yaw = 0.5 * pi * eased(time), .lean = 0.1 * std::sin(pi * part(time))}; }

/// Walks a quarter of a circle of two metres, with a sway that comes back.
Hips walk_a_bend(float time) {
  const double angle = 0.5 * pi * part(time), sway = 0.02 * std::sin(2.0 * pi * part(time));
  return {.place = glm::vec3(2.0 - (2.0 - sway) * std::cos(angle), 1.0, (2.0 - sway) * std::sin(angle)),
          .yaw = angle,
          .lean = sway};
}

Hips climb_stairs(float time) {
  return {.place = glm::vec3(0.0, 1.0 + 0.5 * part(time) + 0.02 * std::sin(2.0 * pi * part(time)), 0.6 * part(time))};
}

struct Baked {
  explicit Baked(Model of) : model(std::move(of)), character(bake_character(model)) {}
  const BakedClip& clip() const { return character.clips.front(); }
  RootMotion loop() const { return whole_motion(clip().root_motion); }
  double error() const { return error_by_definition(model, model.clips.front(), clip(), 200); }
  Model model;
  Character character;
};

TEST(TurningClip, ThatTurnsOnTheSpotHasTheTurnInItsRootMotion) {
  const Baked baked(body_on(turn_left));
  EXPECT_NEAR(baked.loop().yaw, 0.5 * pi, 1e-6);
  EXPECT_LT(glm::length(baked.loop().translation), 1e-6);
  EXPECT_TRUE(baked.clip().loops) << "turned back, it ends as it began";
  EXPECT_LT(baked.error(), baked.clip().error_bound) << "pose and root motion together are the clip";
  EXPECT_NEAR(root_velocity(baked.clip().root_motion, 0).yaw, 0.5 * pi / 1.5, 1e-6) << "at an even rate";
}

TEST(TurningClip, ThatWalksAQuarterOfACircleWalksAWholeOneInFourLoops) {
  const Baked baked(body_on(walk_a_bend));
  EXPECT_NEAR(baked.loop().yaw, 0.5 * pi, 1e-6);
  EXPECT_LT(glm::distance(baked.loop().translation, glm::dvec3(2.0, 0.0, 2.0)), 1e-5);
  EXPECT_LT(baked.error(), baked.clip().error_bound);
  const FineTicks loop = baked.clip().duration * fine_ticks_per_tick;
  const RootMotion round = displacement(baked.clip().root_motion, loop / 3, loop / 3 + 4 * loop, true);
  EXPECT_LT(glm::length(round.translation), 1e-5);
  EXPECT_NEAR(round.yaw, 2.0 * pi, 1e-5);
  EXPECT_NEAR(baked.character.clips.front().ground_speed(), pi / 1.5, 1e-4) << "along the arc";
}

TEST(TurningClip, OfFewKeysIsStillTheClip) {
  const Baked baked(body_on(turn_left, false, 10.0F));
  EXPECT_NEAR(baked.loop().yaw, 0.5 * pi, 1e-6);
  EXPECT_LT(baked.error(), baked.clip().error_bound);
}

TEST(TurningClip, KeepsItsTurnWhereNoRootMotionIsToBeTaken) {
  const Model model = body_on(turn_left);
  const Character character = bake_character(model, {.take_root_motion = false});
  EXPECT_TRUE(character.clips.front().root_motion.keys.empty());
}

TEST(ClimbingClip, HasTheClimbInItsRootMotion) {
  const Baked baked(body_on(climb_stairs));
  EXPECT_LT(glm::distance(baked.loop().translation, glm::dvec3(0.0, 0.5, 0.6)), 1e-5);
  EXPECT_EQ(baked.loop().yaw, 0.0);
  EXPECT_TRUE(baked.clip().loops);
  EXPECT_LT(baked.error(), baked.clip().error_bound);
  EXPECT_NEAR(baked.character.clips.front().ground_speed(), 0.4, 1e-5) << "over the ground";
}

TEST(PoseThatChanges, IsNoTurn) {
  const auto twist = [](float time) { return Hips{.yaw = 0.6 * eased(time)}; };
  EXPECT_EQ(Baked(body_on(twist, true)).loop().yaw, 0.0) << "the feet stay";
  const auto sway = [](float time) { return Hips{.yaw = 0.3 * std::sin(2.0 * pi * part(time))}; };
  EXPECT_EQ(Baked(body_on(sway)).loop().yaw, 0.0) << "it comes back";
  const auto spin = [](float time) { return Hips{.yaw = 2.0 * pi * part(time)}; };
  EXPECT_EQ(Baked(body_on(spin)).loop().yaw, 0.0) << "a whole turn stays in the pose";
}

TEST(PoseThatChanges, IsNoClimb) {
  const auto crouch = [](float time) { return Hips{.place = glm::vec3(0.0, 1.0 - 0.4 * eased(time), 0.0)}; };
  EXPECT_EQ(Baked(body_on(crouch, true)).loop().translation.y, 0.0) << "the feet stay";
  const auto bob = [](float time) { return Hips{.place = glm::vec3(0.0, 1.0 + 0.2 * std::sin(pi * part(time)), 0.0)}; };
  EXPECT_EQ(Baked(body_on(bob)).loop().translation.y, 0.0) << "it comes down again";
}

}  // namespace
}  // namespace throng::anim::turning_clips_test
