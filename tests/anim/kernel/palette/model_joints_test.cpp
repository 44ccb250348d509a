// Listed joints, against matrices in double precision and against palettes.

#include <array>
#include <cstring>
#include <limits>
#include <random>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "engine/anim/asset/synthetic_model.h"
#include "tests/anim/kernel/palette/joint_rig.h"
#include "tests/anim/kernel/palette/palette_rig.h"

namespace throng::anim::model_joints_test {
namespace {

using namespace kernel_rig;

constexpr JointFormat formats[] = {JointFormat::transforms, JointFormat::matrices, JointFormat::matrices_4x4};
constexpr double tolerance = 2e-5;  // of the numbers of a matrix, metres and shares of one

JointProgram compiled(const Skeleton& skeleton, const JointList& list, JointFormat format, int bone_count) {
  auto program = compile_joints(skeleton, list, format, bone_count);
  EXPECT_TRUE(program.has_value()) << program.error().message;
  return std::move(*program);
}

struct Poses {
  Poses(const Skeleton& skeleton, unsigned count) {
    for (unsigned i = 0; i < count; ++i) {
      locals.push_back(random_pose(skeleton, i + 1));
      states.emplace_back(skeleton, locals.back());
    }
  }
  std::vector<LocalPose> locals;
  std::vector<StatePose> states;
};

void expect_near_reference(const Skeleton& skeleton, const JointList& list, JointFormat format, const Kernels& kernels,
                           int width) {
  const Poses poses(skeleton, 19);
  const JointProgram program = compiled(skeleton, list, format, skeleton.bone_count());
  const auto written = compute_joints(kernels, program, poses.states, width);
  for (std::size_t i = 0; i < written.size(); ++i) {
    const auto expected = reference_joints(skeleton, poses.locals[i], list);
    for (std::size_t joint = 0; joint < expected.size(); ++joint) {
      ASSERT_LT(largest_difference(written_joint(format, written[i], joint), expected[joint]), tolerance)
          << kernels.target << " width " << width << " character " << i << " joint " << joint;
    }
  }
}

/// Sockets in the frames of some joints, in no order, one bone twice.
JointList sockets() {
  glm::dmat4 held = glm::translate(glm::dmat4(1.0), glm::dvec3(0.1, -0.2, 0.05));
  held = glm::rotate(held, 0.7, glm::normalize(glm::dvec3(1.0, 2.0, -1.0)));
  return {{.bone = 37}, {.bone = 5, .post = held}, {.bone = 36}, {.bone = 5}, {.bone = 0, .post = held}};
}

TEST(ModelJoints, AreTheGlobalsOfDoublePrecisionOnEveryTarget) {
  const Skeleton skeleton = rigid_skeleton(branching_parents(45));
  for (const Kernels& kernels : runnable_kernels()) {
    for (const int width : {1, 2, 4, 8, 16}) {
      for (const JointFormat format : formats) {
        expect_near_reference(skeleton, all_joints(skeleton), format, kernels, width);
      }
    }
  }
}

TEST(ModelJoints, OfSocketsCarryTheirOffsets) {
  const Skeleton skeleton = rigid_skeleton(branching_parents(45));
  for (const Kernels& kernels : runnable_kernels()) {
    for (const JointFormat format : formats) expect_near_reference(skeleton, sockets(), format, kernels, 16);
  }
}

TEST(ModelJoints, OfSkeletonsThatStretchAreMatrices) {
  const Skeleton skeleton = general_skeleton(branching_parents(45));
  for (const Kernels& kernels : runnable_kernels()) {
    for (const int width : {1, 4, 16}) {
      for (const JointFormat format : {JointFormat::matrices, JointFormat::matrices_4x4}) {
        expect_near_reference(skeleton, all_joints(skeleton), format, kernels, width);
        expect_near_reference(skeleton, sockets(), format, kernels, width);
      }
    }
  }
}

TEST(ModelJoints, HaveTheSameBitsOnEveryTargetWithFusedMultiplyAdd) {
  for (const Skeleton& skeleton : {rigid_skeleton(branching_parents(45)), general_skeleton(branching_parents(45))}) {
    const Poses poses(skeleton, 19);
    for (const JointFormat format : formats) {
      if (format == JointFormat::transforms && !skeleton.rigid) continue;
      const JointProgram program = compiled(skeleton, sockets(), format, skeleton.bone_count());
      const auto expected = compute_joints(best_kernels(), program, poses.states, 16);
      for (const Kernels& kernels : runnable_kernels()) {
        if (kernels.fused_multiply_add != best_kernels().fused_multiply_add) continue;
        for (const int width : {1, 2, 4, 8, 16}) {
          EXPECT_EQ(compute_joints(kernels, program, poses.states, width), expected) << kernels.target << " " << width;
        }
      }
    }
  }
}

TEST(ModelJoints, DoNotDependOnWhichOthersAreListed) {
  const Skeleton skeleton = rigid_skeleton(branching_parents(45));
  const Poses poses(skeleton, 3);
  const auto all = compute_joints(best_kernels(), compiled(skeleton, all_joints(skeleton), JointFormat::transforms, 45),
                                  poses.states, 4);
  for (int bone = 0; bone < skeleton.bone_count(); ++bone) {
    const auto one = compute_joints(best_kernels(), compiled(skeleton, {{.bone = bone}}, JointFormat::transforms, 45),
                                    poses.states, 4);
    for (std::size_t i = 0; i < one.size(); ++i) {
      EXPECT_TRUE(std::equal(one[i].begin(), one[i].end(), all[i].begin() + bone * 8)) << "bone " << bone;
    }
  }
}

TEST(ModelJoints, OfThePaletteAreThePaletteToTheBit) {
  for (const Skeleton& skeleton : {rigid_skeleton(branching_parents(45)), general_skeleton(branching_parents(45))}) {
    const Poses poses(skeleton, 19);
    const auto palettes = compute_palettes(best_kernels(), compile_hierarchy(skeleton), poses.states, 16, 45).palettes;
    const auto rows = compute_joints(
        best_kernels(), compiled(skeleton, palette_joints(skeleton), JointFormat::matrices, 45), poses.states, 16);
    const auto columns = compute_joints(
        best_kernels(), compiled(skeleton, palette_joints(skeleton), JointFormat::matrices_4x4, 45), poses.states, 16);
    for (std::size_t i = 0; i < palettes.size(); ++i) {
      ASSERT_EQ(rows[i].size(), palettes[i].size() * 12);
      EXPECT_EQ(std::memcmp(rows[i].data(), palettes[i].data(), palettes[i].size() * sizeof(PaletteMatrix)), 0) << i;
      for (std::size_t entry = 0; entry < palettes[i].size(); ++entry) {
        for (std::size_t column = 0; column < 4; ++column) {
          for (std::size_t row = 0; row < 4; ++row) {
            const float last = column == 3 ? 1.0F : 0.0F;
            const float expected = row == 3 ? last : palettes[i][entry].rows[row][column];
            EXPECT_EQ(columns[i][entry * 16 + column * 4 + row], expected);
          }
        }
      }
    }
  }
}

// Both walks have the same bits, so it does not matter to a thing whether its holder is drawn.
TEST(ModelJoints, ThatAPaletteWritesOnItsWayHaveTheBitsOfAWalkOfTheirOwn) {
  for (const Skeleton& skeleton : {rigid_skeleton(branching_parents(45)), general_skeleton(branching_parents(45))}) {
    const Poses poses(skeleton, 19);
    const HierarchyProgram hierarchy = compile_hierarchy(skeleton);
    for (const JointFormat format : formats) {
      if (format == JointFormat::transforms && !skeleton.rigid) continue;
      for (const int bones : {45, 38}) {
        const JointProgram program = compiled(skeleton, sockets(), format, bones);
        for (const Kernels& kernels : runnable_kernels()) {
          for (const int width : {1, 2, 4, 8, 16}) {
            for (const bool usual : {false, true}) {
              PaletteRequest request{.hashed = !usual, .whole_lines = usual};
              const CrowdResult without = compute_palettes(kernels, hierarchy, poses.states, width, bones, request);
              request.joints = &program;
              const CrowdResult with = compute_palettes(kernels, hierarchy, poses.states, width, bones, request);
              EXPECT_EQ(with.joints, compute_joints(kernels, program, poses.states, width)) << kernels.target << width;
              EXPECT_EQ(with.hashes, without.hashes);
              for (std::size_t i = 0; i < poses.states.size(); ++i) {
                EXPECT_TRUE(same_bits(with.palettes[i], without.palettes[i])) << kernels.target << width;
              }
            }
          }
        }
      }
    }
  }
}

TEST(ModelJoints, AreNotMovedByPositionsOfQuadsThatAreNotDisplaced) {
  const Skeleton skeleton = rigid_skeleton(branching_parents(45));
  const Poses poses(skeleton, 17);
  const JointProgram program = compiled(skeleton, all_joints(skeleton), JointFormat::transforms, 45);
  for (const QuadMask quads : {0U, 1U, 10U}) {
    EXPECT_EQ(compute_joints(best_kernels(), program, displaced_in(quads, poses.states, not_there), 16, quads),
              compute_joints(best_kernels(), program, displaced_in(quads, poses.states), 16));
  }
}

TEST(ModelJoints, ThatALevelLacksStandStillOnTheirNearestBone) {
  const Skeleton skeleton = rigid_skeleton(branching_parents(45));
  for (const int bones : {1, 9, 16, 30}) {
    LocalPose pose = random_pose(skeleton, 3);
    for (int bone = bones; bone < 45; ++bone) pose[static_cast<std::size_t>(bone)] = to_local(skeleton, bone, {});
    const auto expected = reference_joints(skeleton, pose, all_joints(skeleton));
    const JointProgram program = compiled(skeleton, all_joints(skeleton), JointFormat::transforms, bones);
    EXPECT_EQ(program.bones.size(), static_cast<std::size_t>(bones));
    const auto written = compute_joints(best_kernels(), program, {StatePose(skeleton, random_pose(skeleton, 3))}, 1);
    for (std::size_t joint = 0; joint < 45; ++joint) {
      EXPECT_LT(largest_difference(written_joint(program.format, written[0], joint), expected[joint]), tolerance)
          << "joint " << joint << " of " << bones;
    }
  }
}

TEST(JointProgram, KnowsTheBonesAloneThatItsJointsNeed) {
  const Skeleton skeleton = rigid_skeleton(chain_parents(40));
  const JointProgram program = compiled(skeleton, {{.bone = 17}}, JointFormat::matrices, 40);
  EXPECT_EQ(program.bones.size(), 18U);
  EXPECT_TRUE(program.needs(0) && program.needs(1));
  EXPECT_FALSE(program.needs(2));
  EXPECT_EQ(program.hierarchy.slot_count, 0);
}

TEST(JointProgram, RefusesInWordsWhatItCannotWrite) {
  const Skeleton rigid = rigid_skeleton(chain_parents(4)), general = general_skeleton(chain_parents(4));
  const auto refusal = [](const Skeleton& skeleton, const JointList& list, JointFormat format) {
    const auto program = compile_joints(skeleton, list, format, skeleton.bone_count());
    return program ? std::string() : program.error().message;
  };
  EXPECT_NE(refusal(rigid, {}, JointFormat::matrices).find("empty"), std::string::npos);
  EXPECT_NE(refusal(rigid, {{.bone = 4}}, JointFormat::matrices).find("give 0 to 3"), std::string::npos);
  EXPECT_NE(refusal(rigid, {{.bone = -1}}, JointFormat::matrices).find("give 0 to 3"), std::string::npos);
  EXPECT_NE(refusal(rigid, {{.bone = 0}}, static_cast<JointFormat>(3)).find("format"), std::string::npos);
  EXPECT_NE(refusal(general, {{.bone = 0}}, JointFormat::transforms).find("ask for matrices"), std::string::npos);
  ListedJoint odd{.bone = 1};
  odd.post[0][0] = 2.0;
  EXPECT_NE(refusal(rigid, {odd}, JointFormat::transforms).find("uneven scale"), std::string::npos);
  EXPECT_EQ(refusal(rigid, {odd}, JointFormat::matrices), "");
  odd.post[3][1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(refusal(rigid, {odd}, JointFormat::matrices).find("not finite"), std::string::npos);
}

TEST(JointList, NamesBonesThatAreThere) {
  const Model model = synthetic_model(20, 1);
  const int bones[] = {3, 20};
  const auto list = joints_of(model.skeleton, bones);
  ASSERT_FALSE(list);
  EXPECT_NE(list.error().message.find("no bone 20"), std::string::npos);
}

TEST(JointList, OfASkinIsInTheOrderOfItsJoints) {
  Model model = synthetic_model(20, 1);
  model.skins.front().skin = 6;
  const auto list = joints_of_skin(model, 6);
  ASSERT_TRUE(list);
  ASSERT_EQ(list->size(), model.skins.front().bones.size());
  for (std::size_t joint = 0; joint < list->size(); ++joint) {
    EXPECT_EQ((*list)[joint].bone, model.skins.front().bones[joint]);
    EXPECT_EQ((*list)[joint].post, model.skins.front().inverse_binds[joint]);
  }
  const auto none = joints_of_skin(model, 0);
  ASSERT_FALSE(none);
  EXPECT_NE(none.error().message.find("no skin 0"), std::string::npos);
}

}  // namespace
}  // namespace throng::anim::model_joints_test
