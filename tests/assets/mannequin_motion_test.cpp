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
    const bool goes = is_gait(name) || name == "stumble" || name.starts_with("turn");
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

struct Travel {
  const char* clip;
  glm::dvec3 velocity;  // metres a second
};

TEST(MannequinGaits, TravelEvenlyWhereTheyGoAtTheirSpeed) {
  const std::vector<Travel> gaits{
      {"walk", {0, 0, 1.35}},         {"jog", {0, 0, 2.4}},         {"run", {0, 0, 3.6}},
      {"walk back", {0, 0, -0.8}},    {"step left", {0.45, 0, 0}},  {"step right", {-0.45, 0, 0}},
      {"shuffle", {0, 0, 0.45}},      {"step in place", {0, 0, 0}}, {"veer left", {0.4, 0, 1.2}},
      {"veer right", {-0.4, 0, 1.2}}, {"push", {0, 0, 1.35}},       {"stick", {0, 0, 1.35}}};
  for (const Travel& gait : gaits) {
    const Playback clip(CharacterFile::committed(), gait.clip);
    for (std::size_t key = 0; key < clip.key_count(); ++key) {
      const glm::dvec3 root = clip.pose(clip.key_time(key))[0].position;
      EXPECT_LT(glm::distance(root, gait.velocity * clip.key_time(key)), 1e-5) << gait.clip << " at key " << key;
    }
  }
}

TEST(MannequinGaits, MarkTheRightFootFirstAtAQuarterAndTheLeftOneAtThreeQuarters) {
  const CharacterFile file = CharacterFile::committed();
  for (const auto& animation : file.json()["animations"]) {
    const std::string name = animation["name"];
    if (!is_gait(name)) continue;
    const double length = Playback(file, name).duration();
    const auto& keys = animation["extras"]["throng_data_keys"];
    ASSERT_EQ(keys.size(), 2U) << name;
    EXPECT_EQ(keys[0]["name"], "footstep_right") << name;
    EXPECT_EQ(keys[1]["name"], "footstep_left") << name;
    EXPECT_NEAR(keys[0]["time"].get<double>(), 0.25 * length, 1e-3) << name;
    EXPECT_NEAR(keys[1]["time"].get<double>(), 0.75 * length, 1e-3) << name;
  }
}

TEST(MannequinSideSteps, NeverCrossTheFeetAndAreEachOthersImage) {
  const CharacterFile file = CharacterFile::committed();
  const Playback left(file, "step left");
  const Playback right(file, "step right");
  ASSERT_EQ(left.duration(), right.duration());
  const auto place = [](const Playback& clip, const char* joint, double time) {
    const std::vector<PosedJoint> pose = clip.pose(time);
    return pose[clip.joint(joint)].position - pose[0].position;
  };
  for (std::size_t key = 0; key + 1 < left.key_count(); ++key) {
    const double time = left.key_time(key);
    const double half_a_cycle_on = std::fmod(time + 0.5 * left.duration(), left.duration());
    const glm::dvec3 foot = place(left, "foot.L", time);
    EXPECT_GT(foot.x - place(left, "foot.R", time).x, 0.15) << time;
    const glm::dvec3 image = place(right, "foot.R", half_a_cycle_on);
    EXPECT_LT(glm::distance(foot, {-image.x, image.y, image.z}), 1e-3) << time;
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
