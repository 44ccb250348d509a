#include "engine/tracks/doubts.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <glm/common.hpp>

#include "engine/base/text/joined.h"
#include "engine/tracks/ground_bounds.h"

namespace throng {
namespace {

constexpr std::size_t most_people_looked_at = 2000, most_steps_looked_at = 50'000;

/// Returns the metres between two; 0 if they touch.
float gap_between(const GroundBounds& one, const GroundBounds& other) {
  const glm::vec2 gap = glm::max(glm::max(other.low - one.high, one.low - other.high), glm::vec2(0.0F));
  return std::max(gap.x, gap.y);
}

struct Speeds {
  std::vector<float> moving;  ///< metres a second of each step that moves
  float longest_way = 0.0F;   ///< metres that a person goes in all
};

Speeds moving_speeds(const std::vector<PersonTrack>& persons) {
  Speeds speeds;
  for (std::size_t i = 0; i < std::min(persons.size(), most_people_looked_at); ++i) {
    const std::vector<TrackRow>& rows = persons[i].rows;
    float way = 0.0F;
    for (std::size_t row = 1; row < rows.size() && speeds.moving.size() < most_steps_looked_at; ++row) {
      const float step = std::hypot(rows[row].x - rows[row - 1].x, rows[row].z - rows[row - 1].z);
      way += step;
      if (step > 0.0F) speeds.moving.push_back(step / static_cast<float>(rows[row].seconds - rows[row - 1].seconds));
    }
    speeds.longest_way = std::max(speeds.longest_way, way);
  }
  return speeds;
}

/// Returns the value that a share of the values lie below.
float quantile(std::vector<float>& values, double share) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::ranges::nth_element(values, at);
  return *at;
}

std::string in_metres(float value) {
  const auto size = static_cast<double>(std::abs(value));
  return fixed(static_cast<double>(value), size < 0.1 ? 4 : size < 10.0 ? 2 : 0) + " m";
}

std::string doubt_of_extent(const Trajectories& tracks, const GroundBounds& people) {
  constexpr float narrowest = 0.5F;  // a crowd of three has no room in less
  const float width = width_of(people);
  if (tracks.persons.size() < 3 || width >= narrowest) return {};
  return "All " + counted_people(tracks.persons.size()) + " stay within " + in_metres(width) +
         ", as places in degrees or kilometres do: export metres, or say with --unit how many metres a unit is.";
}

std::string doubt_of_speeds(const RowFacts& facts, const Trajectories& tracks) {
  constexpr float too_fast = 7.0F, too_slow = 0.1F;  // metres a second
  constexpr float least_way = 2.0F;                  // metres: a person who stands may be slow
  constexpr std::size_t least_steps = 10;
  Speeds speeds = moving_speeds(tracks.persons);
  if (speeds.moving.size() < least_steps) return {};
  const float middle = quantile(speeds.moving, 0.5), fast = quantile(speeds.moving, 0.95);
  const std::string clock = facts.has_frames ? "--fps" : "--time-unit";
  const bool are_vehicles = facts.format.find("vehicles") != std::string::npos;
  if (middle > too_fast && !are_vehicles) {
    return "People go " + in_metres(middle) +
           "/s in the middle of all steps, which is too fast to be true: --unit cm, " +
           "the metres of a pixel as --unit 0.02, or " + clock + " may mend it.";
  }
  if (fast < too_slow && speeds.longest_way > least_way) {
    return "People go " + in_metres(fast) + "/s at the most, which is too slow to be true: " + clock +
           (facts.has_frames ? " or --unit may mend it." : " ms, or --unit, may mend it.");
  }
  return {};
}

std::string doubt_of_statures(const Trajectories& tracks) {
  constexpr float shortest = 1.0F, tallest = 2.1F;  // metres, in the middle of a crowd
  std::vector<float> statures;
  for (const PersonTrack& person : tracks.persons) {
    if (person.stature > 0.0F) statures.push_back(person.stature);
  }
  if (statures.empty()) return {};
  const float middle = quantile(statures, 0.5);
  if (middle >= shortest && middle <= tallest) return {};
  return "People are " + in_metres(middle) +
         " tall in the middle, by the heights of their heads: --unit may mend it, or " +
         "--height ground if z is no head.";
}

std::string doubt_of_heights(const RowFacts& facts, const Trajectories& tracks) {
  if (!facts.has_z) return {};
  constexpr float highest_step = 2.0F;  // metres: a stage
  float lowest = std::numeric_limits<float>::infinity(), highest = -lowest;
  for (const PersonTrack& person : tracks.persons) {
    if (person.stature > 0.0F) return {};  // z is the height of heads
    for (const TrackRow& row : person.rows) {
      lowest = std::min(lowest, row.y);
      highest = std::max(highest, row.y);
    }
  }
  if (lowest < highest_step && highest > -highest_step) return {};
  return "People stand at heights from " + in_metres(lowest) + " to " + in_metres(highest) +
         ", and the ground is drawn at 0: --height none puts them on it.";
}

std::string doubt_of_place(const Trajectories& tracks, const GroundBounds& people) {
  constexpr float farthest = 1.0F;  // metres: people may wait before a door
  const auto place = bounds_of(tracks.plan);
  const float gap = place ? gap_between(*place, people) : 0.0F;
  if (gap <= farthest) return {};
  return "The walls and floors lie " + in_metres(gap) + " away from all people: --walls takes others.";
}

std::string doubt_of_shapes(const GroundPlan& plan) {
  if (plan.unknown_shapes == 0) return {};
  return counted(plan.unknown_shapes, "shape") + " of the place " + (plan.unknown_shapes == 1 ? "is" : "are") +
         " left out, for a shape has corners, sides or a radius: --walls takes the place as WKT.";
}

}  // namespace

void add_doubts(const RowFacts& facts, Trajectories& tracks) {
  const GroundBounds people = bounds_of(tracks);
  std::string of_unit = doubt_of_extent(tracks, people);
  if (of_unit.empty()) of_unit = doubt_of_speeds(facts, tracks);
  for (std::string doubt : {std::move(of_unit), doubt_of_statures(tracks), doubt_of_heights(facts, tracks),
                            doubt_of_place(tracks, people), doubt_of_shapes(tracks.plan)}) {
    if (!doubt.empty()) tracks.remarks.push_back(std::move(doubt));
  }
}

}  // namespace throng
