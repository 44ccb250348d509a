#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "tests/assets/character_file.h"
#include "tests/assets/clip_list.h"

namespace throng::test::mannequin_motion_test {
namespace {

constexpr double key_rate = 30;
constexpr double shoes = 4;

class MannequinMotion : public ::testing::TestWithParam<const char*> {
 protected:
  CharacterFile file_ = CharacterFile::committed();
  Playback clip_{file_, GetParam()};
  std::vector<double> region_ = file_.attribute("_REGION");
};

TEST_P(MannequinMotion, HasKeysOnAGridOfThirtyHertz) {
  for (std::size_t key = 0; key < clip_.key_count(); ++key) {
    EXPECT_NEAR(clip_.key_time(key), static_cast<double>(key) / key_rate, 1e-6);
  }
}

TEST_P(MannequinMotion, KeepsEveryVertexOfAPlantedSoleWithinFiveMillimetres) {
  constexpr double touching = 0.004;
  const auto steps = static_cast<int>(std::lround(clip_.duration() * 120));
  std::vector<glm::dvec3> landed(region_.size());
  std::vector<bool> planted(region_.size(), false);
  double worst = 0;
  for (int step = 0; step <= steps; ++step) {
    const std::vector<glm::dvec3> skin = clip_.skin(clip_.duration() * step / steps);
    for (std::size_t v = 0; v < skin.size(); ++v) {
      if (region_[v] != shoes) continue;
      const bool touches = skin[v].y < touching;
      if (touches && !planted[v]) landed[v] = skin[v];
      if (touches) worst = std::max(worst, std::hypot(skin[v].x - landed[v].x, skin[v].z - landed[v].z));
      planted[v] = touches;
    }
  }
  EXPECT_LT(worst, 0.005);
}

TEST_P(MannequinMotion, StaysAboveTheGround) {
  double lowest = 0;
  for (double time = 0; time < clip_.duration(); time += 1.0 / 60) {
    for (const glm::dvec3& vertex : clip_.skin(time)) lowest = std::min(lowest, vertex.y);
  }
  EXPECT_GT(lowest, -0.006);
}

INSTANTIATE_TEST_SUITE_P(Clips, MannequinMotion, ::testing::ValuesIn(clip_list), spaceless_clip_name);

TEST(MannequinClips, AreListedInAFixedOrderThatOthersRelyOn) {
  EXPECT_EQ(clip_names(CharacterFile::committed()), std::vector<std::string>(clip_list.begin(), clip_list.end()));
}

TEST(MannequinClips, MarkEveryFootThatComesDownOnItsWay) {
  const CharacterFile file = CharacterFile::committed();
  for (const auto& animation : file.json()["animations"]) {
    const std::string name = animation["name"];
    const bool goes = name == "walk" || name == "jog" || name == "run" || name == "stumble" || name.starts_with("turn");
    ASSERT_EQ(animation.contains("extras"), goes) << name;
    if (!goes) continue;
    const Playback clip(file, name);
    for (const auto& key : animation["extras"]["throng_data_keys"]) {
      const std::string foot = key["name"] == "footstep_left" ? "foot.L" : "foot.R";
      const std::size_t joint = clip.joint(foot);
      const double time = key["time"];
      const glm::dvec3 landed = clip.pose(time)[joint].position;
      EXPECT_LT(landed.y, 0.12) << name << ": " << foot << " is on the ground at " << time;
      const glm::dvec3 after = clip.pose(std::min(time + 0.04, clip.duration()))[joint].position;
      const glm::dvec3 before = clip.pose(std::max(time - 0.08, 0.0))[joint].position;
      EXPECT_LT(2 * glm::distance(landed, after), glm::distance(landed, before)) << name << ": and was not before";
    }
  }
}

TEST(MannequinWalk, TravelsEvenlyAlongPositiveZAtWalkingSpeed) {
  const Playback walk(CharacterFile::committed(), "walk");
  EXPECT_NEAR(walk.pose(walk.duration())[0].position.z / walk.duration(), 1.35, 1e-4);
  for (std::size_t key = 0; key < walk.key_count(); ++key) {
    const glm::dvec3 root = walk.pose(walk.key_time(key))[0].position;
    EXPECT_NEAR(root.z, 1.35 * walk.key_time(key), 1e-5);
    EXPECT_EQ(root.x, 0);
    EXPECT_EQ(root.y, 0);
  }
}

TEST(MannequinWalk, TurnsShouldersAgainstHipsAndKeepsTheHeadCalm) {
  const Playback walk(CharacterFile::committed(), "walk");
  const auto heading = [&](double time, const char* joint) {
    const glm::dvec3 forward = walk.pose(time)[walk.joint(joint)].rotation * glm::dvec3(0, 0, 1);
    return glm::degrees(std::atan2(forward.x, forward.z));
  };
  double opposed = 0;
  double head_swing = 0;
  double chest_swing = 0;
  for (double time = 0; time < walk.duration(); time += 1.0 / 60) {
    opposed += heading(time, "hips") * heading(time, "upper_chest");
    chest_swing = std::max(chest_swing, std::abs(heading(time, "upper_chest")));
    head_swing = std::max(head_swing, std::abs(heading(time, "head")));
  }
  EXPECT_LT(opposed, 0);
  EXPECT_GT(chest_swing, 3);
  EXPECT_LT(head_swing, 2);
}

}  // namespace
}  // namespace throng::test::mannequin_motion_test
