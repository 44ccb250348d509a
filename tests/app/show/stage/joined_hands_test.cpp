// Grown-ups and children who go hand in hand.
#include "app/show/stage/joined_hands.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "app/character/built_in.h"
#include "app/show/stage/rewind.h"
#include "app/show/stage/stage.h"
#include "tests/app/show/stage/watched_stage.h"

namespace throng::app::joined_hands_test {
namespace {

class JoinedHandsTest : public test::WatchedStage {
 protected:
  void SetUp() override { open_dressed(2); }

  void open_dressed(int pus) {
    std::vector<CharacterSource> characters;
    characters.push_back(*load_built_in("", {.wardrobe = true}));
    Tuning tuning;
    tuning.scene = Scene::plaza;
    tuning.agents = 240;
    tuning.lod.rule = LodRule::off;
    tuning.inspection.forced_bone_level = 0;
    tuning.system = {.pus = pus, .hash = true};
    tuning.wardrobe = true;
    open(tuning, std::move(characters));
    ASSERT_TRUE(stage_->posed().keep_joints(stage_->animated().system()));
    camera_ = camera_at({.x = 0, .y = 20, .z = 28, .yaw = 0, .pitch = -36});
  }
  // A tall window, so that all of the plaza is near.
  void pass_near(int frames) {
    for (int i = 0; i < frames; ++i) {
      stage_->move(frame);
      stage_->pose(camera_, 2560, 2160, frame, stage_->posed().frame());
      rewind_.watch(*stage_);
    }
  }

  std::vector<std::uint32_t> led_children() const {
    std::vector<std::uint32_t> led;
    const auto things = stage_->crowd().minds().things();
    for (std::uint32_t agent = 0; agent < things.size(); ++agent) {
      if (things[agent] == HeldThing::grown_up) led.push_back(agent);
    }
    return led;
  }
  bool is_seen(std::uint32_t agent) const {
    const auto& visible = stage_->posed().selection().visible;
    const auto found = std::ranges::lower_bound(visible, agent, {}, &anim::VisibleAgent::agent);
    return found != visible.end() && found->agent == agent && found->pixels_tall > JoinedHands::pixels_to_begin;
  }

  glm::vec3 joint(std::uint32_t agent, const std::string& name) const {
    const anim::Skeleton& skeleton = stage_->characters()[0].character->skeleton;
    const auto bones = static_cast<std::size_t>(skeleton.bone_count());
    const auto& rows =
        stage_->posed().joints().of(agent, bones)[static_cast<std::size_t>(anim::find_bone(skeleton, name))].rows;
    const glm::vec3 place(rows[0][3], rows[1][3], rows[2][3]);
    const Heading heading = stage_->crowd().headings()[agent];
    const glm::vec3 turned(heading.cosine * place.x + heading.sine * place.z, place.y,
                           heading.cosine * place.z - heading.sine * place.x);
    return stage_->crowd().positions()[agent] + stage_->crowd().scales()[agent] * turned;
  }
  glm::vec3 palm(std::uint32_t agent, const std::string& side) const {
    constexpr std::array fingers{"thumb.1", "index.1", "middle.1", "ring.1", "little.1"};
    glm::vec3 sum(0.0F);
    for (const char* finger : fingers) sum += joint(agent, finger + side);
    return sum / static_cast<float>(fingers.size());
  }
  /// Degrees by which an elbow bends.
  float bend(std::uint32_t agent, const std::string& side) const {
    const glm::vec3 elbow = joint(agent, "forearm" + side);
    const glm::vec3 upper = glm::normalize(elbow - joint(agent, "upper_arm" + side));
    const glm::vec3 lower = glm::normalize(joint(agent, "hand" + side) - elbow);
    return glm::degrees(std::acos(std::clamp(glm::dot(upper, lower), -1.0F, 1.0F)));
  }
};

TEST_F(JoinedHandsTest, MeetPalmToPalmWhileTheirOwnersWalkAndStand) {
  // The bones of two palms that touch are two half hands apart.
  constexpr float touching = 0.034F, within = 0.02F;
  constexpr float farthest_bend = 150.0F;  // of an elbow, in degrees
  int beside = 0, held = 0, meet = 0, standing = 0;
  ASSERT_GT(led_children().size(), 3U);
  for (int i = 0; i < 60; ++i) {
    pass_near(15);
    for (const std::uint32_t child : led_children()) {
      if (!is_seen(child) || !is_seen(child - 1)) continue;
      const auto& crowd = stage_->crowd();
      if (glm::distance(crowd.positions()[child], crowd.positions()[child - 1]) > 0.9F) continue;  // lost each other
      ++beside;
      const HeldArms& arms = stage_->animated().details().held_arms();
      if (!arms.holds(child) || !arms.holds(child - 1)) continue;
      ++held;
      standing += crowd.speeds()[child] < 0.1F ? 1 : 0;
      const float apart = glm::distance(palm(child - 1, ".L"), palm(child, ".R"));
      if (apart > touching + within) continue;
      ++meet;
      EXPECT_GT(bend(child - 1, ".L"), 8.0F) << "an arm is never quite straight";
      EXPECT_LT(bend(child - 1, ".L"), 115.0F);
      EXPECT_GT(bend(child, ".R"), 8.0F);
      EXPECT_LT(bend(child, ".R"), farthest_bend);
    }
  }
  ASSERT_GT(held, 100);
  EXPECT_GT(standing, 5);
  EXPECT_GT(held, beside * 3 / 4) << "hands are away where a turn has parted the two";
  EXPECT_GT(static_cast<double>(meet), 0.95 * held);
}

TEST_F(JoinedHandsTest, LetGoWhereTheyAreTooSmallToBeSeen) {
  pass_near(5);
  ASSERT_FALSE(led_children().empty());
  camera_ = camera_at({.x = 0, .y = 300, .z = 900, .yaw = 0, .pitch = -18});
  pass(60);
  for (const std::uint32_t child : led_children()) {
    EXPECT_GT(glm::distance(palm(child - 1, ".L"), palm(child, ".R")), 0.1F) << child;
  }
}

TEST_F(JoinedHandsTest, GiveTheSamePosesForAnyNumberOfPus) {
  pass_near(40);
  const std::uint64_t two = hash();
  open_dressed(1);
  pass_near(40);
  EXPECT_EQ(hash(), two);
}

TEST_F(JoinedHandsTest, GoBackInTimeWithTheCrowd) {
  pass_near(60);
  StageMoment moment;
  stage_->animated().remember(moment);
  pass_near(20);
  const std::uint64_t once = hash();
  ASSERT_TRUE(stage_->go_back_to(moment));
  pass_near(20);
  EXPECT_EQ(hash(), once);
}

}  // namespace
}  // namespace throng::app::joined_hands_test
