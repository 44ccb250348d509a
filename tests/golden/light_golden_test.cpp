// Places and times of day, each with shadows on everything; both headless contexts draw the same to the eye.

#include <string>

#include <gtest/gtest.h>

#include "app/settings/times_of_day.h"
#include "tests/golden/golden_picture.h"

namespace throng::app::test::light_golden_test {
namespace {

class GoldenLight : public testing::TestWithParam<ContextKind> {};

DemoOptions at_time(ContextKind context, Scene scene, std::size_t time) {
  DemoOptions options = golden_options(context);
  options.tuning.scene = scene;
  options.tuning.light = times_of_day.at(time).light;
  return options;
}
enum Time : std::size_t { noon, evening, overcast, night };

TEST_P(GoldenLight, PlazaInTheEvening) {
  expect_golden_picture("plaza-evening", at_time(GetParam(), Scene::plaza, evening));
}
TEST_P(GoldenLight, PlazaUnderClouds) {
  expect_golden_picture("plaza-overcast", at_time(GetParam(), Scene::plaza, overcast));
}
TEST_P(GoldenLight, PlazaAtNight) { expect_golden_picture("plaza-night", at_time(GetParam(), Scene::plaza, night)); }
TEST_P(GoldenLight, ParadeAtNoon) { expect_golden_picture("parade", at_time(GetParam(), Scene::parade, noon)); }
TEST_P(GoldenLight, StadiumAtNoon) { expect_golden_picture("stadium", at_time(GetParam(), Scene::stadium, noon)); }
TEST_P(GoldenLight, StadiumUnderFloodlights) {
  expect_golden_picture("stadium-night", at_time(GetParam(), Scene::stadium, night));
}

// What a software renderer draws live: spots with a streak stand for shadows.
TEST_P(GoldenLight, WithoutShadows) {
  DemoOptions options = at_time(GetParam(), Scene::plaza, noon);
  options.tuning.shadows = options.tuning.crowd_shade = false;
  expect_golden_picture("without-shadows", options);
}

// Shadows of people on people and on the ground between them, at the size of a hand.
TEST_P(GoldenLight, ShadowsNearBy) {
  DemoOptions options = at_time(GetParam(), Scene::grid, noon);
  options.tuning.agents = 16;
  options.tuning.light.sun_elevation = 25.0F;
  options.tuning.light.sun_azimuth = 70.0F;
  options.camera = CameraPlace{.x = 2.2F, .y = 2.1F, .z = 2.6F, .yaw = 35, .pitch = -16, .field_of_view = 42};
  expect_golden_picture("shadows-near", options);
}

// All cascades are in this picture, and their borders.
TEST_P(GoldenLight, ShadowsFarAway) {
  DemoOptions options = at_time(GetParam(), Scene::grid, noon);
  options.tuning.agents = 400;
  options.tuning.light.sun_elevation = 30.0F;
  options.tuning.light.sun_azimuth = 100.0F;
  options.camera_name = "far";
  expect_golden_picture("shadows-far", options);
}

INSTANTIATE_TEST_SUITE_P(Headless, GoldenLight, testing::Values(ContextKind::egl, ContextKind::osmesa),
                         [](const auto& run) { return run.param == ContextKind::egl ? "Egl" : "OSMesa"; });

}  // namespace
}  // namespace throng::app::test::light_golden_test
