#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "assets/wardrobe/head.h"
#include "assets/wardrobe/head_surface.h"
#include "assets/wardrobe/part.h"

namespace throng::wardrobe {
namespace {

using glm::dvec3;
using mannequin::bind;
using mannequin::Region;
using mannequin::Skin;
using mannequin::Weights;

const dvec3 eye_centre(0.0325, 1.6775, 0.0668);
constexpr double eye_radius = 0.0180;

constexpr mannequin::FaceNotes on_head{.piece = static_cast<unsigned char>(Slot::head)};

std::size_t add_feature_point(Skin& skin, dvec3 place, const Weights& weights) {
  skin.points.push_back({.position = place, .weights = weights});
  return skin.points.size() - 1;
}

void add_feature_face(Skin& skin, std::vector<std::size_t> corners, Region region, dvec3 paint) {
  std::vector<dvec3> paints(corners.size(), paint);
  skin.faces.push_back({std::move(corners), region, std::move(paints), on_head});
}

void bridge_feature(Skin& skin, const std::vector<std::size_t>& outer, const std::vector<std::size_t>& inner,
                    Region region, dvec3 paint) {
  for (std::size_t i = 0; i < outer.size(); ++i) {
    const std::size_t next = (i + 1) % outer.size();
    add_feature_face(skin, {outer[i], outer[next], inner[next], inner[i]}, region, paint);
  }
}

/// A place on the eyeball as far to the left and up from its middle.
dvec3 on_eyeball(double x, double y, double lift) {
  const double radius = eye_radius + lift;
  const double flat = std::min(x * x + y * y, 0.96 * radius * radius);
  return eye_centre + dvec3(x, y, std::sqrt(radius * radius - flat));
}

}  // namespace

dvec3 lid_edge(double share, double grow, double lift) {
  const double angle = 2 * std::numbers::pi * share;
  const double side = std::cos(angle);
  const double height = std::sin(angle);
  const double half_width = side > 0 ? 0.0158 : 0.0138;
  const double half_height = height > 0 ? 0.0073 : 0.0062;
  const double x = half_width * side * grow;
  // The upper lid is highest above the iris' inner edge, and the outer corner is a little higher than the inner.
  const double almond = std::copysign(std::pow(std::abs(height), 0.9), height);
  const double y = half_height * almond * (grow > 1.1 ? 1.12 * grow : grow) + 0.0012 * side * grow - 0.0004;
  return on_eyeball(x, y, lift);
}

void add_eye(Skin& half) {
  constexpr std::array<double, 5> radii{0.0164, 0.0120, 0.0078, 0.0067, 0.0034};
  constexpr std::array<dvec3, 5> paints{
      {{0.70, 0.66, 0.64}, {0.74, 0.71, 0.69}, {0.035, 0.022, 0.016}, {0.105, 0.058, 0.030}, {0.006, 0.005, 0.005}}};
  constexpr std::size_t around = 14;
  const Weights weights = bind({{"eye.L", 1}});
  std::vector<std::size_t> outer;
  for (std::size_t ring = 0; ring < radii.size(); ++ring) {
    std::vector<std::size_t> inner;
    for (std::size_t i = 0; i < around; ++i) {
      const double angle = 2 * std::numbers::pi * static_cast<double>(i) / around;
      inner.push_back(add_feature_point(
          half, on_eyeball(radii[ring] * std::cos(angle), radii[ring] * std::sin(angle), 0), weights));
    }
    if (ring > 0) bridge_feature(half, outer, inner, Region::untinted, paints[ring - 1]);
    outer = inner;
  }
  add_feature_face(half, outer, Region::untinted, paints.back());
  std::vector<std::size_t> light;
  for (const auto& [x, y] : {std::array{0.0008, 0.0020}, {0.0035, 0.0020}, {0.0035, 0.0046}, {0.0008, 0.0046}}) {
    light.push_back(add_feature_point(half, on_eyeball(x, y, 0.0003), weights));
  }
  add_feature_face(half, light, Region::untinted, dvec3(0.95));
}

void add_brow(Skin& half) {
  struct Hair {
    double x, y, half_height;
  };
  constexpr std::array<Hair, 6> hairs{{{0.0130, 1.7010, 0.0022},
                                       {0.0205, 1.7030, 0.0031},
                                       {0.0290, 1.7048, 0.0031},
                                       {0.0380, 1.7048, 0.0026},
                                       {0.0460, 1.7022, 0.0019},
                                       {0.0525, 1.6980, 0.0009}}};
  const Weights weights = bind({{"head", 1}});
  std::array<std::size_t, 3> last{};
  for (std::size_t i = 0; i < hairs.size(); ++i) {
    const auto& [x, y, high] = hairs[i];
    const auto place = [&](double up, double out) {
      const HeadPlace at = face_place(x, y + up);
      return head_point(at.angle, at.row) + head_normal(at.angle, at.row) * out;
    };
    const std::array<std::size_t, 3> here{add_feature_point(half, place(-high, 0.0002), weights),
                                          add_feature_point(half, place(0.0004, 0.0022), weights),
                                          add_feature_point(half, place(high, 0.0002), weights)};
    for (std::size_t k = 0; k < 2 && i > 0; ++k) {
      add_feature_face(half, {last[k], here[k], here[k + 1], last[k + 1]}, Region::hair, dvec3(1));
    }
    last = here;
  }
}

void add_ear(Skin& half) {
  constexpr std::size_t around = 12;
  const Weights weights = bind({{"head", 1}});
  const dvec3 centre(0.0760, 1.6660, -0.0130);
  // Along the ear's plane: up, and back; it stands off the head more behind than in front.
  const dvec3 up = glm::normalize(dvec3(0.10, 1.0, -0.16));
  const dvec3 back = glm::normalize(dvec3(0.42, 0.10, -1.0));
  const dvec3 out = glm::normalize(glm::cross(back, up)) * -1.0;
  struct Ring {
    double size, out;
    dvec3 paint;
  };
  constexpr dvec3 plain(1.0, 0.92, 0.91);
  constexpr std::array<Ring, 5> ear_rings{{{0.62, -0.013, plain},
                                           {0.97, 0.003, plain},
                                           {1.00, 0.0075, plain},
                                           {0.80, 0.0078, {0.90, 0.76, 0.74}},
                                           {0.55, 0.0005, {0.62, 0.46, 0.44}}}};
  std::vector<std::size_t> outer;
  for (const Ring& ring : ear_rings) {
    std::vector<std::size_t> inner;
    for (std::size_t i = 0; i < around; ++i) {
      const double angle = 2 * std::numbers::pi * static_cast<double>(i) / around;
      const double high = std::cos(angle);
      const double behind = std::sin(angle);
      const double width = glm::mix(0.0105, 0.0165, glm::smoothstep(-1.0, 0.5, high)) * (behind < 0 ? 0.72 : 1.0);
      inner.push_back(add_feature_point(
          half,
          centre + up * (0.0310 * high * ring.size) + back * (0.003 + width * behind * ring.size) + out * ring.out,
          weights));
    }
    if (!outer.empty()) bridge_feature(half, outer, inner, Region::skin, ring.paint);
    outer = inner;
  }
  add_feature_face(half, outer, Region::skin, ear_rings.back().paint);
}

}  // namespace throng::wardrobe
