#include "engine/anim/agent/blend_plane.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace throng::anim::blend_plane_test {
namespace {

using Places = std::vector<glm::vec2>;

BlendPlane plane_of(const Places& places) {
  Result<BlendPlane> plane = BlendPlane::create(places);
  EXPECT_TRUE(plane.has_value()) << plane.error().message;
  return std::move(*plane);
}

std::string refusal_of(const Places& places) {
  const Result<BlendPlane> plane = BlendPlane::create(places);
  EXPECT_FALSE(plane.has_value());
  return plane ? std::string() : plane.error().message;
}

glm::vec2 blended(const BlendPlane& plane, const BlendPlane::Shares& shares) {
  glm::vec2 sum(0.0F);
  for (const BlendPlane::Share& share : shares.all()) sum += share.weight * plane.points()[share.point];
  return sum;
}

Places random_places(unsigned seed, std::size_t count) {
  std::mt19937 random(seed);
  const auto any = [&] { return static_cast<float>(random() % 2000U) * 0.001F - 1.0F; };
  Places places;
  while (places.size() < count) {
    const glm::vec2 place(any(), any());
    if (std::ranges::find(places, place) == places.end()) places.push_back(place);
  }
  return places;
}

Places grid() {
  Places places;
  for (int x = -2; x <= 2; ++x) {
    for (int y = -1; y <= 1; ++y) places.emplace_back(static_cast<float>(x), static_cast<float>(y));
  }
  return places;
}

double whole_area(const BlendPlane& plane) {
  double sum = 0.0;
  for (const auto& [a, b, c] : plane.triangles()) {
    const glm::dvec2 p(plane.points()[a]), q(plane.points()[b]), r(plane.points()[c]);
    const double area = 0.5 * ((q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x));
    EXPECT_GT(area, 0.0) << "counter-clockwise";
    sum += area;
  }
  return sum;
}

TEST(BlendPlane, GivesEveryPointAllOfItself) {
  for (const Places& places : {random_places(1, 40), grid(), Places{{0, 0}, {1, 0}, {0, 1}}}) {
    const BlendPlane plane = plane_of(places);
    for (std::size_t i = 0; i < places.size(); ++i) {
      const BlendPlane::Shares shares = plane.shares(places[i]);
      ASSERT_EQ(shares.count, 1U);
      EXPECT_EQ(shares.of[0].point, i);
      EXPECT_EQ(shares.of[0].weight, 1.0F);
    }
  }
}

TEST(BlendPlane, BlendsTheCornersToThePlaceAskedFor) {
  std::mt19937 random(2);
  const BlendPlane plane = plane_of(grid());
  for (int i = 0; i < 2000; ++i) {
    const glm::vec2 place(static_cast<float>(random() % 4001U) * 0.001F - 2.0F,
                          static_cast<float>(random() % 2001U) * 0.001F - 1.0F);
    const BlendPlane::Shares shares = plane.shares(place);
    EXPECT_LT(glm::distance(blended(plane, shares), place), 1e-5F);
    EXPECT_TRUE(std::ranges::is_sorted(shares.all(), {}, &BlendPlane::Share::point));
  }
}

TEST(BlendPlane, CoversItsHullOnceWithTrianglesThatHoldNoOtherPointInTheirCircles) {
  EXPECT_NEAR(whole_area(plane_of(grid())), 8.0, 1e-6) << "four by two";
  for (unsigned seed = 1; seed < 30; ++seed) {
    const BlendPlane plane = plane_of(random_places(seed, 3 + seed));
    EXPECT_LE(whole_area(plane), 4.0);
    for (const auto& [a, b, c] : plane.triangles()) {
      const glm::dvec2 p(plane.points()[a]), q(plane.points()[b]), r(plane.points()[c]);
      const double d = 2.0 * (p.x * (q.y - r.y) + q.x * (r.y - p.y) + r.x * (p.y - q.y));
      const double pp = glm::dot(p, p), qq = glm::dot(q, q), rr = glm::dot(r, r);
      const glm::dvec2 middle((pp * (q.y - r.y) + qq * (r.y - p.y) + rr * (p.y - q.y)) / d,
                              (pp * (r.x - q.x) + qq * (p.x - r.x) + rr * (q.x - p.x)) / d);
      const double radius = glm::distance(middle, p);
      for (const glm::vec2& other : plane.points()) {
        EXPECT_GT(glm::distance(middle, glm::dvec2(other)), radius * (1.0 - 1e-5)) << seed;
      }
    }
  }
}

TEST(BlendPlane, ChangesNoShareSuddenly) {
  const Places places = grid();
  const BlendPlane plane = plane_of(places);
  std::vector<float> before(places.size(), 0.0F);
  for (int i = 0; i <= 20'000; ++i) {
    const float angle = 0.001F * static_cast<float>(i);
    const BlendPlane::Shares shares = plane.shares(glm::vec2(std::cos(3.0F * angle), std::sin(2.0F * angle)) * 2.4F);
    std::vector<float> now(places.size(), 0.0F);
    for (const BlendPlane::Share& share : shares.all()) now[share.point] = share.weight;
    for (std::size_t k = 0; i > 0 && k < now.size(); ++k) ASSERT_LT(std::abs(now[k] - before[k]), 0.02F) << i;
    before = now;
  }
}

TEST(BlendPlane, MovesAPlaceOutsideToTheNearestInside) {
  const BlendPlane plane = plane_of({{0, 0}, {1, 0}, {0, 1}});
  const BlendPlane::Shares below = plane.shares({0.25F, -5.0F});
  EXPECT_EQ(below.count, 2U);
  EXPECT_EQ(below.place, glm::vec2(0.25F, 0.0F));
  EXPECT_EQ(plane.shares({-1e30F, -1e30F}).of[0].point, 0U);
}

TEST(BlendPlane, OfPointsOnALineIsALine) {
  const BlendPlane plane = plane_of({{2, 2}, {0, 0}, {1, 1}});
  const BlendPlane::Shares shares = plane.shares({2.0F, 1.0F});
  ASSERT_EQ(shares.count, 2U);
  EXPECT_LT(glm::distance(blended(plane, shares), glm::vec2(1.5F)), 1e-6F);
  EXPECT_EQ(plane.shares({9.0F, 9.0F}).of[0].point, 0U);
}

TEST(BlendPlane, OfOnePointIsThatPoint) { EXPECT_EQ(plane_of({{3, 4}}).shares({-1.0F, 7.0F}).count, 1U); }

TEST(BlendPlane, RefusesPointsThatItCannotJoin) {
  const float infinity = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_NE(refusal_of({}).find("no points"), std::string::npos);
  EXPECT_NE(refusal_of({{0, 0}, {1, nan}}).find("point 1"), std::string::npos);
  EXPECT_NE(refusal_of({{infinity, 0}}).find("point 0"), std::string::npos);
  EXPECT_NE(refusal_of({{1, 2}, {0, 0}, {1, 2}}).find("points 0 and 2"), std::string::npos);
  EXPECT_NE(refusal_of(random_places(3, 65)).find("at most 64"), std::string::npos);
}

}  // namespace
}  // namespace throng::anim::blend_plane_test
