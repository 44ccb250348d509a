#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include <gtest/gtest.h>

#include "engine/anim/asset/reference_pose.h"
#include "tests/import/test_files.h"

// Every feature file, posed straight from what was imported, against what the independent implementation found.

namespace throng::import::testing::feature_poses_test {
namespace {

using nlohmann::json;

// What poses are held to everywhere: 1e-4, and 1e-5 of the largest magnitude.
double tolerance(const json& numbers) {
  double largest = 0.0;
  for (const json& list : numbers) {
    for (const double number : list) largest = std::max(largest, std::abs(number));
  }
  return 1e-4 + 1e-5 * largest;
}

void expect_vector(const json& expected, const glm::dvec3& actual, double limit, const std::string& what) {
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(actual[i], expected[static_cast<std::size_t>(i)].get<double>(), limit) << what;
  }
}

void expect_rotation(const json& expected, const glm::dquat& actual, double limit, const std::string& what) {
  const glm::dquat wanted(expected[3].get<double>(), expected[0].get<double>(), expected[1].get<double>(),
                          expected[2].get<double>());
  const double sign = glm::dot(wanted, actual) < 0.0 ? -1.0 : 1.0;
  EXPECT_NEAR(glm::length(wanted - actual * sign), 0.0, limit) << what;
}

void expect_matrix(const json& expected, const glm::dmat4& actual, double limit, const std::string& what) {
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) {
      const auto number = static_cast<std::size_t>(row * 4 + column);
      EXPECT_NEAR(actual[column][row], expected[number].get<double>(), limit)
          << what << " row " << row << " column " << column;
    }
  }
}

/// A vertex as the drawing will see it: palette and four influences.
glm::dvec3 skinned(const anim::SkinnedMesh& mesh, std::size_t vertex, const anim::ReferencePose& pose) {
  glm::dvec4 sum(0.0);
  for (int i = 0; i < 4; ++i) {
    const auto weight = static_cast<double>(mesh.weights[vertex][i]);
    const auto& matrix = pose.palette[mesh.palette_entries[vertex][i]];
    sum += weight * (matrix * glm::dvec4(glm::dvec3(mesh.positions[vertex]), 1.0));
  }
  return sum;
}

class FeaturePoses : public ::testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    expected_ =
        read_json(data_path("features/expected") / std::filesystem::path(GetParam()).replace_extension(".json"));
    file_ = import_good(data_path("features") / GetParam());
    ASSERT_EQ(file_.models.size(), 1U);
  }

  const anim::Model& model() const { return file_.models.front(); }

  const anim::Clip* clip(const json& animation) const {
    if (animation.is_null()) return nullptr;
    const auto found = std::ranges::find(model().clips, animation.get<int>(), &anim::Clip::animation);
    return found == model().clips.end() ? nullptr : &*found;
  }

  template <typename Check>
  void for_each_sample(const Check& check) const {
    for (const json& animation : expected_["clips"]) {
      for (const json& sample : animation["samples"]) {
        const double seconds = sample["time"].get<double>();
        SCOPED_TRACE(animation["animation"].dump() + " at " + std::to_string(seconds));
        check(sample, anim::reference_pose(model().skeleton, clip(animation["animation"]), seconds));
      }
    }
  }

  json expected_;
  anim::ImportedFile file_;
};

TEST_P(FeaturePoses, JointsMoveAsTheFileSays) {
  for_each_sample([&](const json& sample, const anim::ReferencePose& pose) {
    for (const json& skin : sample["skins"]) {
      const anim::Skin& ours = model().skins[skin["skin"].get<std::size_t>()];
      ASSERT_EQ(ours.bones.size(), skin["joints"].size());
      for (std::size_t joint = 0; joint < ours.bones.size(); ++joint) {
        const json& wanted = skin["joints"][joint];
        if (!wanted.contains("t")) continue;
        const auto& local = pose.locals[static_cast<std::size_t>(ours.bones[joint])];
        const std::string what = "joint " + std::to_string(joint);
        expect_vector(wanted["t"], local.position, 1e-4, what + " t");
        expect_vector(wanted["s"], local.scale, 1e-4, what + " s");
        expect_rotation(wanted["r"], local.rotation, 1e-4, what + " r");
      }
    }
  });
}

TEST_P(FeaturePoses, PalettesAgreeWithTheDefinition) {
  for_each_sample([&](const json& sample, const anim::ReferencePose& pose) {
    for (const json& skin : sample["skins"]) {
      const anim::Skin& ours = model().skins[skin["skin"].get<std::size_t>()];
      const json& palette = skin["scenePalette"];
      ASSERT_EQ(ours.palette_entries.size(), palette.size());
      for (std::size_t joint = 0; joint < palette.size(); ++joint) {
        const auto entry = static_cast<std::size_t>(ours.palette_entries[joint]);
        expect_matrix(palette[joint], pose.palette[entry] * ours.bind_to_model, tolerance(palette),
                      "skin " + skin["skin"].dump() + " joint " + std::to_string(joint));
      }
    }
  });
}

TEST_P(FeaturePoses, VerticesLandWhereTheDefinitionPutsThem) {
  for_each_sample([&](const json& sample, const anim::ReferencePose& pose) {
    std::size_t mesh = 0;
    for (const json& node : sample["vertices"]) {
      ASSERT_LT(mesh, model().meshes.size());
      for (std::size_t vertex = 0; vertex < node["positions"].size(); ++vertex) {
        expect_vector(node["positions"][vertex], skinned(model().meshes[mesh], vertex, pose),
                      tolerance(node["positions"]), "vertex " + std::to_string(vertex));
      }
      ++mesh;
    }
  });
}

TEST_P(FeaturePoses, StateAndLocalAreTwoWaysToSayTheSame) {
  for_each_sample([&](const json&, const anim::ReferencePose& pose) {
    for (int bone = 0; bone < model().skeleton.bone_count(); ++bone) {
      const auto& local = pose.locals[static_cast<std::size_t>(bone)];
      const auto back = to_local(model().skeleton, bone, to_state(model().skeleton, bone, local));
      EXPECT_LT(glm::distance(back.position, local.position), 1e-9);
      EXPECT_LT(glm::distance(back.scale, local.scale), 1e-9);
      EXPECT_NEAR(std::abs(glm::dot(back.rotation, local.rotation)), 1.0, 1e-12);
    }
  });
}

INSTANTIATE_TEST_SUITE_P(Features, FeaturePoses, ::testing::ValuesIn(model_files(data_path("features"))),
                         [](const auto& instance) { return as_test_name(instance.param); });

}  // namespace
}  // namespace throng::import::testing::feature_poses_test
