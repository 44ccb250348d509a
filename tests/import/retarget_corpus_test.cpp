#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "engine/anim/asset/reference_pose.h"
#include "engine/anim/import/import.h"
#include "engine/anim/retarget/body_pose.h"
#include "engine/anim/retarget/retarget.h"
#include "tests/import/test_files.h"

// Clips of real characters on others, where a folder of them was named when the project was configured (THRONG_CORPUS).

namespace throng::import::testing::retarget_corpus_test {
namespace {

using anim::BodyPose;
using anim::FollowedLeg;

struct RigPair {
  const char* clips;
  const char* character;
  friend std::ostream& operator<<(std::ostream& out, const RigPair& pair) {
    return out << pair.clips << " on " << pair.character;
  }
};

std::vector<RigPair> rig_pairs() {
  if (std::string(THRONG_CORPUS).empty()) return {};
  return {{"Med_MovementBasic.glb", "manny_med_mod.gltf"},
          {"Med_MovementBasic.glb", "Knight.glb"},
          {"Med_MovementBasic.glb", "CesiumMan.glb"},
          {"Soldier_packed.glb", "modular_women_Suit.glb"}};
}

anim::Model model_of(const std::string& name) {
  auto file = import_clips((std::filesystem::path(THRONG_CORPUS) / "models" / name).string());
  if (!file) ADD_FAILURE() << file.error().message;
  return file ? std::move(file->models.front()) : anim::Model{};
}

double lowest(const BodyPose& pose, int foot, const std::array<glm::dvec3, 2>& sole) {
  return pose.place(foot).y + std::min((pose.rotation(foot) * sole[0]).y, (pose.rotation(foot) * sole[1]).y);
}

/// Compares one pose with its source. Lengths are those of a person whose legs are 0.9 m long.
void expect_alike(const anim::Retargeter& retargeter, const BodyPose& source, const BodyPose& own,
                  const std::string& clip) {
  const anim::RetargetPlan& plan = retargeter.plan();
  const double person = 0.9 / plan.leg_length;
  for (const FollowedLeg& leg : plan.legs) {
    const double expected = plan.scale * (lowest(source, leg.source.end, leg.source_sole) - plan.source_origin.y);
    const double height = lowest(own, leg.own.end, leg.own_sole) - plan.own_origin.y;
    const bool in_stance = expected * person < 0.02;
    EXPECT_TRUE(!in_stance || std::abs(height - expected) * person < 0.01) << clip << ": " << height - expected;
    const glm::dvec3 thigh = glm::normalize(own.place(leg.own.middle) - own.place(leg.own.upper));
    const glm::dvec3 shin = glm::normalize(own.rotation(leg.own.middle) * leg.shin);
    EXPECT_GT(glm::dot(thigh, shin), -0.95) << clip << ": the knee is folded";
  }
  const auto joints = [](const BodyPose& pose, const std::array<int, 2>& bones) {
    return 0.5 * (pose.place(bones[0]).y + pose.place(bones[1]).y);
  };
  const double hips = plan.scale * (joints(source, plan.source_joints) - plan.source_origin.y);
  EXPECT_NEAR(joints(own, plan.own_joints) - plan.own_origin.y, hips, 0.02 * plan.leg_length) << clip;
}

class RetargetedCorpus : public ::testing::TestWithParam<RigPair> {};
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(RetargetedCorpus);

TEST_P(RetargetedCorpus, KeepsFeetOnTheGroundAndHipsAtTheirHeight) {
  const anim::Model from = model_of(GetParam().clips);
  const anim::Model to = model_of(GetParam().character);
  const anim::Retargeter retargeter(from.skeleton, to.skeleton);
  ASSERT_EQ(retargeter.plan().legs.size(), 2U);
  for (const anim::Clip& clip : from.clips) {
    const anim::RetargetedClip result = retargeter.retarget(clip);
    for (int i = 0; i <= 40; ++i) {
      const double seconds = clip.start + (clip.duration - clip.start) * i / 40.0;
      expect_alike(retargeter, anim::pose_of(anim::reference_pose(from.skeleton, &clip, seconds).globals),
                   anim::pose_of(anim::reference_pose(to.skeleton, &result.clip, seconds).globals), clip.name);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Pairs, RetargetedCorpus, ::testing::ValuesIn(rig_pairs()), [](const auto& instance) {
  return as_test_name(std::string(instance.param.clips) + "_on_" + instance.param.character);
});

}  // namespace
}  // namespace throng::import::testing::retarget_corpus_test
