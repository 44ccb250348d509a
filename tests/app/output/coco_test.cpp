#include "app/output/coco.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "app/character/source.h"
#include "app/show/show.h"
#include "app/show/stage/stage.h"
#include "engine/anim/asset/joint_list.h"
#include "tests/app/show/recording/recorded_run.h"

namespace throng::app::coco_test {
namespace {

/// The points of the built-in character as it rests, in model space; it faces +Z.
struct RestingPoints {
  std::array<glm::vec3, coco_names.size()> places;

  RestingPoints() {
    const auto show = test::show_of(test::demo("--agents 1"));
    const CharacterSource& source = show->stage().characters().front();
    const CocoPoints points = coco_points(source);
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_GE(points.at(i).bone, 0) << coco_names.at(i);
      const glm::mat4 bind(anim::bind_global(source.character->skeleton, points.at(i).bone));
      places.at(i) = glm::vec3(bind * glm::vec4(points.at(i).place, 1.0F));
    }
  }

  const glm::vec3& at(std::string_view name) const {
    return places.at(static_cast<std::size_t>(std::ranges::find(coco_names, name) - coco_names.begin()));
  }
};

TEST(CocoPointsOfTheBuiltInCharacter, HaveLeftAtItsLeft) {
  const RestingPoints points;
  for (const std::string name : {"eye", "ear", "shoulder", "elbow", "wrist", "hip", "knee", "ankle"}) {
    EXPECT_GT(points.at("left_" + name).x, 0.01F) << name;
    EXPECT_NEAR(points.at("left_" + name).x, -points.at("right_" + name).x, 0.01F) << name;
  }
}

TEST(CocoPointsOfTheBuiltInCharacter, StandAboveEachOtherAsInPeople) {
  const RestingPoints points;
  EXPECT_GT(points.at("left_eye").y, points.at("nose").y);
  float above = points.at("nose").y;
  for (const char* const name : {"left_shoulder", "left_hip", "left_knee", "left_ankle"}) {
    EXPECT_LT(points.at(name).y, above - 0.1F) << name;
    above = points.at(name).y;
  }
}

TEST(CocoPointsOfTheBuiltInCharacter, HaveAFaceOfAPersonsSize) {
  const RestingPoints points;
  EXPECT_NEAR(glm::distance(points.at("left_eye"), points.at("right_eye")), 0.065F, 0.02F);
  EXPECT_NEAR(glm::distance(points.at("left_ear"), points.at("right_ear")), 0.15F, 0.03F);
  EXPECT_GT(points.at("nose").z, points.at("left_eye").z + 0.01F);
  EXPECT_GT(points.at("left_eye").z, points.at("left_ear").z + 0.03F);
}

TEST(CocoPointsOfAThing, AreNone) {
  const auto show = test::show_of(test::demo("--agents 1"));
  const CharacterSource& balloon = show->stage().characters().back();
  ASSERT_TRUE(balloon.roles.is_prop);
  for (const CocoPoint& point : coco_points(balloon)) EXPECT_EQ(point.bone, -1);
}

}  // namespace
}  // namespace throng::app::coco_test
