// Densities of people by the ground that each has, against areas worked out by hand and areas that are sampled.

#include "app/people/measure/voronoi_density.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "engine/anim/run/pu_threads.h"
#include "tests/counting/hot_path_counter.h"

namespace throng::app::voronoi_density_test {
namespace {

constexpr float cut_off = 1.0F;
constexpr float uncut = 1.0F / 3.0F;  // a polygon of twelve corners around a metre has 3 square metres

using Places = std::vector<glm::vec2>;

std::vector<float> densities_of(const Places& places, const WalkableArea& area = {}, float radius = cut_off,
                                const std::vector<std::uint8_t>& absent = {}) {
  std::vector<glm::vec3> positions;
  for (const glm::vec2& place : places) positions.emplace_back(place.x, 0.0F, place.y);
  std::vector<float> densities(places.size());
  InOrder here;
  VoronoiDensity().measure({positions, absent}, radius, area, here, 1, densities);
  return densities;
}

WalkableArea area_of(GroundRing outline, std::vector<GroundRing> holes = {}) {
  GroundPlan plan;
  plan.floors.push_back({std::move(outline), std::move(holes)});
  return WalkableArea(plan);
}

GroundRing rectangle(float left, float low, float right, float high) {
  return {{left, low}, {right, low}, {right, high}, {left, high}};
}

TEST(VoronoiDensity, OfSomebodyAloneIsThatOfTheCutOff) {
  EXPECT_NEAR(densities_of({{5.0F, -3.0F}})[0], uncut, 1e-5F);
  EXPECT_NEAR(densities_of({{5.0F, -3.0F}}, {}, 2.0F)[0], uncut / 4.0F, 1e-5F);
}

TEST(VoronoiDensity, OfASquareLatticeIsOneOverTheSquareOfItsSpacing) {
  for (const float spacing : {0.4F, 0.5F, 0.8F}) {
    Places places;
    for (int x = 0; x < 9; ++x) {
      for (int z = 0; z < 9; ++z) places.push_back(spacing * glm::vec2(x, z));
    }
    EXPECT_NEAR(densities_of(places)[40], 1.0F / (spacing * spacing), 1e-3F) << spacing;
  }
}

TEST(VoronoiDensity, OfTwoPeopleIsThatOfWhatIsOnTheirSideOfTheMiddle) {
  // The part of the polygon on one side of a line through its middle is a half.
  EXPECT_NEAR(densities_of({{0.0F, 0.0F}, {1e-2F, 0.0F}})[0], 2.0F * uncut, 0.01F);
  // Beyond half a metre lie the corners at 60, 30, 0, -30 and -60 degrees: a trapezoid and a triangle.
  const float far = std::sqrt(3.0F) / 2.0F, cap = (far - 0.5F) * (far + 0.5F) + 0.5F * (1.0F - far);
  const std::vector<float> densities = densities_of({{0.0F, 0.0F}, {1.0F, 0.0F}});
  EXPECT_NEAR(densities[0], 1.0F / (3.0F - cap), 1e-3F);
  EXPECT_NEAR(densities[1], densities[0], 1e-5F);
}

TEST(VoronoiDensity, OfTwoPeopleAtTheSamePlaceIsThatOfBothOnTheirGround) {
  EXPECT_NEAR(densities_of({{2.0F, 2.0F}, {2.0F, 2.0F}})[1], 2.0F * uncut, 1e-4F);
}

TEST(VoronoiDensity, KnowsNothingOfWhoIsNotThere) {
  const std::vector<float> densities = densities_of({{0.0F, 0.0F}, {0.5F, 0.0F}}, {}, cut_off, {0, 1});
  EXPECT_NEAR(densities[0], uncut, 1e-5F);
  EXPECT_LT(densities[1], 0.0F);
}

TEST(VoronoiDensity, EndsAtTheEdgeOfTheFloor) {
  // Within half a metre of a corner a square of a metre is left where the floor is narrow.
  EXPECT_NEAR(densities_of({{0.5F, 0.5F}}, area_of(rectangle(0, 0, 1, 1)))[0], 1.0F, 1e-4F);
  EXPECT_NEAR(densities_of({{0.0F, 0.0F}}, area_of(rectangle(-9, 0, 9, 9)))[0], 2.0F * uncut, 1e-3F);
}

// A floor 1 m wide along x. Within half a metre aside the polygon of a metre reaches to 0.866 at its edge and to 1 in
// the middle.
TEST(VoronoiDensity, EndsAtAWall) {
  GroundPlan plan;
  plan.floors.push_back({rectangle(-2, -0.5F, 2, 0.5F), {}});
  plan.walls.push_back({{{0.25F, -1.0F}, {0.25F, 1.0F}}});
  const WalkableArea area(plan);
  const float far = std::sqrt(3.0F) / 2.0F, left = 0.5F * (1.0F + far), right = 0.25F;
  EXPECT_NEAR(1.0F / densities_of({{0.0F, 0.0F}}, area)[0], left + right, 2e-3F);
  // Others count on both sides of it, as for PedPy.
  EXPECT_NEAR(1.0F / densities_of({{0.0F, 0.0F}, {0.4F, 0.0F}}, area)[0], left + 0.2F, 2e-3F);
}

TEST(VoronoiDensity, OfAWallThatEndsNearByGoesOnAroundIt) {
  GroundPlan plan;
  plan.floors.push_back({rectangle(-5, -5, 5, 5), {}});
  plan.walls.push_back({{{0.25F, -5.0F}, {0.25F, 0.0F}}});
  EXPECT_NEAR(densities_of({{0.0F, 0.0F}}, WalkableArea(plan))[0], uncut, 1e-3F);
}

TEST(VoronoiDensity, InAnLDoesNotReachAroundTheCornerThroughTheWall) {
  // Two arms 0.6 m wide, and a gap of 0.4 m between them: the other arm is within a metre, but not to be walked to.
  const WalkableArea arms =
      area_of({{0, 0}, {3, 0}, {3, 0.6F}, {0.6F, 0.6F}, {0.6F, 1.0F}, {3, 1.0F}, {3, 1.6F}, {0, 1.6F}});
  const float density = densities_of({{2.0F, 0.5F}}, arms)[0];
  const float alone = densities_of({{2.0F, 0.5F}}, area_of(rectangle(0, 0, 3, 0.6F)))[0];
  EXPECT_NEAR(density, alone, 1e-3F);
  EXPECT_GT(densities_of({{0.4F, 0.8F}}, arms)[0], 0.0F);
}

TEST(VoronoiDensity, LeavesAHoleOut) {
  const WalkableArea area = area_of(rectangle(-5, -5, 5, 5), {rectangle(0.2F, -0.2F, 0.6F, 0.2F)});
  EXPECT_NEAR(densities_of({{0.0F, 0.0F}}, area)[0], 1.0F / (3.0F - 0.16F), 1e-3F);
}

TEST(VoronoiDensity, LeavesAnObstacleOutWhereThereIsNoFloor) {
  GroundPlan plan;
  plan.obstacles.push_back(rectangle(0.2F, -0.2F, 0.6F, 0.2F));
  const WalkableArea area(plan);
  EXPECT_NEAR(densities_of({{0.0F, 0.0F}}, area)[0], 1.0F / (3.0F - 0.16F), 1e-3F);
  EXPECT_NEAR(densities_of({{700.0F, -900.0F}}, area)[0], uncut, 1e-4F);
}

TEST(VoronoiDensity, OfWhoLeansOverTheEdgeIsThatOfTheFloorBesideThem) {
  const WalkableArea floor = area_of(rectangle(0, -5, 5, 5));
  EXPECT_NEAR(densities_of({{-0.01F, 0.0F}}, floor)[0], 2.0F * uncut, 0.02F);
  EXPECT_LT(densities_of({{-1.5F, 0.0F}}, floor)[0], 0.0F) << "too far away";
}

/// Counts small squares: those that are nearer to the person than to anybody else, within the cut-off, on the floor,
/// and to be reached from the person through such squares.
double sampled_area(const Places& places, std::size_t person, const std::vector<GroundRing>& solid,
                    const GroundRing& floor) {
  constexpr int half = 200;
  constexpr float side = 1.0F / half;
  const auto is_in = [](const GroundRing& ring, const glm::vec2& at) {
    bool within = false;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const glm::vec2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
      if ((a.y > at.y) != (b.y > at.y) && at.x < a.x + (at.y - a.y) / (b.y - a.y) * (b.x - a.x)) within = !within;
    }
    return within;
  };
  GroundRing circle;
  for (int i = 0; i < cut_off_corners; ++i) {
    const float angle = 0.5236F * static_cast<float>(i);
    circle.push_back(places[person] + glm::vec2(std::cos(angle), std::sin(angle)));
  }
  const auto counts = [&](int column, int row) {
    const glm::vec2 at = places[person] + side * (glm::vec2(column, row) + 0.5F);
    if (!is_in(circle, at) || !is_in(floor, at)) return false;
    const auto holds = [&](const GroundRing& ring) { return is_in(ring, at); };
    if (std::ranges::any_of(solid, holds)) return false;
    const auto is_nearer = [&](const glm::vec2& other) {
      return glm::distance(at, other) < glm::distance(at, places[person]);
    };
    return std::ranges::none_of(places, is_nearer);
  };
  std::vector<std::uint8_t> seen(4 * half * half, 0);
  std::vector<std::pair<int, int>> waiting{{0, 0}};
  double area = 0.0;
  while (!waiting.empty()) {
    const auto [column, row] = waiting.back();
    waiting.pop_back();
    if (std::max(column, row) >= half || std::min(column, row) < -half) continue;
    std::uint8_t& is_seen = seen[static_cast<std::size_t>((row + half) * 2 * half + column + half)];
    if (is_seen != 0 || !counts(column, row)) continue;
    is_seen = 1;
    area += static_cast<double>(side) * static_cast<double>(side);
    for (const auto& [right, down] : {std::pair(1, 0), {-1, 0}, {0, 1}, {0, -1}}) {
      waiting.emplace_back(column + right, row + down);
    }
  }
  return area;
}

TEST(VoronoiDensity, IsThatOfSampledGroundAmongObstaclesOfAnyShape) {
  std::mt19937 random(7);
  const auto between = [&](float low, float high) { return std::uniform_real_distribution<float>(low, high)(random); };
  int compared = 0;
  for (int scene = 0; scene < 12; ++scene) {
    GroundPlan plan;
    const GroundRing floor{{0, 0}, {4, 0.3F}, {4.2F, 2}, {2.1F, 2.2F}, {2.0F, 4}, {0.1F, 3.8F}};
    plan.floors.push_back({floor, {}});
    for (int i = 0; i < 3; ++i) {
      const glm::vec2 at(between(0.5F, 3.5F), between(0.5F, 3.5F)), along(between(0.2F, 1.2F), between(-0.5F, 0.5F));
      const glm::vec2 aside = 0.15F * glm::normalize(glm::vec2(-along.y, along.x));
      plan.obstacles.push_back({at - aside, at + along - aside, at + along + aside, at + aside});
    }
    Places places;
    for (int i = 0; i < 14; ++i) places.emplace_back(between(0.2F, 4.0F), between(0.2F, 3.8F));
    const std::vector<float> densities = densities_of(places, WalkableArea(plan));
    for (std::size_t person = 0; person < places.size(); ++person) {
      const double area = sampled_area(places, person, plan.obstacles, floor);
      if (area < 0.05) continue;  // within an obstacle, or so close to others that the squares are too large
      EXPECT_NEAR(1.0 / static_cast<double>(densities[person]), area, 0.03) << scene << ": " << person;
      ++compared;
    }
  }
  EXPECT_GT(compared, 60);
}

TEST(VoronoiDensity, IsTheSameByAnyNumberOfJobsAndAllocatesNothing) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> place(0.0F, 20.0F);
  std::vector<glm::vec3> positions(1500);
  for (glm::vec3& position : positions) position = {place(random), 0.0F, place(random)};
  const WalkableArea area = area_of(rectangle(0, 0, 20, 20), {rectangle(5, 5, 7, 9)});
  std::vector<float> alone(positions.size()), together(positions.size());
  InOrder here;
  anim::PuThreads threads(4);
  VoronoiDensity density;
  density.measure({positions, {}}, cut_off, area, here, 1, alone);
  density.measure({positions, {}}, cut_off, area, threads, 4, together);
  EXPECT_EQ(alone, together);
  const HotPathCounts before = hot_path_counts();
  density.measure({positions, {}}, cut_off, area, threads, 4, together);
  EXPECT_EQ((hot_path_counts() - before).allocations, 0U);
}

}  // namespace
}  // namespace throng::app::voronoi_density_test
