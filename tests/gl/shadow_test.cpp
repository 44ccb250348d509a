#include <cmath>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "tests/gl/doll_crowd.h"
#include "tests/gl/gl_test.h"

namespace throng::render::test::shadow_test {
namespace {

constexpr SceneLight low_sun{.sun_elevation = 30.0F, .sun_azimuth = 90.0F, .clouds = 0.0F};  // from +X

/// Dolls under a sun that shines from the right, seen from in front, or from above.
class Shadows : public SoftwareGlTest {
 protected:
  void SetUp() override {
    SoftwareGlTest::SetUp();
    if (HasFatalFailure()) return;
    crowd_ = std::make_unique<DollCrowd>(context());
  }

  DollCrowd& crowd() { return *crowd_; }

  void stand_at(const std::vector<glm::vec3>& places) {
    crowd().instances.clear();
    crowd().stand(places.size());
    for (std::size_t i = 0; i < places.size(); ++i) {
      for (int axis = 0; axis < 3; ++axis) crowd().instances[i].position[axis] = places[i][axis];
    }
    crowd().write_palettes();
  }

  CrowdFrame frame(bool shadows) {
    CrowdFrame frame = crowd().frame();
    frame.light = low_sun;
    frame.shadows = shadows;
    frame.crowd_shade = false;
    return frame;
  }

  Image drawn(const CrowdFrame& frame) {
    crowd().renderer().draw(frame);
    return crowd().renderer().read_image();
  }

  /// Returns how bright a point of the world is in a picture, 0 to 255.
  int brightness_at(const Image& image, const CrowdFrame& frame, const glm::vec3& point) {
    const glm::vec4 clip = frame.camera.projection * frame.camera.view * glm::vec4(point, 1.0F);
    const auto pixel = [](float place, int size) {
      return static_cast<int>((0.5F + 0.5F * place) * static_cast<float>(size));
    };
    const int x = pixel(clip.x / clip.w, image.width), y = image.height - 1 - pixel(clip.y / clip.w, image.height);
    return image.pixel(x, y)[1];
  }

 private:
  std::unique_ptr<DollCrowd> crowd_;
};

TEST_F(Shadows, FallAwayFromTheSunAsFarAsTheCasterIsTall) {
  stand_at({{0.0F, 0.0F, 0.0F}});
  crowd().camera = {.position = {-1.5F, 9.0F, 0.01F}, .pitch = -1.55F};
  const CrowdFrame with = frame(true), without = frame(false);
  const Image shaded = drawn(with), plain = drawn(without);
  const auto loss_at = [&](float x) {
    return brightness_at(plain, without, {x, 0.0F, 0.0F}) - brightness_at(shaded, with, {x, 0.0F, 0.0F});
  };
  EXPECT_GT(loss_at(-0.8F), 25) << "beside the legs";
  EXPECT_GT(loss_at(-1.9F), 25) << "the trunk's";
  EXPECT_LT(std::abs(loss_at(-4.2F)), 8) << "1.75 m and arms cast no more than 4 m";
  EXPECT_LT(std::abs(loss_at(1.2F)), 8) << "towards the sun";
}

TEST_F(Shadows, FallOnSomebodyElse) {
  stand_at({{0.0F, 0.0F, 0.0F}, {0.75F, 0.0F, 0.75F}});
  crowd().camera = {.position = {-1.0F, 1.3F, 3.0F}, .yaw = -0.3F};
  CrowdFrame both = frame(true);
  both.light.sun_azimuth = 45.0F;
  const Image two = drawn(both);
  stand_at({{0.0F, 0.0F, 0.0F}});
  CrowdFrame alone = frame(true);
  alone.light = both.light;
  const Image one = drawn(alone);
  int darker = 0;
  for (float y = 0.5F; y < 1.5F; y += 0.1F) {
    darker += brightness_at(one, alone, {0.1F, y, 0.12F}) - brightness_at(two, both, {0.1F, y, 0.12F}) > 20 ? 1 : 0;
  }
  EXPECT_GE(darker, 3);
}

TEST_F(Shadows, LeaveNobodySpeckled) {
  stand_at({{0.0F, 0.0F, 0.0F}});
  crowd().camera = {.position = {1.8F, 1.3F, 1.2F}, .yaw = 0.98F};
  const Image shaded = drawn(frame(true)), plain = drawn(frame(false));
  // A single pixel that is darker than in the plain picture between two that are not is acne.
  int speckles = 0;
  for (int y = 0; y < plain.height; ++y) {
    for (int x = 1; x + 1 < plain.width; ++x) {
      const auto lost = [&](int at) { return plain.pixel(at, y)[1] - shaded.pixel(at, y)[1] > 12; };
      speckles += lost(x) && !lost(x - 1) && !lost(x + 1) ? 1 : 0;
    }
  }
  EXPECT_LE(speckles, plain.width * plain.height / 4000);
}

TEST_F(Shadows, TouchTheFeetThatCastThem) {
  stand_at({{0.0F, 0.0F, 0.0F}});
  crowd().instances[0].contact_scale = 0.0F;  // no spot hides a gap
  crowd().camera = {.position = {-1.5F, 6.0F, 0.01F}, .pitch = -1.55F};
  const CrowdFrame with = frame(true), without = frame(false);
  const Image shaded = drawn(with), plain = drawn(without);
  float first_shade = 0.0F;
  for (float x = -0.15F; x > -2.0F && first_shade == 0.0F; x -= 0.01F) {
    const glm::vec3 point(x, 0.0F, 0.1F);
    if (brightness_at(plain, without, point) - brightness_at(shaded, with, point) > 20) first_shade = x;
  }
  EXPECT_GT(first_shade, -0.45F);
}

TEST_F(Shadows, AreTheSameInTilesAsInOnePicture) {
  stand_at({{0.0F, 0.0F, 0.0F}, {1.1F, 0.0F, -1.0F}, {-1.4F, 0.0F, -3.0F}});
  const Image whole = drawn(frame(true));
  DollCrowd tiled(context(), 0, 128);
  tiled.stand(3);
  for (std::size_t i = 0; i < 3; ++i) tiled.instances[i] = crowd().instances[i];
  tiled.write_palettes();
  CrowdFrame in_tiles = tiled.frame();
  in_tiles.light = low_sun;
  in_tiles.crowd_shade = false;
  tiled.renderer().draw(in_tiles);
  const Image& parts = tiled.renderer().read_image();
  int different = 0;
  for (int y = 0; y < whole.height; ++y) {
    for (int x = 0; x < whole.width; ++x)
      different += std::abs(whole.pixel(x, y)[1] - parts.pixel(x, y)[1]) > 8 ? 1 : 0;
  }
  EXPECT_LE(different, whole.width * whole.height / 500) << "single pixels along outlines may differ";
}

TEST_F(Shadows, AreNotDrawnForThoseWhoCastNone) {
  stand_at({{0.0F, 0.0F, 0.0F}});
  const std::uint64_t with = crowd().renderer().draw(frame(true)).triangles;
  const std::uint64_t without = crowd().renderer().draw(frame(false)).triangles;
  EXPECT_GT(with, without);
  stand_at({{0.0F, 0.0F, 0.0F}, {-400.0F, 0.0F, 0.0F}});
  const std::uint64_t far_aside = crowd().renderer().draw(frame(true)).triangles;
  const std::uint64_t surface = crowd().renderer().mesh_lods(0).triangles[0];
  EXPECT_EQ(far_aside - with, surface + 2) << "the second is drawn with its spot, and casts no shadow that is seen";
}

/// Returns the share of the sky that bodies leave, which stand at random, `people` a square metre
/// (shaders/shadows.glsl).
double exact_sky_share(double people, double height) {
  constexpr int steps = 2000;
  constexpr double half_turn = 1.57079632679, width = 0.44, tall = 1.7;
  double share = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double elevation = (i + 0.5) / steps * half_turn;
    const double free = std::exp(-people * width * (tall - height) / std::tan(elevation));
    share += free * std::sin(2.0 * elevation) * half_turn / steps;
  }
  return share;
}

TEST(CrowdShade, IsCloseToTheSkyThatAForestOfBodiesLeaves) {
  for (const double people : {0.1, 0.3, 1.0, 2.0, 4.0}) {
    for (const double height : {0.0, 0.8, 1.5}) {
      const double crowding = people * 0.44 * (1.7 - height);
      const double shader = 1.0 / (1.0 + crowding * (1.57 + 0.15 * crowding));
      EXPECT_NEAR(shader, exact_sky_share(people, height), 0.025) << people << " people, at " << height;
    }
  }
}

TEST_F(Shadows, CrowdShadeDarkensTheGroundBetweenPeopleAndLeavesItFarAway) {
  std::vector<glm::vec3> places;
  for (int i = 0; i < 25; ++i)
    places.emplace_back(0.8F * static_cast<float>(i % 5), 0.0F, -0.8F * static_cast<float>(i / 5));
  stand_at(places);
  crowd().camera = {.position = {1.6F, 11.0F, -1.59F}, .pitch = -1.55F};
  CrowdFrame with = frame(false);
  with.crowd_shade = true;
  const CrowdFrame without = frame(false);
  const Image shaded = drawn(with), plain = drawn(without);
  const auto loss_at = [&](const glm::vec3& point) {
    return brightness_at(plain, without, point) - brightness_at(shaded, with, point);
  };
  EXPECT_GT(loss_at({2.0F, 0.0F, -2.0F}), 5) << "what the sky gives beside a sun of 30 degrees";
  EXPECT_LE(loss_at({-5.0F, 0.0F, -1.6F}), 1);
}

}  // namespace
}  // namespace throng::render::test::shadow_test
