#include "app/people/crowd/clothes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "app/people/crowd/lettering.h"
#include "app/people/crowd/numbers/turn.h"
#include "app/people/crowd/parade.h"

namespace throng::app {
namespace {

// Red, green, blue, sRGB. They lie far apart, also in the haze.
using Paint = std::array<float, 3>;
constexpr Paint white{250.0F, 248.0F, 240.0F}, navy{14.0F, 26.0F, 78.0F};
constexpr Paint gold{255.0F, 204.0F, 44.0F}, ember{245.0F, 122.0F, 26.0F}, crimson{172.0F, 14.0F, 44.0F};
constexpr std::array<Paint, 5> rings{navy, white, crimson, gold, Paint{24.0F, 100.0F, 190.0F}};

constexpr double person = 1.2;   // metres above the feet that are seen
constexpr double nearest = 1.0;  // metres ahead of the tower
constexpr double picture_aspect = 16.0 / 9.0;
constexpr double trousers_light = 0.72;
constexpr float share_who_wear_what_they_like = 0.03F;
constexpr std::size_t shirt = 2, legs = 3;

// Shares of the height of letters.
constexpr double half_stroke = 0.085, half_outline = 0.135;
constexpr double word_beyond = 0.5;  // of the strokes' middles, on both sides

// The word takes these shares of the part of the picture.
constexpr double word_share_across = 0.84, word_share_along = 0.46, word_middle = 0.50;

constexpr double rays = 32.0;  // around the sun, half of which is seen
constexpr std::size_t least_for_word = 5000;
constexpr double rising_sun = 0.13;

constexpr double swell = 0.5, swells = 9.0;  // of rings, in widths of one

double quarters_of(glm::dvec2 way) { return std::atan2(way.y, way.x) * 2.0 / std::numbers::pi; }

// `at` is in units of the height of the picture's part, from the sun.
const Paint& paint_of_rays(glm::dvec2 at) {
  if (glm::length(at) < rising_sun) return gold;
  const bool bright = cosine_sine(rays * quarters_of(at)).x > 0.0;
  return bright ? ember : crimson;
}

// `away` is 0 at the innermost ring and 1 at the edge.
const Paint& paint_of_rings(double away, double swollen) {
  const double ring = std::max(away, 0.0) * static_cast<double>(rings.size()) + swollen;
  return rings.at(static_cast<std::size_t>(std::max(ring, 0.0)) % rings.size());
}

const Paint& paint_of_word(glm::dvec2 at, glm::dvec2 low, glm::dvec2 high) {
  const glm::dvec2 size = high - low;
  const double letters = std::min(word_share_along * size.y, word_share_across * size.x / (word_width + word_beyond));
  const glm::dvec2 middle = glm::mix(low, high, glm::dvec2(0.5, word_middle));
  const double away = distance_to_word((at - middle) / letters + glm::dvec2(0.5 * word_width, 0.5));
  if (away < half_stroke) return white;
  if (away < half_outline) return navy;
  return paint_of_rays((at - glm::dvec2(middle.x, high.y)) / size.y);
}

std::uint32_t tint_of_paint(const Paint& paint, float light) {
  std::uint32_t tint = 0xFF;
  for (const std::size_t channel : {2U, 1U, 0U}) {
    tint = tint << 8U | static_cast<std::uint32_t>(std::clamp(paint.at(channel) * light, 0.0F, 255.0F));
  }
  return tint;
}

}  // namespace

ClothesPattern::ClothesPattern(Motif motif, std::span<const glm::dvec3> places, const CameraPose& tower)
    : motif_(motif), eye_(tower.x, tower.y, tower.z) {
  const double yaw = glm::radians(static_cast<double>(tower.yaw)),
               pitch = glm::radians(static_cast<double>(tower.pitch));
  const double tall = std::tan(0.5 * glm::radians(static_cast<double>(tower.field_of_view)));
  ahead_ = tall * glm::dvec3(-std::sin(yaw) * std::cos(pitch), std::sin(pitch), -std::cos(yaw) * std::cos(pitch));
  right_ = {std::cos(yaw), 0.0, -std::sin(yaw)};
  up_ = glm::cross(right_, ahead_) / tall;
  const glm::dvec2 border(picture_aspect, 1.0);
  glm::dvec2 low = border, high = -border;
  for (const glm::dvec3& place : places) {
    const glm::dvec2 seen = glm::clamp(in_picture(place), -border, border);
    low = glm::min(low, seen);
    high = glm::max(high, seen);
  }
  low_ = low;
  high_ = glm::max(high, low + 1e-3);
  measure_ground(places);
}

void ClothesPattern::measure_ground(std::span<const glm::dvec3> places) {
  glm::dvec2 low(std::numeric_limits<double>::max()), high(std::numeric_limits<double>::lowest());
  for (const glm::dvec3& place : places) {
    low = glm::min(low, glm::dvec2(place.x, place.z));
    high = glm::max(high, glm::dvec2(place.x, place.z));
  }
  middle_ = 0.5 * (low + high);
  half_ = glm::max(0.5 * (high - low), glm::dvec2(1.0));
  inner_ = half_.y;
  for (const glm::dvec3& place : places) inner_ = std::min(inner_, from_core(place));
}

// Rings lie around a straight line along x, as lanes around a field do.
double ClothesPattern::from_core(const glm::dvec3& place) const {
  const double core = std::max(half_.x - half_.y, 0.0);
  const glm::dvec2 way = glm::dvec2(place.x, place.z) - middle_;
  return glm::length(way - glm::dvec2(glm::clamp(way.x, -core, core), 0.0));
}

// From -1 at the bottom of the picture to 1 at its top, and as far to the sides as its aspect says.
glm::dvec2 ClothesPattern::in_picture(const glm::dvec3& place) const {
  const glm::dvec3 way = place + glm::dvec3(0.0, person, 0.0) - eye_;
  return glm::dvec2(glm::dot(way, right_), glm::dot(way, up_)) / std::max(glm::dot(way, ahead_), nearest);
}

const std::array<float, 3>& ClothesPattern::paint_at(const glm::dvec3& place) const {
  if (motif_ == Motif::word) return paint_of_word(in_picture(place), low_, high_);
  const glm::dvec2 way = (glm::dvec2(place.x, place.z) - middle_) / half_;
  const double swollen = motif_ == Motif::waves ? swell * cosine_sine(swells * quarters_of(way)).y : 0.0;
  return paint_of_rings((from_core(place) - inner_) / std::max(half_.y - inner_, 1.0), swollen);
}

Tints ClothesPattern::at(const glm::dvec3& place, const Tints& own, Random& random) const {
  const float light = random.between(0.90F, 1.08F);
  if (random.chance(share_who_wear_what_they_like)) return own;
  const Paint& paint = paint_at(place);
  Tints tints = own;
  tints.at(shirt) = tint_of_paint(paint, light);
  tints.at(legs) = tint_of_paint(paint, static_cast<float>(trousers_light) * light);
  return tints;
}

Motif motif_of(Scene scene, std::size_t people) {
  if (scene == Scene::plaza && people >= least_for_word) return Motif::word;
  return scene == Scene::stadium ? Motif::waves : Motif::rings;
}

std::vector<glm::dvec3> places_of(const CrowdLayout& layout) {
  std::vector<glm::dvec3> places;
  const auto add = [&](glm::dvec2 place, double height) { places.emplace_back(place.x, height, place.y); };
  for (const WalkerStart& walker : layout.walkers) add(layout.lanes[walker.lane].at(walker.distance).position, 0.0);
  for (const MarcherStart& marcher : layout.marchers) add(marcher_place(layout.route, marcher, 0.0).position, 0.0);
  for (const StanderStart& stander : layout.standers) add(stander.position, stander.height);
  return places;
}

}  // namespace throng::app
