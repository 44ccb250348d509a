#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "assets/wardrobe/hair.h"
#include "assets/wardrobe/head_surface.h"
#include "assets/wardrobe/make.h"
#include "assets/wardrobe/part.h"

namespace throng::wardrobe {
namespace {

using glm::dvec3;
using mannequin::Skin;

double front_share(double angle) { return glm::smoothstep(70.0, 20.0, std::abs(angle)); }

double strands(double angle, double row) {
  return 1 + 0.09 * std::sin(angle * 0.35 + row) + 0.07 * std::sin(angle * 0.81 - 2 * row);
}

Skin cropped() {
  return hair_cap(
      hairline, [](double, double row) { return glm::mix(0.0025, 0.0055, glm::smoothstep(8.0, 13.0, row)); }, 6, 26);
}

Skin short_cut() {
  return hair_cap([](double angle) { return hairline(angle) - 0.25 * front_share(angle); },
                  [](double angle, double row) {
                    const double top = glm::smoothstep(11.0, 13.5, row);
                    return glm::mix(0.007, 0.016, top) * strands(angle, row) +
                           0.012 * front_share(angle) * glm::smoothstep(14.8, 13.2, row);
                  });
}

Skin side_parting() {
  return hair_cap(
      [](double angle) { return hairline(angle) - 0.55 * glm::smoothstep(10.0, -30.0, angle) * front_share(angle); },
      [](double angle, double row) {
        const double top = glm::smoothstep(10.8, 13.0, row);
        const double parting = std::exp(-std::pow((angle - 38) / 9, 2.0)) * top * glm::smoothstep(15.6, 14.6, row);
        const double swept = glm::smoothstep(40.0, -40.0, angle) * front_share(angle);
        return (glm::mix(0.008, 0.019, top) + 0.011 * swept * top * glm::smoothstep(15.9, 14.6, row)) *
                   strands(angle, row) -
               0.013 * parting;
      },
      8, 32);
}

Skin swept_back() {
  return hair_cap([](double angle) { return hairline(angle) + 0.15 * front_share(angle); },
                  [](double angle, double row) {
                    const double top = glm::smoothstep(11.2, 13.2, row);
                    const double comb = 1 + 0.10 * std::sin(angle * 0.7) * top;
                    return glm::mix(0.005, 0.022, top) * comb;
                  },
                  8, 32);
}

Skin curly() {
  return hair_cap([](double angle) { return hairline(angle) - 0.15; },
                  [](double angle, double row) {
                    const double top = glm::smoothstep(8.5, 12.5, row);
                    const double curls = std::sin(angle * 0.21 + 2.4 * row) * std::sin(angle * 0.17 - 3.1 * row + 1);
                    return glm::mix(0.014, 0.034, top) + 0.006 * curls;
                  },
                  9, 34);
}

Skin afro() {
  HairPlan plan;
  plan.columns = 32;
  plan.column = [](double angle) {
    std::vector<HairPoint> points;
    const double low = hairline(angle) - 0.1;
    const dvec3 root = head_point(angle, low) - head_normal(angle, low) * 0.003;
    points.push_back({root, dvec3(0.5)});
    // A ball around the upper head, from the hairline to its top.
    const dvec3 middle(0, 1.735, -0.025);
    const double turn = angle * std::numbers::pi / 180;
    const double lowest = glm::mix(-0.75, 0.28, 0.5 + 0.5 * std::cos(turn));
    constexpr int rings = 9;
    for (int ring = 0; ring <= rings; ++ring) {
      const double lift = glm::mix(lowest, std::numbers::pi / 2, static_cast<double>(ring) / rings);
      const double curls = 0.004 * std::sin(angle * 0.21 + 6 * lift) * std::sin(angle * 0.19 - 7 * lift + 1);
      const double radius = 0.122 + (ring == rings ? 0.0 : curls);
      const dvec3 out(std::sin(turn) * std::cos(lift), std::sin(lift) * 0.92, std::cos(turn) * std::cos(lift));
      points.push_back({middle + out * radius, dvec3(0.86 + 30 * curls)});
    }
    return points;
  };
  return hair_surface(plan);
}

/// Bald on top: a band from ear to ear around the back.
Skin bald_with_fringe() {
  HairPlan plan;
  plan.from = 68;
  plan.to = 292;
  plan.columns = 24;
  plan.closed_top = false;
  plan.column = [](double angle) {
    const double folded = angle > 180 ? angle - 360 : angle;
    const double end = glm::smoothstep(66.0, 84.0, std::abs(folded));
    const double low = hairline(folded);
    const double high = glm::mix(low + 0.4, 12.2 - 0.5 * glm::smoothstep(120.0, 180.0, std::abs(folded)), end);
    std::vector<HairPoint> points;
    constexpr int rings = 5;
    for (int ring = 0; ring <= rings; ++ring) {
      const double share = static_cast<double>(ring) / rings;
      const double row = glm::mix(low, high, share);
      const double out = ring == 0 || ring == rings ? -0.003 : 0.009 * end * strands(folded, row) * (1 - 0.4 * share);
      points.push_back({head_point(folded, row) + head_normal(folded, row) * out, strand_paint(folded, share)});
    }
    return points;
  };
  return hair_surface(plan);
}

}  // namespace

std::vector<Part> short_hair() {
  return {{"cropped", Slot::hair, Fits::all, {}, {"short"}, {}, cropped},
          {"short_cut", Slot::hair, Fits::all, {}, {"short"}, {}, short_cut},
          {"side_parting", Slot::hair, Fits::all, {}, {"short"}, {}, side_parting},
          {"swept_back", Slot::hair, Fits::adults, {}, {"short"}, {}, swept_back},
          {"curly", Slot::hair, Fits::all, {}, {"short", "curly"}, {}, curly},
          {"afro", Slot::hair, Fits::all, {}, {"short", "curly"}, {}, afro},
          {"bald_with_fringe", Slot::hair, Fits::man, {}, {"short", "old"}, {}, bald_with_fringe}};
}

}  // namespace throng::wardrobe
