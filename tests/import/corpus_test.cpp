#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "engine/anim/bake/character.h"
#include "engine/anim/import/import.h"
#include "tests/anim/bake/definition_error.h"
#include "tests/import/test_files.h"

// Real characters, where a folder of them was named when the project was configured (THRONG_CORPUS).

namespace throng::import::testing::corpus_test {
namespace {

std::filesystem::path models_folder() { return std::filesystem::path(THRONG_CORPUS) / "models"; }

std::vector<std::string> corpus_models() {
  const std::string corpus = THRONG_CORPUS;
  return corpus.empty() ? std::vector<std::string>() : model_files(models_folder());
}

class Corpus : public ::testing::TestWithParam<std::string> {};
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(Corpus);

TEST_P(Corpus, ImportsOrHoldsNoSkin) {
  const auto file = import_file((models_folder() / GetParam()).string());
  if (!file) {
    EXPECT_NE(file.error().message.find("holds no skin"), std::string::npos) << file.error().message;
    return;
  }
  for (const anim::Model& model : file->models) {
    EXPECT_EQ(model.skeleton.references.size(), model.skeleton.bones.size());
    for (const anim::SkinnedMesh& mesh : model.meshes) {
      EXPECT_EQ(mesh.normals.size(), mesh.positions.size());
      EXPECT_EQ(mesh.weights.size(), mesh.positions.size());
    }
  }
}

TEST_P(Corpus, PlaysWithinTheErrorThatIsPromised) {
  const auto file = import_file((models_folder() / GetParam()).string());
  if (!file) return;
  for (const anim::Model& model : file->models) {
    const anim::Character character = anim::bake_character(model);
    for (std::size_t i = 0; i < model.clips.size(); ++i) {
      const anim::BakedClip& baked = character.clips[i];
      EXPECT_TRUE(baked.sampled() != nullptr || !baked.note.empty()) << baked.name;
      EXPECT_LE(baked.sampled_error, baked.error_bound) << baked.name;
      EXPECT_LE(anim::error_by_definition(model, model.clips[i], baked, 1001), baked.error_bound) << baked.name;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Models, Corpus, ::testing::ValuesIn(corpus_models()),
                         [](const auto& instance) { return as_test_name(instance.param); });

}  // namespace
}  // namespace throng::import::testing::corpus_test
