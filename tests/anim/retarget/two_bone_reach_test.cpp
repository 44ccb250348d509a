#include "engine/anim/retarget/two_bone_reach.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace throng::anim::two_bone_reach_test {
namespace {

constexpr glm::dvec3 forward(0.0, 0.0, 1.0);
constexpr LegPlaces leg{{0.1, 0.9, 0.0}, {0.1, 0.5, 0.05}, {0.1, 0.1, 0.0}};

glm::dvec3 end_of(const LegPlaces& places, const LegTurns& turns) {
  return places.hip + turns.upper * (places.knee - places.hip) + turns.lower * (places.ankle - places.knee);
}

TEST(Reach, EndsAtTheTargetWithTheKneeInFront) {
  for (const glm::dvec3& target :
       {glm::dvec3(0.1, 0.3, 0.2), glm::dvec3(-0.1, 0.25, -0.2), glm::dvec3(0.1, 0.12, 0.0)}) {
    const LegTurns turns = reach(leg, target, forward);
    EXPECT_LT(glm::distance(end_of(leg, turns), target), 1e-9);
    EXPECT_LT(glm::distance(turns.ankle, target), 1e-9);
    EXPECT_GT((turns.upper * (leg.knee - leg.hip)).z - 0.5 * (target - leg.hip).z, 0.0);
  }
}

TEST(Reach, ReachesAsFarAsTheLegIsLong) {
  const LegTurns turns = reach(leg, {0.1, -1.0, 0.0}, forward);
  EXPECT_LT(glm::distance(end_of(leg, turns), turns.ankle), 1e-9);
  EXPECT_NEAR(glm::distance(leg.hip, turns.ankle), 2.0 * glm::length(glm::dvec2(0.4, 0.05)), 1e-3);
}

TEST(Reach, BendsAStraightLegForward) {
  const LegPlaces straight{{0.0, 0.9, 0.0}, {0.0, 0.5, 0.0}, {0.0, 0.1, 0.0}};
  const LegTurns turns = reach(straight, {0.0, 0.4, 0.0}, forward);
  EXPECT_GT((turns.upper * (straight.knee - straight.hip)).z, 0.1);
}

TEST(Reach, FoldsNoFurtherThanAKnee) {
  const LegTurns turns = reach(leg, {0.1, 0.85, 0.0}, forward);
  const glm::dvec3 thigh = glm::normalize(turns.upper * (leg.knee - leg.hip));
  const glm::dvec3 shin = glm::normalize(turns.lower * (leg.ankle - leg.knee));
  EXPECT_NEAR(glm::dot(thigh, shin), -0.94, 1e-6);
}

TEST(Reach, LeavesALegWithoutLength) {
  const LegPlaces point{};
  const LegTurns turns = reach(point, {0.0, 1.0, 0.0}, forward);
  EXPECT_EQ(turns.upper, glm::dquat(1.0, 0.0, 0.0, 0.0));
}

TEST(DropToReach, IsWhatTheLegLacks) {
  EXPECT_EQ(drop_to_reach(leg, {0.1, 0.2, 0.0}), 0.0);
  const LegPlaces straight{{0.0, 0.9, 0.0}, {0.0, 0.5, 0.0}, {0.0, 0.1, 0.0}};
  EXPECT_NEAR(drop_to_reach(straight, {0.0, 0.0, 0.0}), 0.1, 1e-3);
  EXPECT_EQ(drop_to_reach(straight, {2.0, 0.0, 0.0}), 0.0) << "no drop would do";
}

}  // namespace
}  // namespace throng::anim::two_bone_reach_test
