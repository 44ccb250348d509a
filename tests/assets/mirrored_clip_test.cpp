// Clips of the built-in character, mirrored.

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "engine/anim/asset/reference_pose.h"
#include "engine/anim/import/import.h"
#include "engine/anim/rig/mirror.h"

namespace throng::test::mirrored_clip_test {
namespace {

using anim::BodyRole;
using anim::Clip;

class MirroredClip : public ::testing::Test {
 protected:
  MirroredClip()
      : file_(*import::import_file(THRONG_SOURCE_DIR "/assets/mannequin.glb")), rig_(anim::find_rig(skeleton())) {
    auto mirror = anim::find_mirror(skeleton(), rig_);
    EXPECT_TRUE(mirror.has_value()) << mirror.error().message;
    if (mirror) mirror_ = std::move(*mirror);
  }
  const anim::Model& model() const { return file_.models.front(); }
  const anim::Skeleton& skeleton() const { return model().skeleton; }
  const Clip& clip(const std::string& name) const { return *std::ranges::find(model().clips, name, &Clip::name); }
  Clip mirrored(const Clip& clip) const { return anim::mirror_clip(skeleton(), clip, mirror_); }
  glm::dvec3 place(const Clip& clip, int bone, double seconds) const {
    const auto pose = anim::reference_pose(skeleton(), &clip, seconds);
    return glm::dvec3(pose.globals[static_cast<std::size_t>(bone)][3]);
  }
  /// Returns the metres that a bone goes over the clip.
  double way(const Clip& clip, int bone) const {
    constexpr int steps = 60;
    double sum = 0.0;
    for (int i = 0; i < steps; ++i) {
      const double from = clip.start + clip.length() * i / steps, to = clip.start + clip.length() * (i + 1) / steps;
      sum += glm::distance(place(clip, bone, to), place(clip, bone, from));
    }
    return sum;
  }

  anim::ImportedFile file_;
  anim::RigMap rig_;
  anim::MirrorMap mirror_;
};

TEST_F(MirroredClip, PutsEveryJointWhereItsPartnersImageIs) {
  for (const std::string name : {"walk", "wave", "turn left"}) {
    const Clip image = mirrored(clip(name));
    for (int i = 0; i <= 20; ++i) {
      const double seconds = clip(name).start + clip(name).length() * i / 20.0;
      for (int bone = 0; bone < skeleton().bone_count(); ++bone) {
        glm::dvec3 expected = place(clip(name), mirror_[static_cast<std::size_t>(bone)], seconds);
        expected.x = -expected.x;
        ASSERT_LT(glm::distance(place(image, bone, seconds), expected), 1e-3)
            << name << " " << skeleton().bones[static_cast<std::size_t>(bone)].name << " at " << seconds;
      }
    }
  }
}

TEST_F(MirroredClip, MakesAWaveOfOneHandOneOfTheOther) {
  const Clip& wave = clip("wave");
  const Clip image = mirrored(wave);
  const int left = rig_.at(BodyRole::left_hand), right = rig_.at(BodyRole::right_hand);
  EXPECT_NEAR(way(image, left), way(wave, right), 1e-3);
  EXPECT_NEAR(way(image, right), way(wave, left), 1e-3);
  EXPECT_GT(std::abs(way(wave, left) - way(wave, right)), 0.5) << "one hand waves";
}

TEST_F(MirroredClip, IsItselfWhenMirroredTwice) {
  for (const Clip& once : model().clips) {
    const Clip twice = mirrored(mirrored(once));
    for (int i = 0; i <= 10; ++i) {
      const double seconds = once.start + once.length() * i / 10.0;
      for (int bone = 0; bone < skeleton().bone_count(); ++bone) {
        ASSERT_LT(glm::distance(place(twice, bone, seconds), place(once, bone, seconds)), 1e-5) << once.name;
      }
    }
  }
}

TEST_F(MirroredClip, ChangesTheSidesInTheNamesOfDataKeysAndCurves) {
  Clip walk = clip("walk");
  walk.data_keys = {
      {.time = 0.1, .name = "footstep_left"}, {.time = 0.5, .name = "RightHandOut"}, {.time = 0.6, .name = "hop"}};
  walk.curves = {{.name = "blink_left", .times = {0.0F}, .values = {1.0F}}};
  const Clip image = mirrored(walk);
  EXPECT_EQ(image.curves[0].name, "blink_right");
  EXPECT_EQ(image.data_keys[0].name, "footstep_right");
  EXPECT_EQ(image.data_keys[1].name, "LeftHandOut");
  EXPECT_EQ(image.data_keys[2].name, "hop");
}

TEST_F(MirroredClip, IsRefusedWhereASideLacksABone) {
  anim::Skeleton one_armed = skeleton();
  const auto hand = static_cast<std::size_t>(rig_.at(BodyRole::left_hand));
  one_armed.references[hand].origin.x += 0.5;
  const auto refused = anim::find_mirror(one_armed, rig_);
  ASSERT_FALSE(refused.has_value());
  EXPECT_NE(refused.error().message.find("no bone on the other side"), std::string::npos) << refused.error().message;
}

}  // namespace
}  // namespace throng::test::mirrored_clip_test
