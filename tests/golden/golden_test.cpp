// Pictures that no command line asks for; both headless contexts draw the same to the eye. cases.json has all others.

#include <filesystem>

#include <gtest/gtest.h>

#include "engine/anim/kernel/choose_kernels.h"
#include "engine/anim/kernel/kernels.h"
#include "tests/golden/golden_picture.h"

namespace throng::app::test::golden_test {
namespace {

class GoldenPicture : public testing::TestWithParam<ContextKind> {};

DemoOptions split_options(ContextKind context, Split split) {
  DemoOptions options = golden_options(context);
  options.tuning.scenery = false;
  options.tuning.placed_feet = false;
  options.tuning.inspection = {.split = split, .split_at = 0.5F, .forced_interval = 16, .forced_bone_level = 3};
  options.tuning.lod.smooth = false;
  options.frames = 30;
  return options;
}

TEST_P(GoldenPicture, ExactCrowdBesideTheOneShown) {
  expect_golden_picture("split", split_options(GetParam(), Split::shown));
}

TEST_P(GoldenPicture, DifferenceToTheExactCrowd) {
  expect_golden_picture("split-difference", split_options(GetParam(), Split::difference));
}

// Targets round poses differently, by less than a picture shows.
TEST(GoldenPictureOnEveryTarget, Plaza) {
  for (const anim::Kernels& kernels : anim::runnable_kernels()) {
    SCOPED_TRACE(kernels.target);
    anim::choose_kernels(kernels);
    expect_golden_picture("plaza", golden_options(ContextKind::egl));
  }
  anim::choose_kernels(anim::runnable_kernels().front());
}

INSTANTIATE_TEST_SUITE_P(Headless, GoldenPicture, testing::ValuesIn(golden_contexts()),
                         [](const auto& run) { return run.param == ContextKind::egl ? "Egl" : "OSMesa"; });

TEST(GoldenPictures, AreSmall) {
  constexpr std::uintmax_t largest_bytes = 200'000;  // a plaza has the most corners
  for (const auto& entry : std::filesystem::directory_iterator(golden_cases().pictures)) {
    EXPECT_LE(entry.file_size(), largest_bytes) << entry.path();
  }
}

}  // namespace
}  // namespace throng::app::test::golden_test
