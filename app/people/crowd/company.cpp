#include "app/people/crowd/company.h"

#include <algorithm>
#include <numeric>

#include <glm/geometric.hpp>

#include "app/people/crowd/layout.h"
#include "engine/base/random.h"

namespace throng::app {
namespace {

constexpr std::uint64_t company_stream = 26;
constexpr float share_with_company = 0.35F, share_of_threes = 0.3F;  // of leaders
constexpr float to_the_side = 0.68F;                                 // metres

constexpr std::uint64_t gatherings_stream = 28;
constexpr float share_of_pictures = 0.16F, share_of_sights = 0.22F;  // of the groups that are large enough
constexpr std::size_t least_of_picture = 3, least_of_sight = 2, most_of_either = 4;

// Metres, for a person 1.8 m tall.
constexpr double same_gathering = 2.2;  // from one to the next of the list
constexpr double widest_ring = 1.05;    // from the middle of a group to its feet
constexpr double camera_away = 1.15;    // from the middle to the photographer
constexpr double others_away = 0.70;    // to the people in the picture
constexpr double abreast = 0.54;        // from one to the next of a row
constexpr double farthest_sight = 22.0;

using Gathering = std::span<StanderStart>;

glm::dvec2 middle_of_feet(Gathering group) {
  glm::dvec2 sum(0.0);
  for (const StanderStart& place : group) sum += place.position;
  return sum / static_cast<double>(group.size());
}

/// Returns the groups of people who stand about, in the order in which they were placed.
std::vector<Gathering> gatherings_in(std::span<StanderStart> standers, double spacing) {
  std::vector<Gathering> groups;
  std::size_t begin = 0;
  for (std::size_t next = 1; next <= standers.size(); ++next) {
    const bool joins = next < standers.size() && standers[next].habit == Habit::stand_about &&
                       standers[next - 1].habit == Habit::stand_about &&
                       glm::distance(standers[next].position, standers[next - 1].position) < same_gathering * spacing;
    if (joins) continue;
    if (standers[begin].habit == Habit::stand_about) groups.push_back(standers.subspan(begin, next - begin));
    begin = next;
  }
  return groups;
}

/// Says whether a group is one ring, and not two that happen to be neighbours.
bool is_ring(Gathering group, double spacing) {
  const glm::dvec2 middle = middle_of_feet(group);
  return std::ranges::all_of(
      group, [&](const StanderStart& place) { return glm::distance(place.position, middle) < widest_ring * spacing; });
}

/// Stands people in a row across `way`; all look along it.
void stand_in_a_row(Gathering group, glm::dvec2 middle, glm::dvec2 way, double spacing) {
  const glm::dvec2 across(way.y, -way.x);
  const double first = -0.5 * static_cast<double>(group.size() - 1);
  for (std::size_t i = 0; i < group.size(); ++i) {
    group[i].position = middle + (first + static_cast<double>(i)) * abreast * spacing * across;
    group[i].heading = heading_along(way);
  }
}

void face_a_camera(Gathering group, double spacing) {
  const glm::dvec2 middle = middle_of_feet(group);
  const glm::dvec2 way = glm::normalize(group.front().position - middle);
  const Gathering others = group.subspan(1);
  stand_in_a_row(others, middle - others_away * spacing * way, way, spacing);
  for (StanderStart& place : others) {
    place.heading = heading_along(glm::normalize(middle + camera_away * spacing * way - place.position));
    place.habit = Habit::pose;
  }
  group.front().position = middle + camera_away * spacing * way;
  group.front().heading = heading_along(-way);
  group.front().habit = Habit::photograph;
}

void face_a_sight(Gathering group, glm::dvec2 sight, double spacing) {
  const glm::dvec2 middle = middle_of_feet(group);
  stand_in_a_row(group, middle, glm::normalize(sight - middle), spacing);
  for (StanderStart& place : group) place.habit = Habit::wait;
  group.front().habit = Habit::photograph;
}

}  // namespace

void draw_company(CrowdLayout& layout, std::uint32_t seed) {
  if (layout.walkers_habit != Habit::stroll) return;
  Company& company = layout.company;
  company = {.leaders = std::vector<std::uint32_t>(layout.walkers.size()),
             .sides = std::vector<float>(layout.walkers.size())};
  std::iota(company.leaders.begin(), company.leaders.end(), 0U);
  Random random(seed, company_stream);
  const auto on_lane_of = [&](std::size_t leader, std::size_t walker) {
    return walker < layout.walkers.size() && layout.walkers[walker].lane == layout.walkers[leader].lane;
  };
  for (std::size_t leader = 0; leader < layout.walkers.size();) {
    const bool has_company = random.chance(share_with_company), are_three = random.chance(share_of_threes);
    const std::size_t others = has_company ? (are_three ? 2 : 1) : 0;
    std::size_t next = leader + 1;
    for (std::size_t other = 0; other < others && on_lane_of(leader, next); ++other, ++next) {
      company.leaders[next] = static_cast<std::uint32_t>(leader);
      company.sides[next] =
          other == 0 ? to_the_side : -to_the_side;  // the first on the left, where a hand leads a child
      layout.walkers[next].distance = layout.walkers[leader].distance;
    }
    leader = next;
  }
}

void draw_gatherings(CrowdLayout& layout, std::span<const glm::dvec2> sights, double spacing, std::uint32_t seed) {
  Random random(seed, gatherings_stream);
  for (const Gathering group : gatherings_in(layout.standers, spacing)) {
    const bool photographs = random.chance(share_of_pictures), looks = random.chance(share_of_sights);
    if (group.size() == 1) {
      group.front().habit = Habit::wait;
      continue;
    }
    if (group.size() > most_of_either || !is_ring(group, spacing)) continue;
    const auto sight = std::ranges::min_element(
        sights, {}, [&](glm::dvec2 place) { return glm::distance(place, group.front().position); });
    const bool is_in_view =
        sight != sights.end() && glm::distance(*sight, group.front().position) < farthest_sight * spacing;
    if (photographs && group.size() >= least_of_picture) {
      face_a_camera(group, spacing);
    } else if (looks && is_in_view && group.size() >= least_of_sight) {
      face_a_sight(group, *sight, spacing);
    }
  }
}

}  // namespace throng::app
