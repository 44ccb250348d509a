#include "app/people/place/plan_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <gtest/gtest.h>

namespace throng::app::plan_mesh_test {
namespace {

constexpr float height = 1.2F;

struct Face {
  std::array<glm::vec3, 3> corners;
  glm::vec3 normal;

  bool is_upright() const { return std::abs(normal.y) < 0.5F; }
  bool is_top() const { return !is_upright() && corners[0].y > 0.5F * height; }
  bool is_on_ground() const { return !is_upright() && !is_top(); }
  glm::vec3 across() const { return glm::cross(corners[1] - corners[0], corners[2] - corners[0]); }
  double area() const { return 0.5 * static_cast<double>(glm::length(across())); }
};

std::vector<Face> faces_of(const GroundPlan& plan) {
  const render::SceneryMeshData mesh = plan_mesh(plan, height);
  const auto& indices = mesh.lods.front().indices;
  std::vector<Face> faces;
  for (std::size_t i = 0; i < indices.size(); i += 3) {
    Face face{};
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const render::SceneryVertex& vertex = mesh.vertices[indices[i + corner]];
      face.corners.at(corner) = {vertex.position[0], vertex.position[1], vertex.position[2]};
      face.normal = {vertex.normal[0], vertex.normal[1], vertex.normal[2]};
    }
    faces.push_back(face);
  }
  return faces;
}

bool holds(const Face& face, const glm::vec2& at, float margin = 0.0F) {
  bool has_left = false, has_right = false;
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::vec3 &from = face.corners.at(i), &to = face.corners.at((i + 1) % 3);
    const glm::vec2 way(to.x - from.x, to.z - from.z);
    const float aside = (way.x * (at.y - from.z) - way.y * (at.x - from.x)) / std::max(glm::length(way), 1e-9F);
    has_left |= aside > margin, has_right |= aside < -margin;
  }
  return !has_left || !has_right;
}

bool is_in_wall(const std::vector<Face>& faces, const glm::vec2& at) {
  return std::ranges::any_of(faces, [&](const Face& face) { return face.is_top() && holds(face, at); });
}

template <typename Wanted>
double area_of(const std::vector<Face>& faces, Wanted wanted) {
  double sum = 0.0;
  for (const Face& face : faces) sum += wanted(face) ? face.area() : 0.0;
  return sum;
}

double top_area(const std::vector<Face>& faces) {
  return area_of(faces, [](const Face& face) { return face.is_top(); });
}

double ground_area(const std::vector<Face>& faces) {
  return area_of(faces, [](const Face& face) { return face.is_on_ground(); });
}

GroundRing rectangle(glm::vec2 low, glm::vec2 high) { return {low, {high.x, low.y}, high, {low.x, high.y}}; }

GroundPlan floor_of(const GroundRing& outline, const std::vector<GroundRing>& holes = {}) {
  GroundPlan plan;
  plan.floors.push_back({outline, holes});
  return plan;
}

GroundPlan obstacle_of(const GroundRing& outline) {
  GroundPlan plan;
  plan.obstacles.push_back(outline);
  return plan;
}

GroundPlan room_with_pillar() {
  return floor_of(rectangle({0.0F, 0.0F}, {10.0F, 8.0F}), {rectangle({4.0F, 3.0F}, {5.0F, 4.0F})});
}

/// Nothing is missing around the walls: their sides face all ways alike, and each begins where another one ends.
void expect_closed_above_ground(const std::vector<Face>& faces) {
  glm::dvec3 sum(0.0);
  for (const Face& face : faces) {
    if (face.is_on_ground()) continue;
    sum += glm::dvec3(face.normal) * face.area();
  }
  EXPECT_NEAR(sum.x, 0.0, 1e-3);
  EXPECT_NEAR(sum.z, 0.0, 1e-3);
  std::map<std::pair<long, long>, int> balance;
  const auto key = [](const glm::vec3& at) { return std::pair(std::lround(at.x * 1e3F), std::lround(at.z * 1e3F)); };
  for (const Face& face : faces) {
    if (!face.is_upright()) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      const glm::vec3 &from = face.corners.at(i), &to = face.corners.at((i + 1) % 3);
      if (std::max(from.y, to.y) > 0.0F) continue;
      ++balance[key(from)];
      --balance[key(to)];
    }
  }
  EXPECT_GT(balance.size(), 3U);
  for (const auto& [at, count] : balance) EXPECT_EQ(count, 0) << at.first << " mm, " << at.second << " mm";
}

}  // namespace

TEST(PlanMesh, WallsStandOutsideOfWherePeopleWalk) {
  const std::vector<Face> faces = faces_of(room_with_pillar());
  for (float x = -1.0F; x < 11.0F; x += 0.0511F) {
    for (float z = -1.0F; z < 9.0F; z += 0.0507F) {
      const bool is_in_room = x > 0.0F && x < 10.0F && z > 0.0F && z < 8.0F;
      const bool is_in_pillar = x > 4.0F && x < 5.0F && z > 3.0F && z < 4.0F;
      const bool is_near = x > -0.15F && x < 10.15F && z > -0.15F && z < 8.15F;
      EXPECT_EQ(is_in_wall(faces, {x, z}), is_in_pillar || (is_near && !is_in_room)) << x << ", " << z;
    }
  }
  EXPECT_NEAR(top_area(faces), 10.3 * 8.3 - 80.0 + 1.0, 1e-3);
  EXPECT_NEAR(ground_area(faces), 79.0, 1e-3);
}

TEST(PlanMesh, WallsAreAsHighAsAskedAndClosed) {
  const std::vector<Face> faces = faces_of(room_with_pillar());
  expect_closed_above_ground(faces);
  const double feet = 2.0 * (10.0 + 8.0) + 2.0 * (10.3 + 8.3) + 4.0;
  EXPECT_NEAR(area_of(faces, [](const Face& face) { return face.is_upright(); }), feet * (1.2 + 0.003), 1e-2);
  for (const Face& face : faces) {
    for (const glm::vec3& corner : face.corners) {
      EXPECT_TRUE(std::abs(corner.y - height) < 1e-6F || (corner.y < 0.0F && corner.y > -0.01F) || face.is_upright());
      EXPECT_LE(corner.y, height);
    }
    EXPECT_GT(glm::dot(face.across(), face.normal), 0.0F) << "it is seen from its back";
  }
}

TEST(PlanMesh, SidesFaceAwayFromTheirWalls) {
  const std::vector<Face> faces = faces_of(room_with_pillar());
  for (const Face& face : faces) {
    if (!face.is_upright()) continue;
    const glm::vec3 middle = (face.corners[0] + face.corners[1] + face.corners[2]) / 3.0F;
    const glm::vec3 before = middle + 0.01F * face.normal, behind = middle - 0.01F * face.normal;
    EXPECT_FALSE(is_in_wall(faces, {before.x, before.z}));
    EXPECT_TRUE(is_in_wall(faces, {behind.x, behind.z}));
  }
}

TEST(PlanMesh, ThinPartitionsAndSharpCornersLeaveTheFloorFree) {
  // A notch of 4 cm, thinner than a wall; a spike of a few degrees; a second floor beside the first one.
  GroundPlan plan;
  plan.floors.push_back({{{0, 0}, {4.98F, 0}, {4.98F, 6}, {5.02F, 6}, {5.02F, 0}, {10, 0}, {10, 8}, {6, 7.9F}, {0, 8}},
                         {{{2, 2}, {4, 2.02F}, {2, 2.04F}}}});
  plan.floors.push_back({rectangle({10, 0}, {14, 8}), {}});
  const std::vector<Face> faces = faces_of(plan);
  expect_closed_above_ground(faces);
  for (const glm::vec2 free : {glm::vec2(4.97F, 3.0F), glm::vec2(5.03F, 3.0F), glm::vec2(4.1F, 2.02F),
                               glm::vec2(6.0F, 7.88F), glm::vec2(9.99F, 4.0F), glm::vec2(10.01F, 4.0F)}) {
    EXPECT_FALSE(is_in_wall(faces, free)) << free.x << ", " << free.y;
  }
  for (const glm::vec2 solid : {glm::vec2(5.0F, 3.0F), glm::vec2(2.05F, 2.02F), glm::vec2(14.1F, 4.0F)}) {
    EXPECT_TRUE(is_in_wall(faces, solid)) << solid.x << ", " << solid.y;
  }
}

TEST(PlanMesh, ObstaclesAreBlocksAndLinesAreWalls) {
  GroundPlan plan = obstacle_of(rectangle({1, 1}, {3, 2}));
  plan.walls.push_back({{{0, 5}, {4, 5}, {4, 9}}, ""});
  const std::vector<Face> faces = faces_of(plan);
  expect_closed_above_ground(faces);
  EXPECT_NEAR(top_area(faces), 2.0 + 8.0 * 0.15, 1e-3);  // the corner fills what the ends overlap
  EXPECT_NEAR(ground_area(faces), 0.0, 1e-9);
  EXPECT_TRUE(is_in_wall(faces, {2.0F, 1.5F}));
  EXPECT_TRUE(is_in_wall(faces, {4.05F, 7.0F}));
  EXPECT_FALSE(is_in_wall(faces, {3.5F, 7.0F}));
}

TEST(PlanMesh, AnExitOpensAWall) {
  GroundPlan plan = room_with_pillar();
  plan.exits.push_back({rectangle({9.5F, 3.0F}, {10.5F, 5.0F}), {}});
  plan.measurement_lines.push_back({{{2, 0}, {2, 8}}, "entrance"});
  const std::vector<Face> faces = faces_of(plan);
  expect_closed_above_ground(faces);
  EXPECT_FALSE(is_in_wall(faces, {10.1F, 4.0F}));
  EXPECT_TRUE(is_in_wall(faces, {10.1F, 5.5F}));
  EXPECT_NEAR(ground_area(faces), 79.0 + 2.0 + 8.08 * 0.08, 1e-3);
}

TEST(PlanMesh, DegenerateRingsBecomeWallsOrNothing) {
  const GroundRing line{{0, 0}, {5, 0}}, flat{{0, 0}, {5, 0}, {2, 0}}, bow{{0, 0}, {4, 4}, {4, 0}, {0, 4}},
      repeated{{1, 1}, {1, 1}, {1, 1}, {1, 1}}, doubled{{0, 0}, {4, 0}, {4, 4}, {4, 4}, {0, 4}, {0, 0}};
  const double nothing = 0.0;
  for (const auto& [ring, ground] : {std::pair(line, nothing), std::pair(flat, nothing), std::pair(bow, 8.0),
                                     std::pair(repeated, nothing), std::pair(doubled, 16.0)}) {
    EXPECT_NEAR(ground_area(faces_of(floor_of(ring, {ring}))), 0.0, 1e-3) << "its hole is all of it";
    const std::vector<Face> alone = faces_of(floor_of(ring));
    EXPECT_NEAR(ground_area(alone), ground, 1e-3);
    if (ring != repeated) {
      EXPECT_GT(top_area(alone), 0.7);
      expect_closed_above_ground(alone);
      EXPECT_GT(top_area(faces_of(obstacle_of(ring))), 0.7);
    }
  }
  EXPECT_TRUE(plan_mesh({}).vertices.empty());
  GroundPlan empty = floor_of({}, {{}});
  empty.obstacles.emplace_back();
  empty.exits.emplace_back();
  for (std::vector<GroundLine>* lines : {&empty.walls, &empty.measurement_lines}) {
    lines->emplace_back();
    lines->push_back({{{1, 1}}, ""});
  }
  EXPECT_TRUE(faces_of(empty).empty());
}

TEST(PlanMesh, HasNothingOfPlansThatWouldTakeMoreThanASecond) {
  GroundPlan plan;
  const auto add_walls = [&plan](int from, int to) {
    for (int i = from; i < to; ++i) {
      const float x = static_cast<float>(i % 100) * 3.0F, z = static_cast<float>(i / 100) * 3.0F;
      plan.walls.push_back({{{x, z}, {x + 1.0F, z}}, ""});
    }
  };
  add_walls(0, static_cast<int>(most_plan_lines / 2));
  EXPECT_EQ(plan_lines(plan), most_plan_lines);
  EXPECT_FALSE(plan_mesh(plan).vertices.empty());
  add_walls(static_cast<int>(most_plan_lines / 2), static_cast<int>(most_plan_lines / 2) + 1);
  EXPECT_EQ(plan_lines(plan), most_plan_lines + 2);
  EXPECT_TRUE(plan_mesh(plan).vertices.empty());
}

TEST(PlanMesh, NoTriangleIsLong) {
  const std::vector<Face> faces = faces_of(floor_of(rectangle({-400, -20}, {400, 20})));
  float longest = 0.0F;
  for (const Face& face : faces) {
    for (std::size_t i = 0; i < 3; ++i) {
      longest = std::max(longest, glm::distance(face.corners.at(i), face.corners.at((i + 1) % 3)));
    }
  }
  EXPECT_LE(longest, 3.001F);
  EXPECT_LT(faces.size(), 100'000U);
}

TEST(PlanMesh, FarFromTheOriginEndsWhereNumbersDo) {
  for (const float far : {2e7F, 1e8F, 9e8F}) {
    const glm::vec2 corner(far, far);
    const GroundPlan plan = floor_of(rectangle(corner, corner + glm::vec2(200.0F)));
    EXPECT_FALSE(plan_mesh(plan).vertices.empty()) << far;
  }
}

}  // namespace throng::app::plan_mesh_test
