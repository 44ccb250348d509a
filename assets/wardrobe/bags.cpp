#include <array>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "assets/mannequin/clip.h"
#include "assets/mannequin/held.h"
#include "assets/wardrobe/make.h"
#include "assets/wardrobe/part.h"
#include "assets/wardrobe/solids.h"

namespace throng::wardrobe {
namespace {

using glm::dvec2;
using glm::dvec3;
using mannequin::Region;
using mannequin::Skin;

constexpr dvec3 brass{0.42, 0.28, 0.08};
constexpr dvec3 rubber{0.03, 0.03, 0.033};
constexpr dvec3 metal{0.45, 0.46, 0.48};

/// Returns the axes of a thing that hangs from a fist while an arm carries it: x ahead, y up, z away from the body. The
/// origin is in the handle.
Frame hanging_fist() {
  const dvec3 held = mannequin::handle_in_hand();
  const mannequin::ArmFrame& arm = mannequin::left_arm();
  const mannequin::WorldPose posed = mannequin::world_pose(mannequin::make_carry().pose(0));
  const glm::dmat3 at_rest = glm::mat3_cast(glm::inverse(posed[mannequin::joint_index("hand.R")].rotation));
  const Frame handle =
      right_hand().moved({glm::dot(held, arm.thumbwards), glm::dot(held, arm.along), -glm::dot(held, arm.backwards)});
  return {handle.origin, at_rest * glm::dmat3(dvec3(0, 0, 1), dvec3(0, 1, 0), dvec3(-1, 0, 0))};
}

Solids carried() { return Solids(mannequin::bind({{"hand.R", 1}})); }

/// A handle that rises from two places of a bag's upper edge to the fist.
void add_handle(Solids& made, const Frame& fist, double foot, double drop, double aside, double radius) {
  made.rod(fist,
           std::array{dvec3(-foot, -drop, aside), dvec3(-0.94 * foot, -0.62 * drop, 0.8 * aside),
                      dvec3(-0.66 * foot, -0.24 * drop, 0.4 * aside), dvec3(-0.34 * foot, -0.04 * drop, 0.1 * aside),
                      dvec3(0, 0, 0.0), dvec3(0.34 * foot, -0.04 * drop, 0.1 * aside),
                      dvec3(0.66 * foot, -0.24 * drop, 0.4 * aside), dvec3(0.94 * foot, -0.62 * drop, 0.8 * aside),
                      dvec3(foot, -drop, aside)},
           radius, 6);
}

Skin handbag() {
  Solids made = carried();
  const Frame fist = hanging_fist();
  made.coat = {};
  made.box(fist.moved({0, -0.225, 0}), {0.285, 0.190, 0.105}, 0.030, {0.80, 0.55});
  made.coat.trim = 1;
  made.box(fist.moved({0, -0.170, 0.030}), {0.235, 0.095, 0.030}, 0.012, {1.0, 0.6});
  for (const double aside : {-0.022, 0.022}) add_handle(made, fist, 0.085, 0.140, aside, 0.0055);
  made.coat = {Region::untinted, brass};
  made.box(fist.moved({0, -0.205, 0.046}), {0.030, 0.022, 0.008}, 0.003);
  return made.skin();
}

Skin tote() {
  Solids made = carried();
  const Frame fist = hanging_fist();
  made.box(fist.moved({0, -0.330, 0}), {0.340, 0.330, 0.075}, 0.024, {1.04, 0.42});
  made.coat.trim = 1;
  for (const double aside : {-0.013, 0.013}) add_handle(made, fist, 0.080, 0.185, aside, 0.0065);
  return made.skin();
}

Skin shopping_bag() {
  Solids made = carried();
  const Frame fist = hanging_fist();
  made.box(fist.moved({0, -0.300, 0}), {0.300, 0.330, 0.110}, 0.004);
  made.coat = {Region::untinted, dvec3(0.03)};
  made.box(fist.moved({0, -0.134, 0}), {0.284, 0.004, 0.094}, 0.002);
  made.coat = {Region::thing, dvec3(1), 1};
  made.box(fist.moved({0, -0.310, 0.0555}), {0.120, 0.090, 0.002}, 0.001);
  made.box(fist.moved({0, -0.310, -0.0555}), {0.120, 0.090, 0.002}, 0.001);
  for (const double aside : {-0.050, 0.050}) add_handle(made, fist, 0.060, 0.140, aside, 0.0035);
  return made.skin();
}

Skin briefcase() {
  Solids made = carried();
  const Frame fist = hanging_fist();
  made.box(fist.moved({0, -0.195, 0}), {0.410, 0.290, 0.092}, 0.016);
  made.coat.trim = 1;
  made.box(fist.moved({0, -0.195, 0}), {0.414, 0.282, 0.012}, 0.004);
  made.rod(fist,
           std::array{dvec3(-0.062, -0.055, 0), dvec3(-0.058, -0.012, 0), dvec3(-0.04, 0, 0), dvec3(0.04, 0, 0),
                      dvec3(0.058, -0.012, 0), dvec3(0.062, -0.055, 0)},
           0.009, 7);
  made.coat = {Region::untinted, brass};
  for (const double along : {-0.125, 0.125}) made.box(fist.moved({along, -0.062, 0.042}), {0.032, 0.030, 0.012}, 0.003);
  return made.skin();
}

/// A place on the man's shirt, lifted by so much. It is a mean over the neighbourhood, so that a strap runs smoothly.
dvec3 on_shirt(dvec3 near, double lift) {
  dvec3 sum(0);
  double weight = 0;
  for (const mannequin::SkinPoint& point : man_skin().points) {
    const double away = glm::distance(point.position, near) / 0.030;
    const double share = std::exp(-away * away);
    sum += share * point.position;
    weight += share;
  }
  const dvec3 place = sum / weight;
  const dvec3 middle(0, near.y < 1.44 ? near.y : 1.40, -0.015);
  return place + lift * glm::normalize(place - middle);
}

void add_shoulder_strap(Solids& made, double side) {
  const std::array<dvec3, 10> guide{{{0.085, 1.415, -0.150},
                                     {0.098, 1.470, -0.085},
                                     {0.105, 1.490, -0.020},
                                     {0.108, 1.465, 0.045},
                                     {0.112, 1.400, 0.095},
                                     {0.125, 1.310, 0.118},
                                     {0.145, 1.225, 0.095},
                                     {0.165, 1.165, 0.035},
                                     {0.160, 1.120, -0.040},
                                     {0.110, 1.080, -0.120}}};
  std::vector<dvec3> way;
  std::vector<dvec3> across;
  for (const dvec3 at : guide) {
    const dvec3 lifted = on_shirt(at, 0.028);
    way.emplace_back(side * lifted.x, lifted.y, lifted.z);
    across.emplace_back(1, 0, 0);
  }
  way.insert(way.begin(), {side * 0.078, 1.405, -0.165});
  way.emplace_back(side * 0.118, 1.062, -0.160);
  across.resize(way.size(), dvec3(1, 0, 0));
  // Beside the ribs the strap stands upright.
  for (std::size_t i = 7; i < across.size(); ++i) across[i] = dvec3(0.25 * side, 1, 0);
  made.strap(way, across, 0.046, 0.010, [](dvec3 place) { return weights_at(place, {Slot::torso}); });
}

Skin backpack() {
  Solids made(mannequin::bind({{"upper_chest", 0.7}, {"chest", 0.3}}));
  const Frame back{{0, 1.235, -0.206}, glm::dmat3(1)};
  made.box(back, {0.300, 0.430, 0.150}, 0.055, {0.86, 0.80});
  made.box(back.moved({0, 0.195, 0.010}), {0.230, 0.070, 0.130}, 0.030, {0.75, 0.75});
  made.coat.trim = 1;
  made.box(back.moved({0, -0.080, -0.085}), {0.225, 0.220, 0.060}, 0.026, {0.94, 0.80});
  for (const double side : {-1.0, 1.0}) {
    made.coat = {Region::thing, dvec3(1), 1};
    made.box(back.moved({0.150 * side, -0.120, 0.0}), {0.045, 0.150, 0.100}, 0.018);
    made.coat = {Region::untinted, rubber};
    add_shoulder_strap(made, side);
  }
  made.rod(back,
           std::array{dvec3(-0.035, 0.215, 0.055), dvec3(-0.02, 0.245, 0.06), dvec3(0.02, 0.245, 0.06),
                      dvec3(0.035, 0.215, 0.055)},
           0.007);
  return made.skin();
}

void add_wheel(Solids& made, const Frame& ground, dvec3 hub, double radius) {
  const Frame axle = ground.moved(hub).turned({0, 1, 0}, {1, 0, 0});
  made.coat = {Region::untinted, rubber};
  made.turn(axle,
            std::array{dvec2(0.72 * radius, -0.017), dvec2(0.97 * radius, -0.015), dvec2(0.97 * radius, 0.015),
                       dvec2(0.72 * radius, 0.017)},
            12);
  made.coat = {Region::untinted, metal};
  made.turn(axle, std::array{dvec2(0.70 * radius, -0.0185), dvec2(0.70 * radius, 0.0185)}, 10);
}

/// Rolls ahead of whoever holds its bar.
Skin pushchair() {
  Solids made(mannequin::bind({{"root", 1}}));
  const Frame ground{{0, 0, 0.09}, glm::dmat3(1)};  // so that no foot meets a wheel
  constexpr double bar_y = mannequin::bar_height;
  const double bar_z = mannequin::bar_ahead - ground.origin.z;
  made.coat = {Region::untinted, metal};
  for (const double side : {-1.0, 1.0}) {
    const double x = 0.235 * side;
    made.rod(ground,
             std::array{dvec3(x, bar_y, bar_z), dvec3(x, 0.80, 0.60), dvec3(x, 0.30, 1.00), dvec3(x, 0.11, 1.16)},
             0.012, 5);
    made.rod(ground, std::array{dvec3(x, 0.62, 0.745), dvec3(x, 0.30, 0.68), dvec3(x, 0.13, 0.66)}, 0.011, 5);
    made.rod(ground, std::array{dvec3(x, 0.42, 0.905), dvec3(x, 0.40, 0.70)}, 0.009, 4);
  }
  made.rod(ground, std::array{dvec3(-0.235, 0.13, 0.66), dvec3(0.235, 0.13, 0.66)}, 0.009, 4);
  made.coat = {Region::untinted, rubber};
  made.rod(ground, std::array{dvec3(-0.245, bar_y, bar_z), dvec3(0.245, bar_y, bar_z)}, 0.016, 6);
  for (const double side : {-1.0, 1.0}) {
    add_wheel(made, ground, {0.250 * side, 0.13, 0.66}, 0.130);
    add_wheel(made, ground, {0.215 * side, 0.10, 1.16}, 0.100);
  }
  made.coat = {};
  const Frame seat = ground.moved({0, 0.455, 0.86}).turned({1, 0, 0}, {0, 1, 0.22});
  made.box(seat, {0.400, 0.070, 0.330}, 0.028);
  const Frame rest = ground.moved({0, 0.665, 0.690}).turned({1, 0, 0}, {0, 1, -0.42});
  made.box(rest, {0.400, 0.480, 0.060}, 0.028);
  for (const double side : {-1.0, 1.0}) {
    made.box(ground.moved({0.208 * side, 0.540, 0.820}), {0.030, 0.150, 0.320}, 0.013);
  }
  made.box(ground.moved({0, 0.300, 1.100}), {0.300, 0.030, 0.120}, 0.012);
  made.coat.trim = 1;
  // The hood is a quarter of a drum over the seat's back.
  made.cloth(ground.moved({0, 0.800, 0.660}), 8, 4, [](double u, double v) {
    const double angle = 3.14159265 * u;
    const double swung = -0.35 + 1.75 * v;
    const double out = 0.225;
    const double high = 0.215 * std::sin(angle);
    return dvec3(-out * std::cos(angle), high * std::cos(swung) + 0.02 * (1 - v),
                 (0.05 + high) * std::sin(swung) * 1.25);
  });
  return made.skin();
}

}  // namespace

std::vector<Part> bags() {
  return {
      {.name = "backpack", .slot = Slot::back, .make = backpack},
      {.name = "handbag", .slot = Slot::hand_right, .bodies = Fits::woman, .make = handbag},
      {.name = "tote", .slot = Slot::hand_right, .bodies = Fits::adults, .make = tote},
      {.name = "shopping_bag", .slot = Slot::hand_right, .bodies = Fits::adults, .make = shopping_bag},
      {.name = "briefcase", .slot = Slot::hand_right, .bodies = Fits::adults, .tags = {"formal"}, .make = briefcase},
      {.name = "pushchair", .slot = Slot::hand_right, .bodies = Fits::adults, .make = pushchair}};
}

}  // namespace throng::wardrobe
