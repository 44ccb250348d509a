#include <algorithm>

#include <gtest/gtest.h>

#include "engine/anim/import/import.h"
#include "tests/anim/bake/definition_error.h"
#include "tests/assets/clip_list.h"

namespace throng::test::mannequin_promise_test {
namespace {

/// The built-in character as the crowd plays it, and as its file says.
struct BuiltIn {
  BuiltIn()
      : file(*import::import_file(THRONG_SOURCE_DIR "/assets/mannequin.glb")),
        character(anim::bake_character(model())) {}
  const anim::Model& model() const { return file.models.front(); }

  anim::ImportedFile file;
  anim::Character character;
};

const BuiltIn& built_in() {
  static const BuiltIn only;
  return only;
}

class MannequinPromise : public ::testing::TestWithParam<const char*> {};

TEST_P(MannequinPromise, IsKeptByTheSampledClip) {
  const anim::Model& model = built_in().model();
  const auto clip = std::ranges::find(model.clips, GetParam(), &anim::Clip::name);
  ASSERT_NE(clip, model.clips.end());
  const anim::BakedClip& baked = built_in().character.clips[static_cast<std::size_t>(clip - model.clips.begin())];
  ASSERT_NE(baked.sampled(), nullptr) << baked.note;
  EXPECT_NEAR(baked.error_bound, 0.0002 * built_in().character.height / 1.8, 1e-12);
  constexpr double rounding = 2e-6;  // metres, of key times in 32-bit seconds
  const double error = anim::error_by_definition(model, *clip, baked, 1001);
  EXPECT_LE(error, baked.sampled_error + rounding);
  EXPECT_LE(error, baked.error_bound);
}

INSTANTIATE_TEST_SUITE_P(Clips, MannequinPromise, ::testing::ValuesIn(clip_list), spaceless_clip_name);

}  // namespace
}  // namespace throng::test::mannequin_promise_test
