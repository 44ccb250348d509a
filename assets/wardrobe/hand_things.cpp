#include <array>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "assets/mannequin/held.h"
#include "assets/wardrobe/part.h"
#include "assets/wardrobe/solids.h"

namespace throng::wardrobe {
namespace {

using glm::dvec2;
using glm::dvec3;
using mannequin::Region;
using mannequin::Skin;

constexpr double pi = std::numbers::pi;
constexpr dvec3 black{0.035, 0.035, 0.04};
constexpr dvec3 steel{0.42, 0.43, 0.45};
constexpr dvec3 wood{0.20, 0.105, 0.05};
constexpr dvec3 paper{0.80, 0.78, 0.74};

Solids in_right_hand() { return Solids(mannequin::bind({{"hand.R", 1}})); }

/// The fist's middle: x runs up through it, y is where the fingers point, z away from the palm.
Frame fist() {
  const dvec3 held = mannequin::handle_in_hand();
  const mannequin::ArmFrame& arm = mannequin::left_arm();
  return right_hand().moved(
      {glm::dot(held, arm.thumbwards), glm::dot(held, arm.along), -glm::dot(held, arm.backwards)});
}

/// A fist's axes for what stands upright in it: y up, z to where the fingers point.
Frame upright() { return fist().turned({0, 0, 1}, {1, 0, 0}); }

Skin umbrella() {
  Solids made = in_right_hand();
  const Frame up = upright();
  constexpr double top = 0.80;
  constexpr double radius = 0.53;
  made.coat = {Region::untinted, steel};
  made.rod(up, std::array{dvec3(0, -0.06, 0), dvec3(0, 0.40, 0), dvec3(0, top + 0.05, 0)}, 0.0055, 5);
  made.coat = {Region::untinted, wood};
  made.rod(up,
           std::array{dvec3(0, 0.055, 0), dvec3(0, -0.085, 0), dvec3(0, -0.125, 0.012), dvec3(0, -0.140, 0.038),
                      dvec3(0, -0.125, 0.064), dvec3(0, -0.095, 0.070)},
           0.0115, 6);
  made.coat = {};
  constexpr double ribs = 8;
  const auto canopy = [](double u, double v) {
    const double angle = 2 * pi * u;
    // Between its ribs the cloth is drawn in and up.
    const double between = 0.5 - 0.5 * std::cos(ribs * angle);
    const double out = radius * v * (1 - 0.055 * between * v);
    const double drop = 0.235 * std::pow(v, 1.9) - 0.020 * between * v * v;
    return dvec3(out * std::cos(angle), top - drop, out * std::sin(angle));
  };
  made.cloth(up, 24, 4, canopy);
  made.coat = {Region::untinted, steel};
  for (int rib = 0; rib < 8; ++rib) {
    const double u = rib / ribs;
    const auto below = [&](double v) { return canopy(u, v) - dvec3(0, 0.010, 0); };
    made.rod(up, std::array{below(0.04), below(0.5), below(0.99)}, 0.0028, 3);
  }
  return made.skin();
}

Skin phone() {
  Solids made = in_right_hand();
  const dvec3 held = mannequin::phone_in_hand();
  const mannequin::ArmFrame& arm = mannequin::left_arm();
  const double slant = 28 * mannequin::degrees;
  const Frame lying =
      right_hand()
          .moved({glm::dot(held, arm.thumbwards), glm::dot(held, arm.along), -glm::dot(held, arm.backwards)})
          .turned({std::cos(slant), -std::sin(slant), 0}, {std::sin(slant), std::cos(slant), 0});
  made.coat = {Region::thing, dvec3(1)};
  made.box(lying, {0.074, 0.152, 0.0085}, 0.004);
  made.coat = {Region::untinted, dvec3(0.012, 0.014, 0.020)};
  made.box(lying.moved({0, 0, 0.0045}), {0.069, 0.147, 0.0014}, 0.0006);
  made.coat = {Region::untinted, dvec3(0.30, 0.42, 0.55)};
  made.box(lying.moved({0, 0.004, 0.0053}), {0.062, 0.120, 0.0006}, 0.0002);
  made.coat = {Region::untinted, black};
  made.box(lying.moved({0.022, 0.055, -0.0050}), {0.022, 0.028, 0.003}, 0.001);
  return made.skin();
}

Skin cup() {
  Solids made = in_right_hand();
  const dvec3 held = mannequin::cup_in_hand();
  const mannequin::ArmFrame& arm = mannequin::left_arm();
  const Frame standing =
      right_hand()
          .moved({glm::dot(held, arm.thumbwards), glm::dot(held, arm.along), -glm::dot(held, arm.backwards)})
          .turned({0, 0, 1}, {1, 0, 0});
  made.coat = {Region::untinted, paper};
  made.turn(standing, std::array{dvec2(0.029, -0.056), dvec2(0.0305, -0.052), dvec2(0.0395, 0.046)}, 12);
  made.coat = {};
  made.turn(standing,
            std::array{dvec2(0.0325, -0.034), dvec2(0.0345, -0.033), dvec2(0.0395, 0.020), dvec2(0.0375, 0.021)}, 12);
  made.coat = {Region::untinted, dvec3(0.075, 0.06, 0.05)};
  made.turn(standing,
            std::array{dvec2(0.0415, 0.044), dvec2(0.0420, 0.050), dvec2(0.0385, 0.053), dvec2(0.0365, 0.059),
                       dvec2(0.0310, 0.060)},
            12);
  return made.skin();
}

Skin stick() {
  Solids made = in_right_hand();
  const Frame hand = fist();
  constexpr double tip = mannequin::stick_length;
  made.coat = {};
  made.rod(hand, std::array{dvec3(0, 0, 0), dvec3(0, 0.4 * tip, 0), dvec3(0, tip - 0.03, 0)}, 0.0095, 7);
  made.rod(hand,
           std::array{dvec3(-0.062, 0.016, 0), dvec3(-0.052, 0.004, 0), dvec3(-0.02, -0.002, 0), dvec3(0.03, 0, 0),
                      dvec3(0.066, 0.006, 0)},
           0.0125, 7);
  made.coat = {Region::untinted, black};
  made.rod(hand, std::array{dvec3(0, tip - 0.035, 0), dvec3(0, tip, 0)}, 0.014, 7);
  made.coat = {Region::untinted, steel};
  made.rod(hand, std::array{dvec3(0, 0.030, 0), dvec3(0, 0.044, 0)}, 0.0112, 7);
  return made.skin();
}

/// The camera's own axes in the hand: x to its right side as seen from behind, y up, z from the lens to the face.
Frame camera_frame() {
  const glm::dquat hand = mannequin::hand_at_camera(mannequin::Side::right, {-1, 0, 0}, {0, 0, -1}, {0, 1, 0});
  const glm::dmat3 back = glm::mat3_cast(glm::inverse(hand));
  dvec3 held = mannequin::camera_in_hand();
  held.x = -held.x;
  const dvec3 middle = right_hand().origin + held + back * dvec3(mannequin::hand_from_camera, 0, 0);
  return {middle, back};
}

Skin camera() {
  Solids made = in_right_hand();
  const Frame body = camera_frame();  // x to the wearer's left, y up, z forwards
  made.coat = {Region::untinted, black};
  made.box(body, {0.132, 0.078, 0.048}, 0.010);
  made.box(body.moved({0, 0.046, -0.002}), {0.052, 0.026, 0.044}, 0.008, {0.7, 0.8});
  made.box(body.moved({-0.050, -0.002, 0.018}), {0.026, 0.074, 0.040}, 0.010);
  const Frame lens = body.turned({1, 0, 0}, {0, 0, 1});
  made.turn(lens,
            std::array{dvec2(0.034, 0.020), dvec2(0.034, 0.050), dvec2(0.031, 0.054), dvec2(0.031, 0.080),
                       dvec2(0.035, 0.084), dvec2(0.035, 0.100), dvec2(0.030, 0.102)},
            14);
  made.coat = {Region::untinted, dvec3(0.09, 0.10, 0.16)};
  made.turn(lens, std::array{dvec2(0.029, 0.101), dvec2(0.028, 0.1035), dvec2(0.015, 0.1045), dvec2(0, 0.105)}, 14);
  made.coat = {};
  made.turn(lens, std::array{dvec2(0.0345, 0.058), dvec2(0.0358, 0.060), dvec2(0.0358, 0.066), dvec2(0.0345, 0.068)},
            14);
  made.coat = {Region::untinted, steel};
  made.turn(body.moved({-0.046, 0.040, 0.004}),
            std::array{dvec2(0.008, 0), dvec2(0.008, 0.006), dvec2(0.007, 0.007), dvec2(0, 0.0072)}, 8);
  return made.skin();
}

Skin balloon() {
  Solids made = in_right_hand();
  const Frame up = upright();
  made.coat = {Region::untinted, paper};
  std::vector<dvec3> string;
  for (int i = 0; i <= 8; ++i) {
    const double t = i / 8.0;
    string.emplace_back(0.018 * std::sin(5.0 * t) * t, -0.09 + 1.05 * t, 0.012 * std::sin(3.3 * t));
  }
  made.rod(up, string, 0.0022, 3);
  made.coat = {};
  const Frame air = up.moved(string.back());
  std::vector<dvec2> outline{{0, -0.012}, {0.016, -0.010}, {0.009, 0.004}, {0.012, 0.014}};
  constexpr int rings = 9;
  for (int i = 1; i <= rings; ++i) {
    const double angle = pi * (-0.44 + 0.94 * i / rings);
    // A drop: its lower half is longer.
    const double height = angle < 0 ? 0.205 * std::sin(angle) : 0.155 * std::sin(angle);
    outline.emplace_back(i == rings ? 0.0 : 0.140 * std::cos(angle), 0.215 + height);
  }
  made.turn(air, outline, 16);
  return made.skin();
}

Skin flag() {
  Solids made = in_right_hand();
  const Frame up = upright();
  made.coat = {Region::untinted, wood};
  made.rod(up, std::array{dvec3(0, -0.13, 0), dvec3(0, 0.3, 0), dvec3(0, 0.72, 0)}, 0.007);
  made.turn(up.moved({0, 0.71, 0}),
            std::array{dvec2(0.006, 0), dvec2(0.012, 0.010), dvec2(0.007, 0.022), dvec2(0, 0.026)}, 8);
  for (int stripe = 0; stripe < 3; ++stripe) {
    made.coat = {Region::thing, dvec3(1), stripe == 1 ? 1.0 : 0.0};
    made.cloth(up, 8, 1, [stripe](double u, double v) {
      const double down = (stripe + v) / 3;
      const double wave = 0.040 * std::sin(7.5 * u + 1.1 * down) * u;
      return dvec3(wave, 0.695 - 0.32 * down - 0.05 * u * u, -0.006 - 0.47 * u);
    });
  }
  return made.skin();
}

}  // namespace

std::vector<Part> hand_things() {
  return {{.name = "umbrella", .slot = Slot::hand_right, .tags = {"rain"}, .make = umbrella},
          {.name = "phone", .slot = Slot::hand_right, .make = phone},
          {.name = "cup", .slot = Slot::hand_right, .make = cup},
          {.name = "stick", .slot = Slot::hand_right, .bodies = Fits::adults, .tags = {"old"}, .make = stick},
          {.name = "camera", .slot = Slot::hand_right, .make = camera},
          {.name = "balloon", .slot = Slot::hand_right, .tags = {"child", "party"}, .make = balloon},
          {.name = "flag", .slot = Slot::hand_right, .tags = {"party"}, .make = flag}};
}

}  // namespace throng::wardrobe
