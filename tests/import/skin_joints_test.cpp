#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "engine/anim/agent/animation_system.h"
#include "tests/import/test_files.h"

// Every feature file: what a system writes in the order of a skin's joints is what its palette says.
namespace throng::import::testing::skin_joints_test {
namespace {

using anim::PaletteMatrix;

/// All skins of a model, one behind the other.
anim::JointList all_skins(const anim::Model& model) {
  anim::JointList list;
  for (const anim::Skin& skin : model.skins) {
    const auto joints = anim::joints_of_skin(model, skin.skin);
    EXPECT_TRUE(joints);
    list.insert(list.end(), joints->begin(), joints->end());
  }
  return list;
}

glm::dmat4 in_double(const PaletteMatrix& matrix) {
  glm::dmat4 result(1.0);
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) result[column][row] = matrix.rows[row][column];
  }
  return result;
}

class SkinJoints : public ::testing::TestWithParam<std::string> {};

TEST_P(SkinJoints, AreThePaletteInTheOrderOfTheFile) {
  const anim::ImportedFile file = import_good(data_path("features") / GetParam());
  for (const anim::Model& model : file.models) {
    const auto character = std::make_shared<const anim::Character>(anim::bake_character(model));
    const auto system = std::move(*anim::AnimationSystem::create(character, {}));
    const anim::JointList list = all_skins(model);
    if (list.empty()) continue;
    ASSERT_TRUE(system->characters().write_joints(list, JointFormat::matrices_4x4));
    system->set_agent_count(1);
    system->agent(0).play({.clip = 0, .start = to_ticks(0.1)});
    const auto entries = static_cast<std::size_t>(model.skeleton.palette_count());
    std::vector<PaletteMatrix> palette(entries + 4);
    std::vector<anim::Matrix4x4> joints(list.size());
    const PoseRequest update{.agent = {0},
                             .palette = anim::PaletteDestination(palette.data()).memory(),
                             .joints = anim::PaletteDestination(joints.data()).memory()};
    system->update({&update, 1});
    std::size_t joint = 0;
    for (const anim::Skin& skin : model.skins) {
      for (const int entry : skin.palette_entries) {
        glm::dmat4 expected = in_double(palette[static_cast<std::size_t>(entry)]);
        if (model.skeleton.rigid) expected = expected * skin.bind_to_model;
        const double size = std::max(1.0, glm::length(expected[0]) + glm::length(expected[3]));
        for (int column = 0; column < 4; ++column) {
          for (int row = 0; row < 4; ++row) {
            EXPECT_NEAR(joints[joint].columns[column][row], expected[column][row], 2e-5 * size)
                << "skin " << skin.skin << " joint " << joint;
          }
        }
        ++joint;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Features, SkinJoints, ::testing::ValuesIn(model_files(data_path("features"))),
                         [](const auto& instance) { return as_test_name(instance.param); });

}  // namespace
}  // namespace throng::import::testing::skin_joints_test
