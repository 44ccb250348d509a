// A cut scene: a person, a balloon and a camera, agents of one system, placed by their absolute roots.

#include "app/show/stage/cut_scene.h"

#include <algorithm>
#include <memory>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "throng/heap_pages.h"

#include "app/character/cut_scene_models.h"
#include "app/show/stage/stage.h"

namespace throng::app::cut_scene_test {
namespace {

constexpr Ticks frame = ticks_per_second / 60;
constexpr std::uint32_t actor = 0, the_balloon = 1;
constexpr const char* mannequin = THRONG_SOURCE_DIR "/assets/mannequin.glb";
constexpr const char* pillar = THRONG_SOURCE_DIR "/tests/data/features/plain.glb";

class CutSceneOnStage : public testing::Test {
 protected:
  CutSceneOnStage() { open({.scene = Scene::film, .agents = 40, .system = {.pus = 2}}); }

  void open(const Tuning& tuning, const char* file = mannequin) {
    std::vector<CharacterSource> characters;
    characters.push_back(*load_character(file, file));
    auto made = Stage::create(std::move(characters), tuning, pages_);
    ASSERT_TRUE(made);
    stage_ = std::move(*made);
    seconds_ = 0.0;
  }
  void pass(int frames) {
    for (int i = 0; i < frames; ++i) {
      stage_->move(frame);
      stage_->pose(camera(), 1280, 720, frame, stage_->posed().frame());
    }
    seconds_ += frames / 60.0;
  }
  void pass_until(double seconds) { pass(static_cast<int>((seconds - seconds_) * 60.0 + 0.5)); }
  glm::vec3 place(std::uint32_t agent) const { return stage_->crowd().positions()[agent]; }
  render::Camera camera() const { return stage_->animated().cut_scene()->film(); }
  /// Cosine of the angle between where the camera looks and where something is.
  float faces(const glm::vec3& target) const {
    return glm::dot(render::forward(camera()), glm::normalize(target - camera().position));
  }

  HeapPageSource pages_{std::size_t{1} << 20U};
  std::unique_ptr<Stage> stage_;
  double seconds_ = 0.0;
};

TEST_F(CutSceneOnStage, ItsCameraIsOneMoreAgentOfTheCrowdsSystem) {
  EXPECT_EQ(stage_->crowd().size(), 40U);
  EXPECT_EQ(stage_->system().agent_count(), 41U);
  EXPECT_EQ(stage_->system().agent(40).character().skeleton.bone_count(), 1);
  EXPECT_TRUE(stage_->character_of(the_balloon).roles.is_prop);
}

TEST_F(CutSceneOnStage, TheActorComesByTheRootMotionOfItsWalkAndStopsAtTheOrigin) {
  const double speed = common_roles(roles_of(stage_->characters())).walk_speed;
  EXPECT_NEAR(place(actor).z, -walk_on_seconds * speed, 1e-4);
  pass_until(0.5 * walk_on_seconds);
  EXPECT_NEAR(place(actor).z, -0.5 * walk_on_seconds * speed, 0.05);
  pass_until(walk_on_seconds + 3.0);
  EXPECT_NEAR(place(actor).z, 0.0, 0.3) << "the last step of the walk fades out";
  EXPECT_FLOAT_EQ(place(actor).x, 0.0F);
  const glm::vec3 stopped = place(actor);
  pass(60);
  EXPECT_LT(glm::distance(place(actor), stopped), 1e-4F);
}

TEST_F(CutSceneOnStage, TheBalloonGoesAlongUntilItIsLetGoAndThenUpFromThere) {
  for (const double seconds : {1.0, 3.0, 4.5}) {
    pass_until(seconds);
    EXPECT_EQ(place(the_balloon), place(actor)) << seconds;
  }
  pass_until(release_seconds + 0.1);
  const glm::vec3 left_from = place(the_balloon);
  pass(120);
  EXPECT_EQ(place(the_balloon), left_from) << "its root stays, its pose rises";
  EXPECT_GT(balloon_place(3.0, 1.0).y, balloon_place(0.0, 1.0).y + 2.0);
}

TEST_F(CutSceneOnStage, TheCameraSeesTheActorComeAndThenFollowsTheBalloon) {
  for (const double seconds : {0.1, 2.0, 4.0}) {
    pass_until(seconds);
    EXPECT_GT(faces(place(actor) + glm::vec3(0.0F, 1.3F, 0.0F)), 0.97F) << seconds;
  }
  for (const double seconds : {5.5, 7.0, 8.5}) {
    pass_until(seconds);
    const glm::dvec3 up = balloon_place(seconds - release_seconds, 1.0) + glm::dvec3(0.0, 1.17, 0.0);
    EXPECT_GT(faces(place(the_balloon) + glm::vec3(up)), 0.93F) << seconds;
  }
}

TEST_F(CutSceneOnStage, EverybodyCheersWhenTheBalloonIsLetGo) {
  pass_until(release_seconds + 1.2);
  const auto roles = stage_->crowd().minds().roles().subspan(2);
  EXPECT_EQ(std::ranges::count(roles, Role::cheer), static_cast<std::ptrdiff_t>(roles.size()));
}

TEST_F(CutSceneOnStage, BeginsAnewWhereItBegan) {
  pass(1);
  const render::Camera first = camera();
  const glm::vec3 from = place(actor);
  pass_until(cut_scene_seconds - 0.1);
  EXPECT_GT(glm::distance(camera().position, first.position), 2.0F);
  pass_until(cut_scene_seconds + 1.0 / 60.0);
  EXPECT_LT(glm::distance(camera().position, first.position), 1e-3F);
  EXPECT_LT(glm::distance(place(actor), from), 1e-3F);
}

TEST_F(CutSceneOnStage, HasOnePoseHashHoweverItIsScheduled) {
  const auto hash = [&](const Tuning& tuning) {
    open(tuning);
    pass_until(5.5);
    return stage_->system().figures().pose_hash();
  };
  const Tuning base{.scene = Scene::film, .agents = 12, .system = {.pus = 1}};
  Tuning levels = base, two = base;
  levels.system.schedule = anim::Schedule::levels;
  two.system.pus = 2;
  two.system.tile = 4;
  const std::uint64_t expected = hash(base);
  EXPECT_EQ(hash(levels), expected);
  EXPECT_EQ(hash(two), expected);
}

TEST_F(CutSceneOnStage, ASelectedActorIsNotPushedOutOfIt) {
  EXPECT_FALSE(stage_->animated().can_fall(actor));
  EXPECT_FALSE(stage_->animated().push_over(actor, {0.0F, 0.0F, 1.0F}));
  EXPECT_TRUE(stage_->animated().can_fall(2));
}

TEST_F(CutSceneOnStage, PlaysWithoutABalloonAndWithAnActorThatCannotWalk) {
  open({.scene = Scene::film, .agents = 1});
  pass_until(release_seconds + 1.0);
  EXPECT_GT(faces(place(actor) + glm::vec3(0.0F, 2.0F, 0.0F)), 0.9F);
  open({.scene = Scene::film, .agents = 6}, pillar);
  pass_until(release_seconds + 1.0);
  EXPECT_EQ(place(actor), glm::vec3(0.0F));
}

TEST_F(CutSceneOnStage, AnotherSceneHasNone) {
  Tuning plaza = stage_->tuning();
  plaza.scene = Scene::plaza;
  ASSERT_TRUE(stage_->apply(plaza));
  EXPECT_EQ(stage_->animated().cut_scene(), nullptr);
  EXPECT_EQ(stage_->system().agent_count(), 40U);
  plaza.scene = Scene::film;
  ASSERT_TRUE(stage_->apply(plaza));
  EXPECT_NE(stage_->animated().cut_scene(), nullptr);
}

}  // namespace
}  // namespace throng::app::cut_scene_test
