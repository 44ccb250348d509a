#include <gtest/gtest.h>

#include "engine/anim/asset/reference_pose.h"
#include "engine/anim/asset/skeleton.h"
#include "engine/anim/asset/synthetic_model.h"

namespace throng::anim::joint_place_test {
namespace {

glm::dvec3 carried(const ReferencePose& pose, const JointPlace& place) {
  return glm::dvec3(pose.palette[static_cast<std::size_t>(place.entry)] * glm::dvec4(place.position, 1.0));
}

TEST(JointPlace, OfARigidSkeletonIsCarriedToThePosedJoint) {
  const Model model = synthetic_model(40, 1);
  const ReferencePose pose = reference_pose(model.skeleton, &model.clips.front(), 0.37);
  for (int bone = 0; bone < model.skeleton.bone_count(); ++bone) {
    const glm::dvec3 joint(pose.globals[static_cast<std::size_t>(bone)][3]);
    EXPECT_LT(glm::distance(carried(pose, joint_place(model.skeleton, bone)), joint), 1e-9) << bone;
  }
}

TEST(JointPlace, OfAnyOtherSkeletonIsCarriedToThePosedJointThroughTheBindMatrix) {
  Skeleton skeleton;
  skeleton.rigid = false;
  skeleton.bones.resize(2);
  skeleton.bones[1].parent = 0;
  skeleton.bones[1].rest.translation = {1, 2, 3};
  skeleton.references.resize(2);
  PaletteEntry sheared{.bone = 1};
  sheared.post[0] = {2, 1, 0, 0};
  sheared.post[3] = {5, 0, -1, 1};
  skeleton.palette = {sheared};
  const ReferencePose pose = reference_pose(skeleton, nullptr, 0.0);
  EXPECT_LT(glm::distance(carried(pose, joint_place(skeleton, 1)), glm::dvec3(1, 2, 3)), 1e-12);
  EXPECT_EQ(joint_place(skeleton, 0).entry, -1) << "no skin uses it";
}

}  // namespace
}  // namespace throng::anim::joint_place_test
