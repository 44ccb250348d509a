// The colours that stand for values are told apart by people who see few colours.
#include "app/settings/agent_colors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "engine/base/srgb.h"

namespace throng::app::agent_colors_test {
namespace {

using Triple = std::array<double, 3>;

struct Sight {
  const char* name;
  std::array<Triple, 3> seen;  ///< what becomes of linear red, green and blue
};

/// The usual sight, and those without red, green and blue receptors, after Machado, Oliveira and Fernandes (2009).
constexpr std::array sights = std::to_array<Sight>({
    {"usual", {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}},
    {"protanopia",
     {{{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}}},
    {"deuteranopia",
     {{{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}}},
    {"tritanopia",
     {{{1.255528, -0.076749, -0.178779}, {-0.078411, 0.930809, 0.147602}, {0.004733, 0.691367, 0.303900}}}},
});

/// Returns the colour in CIE L*a*b*, whose first part is lightness, 0 to 100.
Triple lab(std::uint32_t color, const Sight& sight) {
  Triple light{}, seen{}, scaled{};
  for (unsigned i = 0; i < 3; ++i) {
    light.at(i) = static_cast<double>(light_of_srgb(static_cast<float>(color >> (8 * i) & 0xFFU) / 255.0F));
  }
  for (unsigned i = 0; i < 3; ++i) {
    const Triple& row = sight.seen.at(i);
    seen.at(i) = std::clamp(row[0] * light[0] + row[1] * light[1] + row[2] * light[2], 0.0, 1.0);
  }
  constexpr std::array<Triple, 3> to_xyz = {
      {{0.4339, 0.3762, 0.1899}, {0.2126, 0.7152, 0.0722}, {0.0177, 0.1095, 0.8729}}};  // over those of white
  for (unsigned i = 0; i < 3; ++i) {
    const Triple& row = to_xyz.at(i);
    const double value = row[0] * seen[0] + row[1] * seen[1] + row[2] * seen[2];
    scaled.at(i) = value > 0.008856 ? std::cbrt(value) : 7.787 * value + 16.0 / 116.0;
  }
  return {116 * scaled[1] - 16, 500 * (scaled[0] - scaled[1]), 200 * (scaled[1] - scaled[2])};
}

double difference(std::uint32_t color, std::uint32_t other, const Sight& sight) {
  const Triple a = lab(color, sight), b = lab(other, sight);
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

void expect_rising(const std::vector<std::uint32_t>& colors, double least, const std::string& what) {
  for (const Sight& sight : sights) {
    for (std::size_t i = 1; i < colors.size(); ++i) {
      EXPECT_GT(lab(colors[i], sight)[0] - lab(colors[i - 1], sight)[0], least)
          << what << ", step " << i << ", with " << sight.name;
    }
  }
}

std::vector<std::uint32_t> steps(int count, const std::function<std::uint32_t(int)>& color) {
  std::vector<std::uint32_t> colors;
  for (int i = 0; i < count; ++i) colors.push_back(color(i));
  return colors;
}

TEST(ColorsOfValues, GrowLighterStepByStepForEverySight) {
  constexpr double seen_at_a_glance = 6;
  expect_rising(steps(interval_steps, [](int i) { return interval_color(i + 1); }), seen_at_a_glance, "intervals");
  expect_rising(steps(mesh_lod_steps, mesh_lod_color), seen_at_a_glance, "mesh LODs");
  expect_rising(steps(4, bone_level_color), seen_at_a_glance, "bone levels");
  Tuning tuning;
  tuning.debug_view = DebugView::error;
  const auto error = [&](int i) { return debug_color(tuning, {.error_px = 0.2F * std::ldexp(1.0F, i)}); };
  expect_rising(steps(error_steps, error), seen_at_a_glance, "errors");
  expect_rising(steps(17, [](int i) { return scale_color(static_cast<float>(i) / 16); }), 2, "a scale");
  expect_rising(steps(9, [](int i) { return weight_color(static_cast<float>(i) / 8); }), 2, "weights");
}

TEST(ColorsOfValues, HaveOneForEachStepThatNoClothesShowThrough) {
  for (int frames = 1; frames <= interval_steps; ++frames) EXPECT_EQ(interval_color(frames) >> 24U, 0xFFU);
  EXPECT_EQ(interval_color(interval_steps), interval_color(16));
}

TEST(ColorsOfTheSelectedAgentAndOfPlainBodies, AreNoneOfAValue) {
  constexpr double another_colour = 30, another_grey = 12;  // no grey is much farther from all colours in each sight
  for (const Sight& sight : sights) {
    for (int i = 0; i <= 64; ++i) {
      const std::uint32_t value = scale_color(static_cast<float>(i) / 64);
      EXPECT_GT(difference(selected_color, value, sight), another_colour) << i << " of 64, with " << sight.name;
      EXPECT_GT(difference(plain_body_color, value, sight), another_grey) << i << " of 64, with " << sight.name;
    }
  }
}

TEST(ColorsOfPlainBodies, AreThoseOfTheViewWhereItHasOne) {
  Tuning tuning;
  EXPECT_EQ(debug_color(tuning, {}), 0U);
  tuning.plain_bodies = true;
  EXPECT_EQ(debug_color(tuning, {}), plain_body_color);
  tuning.debug_view = DebugView::speed;
  EXPECT_EQ(debug_color(tuning, {.measure = 1.0F}), scale_color(0.5F));
  EXPECT_EQ(debug_color(tuning, {.measure = -1.0F}), plain_body_color) << "it is not measured";
}

}  // namespace
}  // namespace throng::app::agent_colors_test
