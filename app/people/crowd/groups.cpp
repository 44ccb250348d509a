#include "app/people/crowd/groups.h"

#include <algorithm>
#include <array>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "app/people/crowd/numbers/turn.h"

namespace throng::app {
namespace {

constexpr std::size_t largest_group = 6;
constexpr std::array<float, largest_group> share_up_to_size{0.18F, 0.44F, 0.66F, 0.83F, 0.93F, 1.0F};

// Metres, for a person 1.8 m tall. With the jitter, neighbours in a ring stay 0.7 m apart and more.
constexpr std::array<double, largest_group> ring_radii{0.0, 0.56, 0.66, 0.76, 0.88, 1.02};
constexpr double ring_jitter = 0.12;
constexpr double between_groups = 0.72, between_few_groups = 1.2;  // where the crowd is dense, and where it is thin
constexpr double from_obstacle = 0.6;                              // to the feet of a group; a person passes sideways
constexpr double clear_view = 4.6;
constexpr double bucket = 3.6;  // more than two of the largest groups' radii and the gap between them

constexpr double lane_cell = 8.0;

constexpr std::size_t foreground_groups = 4;
constexpr int tries_before_any_place = 40, tries_before_spreading = 100;

struct Group {
  glm::dvec2 centre;
  double radius;  // of the disc that holds all feet
};

/// A square grid about the origin, clamped at its edge.
struct Grid {
  double cell;  // metres
  int columns;

  int column(double coordinate) const {
    return static_cast<int>(std::clamp(coordinate / cell + 0.5 * columns, 0.0, columns - 1.0));
  }
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(x);
  }
  std::size_t index(glm::dvec2 place) const { return index(column(place.x), column(place.y)); }
  std::size_t size() const { return index(0, columns); }
};

/// Finds groups near a point: each cell of the grid has a chain of groups.
class GroupMap {
 public:
  GroupMap(double side, double spacing)
      : grid_{bucket * spacing, static_cast<int>(side / (bucket * spacing)) + 8}, first_(grid_.size(), -1) {}

  void add(const Group& group) {
    int& first = first_[grid_.index(group.centre)];
    next_.push_back(first);
    first = static_cast<int>(groups_.size());
    groups_.push_back(group);
  }

  bool is_free(const Group& wanted, double gap) const {
    const int x = grid_.column(wanted.centre.x), y = grid_.column(wanted.centre.y), last = grid_.columns - 1;
    for (int row = std::max(0, y - 1); row <= std::min(last, y + 1); ++row) {
      for (int at = std::max(0, x - 1); at <= std::min(last, x + 1); ++at) {
        if (meets_bucket(grid_.index(at, row), wanted, gap)) return false;
      }
    }
    return true;
  }

 private:
  bool meets_bucket(std::size_t at, const Group& wanted, double gap) const {
    for (int group = first_[at]; group >= 0; group = next_[static_cast<std::size_t>(group)]) {
      const Group& there = groups_[static_cast<std::size_t>(group)];
      if (glm::distance(there.centre, wanted.centre) < there.radius + wanted.radius + gap) return true;
    }
    return false;
  }

  Grid grid_;
  std::vector<int> first_;  // by bucket
  std::vector<int> next_;   // by group
  std::vector<Group> groups_;
};

/// Finds the lanes near a point by a coarse grid.
class LaneMap {
 public:
  explicit LaneMap(const GroupGround& ground)
      : lanes_(ground.lanes),
        grid_{lane_cell * ground.spacing, static_cast<int>(ground.side / (lane_cell * ground.spacing)) + 1},
        cells_(grid_.size()) {
    for (std::size_t lane = 0; lane < lanes_.size(); ++lane) add(lane, ring_radii.back() * 2.0 * ground.spacing);
  }

  bool is_free(const Group& group) const {
    return std::ranges::all_of(cells_[grid_.index(group.centre)],
                               [&](std::size_t lane) { return clear_of(lanes_[lane], group); });
  }

 private:
  static bool clear_of(const LaneGround& lane, const Group& group) {
    const double outside = lane.outermost.signed_distance(group.centre);
    const double room = group.radius + lane.clear;
    return outside >= room || outside <= -lane.width - room;
  }
  void add(std::size_t lane, double margin) {
    const Lane& loop = lanes_[lane].outermost;
    const glm::dvec2 reach = loop.core + glm::dvec2(loop.corner_radius + lanes_[lane].clear + margin);
    const glm::dvec2 low = loop.centre - reach, high = loop.centre + reach;
    for (int y = grid_.column(low.y); y <= grid_.column(high.y); ++y) {
      for (int x = grid_.column(low.x); x <= grid_.column(high.x); ++x) cells_[grid_.index(x, y)].push_back(lane);
    }
  }

  std::span<const LaneGround> lanes_;
  Grid grid_;
  std::vector<std::vector<std::size_t>> cells_;
};

/// Finds the obstacles near a point by the same grid.
class GroundObstacles {
 public:
  explicit GroundObstacles(const GroupGround& ground)
      : obstacles_(ground.obstacles),
        gap_(from_obstacle * ground.spacing),
        grid_{lane_cell * ground.spacing, static_cast<int>(ground.side / (lane_cell * ground.spacing)) + 5},
        cells_(grid_.size()) {
    const double margin = gap_ + (ring_radii.back() + ring_jitter) * ground.spacing;
    for (std::size_t obstacle = 0; obstacle < obstacles_.size(); ++obstacle) add(obstacle, margin);
  }

  bool is_free(const Group& group) const {
    return std::ranges::none_of(cells_[grid_.index(group.centre)], [&](std::size_t obstacle) {
      return glm::distance(obstacles_[obstacle].position, group.centre) <
             obstacles_[obstacle].radius + group.radius + gap_;
    });
  }

 private:
  void add(std::size_t obstacle, double margin) {
    const glm::dvec2 reach(obstacles_[obstacle].radius + margin);
    const glm::dvec2 low = obstacles_[obstacle].position - reach, high = obstacles_[obstacle].position + reach;
    for (int y = grid_.column(low.y); y <= grid_.column(high.y); ++y) {
      for (int x = grid_.column(low.x); x <= grid_.column(high.x); ++x) cells_[grid_.index(x, y)].push_back(obstacle);
    }
  }

  std::span<const Obstacle> obstacles_;
  double gap_;
  Grid grid_;
  std::vector<std::vector<std::size_t>> cells_;
};

std::size_t pick_size(Random& random) {
  const float chance = random.unit();
  const auto* share = std::upper_bound(share_up_to_size.begin(), share_up_to_size.end() - 1, chance);
  return static_cast<std::size_t>(share - share_up_to_size.begin()) + 1;
}

// Before the camera, which looks from the viewpoint at the middle of the square.
glm::dvec2 somewhere_in_front(const GroupGround& ground, Random& random) {
  const glm::dvec2 ahead = -glm::normalize(ground.viewpoint);
  const auto depth = static_cast<double>(random.between(5.0F, 7.5F));
  const double side = static_cast<double>(random.between(-0.55F, 0.55F)) * depth;
  return ground.viewpoint + ground.spacing * (depth * ahead + side * glm::dvec2(ahead.y, -ahead.x));
}

glm::dvec2 somewhere(double half, Random& random) {
  const double x = half * static_cast<double>(random.between(-1.0F, 1.0F));
  return {x, half * static_cast<double>(random.between(-1.0F, 1.0F))};
}

// Into the ring, more or less.
Heading facing_inward(glm::dvec2 outward, Random& random) {
  const glm::dvec2 turn = cosine_sine(static_cast<double>(random.between(-0.25F, 0.25F)));
  const double x = turn.x * outward.x - turn.y * outward.y;
  const double z = turn.y * outward.x + turn.x * outward.y;
  return {static_cast<float>(-z), static_cast<float>(-x)};
}

void stand_in_ring(const Group& group, std::size_t size, double jitter, Random& random,
                   std::vector<StanderStart>& standers) {
  const double first = 4.0 * static_cast<double>(random.unit());
  for (std::size_t member = 0; member < size; ++member) {
    const double quarters = first + 4.0 * static_cast<double>(member) / static_cast<double>(size);
    const glm::dvec2 outward = cosine_sine(quarters + static_cast<double>(random.between(-0.07F, 0.07F)));
    const double radius = group.radius - 2.0 * jitter * static_cast<double>(random.unit());
    const glm::dvec2 place = group.centre + (size == 1 ? 0.0 : radius) * outward;
    standers.push_back({place, facing_inward(outward, random)});
  }
}

/// Waves that cross, by which the crowd swells and thins as one walks through it.
class Swell {
 public:
  Swell(double spacing, Random& random) {
    for (Wave& wave : waves_) {
      const double length = spacing * static_cast<double>(random.between(shortest, longest));
      wave.quarters_a_metre = 4.0 / length * cosine_sine(4.0 * static_cast<double>(random.unit()));
      wave.phase = 4.0 * static_cast<double>(random.unit());
    }
  }

  /// Returns 0 where the crowd is thinnest, and 1 where it is densest.
  double at(glm::dvec2 place) const {
    double sum = 0.0;
    for (const Wave& wave : waves_) sum += cosine_sine(wave.phase + glm::dot(wave.quarters_a_metre, place)).x;
    return std::clamp(0.5 + steepness * sum, 0.0, 1.0);
  }

  /// Returns how likely a place there is taken.
  float chance_at(glm::dvec2 place) const {
    const double height = at(place);
    return static_cast<float>(least + (1.0 - least) * height * height);
  }

  /// Returns the metres between groups there, for a person 1.8 m tall.
  double gap_at(glm::dvec2 place) const { return glm::mix(between_few_groups, between_groups, at(place)); }

 private:
  static constexpr float shortest = 14.0F, longest = 40.0F;  // metres, for a person 1.8 m tall
  static constexpr double least = 0.05, steepness = 0.33;

  struct Wave {
    glm::dvec2 quarters_a_metre;
    double phase;
  };
  std::array<Wave, 3> waves_{};
};

class GroupPlacer {
 public:
  GroupPlacer(const GroupGround& ground, Random random)
      : ground_(ground),
        random_(random),
        groups_(ground.side, ground.spacing),
        lanes_(ground),
        obstacles_(ground),
        swell_(ground.spacing, random_),
        half_(0.5 * ground.side) {}

  Group place(std::size_t size, bool in_foreground) {
    const double radius = (ring_radii[size - 1] + (size > 1 ? ring_jitter : 0.0)) * ground_.spacing;
    for (int tries = 1;; ++tries) {
      // A group that finds no place where the crowd is dense takes any place that is left, before the crowd spreads.
      const bool choosy = tries <= tries_before_any_place;
      const Group group{place_to_try(in_foreground && choosy, choosy), radius};
      if (fits(group, choosy)) {
        groups_.add(group);
        return group;
      }
      if (tries % tries_before_spreading == 0) half_ += 0.1 * ground_.spacing;
    }
  }

 private:
  glm::dvec2 somewhere_likely() {
    glm::dvec2 place = somewhere(half_, random_);
    while (!random_.chance(swell_.chance_at(place))) place = somewhere(half_, random_);
    return place;
  }

  glm::dvec2 place_to_try(bool in_foreground, bool choosy) {
    if (in_foreground) return somewhere_in_front(ground_, random_);
    return choosy ? somewhere_likely() : somewhere(half_, random_);
  }

  bool fits(const Group& group, bool choosy) const {
    if (glm::distance(group.centre, ground_.viewpoint) < clear_view * ground_.spacing + group.radius) return false;
    const double gap = choosy ? swell_.gap_at(group.centre) : between_groups;
    return groups_.is_free(group, gap * ground_.spacing) && lanes_.is_free(group) && obstacles_.is_free(group);
  }

  const GroupGround& ground_;
  Random random_;
  GroupMap groups_;
  LaneMap lanes_;
  GroundObstacles obstacles_;
  Swell swell_;
  double half_;  // metres, of the square that is searched for places
};

}  // namespace

std::vector<StanderStart> place_groups(std::size_t standers, const GroupGround& ground, Random random) {
  std::vector<StanderStart> places;
  places.reserve(standers);
  GroupPlacer placer(ground, random);
  for (std::size_t group = 0; places.size() < standers; ++group) {
    const std::size_t size = std::min(pick_size(random), standers - places.size());
    const Group place = placer.place(size, group < foreground_groups);
    stand_in_ring(place, size, ring_jitter * ground.spacing, random, places);
  }
  return places;
}

}  // namespace throng::app
