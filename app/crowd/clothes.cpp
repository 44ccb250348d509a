#include "app/crowd/clothes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "app/crowd/parade.h"
#include "app/crowd/turn.h"

namespace throng::app {
namespace {

// Red, green, blue, sRGB. They lie far apart, also in the haze.
using Paint = std::array<float, 3>;
constexpr Paint gold{250.0F, 184.0F, 38.0F}, ember{222.0F, 76.0F, 36.0F}, crimson{176.0F, 26.0F, 48.0F};
constexpr std::array<Paint, 4> rings{Paint{244.0F, 240.0F, 228.0F}, Paint{24.0F, 92.0F, 178.0F},
                                     Paint{36.0F, 164.0F, 160.0F}, Paint{22.0F, 42.0F, 104.0F}};

// Shares of the way from the middle to the edge.
constexpr double disc = 0.16, rays_end = 0.52, ring_width = 0.12;
constexpr double swell_of_rays = 0.05, swell_of_rings = 0.025;
constexpr double rays = 12.0, waves = 8.0;
constexpr double trousers_light = 0.72;
constexpr float share_who_wear_what_they_like = 0.06F;
constexpr std::size_t shirt = 2, legs = 3;

const Paint& paint_at(double away, double quarters) {
  const double ray = cosine_sine(rays * quarters).x, wave = cosine_sine(waves * quarters).y;
  if (away < disc) return gold;
  if (away < rays_end + swell_of_rays * (2.0 * std::fabs(ray) - 1.0)) {
    if (ray > 0.0) return gold;
    return away < 0.5 * (disc + rays_end) ? ember : crimson;
  }
  const double ring = (away - rays_end + swell_of_rings * wave) / ring_width;
  return rings.at(static_cast<std::size_t>(std::max(ring, 0.0)) % rings.size());
}

std::uint32_t tint_of_paint(const Paint& paint, float light) {
  std::uint32_t tint = 0xFF;
  for (const std::size_t channel : {2U, 1U, 0U}) {
    tint = tint << 8U | static_cast<std::uint32_t>(std::clamp(paint.at(channel) * light, 0.0F, 255.0F));
  }
  return tint;
}

}  // namespace

ClothesPattern::ClothesPattern(std::span<const glm::dvec2> places) {
  if (places.empty()) return;
  glm::dvec2 low(std::numeric_limits<double>::max()), high(std::numeric_limits<double>::lowest());
  for (const glm::dvec2& place : places) {
    low = glm::min(low, place);
    high = glm::max(high, place);
  }
  middle_ = 0.5 * (low + high);
  half_ = glm::max(0.5 * (high - low), glm::dvec2(1.0));
}

Tints ClothesPattern::at(glm::dvec2 place, const Tints& own, Random& random) const {
  const float light = random.between(0.86F, 1.08F);
  if (random.chance(share_who_wear_what_they_like)) return own;
  const glm::dvec2 from_middle = (place - middle_) / half_;
  const double quarters = std::atan2(from_middle.y, from_middle.x) * 2.0 / std::numbers::pi;
  const Paint& paint = paint_at(glm::length(from_middle), quarters);
  Tints tints = own;
  tints.at(shirt) = tint_of_paint(paint, light);
  tints.at(legs) = tint_of_paint(paint, static_cast<float>(trousers_light) * light);
  return tints;
}

std::vector<glm::dvec2> places_of(const CrowdLayout& layout) {
  std::vector<glm::dvec2> places;
  for (const WalkerStart& walker : layout.walkers) {
    places.push_back(layout.lanes[walker.lane].at(walker.distance).position);
  }
  for (const MarcherStart& marcher : layout.marchers) {
    places.push_back(marcher_place(layout.route, marcher, 0.0).position);
  }
  for (const StanderPlace& stander : layout.standers) places.push_back(stander.position);
  return places;
}

}  // namespace throng::app
