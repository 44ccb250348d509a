#include "app/people/measure/voronoi_density.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "engine/base/tiles.h"

namespace throng::app {
namespace {

constexpr float same_place = 1e-3F;  // metres
constexpr float no_density = -1.0F;

/// The nearest others of a person, the nearest first.
class Nearest {
 public:
  struct Other {
    float distance_squared;
    glm::vec2 way;
  };

  Nearest(const CrowdCells& all, const Body& person, float reach) {
    all.visit_near(person.position, [&](const Body& body) {
      const glm::vec2 way = body.position - person.position;
      const float squared = glm::dot(way, way);
      if (body.agent != person.agent && squared < reach * reach) add({squared, way});
    });
    std::make_heap(others_.data(), end(), is_farther);
  }

  bool is_empty() const { return count_ == 0; }
  Other take() {
    std::pop_heap(others_.data(), end(), is_farther);
    return others_[--count_];
  }

 private:
  static bool is_farther(const Other& a, const Other& b) { return a.distance_squared > b.distance_squared; }
  static bool is_nearer(const Other& a, const Other& b) { return a.distance_squared < b.distance_squared; }
  Other* end() { return others_.data() + count_; }

  // Keeps the nearest of very many people: they cut the ground to less than the rest could reach.
  void add(const Other& other) {
    if (count_ < others_.size()) {
      others_[count_++] = other;
      if (count_ == others_.size()) std::make_heap(others_.begin(), others_.end(), is_nearer);
    } else if (is_nearer(other, others_.front())) {
      std::pop_heap(others_.begin(), others_.end(), is_nearer);
      others_.back() = other;
      std::push_heap(others_.begin(), others_.end(), is_nearer);
    }
  }

  std::array<Other, 192> others_;
  std::size_t count_ = 0;
};

/// Returns the corners of the polygon of radius 1.
std::array<glm::vec2, cut_off_corners> circle() {
  std::array<glm::vec2, cut_off_corners> corners;
  for (int i = 0; i < cut_off_corners; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / cut_off_corners;
    corners.at(static_cast<std::size_t>(i)) = {std::cos(angle), std::sin(angle)};
  }
  return corners;
}

float density_at(const Body& person, const CrowdCells& all, float cut_off, const WalkableArea& area) {
  static const std::array<glm::vec2, cut_off_corners> directions = circle();
  std::array<glm::vec2, cut_off_corners> corners = directions;
  for (glm::vec2& corner : corners) corner *= cut_off;
  ConvexPolygon ground(corners);
  Nearest others(all, person, 2.0F * cut_off);
  float sharing = 1.0F;
  while (!others.is_empty()) {
    const auto [squared, way] = others.take();
    if (squared > 4.0F * ground.reach_squared()) break;
    if (squared < same_place * same_place) {
      ++sharing;
      continue;
    }
    ground.cut(way, 0.5F * squared);
  }
  const float square_metres = area.area_around(person.position, ground);
  constexpr float least = 1e-4F;  // square metres; less is an error of rounding
  return square_metres < least ? no_density : sharing / square_metres;
}

}  // namespace

void VoronoiDensity::measure(const MeasuredPeople& people, float cut_off, const WalkableArea& area, Executor& executor,
                             int jobs, std::span<float> densities) {
  assert(densities.size() == people.positions.size() && cut_off > 0.0F);
  std::ranges::fill(densities, no_density);
  bodies_.reserve(people.positions.size());
  bodies_.clear();
  glm::vec2 low(std::numeric_limits<float>::max()), high(std::numeric_limits<float>::lowest());
  for (std::size_t person = 0; person < people.positions.size(); ++person) {
    if (!people.absent.empty() && people.absent[person] != 0) continue;
    const glm::vec2 place(people.positions[person].x, people.positions[person].z);
    bodies_.push_back({.position = place, .agent = static_cast<std::uint32_t>(person)});
    low = glm::min(low, place), high = glm::max(high, place);
  }
  if (bodies_.empty()) return;
  neighbours_.set_aside(bodies_.size(), low, high, 2.0F * cut_off);
  neighbours_.sort(bodies_);
  const std::span<const Body> sorted = neighbours_.bodies();
  visit_in_tiles(sorted.size(), executor, jobs, [&](std::size_t at) {
    densities[sorted[at].agent] = density_at(sorted[at], neighbours_, cut_off, area);
  });
}

}  // namespace throng::app
