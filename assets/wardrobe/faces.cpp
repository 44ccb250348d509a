#include <array>
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
using mannequin::Region;
using mannequin::Skin;

/// Hair that lies on the face as its skin moves: from a lower to an upper row, thin at its edges.
Skin beard_patch(double reach, std::size_t columns, const std::function<double(double)>& low,
                 const std::function<double(double)>& high, double thick) {
  HairPlan plan;
  plan.from = -reach;
  plan.to = reach;
  plan.columns = columns;
  plan.closed_top = false;
  plan.column = [&](double angle) {
    std::vector<HairPoint> points;
    constexpr int rings = 6;
    const double end = 1 - std::pow(std::abs(angle) / reach, 6.0);
    for (int ring = 0; ring <= rings; ++ring) {
      const double share = static_cast<double>(ring) / rings;
      const double row = glm::mix(low(angle), high(angle), share);
      const double swell =
          ring == 0 || ring == rings ? -0.0015 : thick * end * std::sin(std::numbers::pi * (0.15 + 0.7 * share));
      points.push_back({head_point(angle, row) + head_normal(angle, row) * swell, strand_paint(angle * 2, share)});
    }
    return points;
  };
  Skin skin = hair_surface(plan);
  for (mannequin::SkinPoint& point : skin.points) {
    const HeadPlace place = face_place(point.position.x, point.position.y);
    point.weights = head_weights(point.position, std::min(std::abs(place.angle), 90.0), std::max(place.row, 5.0));
  }
  return skin;
}

Skin moustache() {
  return beard_patch(
      19, 10, [](double angle) { return 7.24 - 0.16 * std::pow(std::abs(angle) / 19, 2.0); },
      [](double angle) { return 7.88 - 0.42 * std::pow(std::abs(angle) / 19, 2.0); }, 0.0065);
}

Skin full_beard() {
  Skin skin = beard_patch(
      80, 22, [](double angle) { return 2.9 + 0.5 * glm::smoothstep(30.0, 80.0, std::abs(angle)); },
      [](double angle) {
        const double side = std::abs(angle);
        return glm::mix(6.45, 8.1, glm::smoothstep(14.0, 24.0, side)) + 2.0 * glm::smoothstep(52.0, 80.0, side);
      },
      0.0095);
  append(skin, moustache());
  return skin;
}

Skin goatee() {
  Skin skin = beard_patch(
      24, 10, [](double) { return 3.5; },
      [](double angle) { return glm::mix(6.4, 7.3, glm::smoothstep(12.0, 22.0, std::abs(angle))); }, 0.008);
  append(skin, moustache());
  return skin;
}

void add_box_ring(Skin& skin, const std::vector<std::array<dvec3, 4>>& sections, bool closed, Region region,
                  dvec3 paint) {
  const mannequin::Weights head = mannequin::bind({{"head", 1}});
  std::vector<std::array<std::size_t, 4>> rings;
  for (const auto& section : sections) {
    auto& ring = rings.emplace_back();
    for (std::size_t k = 0; k < 4; ++k) {
      ring[k] = skin.points.size();
      skin.points.push_back({.position = section[k], .weights = head});
    }
  }
  const std::size_t count = closed ? rings.size() : rings.size() - 1;
  for (std::size_t i = 0; i < count; ++i) {
    const auto& here = rings[i];
    const auto& there = rings[(i + 1) % rings.size()];
    for (std::size_t k = 0; k < 4; ++k) {
      const std::size_t next = (k + 1) % 4;
      skin.faces.push_back({{here[k], here[next], there[next], there[k]}, region, std::vector<dvec3>(4, paint)});
    }
  }
}

struct LensFrame {
  double half_width, half_height, bar;  ///< Metres.
  double boxy;                          ///< 1 is round, less is a rectangle.
};

dvec3 rim_place(const LensFrame& frame, double share, double grow) {
  const double turn = 2 * std::numbers::pi * share;
  const auto power = [&](double value) { return std::copysign(std::pow(std::abs(value), frame.boxy), value); };
  const double x = 0.0335 + frame.half_width * grow * power(std::cos(turn));
  const double y = 1.6745 + frame.half_height * grow * power(std::sin(turn));
  return {x, y, 0.1035 - 4.5 * (x - 0.012) * (x - 0.012)};
}

Skin glasses_of(const LensFrame& frame, bool dark) {
  Skin skin;
  const mannequin::Weights head = mannequin::bind({{"head", 1}});
  constexpr std::size_t around = 16;
  constexpr double depth = 0.003;
  for (const double side : {1.0, -1.0}) {
    const auto mirror = [side](dvec3 p) { return dvec3(p.x * side, p.y, p.z); };
    std::vector<std::array<dvec3, 4>> sections;
    std::vector<std::size_t> lens;
    for (std::size_t i = 0; i < around; ++i) {
      const double share = static_cast<double>(i) / around * side + (side < 0 ? 1.0 : 0.0);
      const dvec3 in = rim_place(frame, share, 1.0);
      const dvec3 out = rim_place(frame, share, 1 + frame.bar / frame.half_height);
      sections.push_back({mirror(out), mirror(in), mirror(in - dvec3(0, 0, depth)), mirror(out - dvec3(0, 0, depth))});
      if (!dark) continue;
      lens.push_back(skin.points.size());
      skin.points.push_back({.position = mirror(in - dvec3(0, 0, 0.001)), .weights = head});
    }
    if (dark) skin.faces.push_back({lens, Region::untinted, std::vector<dvec3>(around, dvec3(0.012, 0.013, 0.016))});
    add_box_ring(skin, sections, true, Region::thing, dvec3(1));
    const double y = 1.6745 + 0.5 * frame.half_height;
    const dvec3 hinge = rim_place(frame, 0.06, 1 + frame.bar / frame.half_height);
    std::vector<std::array<dvec3, 4>> temple;
    for (const dvec3& at : {dvec3(hinge.x, y, hinge.z), dvec3(0.0745, y + 0.004, 0.050),
                            dvec3(0.0805, y + 0.006, -0.008), dvec3(0.0800, y - 0.012, -0.030)}) {
      temple.push_back({mirror(at + dvec3(0.0012, 0.002, 0)), mirror(at + dvec3(0.0012, -0.002, 0)),
                        mirror(at + dvec3(-0.0012, -0.002, 0)), mirror(at + dvec3(-0.0012, 0.002, 0))});
    }
    if (side > 0) {
      for (auto& section : temple) std::swap(section[1], section[3]);
    }
    add_box_ring(skin, temple, false, Region::thing, dvec3(1));
  }
  const dvec3 left = rim_place(frame, 0.44, 1.02);
  const double y = left.y + 0.002;
  std::vector<std::array<dvec3, 4>> bridge;
  for (const double x : {-left.x, 0.0, left.x}) {
    const double z = x == 0.0 ? left.z + 0.005 : left.z;
    bridge.push_back({dvec3(x, y + 0.0018, z), dvec3(x, y + 0.0018, z - depth), dvec3(x, y - 0.0018, z - depth),
                      dvec3(x, y - 0.0018, z)});
  }
  for (auto& section : bridge) std::swap(section[1], section[3]);
  add_box_ring(skin, bridge, false, Region::thing, dvec3(1));
  return skin;
}

Skin glasses() { return glasses_of({0.0205, 0.0155, 0.0022, 0.75}, false); }
Skin round_glasses() { return glasses_of({0.0190, 0.0185, 0.0016, 1.0}, false); }
Skin sunglasses() { return glasses_of({0.0235, 0.0185, 0.0024, 0.8}, true); }

}  // namespace

std::vector<Part> faces() {
  return {{"full_beard", Slot::face, Fits::man, {}, {"beard"}, {}, full_beard},
          {"goatee", Slot::face, Fits::man, {}, {"beard"}, {}, goatee},
          {"moustache", Slot::face, Fits::man, {}, {"beard"}, {}, moustache},
          {"glasses", Slot::face, Fits::all, {}, {"glasses"}, {}, glasses},
          {"round_glasses", Slot::face, Fits::all, {}, {"glasses"}, {}, round_glasses},
          {"sunglasses", Slot::face, Fits::adults, {}, {"glasses", "sun"}, {}, sunglasses}};
}

}  // namespace throng::wardrobe
