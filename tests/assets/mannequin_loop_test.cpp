#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "assets/mannequin/clip.h"
#include "engine/anim/bake/character.h"
#include "engine/anim/import/import.h"
#include "tests/assets/clip_list.h"

namespace throng::test::mannequin_loop_test {
namespace {

using mannequin::joint_count;
using mannequin::Motion;

/// A motion as it is authored, between its keys too; joints as seen from the root, so that travel and turns drop out.
class MannequinLoop : public ::testing::TestWithParam<const char*> {
 protected:
  MannequinLoop() {
    for (Motion& motion : mannequin::make_motions()) {
      if (motion.name == GetParam()) motion_ = std::move(motion);
    }
  }

  using Places = std::array<glm::dvec3, joint_count>;
  [[nodiscard]] Places places(double phase) const {
    const mannequin::WorldPose world = mannequin::world_pose(motion_.pose(phase));
    Places seen;
    for (std::size_t j = 0; j < joint_count; ++j) {
      seen[j] = glm::inverse(world[0].rotation) * (world[j].position - world[0].position);
    }
    return seen;
  }

  /// Metres a second, between two phases.
  [[nodiscard]] Places velocities(double from, double to) const {
    const Places before = places(from);
    Places change = places(to);
    for (std::size_t j = 0; j < joint_count; ++j)
      change[j] = (change[j] - before[j]) / ((to - from) * motion_.seconds());
    return change;
  }

  Motion motion_;
};

TEST_P(MannequinLoop, ClosesItsSeamWithinAMillimetre) {
  const Places first = places(0);
  const Places last = places(1);
  for (std::size_t j = 0; j < joint_count; ++j) {
    EXPECT_LT(glm::distance(first[j], last[j]), 0.001) << mannequin::skeleton()[j].name;
  }
}

TEST_P(MannequinLoop, KeepsItsVelocityOverTheSeamWithinAHundredth) {
  constexpr double instant = 1e-5;
  constexpr double unseen = 1e-3;  // metres a second
  const Places before = velocities(1 - instant, 1);
  const Places after = velocities(0, instant);
  std::array<double, joint_count> fastest{};
  constexpr int samples = 60;
  for (int i = 0; i < samples; ++i) {
    const double phase = static_cast<double>(i) / samples;
    const Places now = velocities(phase, phase + instant);
    for (std::size_t j = 0; j < joint_count; ++j) fastest[j] = std::max(fastest[j], glm::length(now[j]));
  }
  for (std::size_t j = 0; j < joint_count; ++j) {
    EXPECT_LT(glm::distance(before[j], after[j]), 0.01 * fastest[j] + unseen)
        << mannequin::skeleton()[j].name << ", at most " << fastest[j] << " m/s";
  }
}

std::vector<const char*> loops() {
  std::vector<const char*> names;
  std::copy_if(clip_list.begin(), clip_list.end(), std::back_inserter(names),
               [](const char* clip) { return !plays_once(clip); });
  return names;
}

INSTANTIATE_TEST_SUITE_P(Loops, MannequinLoop, ::testing::ValuesIn(loops()), spaceless_clip_name);

TEST(MannequinLoops, AreWhatTheDemoMayRepeatAndTheOthersAreNot) {
  const auto file = import::import_file(std::string(THRONG_SOURCE_DIR) + "/assets/mannequin.glb");
  ASSERT_TRUE(file) << file.error().message;
  for (const anim::BakedClip& clip : anim::bake_character(file->models.front()).clips) {
    EXPECT_EQ(clip.loops, !plays_once(clip.name)) << clip.name;
  }
}

TEST(MannequinLoops, CarryTheRootAlongOrAround) {
  for (const Motion& motion : mannequin::make_motions()) {
    const mannequin::WorldPose end = mannequin::world_pose(motion.pose(1));
    const bool goes = (is_gait(motion.name) && motion.name != "step in place") || motion.name == "stumble";
    EXPECT_EQ(glm::length(end[0].position) > 0.4, goes) << motion.name;
    const glm::dvec3 ahead = end[0].rotation * glm::dvec3(0, 0, 1);
    const double turned = glm::degrees(std::atan2(ahead.x, ahead.z));
    EXPECT_NEAR(turned, motion.name == "turn left" ? 90 : (motion.name == "turn right" ? -90 : 0), 1e-9) << motion.name;
  }
}

TEST(MannequinLoops, JoinWhereOneIsMeantToFollowTheOther) {
  const auto pose_of = [](const std::string& clip, double phase) {
    for (const Motion& motion : mannequin::make_motions()) {
      if (motion.name == clip) return mannequin::world_pose(motion.pose(phase));
    }
    throw std::runtime_error("no such motion: " + clip);
  };
  struct Join {
    const char* before;
    double at;
    const char* after;
  };
  for (const auto& [before, at, after] :
       {Join{"idle", 1, "sit down"}, Join{"sit down", 1, "sit"}, Join{"sit", 1, "stand up"},
        Join{"stand up", 1, "idle"}, Join{"walk", 1, "stumble"}}) {
    const mannequin::WorldPose last = pose_of(before, at);
    const mannequin::WorldPose first = pose_of(after, 0);
    for (std::size_t j = 0; j < joint_count; ++j) {
      EXPECT_LT(glm::distance(last[j].position - last[0].position, first[j].position), 0.001)
          << before << " to " << after << ": " << mannequin::skeleton()[j].name;
    }
  }
}

}  // namespace
}  // namespace throng::test::mannequin_loop_test
