#include "engine/anim/survey/placement_guess.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "engine/anim/base/elementary.h"

namespace throng::anim {

namespace {

constexpr double least_side = 0.04;                                   // metres: a mouse
constexpr double largest_side = 40.0;                                 // metres: a tall house
constexpr double upright_over_depth = 0.8, upright_over_width = 0.6;  // an animal is longer; arms may be spread
constexpr double off_the_middle = 0.25;  // of the largest side: no figure that stands on the origin is so far off
constexpr double sunk = 0.02;            // of the height: soles lie a little below the ground in many files
constexpr double afloat = 0.5;           // of the height: a figure that hovers on purpose is lower

double largest_of(const glm::dvec3& size) { return std::max({size.x, size.y, size.z}); }

/// Returns the metres that a unit of the file probably is: 1, or the power of ten that brings a model of `side` units
/// nearest to a person. No artist models in decimetres.
double guess_scale(double side) {
  if (side >= least_side && side <= largest_side) return 1.0;
  const double power = std::round(std::log10(tall_person / side));
  return std::pow(10.0, side > largest_side ? std::min(power, -2.0) : power);
}

bool stands_upright(const glm::dvec3& size) {
  return size.y >= upright_over_depth * size.z && size.y >= upright_over_width * size.x;
}

/// Returns by how much a model of that size in metres grows to fit among people: 1 for one that fits. No unit makes a
/// figure of 5 cm or of 6 m that stands upright, so it is a person in an unknown unit.
double growth_among_people(const glm::dvec3& metres) {
  const bool upright = stands_upright(metres);
  const double side = upright ? metres.y : largest_of(metres);
  const double most = upright ? tallest_among_people : longest_among_people;
  if (side >= least_among_people && side <= most) return 1.0;
  return (upright ? tall_person : std::clamp(side, least_among_people, most)) / side;
}

glm::dquat upright(UpAxis up) {
  constexpr double quarter = std::numbers::pi / 2.0;
  const glm::dvec3 x(1.0, 0.0, 0.0), z(0.0, 0.0, 1.0);
  switch (up) {
    case UpAxis::x:
      return angle_axis(quarter, z);
    case UpAxis::y:
      break;
    case UpAxis::z:
      return angle_axis(-quarter, x);
    case UpAxis::minus_x:
      return angle_axis(-quarter, z);
    case UpAxis::minus_y:
      return angle_axis(2.0 * quarter, z);
    case UpAxis::minus_z:
      return angle_axis(quarter, x);
  }
  return {1.0, 0.0, 0.0, 0.0};
}

std::string number(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3g", value);
  return text.data();
}

std::string unit_named(double scale) {
  constexpr std::array<std::pair<double, const char*>, 3> units = {
      {{1.0, "metres"}, {0.01, "centimetres"}, {0.001, "millimetres"}}};
  for (const auto& [size, name] : units) {
    if (std::abs(scale - size) < 1e-6 * size) return name;
  }
  return "units of " + number(scale) + " m";
}

class PlacementGuesser {
 public:
  PlacementGuesser(const ModelExtent& extent, const PlacementChoice& choice, SizeRule rule)
      : extent_(extent), choice_(choice), rule_(rule) {}

  GuessedPlacement guess() {
    guessed_.choice = choice_;
    guessed_.extent = extent_;
    set_scale();
    guessed_.placement.rotation = upright(choice_.up);
    if (choice_.up != UpAxis::y) add_reason("turned upright as asked");
    guessed_.height = guessed_.placement.scale * extent_.size.y;
    if (choice_.ground != GroundRule::file) set_place();
    guessed_.is_plain = reasons_.empty();
    guessed_.reasons = number(guessed_.height) + " m tall" + (reasons_.empty() ? "" : ": ") + reasons_;
    return std::move(guessed_);
  }

 private:
  void add_reason(const std::string& reason) { reasons_ += (reasons_.empty() ? "" : ", ") + reason; }

  void set_scale() {
    double& scale = guessed_.placement.scale;
    if (choice_.scale) {
      scale = *choice_.scale;
      return add_reason("scaled by " + number(scale) + " as asked");
    }
    scale = guess_scale(largest_of(extent_.size));
    if (scale != 1.0) {
      add_reason("taken as " + unit_named(scale) + " (" + number(extent_.size.y) + " units tall in its file)");
    }
    if (rule_ == SizeRule::among_people) fit_among_people();
  }

  void fit_among_people() {
    double& scale = guessed_.placement.scale;
    const double tall = scale * extent_.size.y, growth = growth_among_people(scale * extent_.size);
    if (growth == 1.0) return;
    scale *= growth;
    add_reason("scaled by " + number(growth) + " from " + number(tall) + " m to fit among people");
  }

  void set_place() {
    glm::dvec3& offset = guessed_.placement.offset;
    const glm::dvec3 middle = guessed_.placement.scale * extent_.middle;
    const double beside = glm::length(glm::dvec2(middle.x, middle.z));
    const double side = guessed_.placement.scale * largest_of(extent_.size);
    if (beside > off_the_middle * side) {
      offset.x = -middle.x;
      offset.z = -middle.z;
      add_reason("moved to its place from " + number(beside) + " m beside the file's origin");
    }
    const double lowest = guessed_.placement.scale * extent_.lowest;
    const bool asked = choice_.ground == GroundRule::feet;
    const bool off_the_ground = lowest < -sunk * guessed_.height || lowest > afloat * guessed_.height;
    if (!asked && !off_the_ground) return;
    offset.y = -lowest;
    add_reason((lowest < 0.0 ? "raised " : "lowered ") + number(std::abs(lowest)) + " m to stand on the ground");
  }

  ModelExtent extent_;
  PlacementChoice choice_;
  SizeRule rule_;
  GuessedPlacement guessed_;
  std::string reasons_;  // one after the other
};

}  // namespace

double guessed_scale(const ModelExtent& extent, SizeRule rule) {
  const double scale = guess_scale(largest_of(extent.size));
  return rule == SizeRule::among_people ? scale * growth_among_people(scale * extent.size) : scale;
}

GuessedPlacement guess_placement(const Model& model, const PlacementChoice& choice, SizeRule rule) {
  if (const auto extent = measure_extent(model, upright(choice.up))) {
    return PlacementGuesser(*extent, choice, rule).guess();
  }
  return {.placement = {.scale = choice.scale.value_or(1.0), .rotation = upright(choice.up)},
          .is_plain = false,
          .choice = choice,
          .reasons = "nothing of it has any extent, so there is nothing to see"};
}

}  // namespace throng::anim
