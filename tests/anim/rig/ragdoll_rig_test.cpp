#include "engine/anim/rig/ragdoll_rig.h"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "engine/anim/asset/synthetic_model.h"
#include "tests/anim/kernel/kernel_rig.h"
#include "tests/anim/kernel/ragdoll/ragdoll_stage.h"

namespace throng::anim::ragdoll_rig_test {
namespace {

using namespace ragdoll_stage;

std::set<std::string> bones_with_bodies(const Model& model) {
  std::set<std::string> names;
  for (const RagdollBody& body : rig_of(model).bodies) {
    names.insert(model.skeleton.bones[static_cast<std::size_t>(body.bone)].name);
  }
  return names;
}

void rename(Model& model, const std::string& from, const std::string& to) {
  std::ranges::find(model.skeleton.bones, from, &Bone::name)->name = to;
}

TEST(RagdollRig, GivesAPersonSixteenBodies) {
  const std::set<std::string> expected{"hips",   "spine",   "upper_chest", "head",   "upper_arm.L", "forearm.L",
                                       "hand.L", "thigh.L", "shin.L",      "foot.L", "upper_arm.R", "forearm.R",
                                       "hand.R", "thigh.R", "shin.R",      "foot.R"};
  EXPECT_EQ(bones_with_bodies(person()), expected);
}

struct Scheme {
  const char* names[8];  ///< left upper arm, forearm, thigh, shin; right
};

class EveryScheme : public testing::TestWithParam<Scheme> {};

TEST_P(EveryScheme, IsReadAsAPerson) {
  Model model = person();
  const char* const ours[] = {"upper_arm.L", "forearm.L", "thigh.L", "shin.L",
                              "upper_arm.R", "forearm.R", "thigh.R", "shin.R"};
  for (int i = 0; i < 8; ++i) rename(model, ours[i], GetParam().names[i]);
  const RagdollRig rig = rig_of(model);
  EXPECT_EQ(rig.bodies.size(), 16U);
  EXPECT_EQ(std::ranges::count_if(rig.bodies, [](const RagdollBody& body) { return body.limit.hinge; }), 4);
}

INSTANTIATE_TEST_SUITE_P(RagdollRig, EveryScheme,
                         testing::Values(Scheme{{"mixamorig:LeftArm", "mixamorig:LeftForeArm", "mixamorig:LeftUpLeg",
                                                 "mixamorig:LeftLeg", "mixamorig:RightArm", "mixamorig:RightForeArm",
                                                 "mixamorig:RightUpLeg", "mixamorig:RightLeg"}},
                                         Scheme{{"DEF-upper_arm.L", "DEF-forearm.L", "DEF-thigh.L", "DEF-shin.L",
                                                 "DEF-upper_arm.R", "DEF-forearm.R", "DEF-thigh.R", "DEF-shin.R"}},
                                         Scheme{{"upperarm_l", "lowerarm_l", "thigh_l", "calf_l", "upperarm_r",
                                                 "lowerarm_r", "thigh_r", "calf_r"}},
                                         Scheme{{"J_Bip_L_UpperArm", "J_Bip_L_LowerArm", "J_Bip_L_UpperLeg",
                                                 "J_Bip_L_LowerLeg", "J_Bip_R_UpperArm", "J_Bip_R_LowerArm",
                                                 "J_Bip_R_UpperLeg", "J_Bip_R_LowerLeg"}}));

TEST(RagdollRig, HangsFeetThatStandBesideTheLegsOnTheShins) {
  Model model = person();
  const auto foot = std::ranges::find(model.skeleton.bones, "foot.L", &Bone::name);
  foot->parent = 0;
  const RagdollRig rig = rig_of(model);
  const auto body =
      std::ranges::find(rig.bodies, static_cast<int>(foot - model.skeleton.bones.begin()), &RagdollBody::bone);
  ASSERT_NE(body, rig.bodies.end());
  EXPECT_EQ(
      model.skeleton.bones[static_cast<std::size_t>(rig.bodies[static_cast<std::size_t>(body->parent)].bone)].name,
      "shin.L");
  EXPECT_EQ(body->pose_parent, -1);
  const RagdollState state = fallen(rig, 3.0);
  const auto origins = bone_origins(model, rig, state);
  const auto b = static_cast<int>(body - rig.bodies.begin());
  EXPECT_LT(glm::distance(origins[static_cast<std::size_t>(body->bone)], glm::dvec3(joint_of(rig, state, b))), 1e-5);
}

TEST(RagdollRig, FindsBodiesInWhateverHasBones) {
  for (const Model& model :
       {chain(2), chain(5), chain(200), octopus(), synthetic_model(62, 1), synthetic_model(300, 1)}) {
    const RagdollRig rig = rig_of(model);
    ASSERT_GE(rig.bodies.size(), 2U);
    ASSERT_LE(rig.bodies.size(), static_cast<std::size_t>(max_ragdoll_bodies));
    for (std::size_t b = 1; b < rig.bodies.size(); ++b) {
      ASSERT_GE(rig.bodies[b].parent, 0);
      ASSERT_LT(rig.bodies[b].parent, static_cast<int>(b));
    }
    const RagdollState state = fallen(rig, 6.0);
    EXPECT_TRUE(is_finite(rig, state)) << model.skeleton.bone_count();
    EXPECT_LT(deepest(rig, state), 0.01F) << model.skeleton.bone_count();
    EXPECT_LT(widest_gap(rig, state), 0.01F) << model.skeleton.bone_count();
  }
}

TEST(RagdollRig, WeighsWhatItIsToldTo) {
  double mass = 0.0;
  for (const RagdollBody& body : rig_of(person()).bodies) mass += 1.0 / static_cast<double>(body.inverse_mass);
  EXPECT_NEAR(mass, 70.0, 3.0);  // hands and feet are made heavier than they are
}

TEST(RagdollRig, RefusesASingleBone) {
  const auto rig = build_ragdoll_rig(chain(1));
  ASSERT_FALSE(rig);
  EXPECT_NE(rig.error().message.find("a rag-doll needs a joint"), std::string::npos);
}

TEST(RagdollRig, RefusesShearedSkeletons) {
  Model model;
  model.skeleton = kernel_rig::general_skeleton(kernel_rig::chain_parents(5));
  const auto rig = build_ragdoll_rig(model);
  ASSERT_FALSE(rig);
  EXPECT_NE(rig.error().message.find("rigid bones"), std::string::npos);
}

}  // namespace
}  // namespace throng::anim::ragdoll_rig_test
