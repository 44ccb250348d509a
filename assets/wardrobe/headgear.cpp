#include <algorithm>
#include <array>
#include <cmath>
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
using mannequin::Region;
using mannequin::Skin;

dvec3 off_head(double angle, double row, double out) { return head_point(angle, row) + head_normal(angle, row) * out; }

double in_front(double angle) { return 0.5 + 0.5 * std::cos(angle * std::numbers::pi / 180); }

/// Returns the hair that shows below a hat: a band from ear to ear around the back, and sideburns.
Skin hair_below(double high_row) {
  HairPlan plan;
  plan.from = 60;
  plan.to = 300;
  plan.columns = 22;
  plan.closed_top = false;
  plan.column = [high_row](double angle) {
    const double folded = angle > 180 ? angle - 360 : angle;
    const double low = std::min(hairline(folded), high_row - 0.3);
    const double end = glm::smoothstep(60.0, 72.0, std::abs(folded));
    std::vector<HairPoint> points{{off_head(folded, low, -0.003), dvec3(0.6)}};
    for (int ring = 0; ring < 4; ++ring) {
      const double row = glm::mix(low + 0.1, high_row + 0.4, ring / 3.0);
      points.push_back({off_head(folded, row, 0.008 * end - 0.002 * (1 - end)), strand_paint(folded, ring / 3.0)});
    }
    return points;
  };
  return hair_surface(plan);
}

Skin with(Skin hat, const Skin& hair) {
  append(hat, hair);
  return hat;
}

/// A hat that lies close: from `low` over the head's top, `thick` metres off it; a hem at its edge.
Skin close_hat(const std::function<double(double)>& low, const std::function<double(double, double)>& thick,
               double hem_rows, dvec3 hem_paint) {
  HairPlan plan;
  plan.columns = 28;
  plan.region = Region::headgear;
  plan.column = [&](double angle) {
    const double from = low(angle);
    std::vector<HairPoint> points{{off_head(angle, from, 0.002), dvec3(0.6)},
                                  {off_head(angle, from, thick(angle, from)), hem_paint}};
    if (hem_rows > 0) {
      points.push_back({off_head(angle, from + hem_rows, thick(angle, from) + 0.001), hem_paint});
      points.push_back(
          {off_head(angle, from + hem_rows + 0.08, thick(angle, from + hem_rows) - 0.003), hem_paint * 0.8});
    }
    const double first = from + hem_rows + 0.3;
    constexpr int rings = 6;
    for (int ring = 0; ring < rings; ++ring) {
      const double row = glm::mix(first, head_row::crown, static_cast<double>(ring) / rings);
      points.push_back({off_head(angle, row, thick(angle, row)), dvec3(1)});
    }
    points.push_back({off_head(0, head_row::crown, thick(0, head_row::crown)), dvec3(1)});
    return points;
  };
  return hair_surface(plan);
}

/// A sheet around the head from an inner to an outer edge, with an upper and a lower side.
Skin brim(double from, double to, std::size_t columns, const std::function<dvec3(double angle, double share)>& place) {
  HairPlan plan;
  plan.from = from;
  plan.to = to;
  plan.columns = columns;
  plan.region = Region::headgear;
  plan.closed_top = false;
  plan.column = [&](double angle) {
    constexpr dvec3 thickness(0, 0.0035, 0);
    std::vector<HairPoint> points;
    for (const double share : {0.0, 0.5, 1.0}) points.push_back({place(angle, share), dvec3(0.62)});
    for (const double share : {1.0, 0.5, 0.0}) points.push_back({place(angle, share) + thickness, dvec3(1)});
    return points;
  };
  return hair_surface(plan);
}

double cap_edge(double angle) { return glm::mix(11.0, 12.25, in_front(angle)); }

Skin cap_alone() {
  Skin skin = close_hat(
      cap_edge,
      [](double angle, double row) {
        const double tall = glm::smoothstep(12.5, 14.5, row) * in_front(angle);
        return 0.010 + 0.010 * glm::smoothstep(12.0, 14.0, row) + 0.006 * tall;
      },
      0, dvec3(0.95));
  append(skin, brim(-62, 62, 14, [](double angle, double share) {
           const dvec3 root = off_head(angle, cap_edge(angle) + 0.12, 0.006);
           const double turn = angle / 62;
           const double reach = 0.072 * share * std::sqrt(std::max(0.0, 1 - std::pow(std::abs(turn), 3.0)));
           return root +
                  dvec3(0.02 * share * turn * (1 - turn * turn), -0.012 * share - 0.010 * share * turn * turn, reach);
         }));
  append(skin, hair_tube({{0, 1.806, -0.018}, {0, 1.812, -0.018}}, {0.006, 0.004}, 6, Region::headgear));
  return skin;
}

Skin baseball_cap() { return with(cap_alone(), hair_below(12.4)); }
Skin baseball_cap_with_tail() { return with(baseball_cap(), tied_tail()); }

double beanie_edge(double angle) { return glm::mix(9.7, 12.0, in_front(angle)); }

Skin beanie_alone() {
  const auto ribs = [](double angle) { return 1 + 0.05 * std::sin(angle * 1.4); };
  Skin skin = close_hat(
      beanie_edge,
      [&](double angle, double row) {
        const double top = glm::smoothstep(13.0, 15.5, row);
        return (0.012 + 0.012 * top) * ribs(angle);
      },
      1.3, dvec3(0.84));
  return skin;
}

Skin beanie() { return with(beanie_alone(), hair_below(11.6)); }
Skin beanie_with_long_hair() { return with(beanie_alone(), hair_below_hat(beanie_edge, 1.400, 1.490)); }

Skin with_bobble(const Skin& hat) {
  return with(
      hat,
      hair_tube({{0, 1.805, -0.020}, {0, 1.814, -0.020}, {0, 1.832, -0.020}, {0, 1.850, -0.020}, {0, 1.860, -0.020}},
                {0.008, 0.024, 0.030, 0.024, 0.006}, 10, Region::headgear));
}

Skin beanie_with_bobble() { return with_bobble(beanie()); }
Skin beanie_with_bobble_and_long_hair() { return with_bobble(beanie_with_long_hair()); }

double sun_hat_edge(double angle) { return glm::mix(11.0, 12.4, in_front(angle)); }

Skin sun_hat_alone() {
  const auto edge = sun_hat_edge;
  Skin skin = close_hat(
      edge, [](double, double row) { return 0.012 + 0.022 * glm::smoothstep(12.5, 14.5, row); }, 0.5,
      dvec3(0.55, 0.5, 0.5));
  append(skin, brim(-180, 180, 28, [&](double angle, double share) {
           const double turn = angle * std::numbers::pi / 180;
           const dvec3 root = off_head(angle, edge(angle), 0.010);
           const double wave = 0.006 * std::sin(3 * turn) * share;
           return root + dvec3(std::sin(turn), 0, std::cos(turn)) * (0.095 * share) +
                  dvec3(0, -0.030 * share * share + wave, 0);
         }));
  return skin;
}

Skin sun_hat() { return with(sun_hat_alone(), hair_below(12.4)); }
Skin sun_hat_with_long_hair() { return with(sun_hat_alone(), hair_below_hat(sun_hat_edge, 1.370, 1.500)); }

Skin flat_cap() {
  Skin skin = close_hat(
      cap_edge,
      [](double angle, double row) {
        const double side = 1 - std::abs(std::cos(angle * std::numbers::pi / 180));
        return 0.011 + (0.013 + 0.004 * side) * glm::smoothstep(11.8, 13.2, row) -
               0.012 * glm::smoothstep(14.2, 16.0, row);
      },
      0, dvec3(0.9));
  append(skin, brim(-55, 55, 12, [](double angle, double share) {
           const dvec3 root = off_head(angle, cap_edge(angle) + 0.15, 0.008);
           const double turn = angle / 55;
           return root + dvec3(0, -0.014 * share, 0.045 * share * std::sqrt(std::max(0.0, 1 - turn * turn)));
         }));
  append(skin, hair_below(12.4));
  return skin;
}

Skin helmet() {
  const auto edge = [](double angle) { return glm::mix(10.2, 12.3, in_front(angle)); };
  Skin skin = close_hat(
      edge,
      [](double angle, double row) {
        const double groove = std::pow(std::abs(std::cos(angle * 0.07854)), 8.0);
        return 0.024 + 0.008 * glm::smoothstep(12.0, 14.0, row) - 0.004 * groove;
      },
      0.35, dvec3(0.25));
  for (const double side : {1.0, -1.0}) {
    append(skin, hair_tube({off_head(side * 78, 10.9, 0.012), off_head(side * 72, 8.5, 0.004),
                            off_head(side * 50, 5.2, 0.004), off_head(side * 18, 3.6, 0.005), off_head(0, 3.5, 0.005)},
                           {0.004, 0.004, 0.004, 0.004, 0.004}, 6, Region::headgear));
  }
  append(skin, hair_below(12.2));
  return skin;
}

Skin helmet_with_tail() { return with(helmet(), tied_tail()); }

/// A scarf around the head: an egg that leaves the face open, and a cowl around neck and shoulders.
Skin headscarf() {
  HairPlan hood;
  hood.columns = 32;
  hood.region = Region::headgear;
  hood.column = [](double angle) {
    const double turn = angle * std::numbers::pi / 180;  // 0 at the top, around the face
    const double up = std::cos(turn);
    const dvec3 radius(0.0985, up > 0 ? glm::mix(0.112, 0.127, up) : glm::mix(0.112, 0.150, -up), 0.125);
    const double edge = glm::mix(up > 0 ? 0.86 : 0.98, 1.30, std::pow(std::abs(std::sin(turn)), 1.4));
    std::vector<HairPoint> points;
    constexpr int rings = 9;
    for (int ring = -1; ring <= rings; ++ring) {
      const double back = glm::mix(edge, std::numbers::pi, std::max(ring, 0) / static_cast<double>(rings));
      const double fold = 1 + 0.012 * std::sin(9 * turn + 3 * back) * std::sin(back);
      const dvec3 out = radius * dvec3(std::sin(back) * std::sin(turn), std::sin(back) * up, std::cos(back)) * fold;
      const dvec3 place = dvec3(0, 1.677, -0.008) + out * (ring < 0 ? 0.93 : 1.0);
      points.push_back({place, dvec3(ring < 0 ? 0.7 : 1.0)});
    }
    return points;
  };
  HairPlan cowl;
  cowl.columns = 32;
  cowl.region = Region::headgear;
  cowl.closed_top = false;
  cowl.column = [](double angle) {
    constexpr std::array<CurveKey, 5> width{
        {{1.43, 0.150}, {1.47, 0.112}, {1.51, 0.080}, {1.56, 0.074}, {1.60, 0.070}}};
    constexpr std::array<CurveKey, 5> front{
        {{1.43, 0.128}, {1.47, 0.104}, {1.51, 0.078}, {1.56, 0.074}, {1.60, 0.060}}};
    constexpr std::array<CurveKey, 5> behind{
        {{1.43, 0.146}, {1.47, 0.132}, {1.51, 0.112}, {1.56, 0.104}, {1.60, 0.090}}};
    const double turn = angle * std::numbers::pi / 180;
    std::vector<HairPoint> points;
    for (int ring = 0; ring < 8; ++ring) {
      const double y = glm::mix(1.432, 1.592, ring / 7.0);
      const double fold = 1 + 0.035 * std::sin(4 * turn + 30 * y) * (1 - ring / 7.0);
      const auto& depth = std::cos(turn) > 0 ? front : behind;
      const dvec3 place(mannequin::open_curve(width, y) * std::sin(turn) * fold, y,
                        -0.006 + mannequin::open_curve(depth, y) * std::cos(turn) * fold);
      points.push_back({place, dvec3(0.93 + 0.07 * std::sin(4 * turn + 30 * y))});
    }
    return points;
  };
  Skin skin = hair_surface(cowl);
  append(skin, hair_surface(hood));
  return skin;
}

}  // namespace

// Women have long hair below hats. A part may be listed more than once, for other bodies each time.
std::vector<Part> headgear() {
  constexpr Slot headgear = Slot::headgear;
  constexpr Fits others = Fits::men_and_children;
  const std::vector<Slot> hair{Slot::hair};
  return {{"cap", headgear, others, hair, {"sun", "casual", "short"}, {}, baseball_cap},
          {"cap", headgear, Fits::woman, hair, {"sun", "casual", "long"}, {}, baseball_cap_with_tail},
          {"flat_cap", headgear, Fits::man, hair, {"formal", "old", "short"}, {}, flat_cap},
          {"beanie", headgear, others, hair, {"cold", "casual", "short"}, {}, beanie},
          {"beanie", headgear, Fits::woman, hair, {"cold", "casual", "long"}, {}, beanie_with_long_hair},
          {"beanie_with_bobble", headgear, Fits::child, hair, {"cold", "short"}, {}, beanie_with_bobble},
          {"beanie_with_bobble", headgear, Fits::woman, hair, {"cold", "long"}, {}, beanie_with_bobble_and_long_hair},
          {"sun_hat", headgear, others, hair, {"sun", "short"}, {}, sun_hat},
          {"sun_hat", headgear, Fits::woman, hair, {"sun", "long"}, {}, sun_hat_with_long_hair},
          {"helmet", headgear, others, hair, {"safety", "short"}, {}, helmet},
          {"helmet", headgear, Fits::woman, hair, {"safety", "long"}, {}, helmet_with_tail},
          {"headscarf", headgear, Fits::woman, hair, {"modest"}, {}, headscarf}};
}

}  // namespace throng::wardrobe
