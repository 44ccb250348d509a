// One picture a scene, shared by both headless contexts: EGL and OSMesa draw the same to the eye.

#include <gtest/gtest.h>

#include "engine/anim/kernel/choose_kernels.h"
#include "engine/anim/kernel/kernels.h"
#include "engine/render/crowd_mesh_data.h"
#include "tests/golden/golden_picture.h"

namespace throng::app::test::golden_test {
namespace {

class GoldenPicture : public testing::TestWithParam<ContextKind> {};

TEST_P(GoldenPicture, Plaza) { expect_golden_picture("plaza", golden_options(GetParam())); }

TEST_P(GoldenPicture, GridCloseUp) {
  DemoOptions options = golden_options(GetParam());
  options.tuning.scene = Scene::grid;
  options.tuning.agents = 9;
  options.camera_name = "close";
  expect_golden_picture("grid-close", options);
}

// Nobody of whom only the coarsest mesh is drawn lacks a leg, an arm or a head.
TEST_P(GoldenPicture, FarPeople) {
  DemoOptions options = golden_options(GetParam());
  options.tuning.scenery = false;
  options.tuning.mesh_lod = render::largest_mesh_lod_count - 1;
  expect_golden_picture("far-people", options);
}

// Bodies hide no bones of their own, and those of others nearly.
TEST_P(GoldenPicture, BonesOverCharacters) {
  DemoOptions options = golden_options(GetParam());
  options.tuning.scene = Scene::grid;
  options.tuning.agents = 9;
  options.tuning.bones_as_lines = true;
  options.camera_name = "close";
  expect_golden_picture("bones", options);
}

TEST_P(GoldenPicture, SmoothSkippingBetweenUpdates) {
  DemoOptions options = golden_options(GetParam());
  options.tuning.scenery = false;
  options.tuning.lod.rule = anim::LodRule::distance;
  options.tuning.lod.full_rate_distance = 1.0F;
  options.tuning.lod.interval_growth = 1.0F;
  options.frames = 13;
  expect_golden_picture("smooth-skipping", options);
}

TEST_P(GoldenPicture, IntervalsAsColors) {
  DemoOptions options = golden_options(GetParam());
  options.tuning.scenery = false;
  options.tuning.debug_view = DebugView::interval;
  options.tuning.lod.rule = anim::LodRule::distance;
  options.tuning.lod.full_rate_distance = 6.0F;
  options.tuning.lod.interval_growth = 3.0F;
  expect_golden_picture("intervals", options);
}

TEST_P(GoldenPicture, FewestBonesAndTriangles) {
  DemoOptions options = golden_options(GetParam());
  options.tuning.scenery = false;
  options.tuning.lod.rule = anim::LodRule::distance;
  options.tuning.lod.level_distances[0] = 1.0F;
  options.tuning.lod.level_distances[1] = 2.0F;
  options.tuning.lod.level_distances[2] = 3.0F;
  options.tuning.mesh_lod = 1;
  expect_golden_picture("fewest-bones", options);
}

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

// The camera's own picture, a second after the balloon was let go: three characters in one system.
TEST_P(GoldenPicture, FilmOfTheCutScene) {
  DemoOptions options = golden_options(GetParam());
  options.tuning.scene = Scene::film;
  options.frames = 335;
  expect_golden_picture("film", options);
}

TEST_P(GoldenPicture, OverlayWithFixedFigures) {
  DemoOptions options = golden_options(GetParam());
  options.width = 1280;
  options.height = 720;
  look_at_plain_sky(options);
  options.ui = true;
  options.ui_fixed = true;
  expect_golden_picture("overlay", options);
}

// Targets round poses differently; nobody sees it.
TEST(GoldenPictureOnEveryTarget, Plaza) {
  for (const anim::Kernels& kernels : anim::runnable_kernels()) {
    SCOPED_TRACE(kernels.target);
    anim::choose_kernels(kernels);
    expect_golden_picture("plaza", golden_options(ContextKind::egl));
  }
  anim::choose_kernels(anim::runnable_kernels().front());
}

INSTANTIATE_TEST_SUITE_P(Headless, GoldenPicture, testing::Values(ContextKind::egl, ContextKind::osmesa),
                         [](const auto& run) { return run.param == ContextKind::egl ? "Egl" : "OSMesa"; });

}  // namespace
}  // namespace throng::app::test::golden_test
