#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "assets/mannequin/curve.h"
#include "assets/wardrobe/hair.h"
#include "assets/wardrobe/head_surface.h"
#include "assets/wardrobe/make.h"
#include "assets/wardrobe/part.h"

namespace throng::wardrobe {
namespace {

using glm::dvec3;
using mannequin::CurveKey;
using mannequin::Skin;

/// Hair that hangs: a cap with a parting, and below the ears a curtain down to `bottom`.
struct Curtain {
  double bottom;       ///< Height where it ends at the back.
  double side_bottom;  ///< The same at the sides, where it is open in front.
  double fringe;       ///< Row where it ends over the forehead; beyond the hairline there is none.
  double flare;        ///< Metres that its end stands further out.
  double opens;        ///< Degrees from the front where the curtain begins.
  std::function<double(double angle)> hat_edge = {};  ///< The row below which it comes out of a hat; none: of no hat.
};

/// Locks: how far hair stands out, or hangs down, -1 to 1.
double lock(double angle) { return std::sin(angle * 0.34 + 1.3 * std::sin(angle * 0.13)); }

constexpr double parted_at = 20;  // degrees

std::vector<HairPoint> curtain_column(const Curtain& curtain, double angle) {
  const double side = std::abs(angle);
  const double hangs = glm::smoothstep(curtain.opens - 8, curtain.opens + 10, side);
  const bool below_hat = static_cast<bool>(curtain.hat_edge);
  // Without a fringe it leaves the forehead free below the parting.
  const double swept = curtain.fringe > 12 ? 0.6 * std::exp(-std::pow((angle - parted_at) / 22, 2.0)) : 0;
  const double root_row = below_hat
                              ? curtain.hat_edge(angle) + 0.5
                              : glm::mix(curtain.fringe + swept, 11.2, glm::smoothstep(40.0, curtain.opens + 4, side));
  const double back = glm::smoothstep(80.0, 135.0, side);
  const double bottom = glm::mix(curtain.side_bottom, curtain.bottom, back) + 0.008 * lock(2.3 * angle);
  std::vector<HairPoint> points;
  const auto on_head = [&](double row, double out) { return head_point(angle, row) + head_normal(angle, row) * out; };
  constexpr int hanging_rings = 7;
  const double over_ear = 0.007 * std::exp(-std::pow((side - 98) / 20, 2.0));
  const dvec3 top = on_head(root_row, (below_hat ? 0.004 : 0.015) + over_ear);
  for (int ring = -2; ring < hanging_rings; ++ring) {
    const double share = static_cast<double>(hanging_rings - std::max(ring, 0)) / hanging_rings;
    const double y = glm::mix(top.y, glm::mix(top.y - 0.012, bottom, hangs), share);
    const double turn = angle * std::numbers::pi / 180;
    // Down the sides of the head, then straight, a little out at the end; behind the back of who wears a coat.
    const double out = 0.004 * std::sin(share * std::numbers::pi) + curtain.flare * share * share +
                       0.0030 * lock(1.9 * angle) * share + (below_hat ? 0.011 * glm::smoothstep(0.1, 0.4, share) : 0);
    dvec3 place(top.x + std::sin(turn) * out, y, top.z - std::abs(std::cos(turn)) * out * (side > 90 ? 1 : -0.3));
    const double tapers = glm::smoothstep(1.66, 1.56, y) * glm::smoothstep(95.0, 70.0, side);
    place.x *= 1 - 0.17 * tapers;
    if (side > 80) {
      const double down = glm::smoothstep(1.56, 1.42, y);
      place.z = glm::mix(place.z, std::min(place.z, -0.128), down * back);
      place.x *= glm::mix(1.0, 0.94, down);
    }
    if (hangs < 0.5) place = on_head(root_row, glm::mix(0.016, 0.004, share));
    const dvec3 paint = strand_paint(angle, 1 - share) * glm::mix(1.0, 0.86, share);
    if (ring < 0) {
      // The inner side, which shows where hair stands off the cheek.
      const dvec3 root = on_head(root_row - 0.6 * hangs, -0.003);
      const dvec3 end = place - dvec3(0.012 * std::sin(turn), -0.004, 0.012 * std::cos(turn));
      points.push_back({ring == -2 || hangs < 0.5 ? root : end, dvec3(0.5)});
    } else {
      points.push_back({place, paint});
    }
  }
  if (below_hat) {
    points.push_back({on_head(root_row + 0.4, 0.0), dvec3(0.7)});
    return points;
  }
  constexpr int cap_rings = 6;
  for (int ring = 0; ring < cap_rings; ++ring) {
    const double row = glm::mix(root_row, head_row::crown, static_cast<double>(ring) / cap_rings);
    const double parting = std::exp(-std::pow((angle - parted_at) / 9, 2.0)) * glm::smoothstep(12.0, 13.0, row);
    const double out = 0.015 + over_ear * glm::smoothstep(14.0, 11.0, row) + 0.004 * glm::smoothstep(11.0, 13.5, row) -
                       0.009 * parting + 0.0015 * lock(1.9 * angle);
    points.push_back({on_head(row, out), strand_paint(angle, 1) * (1 - 0.42 * parting)});
  }
  points.push_back({head_point(0, head_row::crown) + dvec3(0, 0.014, 0), dvec3(0.85)});
  return points;
}

Skin curtain_hair(const Curtain& curtain) {
  HairPlan plan;
  plan.columns = 36;
  plan.column = [&](double angle) { return curtain_column(curtain, angle); };
  return hair_surface(plan);
}

Skin bob() { return curtain_hair({1.565, 1.575, 12.6, 0.010, 62}); }
Skin bob_with_fringe() { return curtain_hair({1.570, 1.575, 11.55, 0.006, 60}); }
Skin long_straight() { return curtain_hair({1.360, 1.500, 12.7, 0.004, 66}); }

/// Hair combed back tightly, so that what is tied shows.
Skin combed_back() {
  return hair_cap([](double angle) { return hairline(angle); },
                  [](double angle, double row) {
                    return glm::mix(0.006, 0.011, glm::smoothstep(10.0, 13.0, row)) *
                           (1 + 0.08 * std::sin(angle * 0.6));
                  },
                  6, 28);
}

Skin ponytail() {
  Skin skin = combed_back();
  append(skin, tied_tail());
  return skin;
}

Skin bun() {
  Skin skin = combed_back();
  std::vector<dvec3> places;
  std::vector<double> radii;
  constexpr int steps = 7;
  for (int i = 0; i <= steps; ++i) {
    const double turn = std::numbers::pi * (i + 0.4) / (steps + 0.8);
    places.emplace_back(dvec3(0, 1.755, -0.105) + dvec3(0, 0.55, -0.83) * (0.034 * (1 - std::cos(turn)) - 0.008));
    radii.push_back(0.038 * std::sin(turn));
  }
  append(skin, hair_tube(places, radii, 12));
  return skin;
}

Skin pigtails() {
  Skin skin = combed_back();
  for (const double side : {1.0, -1.0}) {
    append(skin, hair_tube({{side * 0.062, 1.700, -0.055},
                            {side * 0.088, 1.705, -0.062},
                            {side * 0.106, 1.680, -0.064},
                            {side * 0.112, 1.640, -0.060},
                            {side * 0.110, 1.600, -0.054},
                            {side * 0.106, 1.572, -0.050}},
                           {0.010, 0.014, 0.022, 0.025, 0.019, 0.004}, 8));
  }
  return skin;
}

/// A plait down the back: beads that grow smaller.
Skin plait() {
  Skin skin = combed_back();
  constexpr std::array<CurveKey, 5> depth{
      {{1.36, -0.142}, {1.45, -0.142}, {1.55, -0.136}, {1.62, -0.142}, {1.68, -0.128}}};
  std::vector<dvec3> places;
  std::vector<double> radii;
  constexpr int beads = 8;
  for (int i = 0; i <= beads * 3; ++i) {
    const double share = static_cast<double>(i) / (beads * 3);
    const double y = glm::mix(1.670, 1.380, share);
    places.emplace_back(0, y, mannequin::open_curve(depth, y));
    const double bead = i % 3 == 0 ? 0.72 : 1.0;
    radii.push_back(glm::mix(0.022, 0.014, share) * bead);
  }
  radii.back() = 0.003;
  append(skin, hair_tube(places, radii, 8));
  return skin;
}

}  // namespace

Skin hair_below_hat(const std::function<double(double)>& edge, double bottom, double side_bottom) {
  const Curtain curtain{bottom, side_bottom, 0, 0.006, 68, edge};
  HairPlan plan;
  plan.from = 62;
  plan.to = 298;
  plan.columns = 22;
  plan.closed_top = false;
  plan.column = [&](double angle) { return curtain_column(curtain, angle > 180 ? angle - 360 : angle); };
  return hair_surface(plan);
}

Skin tied_tail() {
  return hair_tube({{0, 1.722, -0.108},
                    {0, 1.725, -0.133},
                    {0, 1.704, -0.153},
                    {0, 1.655, -0.158},
                    {0, 1.600, -0.157},
                    {0, 1.545, -0.150},
                    {0, 1.500, -0.148}},
                   {0.016, 0.019, 0.025, 0.029, 0.026, 0.018, 0.004});
}

std::vector<Part> long_hair() {
  return {{"bob", Slot::hair, Fits::women_and_children, {}, {"long"}, {}, bob},
          {"bob_with_fringe", Slot::hair, Fits::women_and_children, {}, {"long"}, {}, bob_with_fringe},
          {"long_straight", Slot::hair, Fits::women_and_children, {}, {"long"}, {}, long_straight},
          {"ponytail", Slot::hair, Fits::women_and_children, {}, {"tied"}, {}, ponytail},
          {"bun", Slot::hair, Fits::all, {}, {"tied"}, {}, bun},
          {"pigtails", Slot::hair, Fits::child, {}, {"tied"}, {}, pigtails},
          {"plait", Slot::hair, Fits::women_and_children, {}, {"tied"}, {}, plait}};
}

}  // namespace throng::wardrobe
