// Agents keep their places and their phases when their character gets other clips for its roles.

#include <algorithm>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "throng/heap_pages.h"

#include "app/show/camera/fly_camera.h"
#include "app/show/stage/stage.h"

namespace throng::app::stage_roles_test {
namespace {

constexpr Ticks frame = ticks_per_second / 60;
constexpr const char* mannequin = THRONG_SOURCE_DIR "/assets/mannequin.glb";

struct OtherRolesOnAStage : testing::Test {
  std::unique_ptr<Stage> open(Scene scene, HeapPageSource& pages) const {
    std::vector<CharacterSource> characters;
    characters.push_back(*load_character(mannequin, mannequin));
    auto stage = Stage::create(std::move(characters),
                               {.scene = scene,
                                .agents = 60,
                                .lod = {.rule = LodRule::off, .bone_lod = false, .smooth = true},
                                .system = {.pus = 2}},
                               pages);
    EXPECT_TRUE(stage);
    return std::move(*stage);
  }
  void pass(Stage& stage, int frames) const {
    for (int i = 0; i < frames; ++i) {
      stage.move(frame);
      stage.pose(camera_, 1280, 720, frame, stage.posed().frame());
    }
  }
  static RoleClips running(const Stage& stage) {
    RoleClips clips = stage.people().front().roles.clips;
    clips[index_of(Role::walk)] = clips[index_of(Role::run)];
    return clips;
  }

  HeapPageSource pages_{std::size_t{1} << 20U}, other_pages_{std::size_t{1} << 20U};
  render::Camera camera_ = camera_at({.x = 0, .y = 12, .z = 25, .yaw = 0, .pitch = -25});
};

TEST_F(OtherRolesOnAStage, MoveNobodyAndChangeNoPoseOfThoseWhoDoNotPlayThem) {
  const auto changed = open(Scene::plaza, pages_), never = open(Scene::plaza, other_pages_);
  pass(*changed, 60);
  pass(*never, 60);
  const std::vector<glm::vec3> before(changed->crowd().positions().begin(), changed->crowd().positions().end());
  changed->select(5);
  changed->set_roles(0, running(*changed));
  EXPECT_TRUE(std::ranges::equal(changed->crowd().positions(), before));
  EXPECT_EQ(changed->selected(), 5U) << "the selected agent is the same";
  pass(*changed, 1);
  pass(*never, 1);
  int same = 0, other = 0;
  for (std::size_t agent = changed->crowd().walkers().count(); agent < before.size(); ++agent) {
    if (changed->crowd().minds().clips()[agent] != never->crowd().minds().clips()[agent]) continue;
    EXPECT_EQ(changed->animated().agent_hashes()[agent], never->animated().agent_hashes()[agent]) << agent;
    ++same;
  }
  for (std::size_t agent = 0; agent < changed->crowd().walkers().count(); ++agent) {
    other += changed->crowd().minds().clips()[agent] != never->crowd().minds().clips()[agent] ? 1 : 0;
  }
  EXPECT_GT(same, 5);
  EXPECT_GT(other, 5);
}

TEST_F(OtherRolesOnAStage, PlaceEverybodyAnewWhereNobodyWalksAnyMore) {
  const auto stage = open(Scene::plaza, pages_);
  pass(*stage, 10);
  RoleClips still = stage->people().front().roles.clips;
  for (const Role gait : {Role::walk, Role::jog, Role::run}) still[index_of(gait)] = no_clip;
  stage->set_roles(0, still);
  EXPECT_EQ(stage->crowd().walkers().count(), 0U);
  pass(*stage, 2);
}

TEST_F(OtherRolesOnAStage, LetAFallenAgentLieAndGetUp) {
  const auto stage = open(Scene::plaza, pages_);
  pass(*stage, 10);
  ASSERT_TRUE(stage->animated().push_over(0, {0, 0, 1}));
  pass(*stage, 30);
  stage->set_roles(0, running(*stage));
  EXPECT_EQ(stage->animated().fallen().fallen().size(), 1U);
  for (int i = 0; i < 900 && !stage->animated().fallen().fallen().empty(); ++i) pass(*stage, 1);
  EXPECT_TRUE(stage->animated().fallen().fallen().empty());
}

}  // namespace
}  // namespace throng::app::stage_roles_test
