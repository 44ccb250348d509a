#include "app/people/crowd/cut_scene_layout.h"

#include <algorithm>
#include <cmath>

#include "app/character/cut_scene_models.h"
#include "app/people/crowd/numbers/turn.h"
#include "engine/base/random.h"

namespace throng::app {
namespace {

constexpr std::uint64_t street_stream = 8;
constexpr double street_half_width = 2.3;    // in spacings
constexpr double place_pitch = 0.95;         // in spacings, along the street and between rows
constexpr double unevenness = 0.16;          // in spacings
constexpr double least_length = 16.0;        // in spacings
constexpr double middle = -1.0;              // of the street, in spacings
constexpr double cheer_after_release = 0.5;  // seconds

Heading heading_to(const glm::dvec2& from, const glm::dvec2& to) {
  const glm::dvec2 way = to - from;
  const double length = std::max(std::hypot(way.x, way.y), 1e-6);
  return {static_cast<float>(way.y / length), static_cast<float>(way.x / length)};
}

// People side by side along the street.
double columns_for(std::size_t people) {
  return std::max(least_length, std::ceil(std::sqrt(static_cast<double>(people)) * 1.4));
}

}  // namespace

CrowdLayout cut_scene_layout(std::size_t agents, std::uint32_t seed, const CharacterRoles& roles) {
  Random random(seed, street_stream);
  const double spacing = roles.spacing();
  CrowdLayout layout;
  const double round = (release_seconds + cheer_after_release) / cut_scene_seconds;
  for (const Part part : {Part::actor, Part::prop}) {
    if (layout.standers.size() < agents)
      layout.standers.push_back({.position = {}, .heading = {}, .habit = Habit::act, .round = round, .part = part});
  }
  const std::size_t people = agents - layout.standers.size();
  const double columns = columns_for(people);
  const auto a_row = static_cast<std::size_t>(columns);
  for (std::size_t i = 0; i < people; ++i) {
    const double side = i % 2 == 0 ? 1.0 : -1.0;
    const std::size_t on_this_side = i / 2;
    const std::size_t row = on_this_side / a_row, in_row = on_this_side % a_row;
    const double along = static_cast<double>(in_row) - 0.5 * (columns - 1.0) + (row % 2 == 0 ? 0.0 : 0.5);
    const auto jitter = [&] { return unevenness * static_cast<double>(random.between(-1.0F, 1.0F)); };
    const glm::dvec2 place(side * (street_half_width + place_pitch * static_cast<double>(row) + jitter()),
                           middle + place_pitch * along + jitter());
    layout.standers.push_back({.position = spacing * place,
                               .heading = heading_to(spacing * place, {0.0, 0.5 * spacing}),
                               .habit = Habit::watch,
                               .round = round});
  }
  layout.wave_seconds = cut_scene_seconds;
  layout.wave_begins = 0.0;
  return layout;
}

CutSceneStreet cut_scene_street(std::size_t agents, const CharacterRoles& roles) {
  const double spacing = roles.spacing(), columns = columns_for(agents),
               rows = std::ceil(0.5 * static_cast<double>(agents) / columns);
  const double half_length = place_pitch * (0.5 * columns + 0.5) + unevenness;
  return {(street_half_width - unevenness) * spacing,
          (street_half_width + place_pitch * std::max(rows - 1.0, 0.0) + unevenness) * spacing,
          (middle - half_length) * spacing, (middle + half_length) * spacing};
}

}  // namespace throng::app
