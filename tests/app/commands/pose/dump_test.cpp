#include "app/commands/pose/dump.h"

#include <gtest/gtest.h>

#include "engine/anim/asset/reference_pose.h"
#include "engine/anim/asset/synthetic_model.h"

namespace throng::app::dump_test {
namespace {

Json joints_of(const anim::Model& model) {
  const anim::Clip& clip = model.clips.front();
  anim::Skin skin;
  skin.skin = 0;
  for (int bone = 0; bone < model.skeleton.bone_count(); ++bone) {
    skin.bones.push_back(bone);
    skin.palette_entries.push_back(bone);
  }
  const anim::ReferencePose reference = anim::reference_pose(model.skeleton, &clip, 0.5);
  BonePose pose{.states = {}, .palette = reference.palette};
  for (int bone = 0; bone < model.skeleton.bone_count(); ++bone) {
    pose.states.push_back(anim::to_state(model.skeleton, bone, reference.locals[static_cast<std::size_t>(bone)]));
  }
  return dump_skin(model, skin, &clip, pose)["joints"];
}

TEST(PoseDump, SaysTheRotationOfEveryJoint) {
  const Json joints = joints_of(anim::synthetic_model(8, 1));
  for (const Json& joint : joints.elements()) EXPECT_TRUE(joint.contains("r")) << joint.dump();
}

TEST(PoseDump, LeavesOutARotationWhoseKeysAreNotUnitAndKeepsTheMatrix) {
  anim::Model model = anim::synthetic_model(8, 1);
  for (glm::quat& key : model.clips.front().tracks.at(3).rotation.values) key = key * 0.9998F;
  const Json joints = joints_of(model);
  const auto changed = static_cast<std::size_t>(model.clips.front().tracks.at(3).bone);
  for (std::size_t joint = 0; joint < joints.elements().size(); ++joint) {
    EXPECT_EQ(joints.elements()[joint].contains("r"), joint != changed);
    EXPECT_TRUE(joints.elements()[joint].contains("global"));
  }
}

}  // namespace
}  // namespace throng::app::dump_test
