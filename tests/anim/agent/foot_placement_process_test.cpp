#include "engine/anim/agent/foot_placement_process.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "tests/anim/agent/person_crowd.h"
#include "tests/anim/kernel/limb/foot_placement_reference.h"

namespace throng::anim::foot_placement_process_test {
namespace {

constexpr float twenty_degrees = 20.0F * std::numbers::pi_v<float> / 180.0F;

/// Rises by 20 degrees towards +Z of the world.
const Footing slope{.place = {3.0F, 0.5F, -2.0F},
                    .normal = {0.0F, std::cos(twenty_degrees), -std::sin(twenty_degrees)}};

float height_over(const Footing& plane, const glm::vec3& point) { return glm::dot(point - plane.place, plane.normal); }

class PersonOnASlope : public testing::TestWithParam<float> {
 protected:
  PersonOnASlope() {
    auto feet = std::make_unique<FootPlacementProcess>(*crowd_.kinds().foot_placement);
    feet->set_ground(slope);
    feet->set_placement(placement_);
    EXPECT_TRUE(crowd_.system().agent(0).add_post_process(std::move(feet)));
  }
  const FootPlacementProcess& feet() { return *crowd_.system().agent(0).post_process<FootPlacementProcess>({0}); }
  glm::vec3 in_world(const glm::vec3& point) const { return placement_.position + placement_.rotation * point; }

  /// How far the animation has lifted an ankle from where it is in the bind pose.
  float lift(int leg) {
    const float ankle = feet().ankle(crowd_.system().characters().pools(0), leg).y - placement_.position.y;
    return ankle + person_rigs().foot_placement()->legs[static_cast<std::size_t>(leg)].sole[0].y;
  }

  /// Of heel and ball, whichever is lower; metres over the slope.
  float sole_over(const Footing& plane, const char* foot, std::size_t leg) const {
    const JointMotion ankle = crowd_.joint(foot);
    const PlacedLeg& about = person_rigs().foot_placement()->legs[leg];
    const glm::vec3 normal = glm::conjugate(placement_.rotation) * plane.normal;
    return std::min(height_over(plane, in_world(ankle.position + ankle.rotation * about.sole[0])),
                    height_over(plane, in_world(ankle.position + under_toes(about, ankle.rotation, normal))));
  }

  PersonCrowd crowd_{{.schedule = Schedule::levels}};
  // The character stands where its origin is on the slope.
  JointMotion placement_{.rotation = glm::angleAxis(GetParam(), glm::vec3(0.0F, 1.0F, 0.0F)),
                         .position = {4.0F, ground_height(slope, 4.0F, -1.0F), -1.0F}};
};

INSTANTIATE_TEST_SUITE_P(FacingAnyWay, PersonOnASlope, testing::Values(0.0F, 0.8F, 1.6F, 3.1F, -2.0F));

TEST_P(PersonOnASlope, HasPlantedFeetWithinACentimetreOfIt) {
  int planted = 0;
  int lifted = 0;
  for (int frame = 0; frame < 180; ++frame) {
    crowd_.step();
    for (std::size_t leg = 0; leg < 2; ++leg) {
      const float over = sole_over(slope, leg == 0 ? "foot.L" : "foot.R", leg);
      const bool is_locked = feet().lock(crowd_.system().characters().pools(0), static_cast<int>(leg)).locked();
      if (is_locked && lift(static_cast<int>(leg)) < 0.02F) {
        ++planted;
        EXPECT_NEAR(over, 0.0F, 0.01F) << "frame " << frame << ", leg " << leg;
      } else {
        ++lifted;
        EXPECT_GT(over, -0.01F);
      }
    }
  }
  EXPECT_GT(planted, 120);
  EXPECT_GT(lifted, 60);
}

TEST_P(PersonOnASlope, StandsOnGroundThatTheHostSamplesUnderEachAnkle) {
  const auto ground_at = [](const glm::vec3& place) {
    return Footing{.place = {place.x, ground_height(slope, place.x, place.z), place.z}, .normal = slope.normal};
  };
  const auto stand_up = [](auto& process) {
    process.set_planted(0, 1.0F);
    process.set_planted(1, 1.0F);
  };
  EXPECT_TRUE(crowd_.system().agent(0).play({.clip = 1}));
  EXPECT_TRUE(crowd_.system().agent(0).change_process<FootPlacementProcess>({0}, stand_up));
  for (int frame = 0; frame < 60; ++frame) {
    crowd_.step();
    EXPECT_TRUE(crowd_.system().agent(0).change_process<FootPlacementProcess>({0}, [&](auto& process) {
      for (int leg = 0; leg < 2; ++leg) {
        process.set_ground(leg, ground_at(process.ankle(crowd_.system().characters().pools(0), leg)));
      }
    }));
    EXPECT_NEAR(sole_over(slope, "foot.L", 0), 0.0F, 0.01F);
    EXPECT_NEAR(sole_over(slope, "foot.R", 1), 0.0F, 0.01F);
  }
}

}  // namespace
}  // namespace throng::anim::foot_placement_process_test
