#include "engine/anim/asset/additive_clip.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "engine/anim/asset/reference_pose.h"
#include "engine/anim/asset/synthetic_model.h"
#include "tests/anim/asset/clip_fixtures.h"

namespace throng::anim::additive_clip_test {
namespace {

constexpr double seconds = 1.3;

/// Adds to a base what `layer` has more than the rest pose, as an additive layer does.
StateTransform added(const StateTransform& base, const StateTransform& layer, const StateTransform& rest) {
  return {.rotation = base.rotation * glm::conjugate(rest.rotation) * layer.rotation,
          .position = base.position + layer.position - rest.position,
          .scale = base.scale * layer.scale / rest.scale};
}

double distance(const StateTransform& a, const StateTransform& b) {
  const double cosine = std::abs(glm::dot(glm::normalize(a.rotation), glm::normalize(b.rotation)));
  return glm::distance(a.position, b.position) + glm::distance(a.scale, b.scale) +
         std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
}

class AdditiveClip : public testing::TestWithParam<Interpolation> {
 protected:
  Model model_ = general_model(12);
  Clip clip_ = wild_clip(model_.skeleton, GetParam(), seconds, 1);
};

TEST_P(AdditiveClip, AddedToItsReferenceIsTheClipItself) {
  const Clip stance = wild_clip(model_.skeleton, Interpolation::linear, seconds, 2);
  const Clip additive = make_additive(model_.skeleton, clip_, stance, 0.4);
  const std::vector<StateTransform> from = reference_pose(model_.skeleton, &stance, 0.4).locals;
  const std::vector<StateTransform> rest = reference_pose(model_.skeleton, nullptr, 0.0).locals;
  for (int i = 0; i <= 20; ++i) {
    const double time = seconds * i / 20.0;
    const std::vector<StateTransform> layer = reference_pose(model_.skeleton, &additive, time).locals;
    const std::vector<StateTransform> expected = reference_pose(model_.skeleton, &clip_, time).locals;
    for (std::size_t bone = 0; bone < rest.size(); ++bone) {
      EXPECT_LT(distance(added(from[bone], layer[bone], rest[bone]), expected[bone]), 2e-5) << bone << " at " << time;
    }
  }
}

TEST_P(AdditiveClip, OfAPoseFromItselfIsTheRestPose) {
  const Clip additive = make_additive(model_.skeleton, clip_, clip_, 0.7);
  const std::vector<StateTransform> layer = reference_pose(model_.skeleton, &additive, 0.7).locals;
  const std::vector<StateTransform> rest = reference_pose(model_.skeleton, nullptr, 0.0).locals;
  for (std::size_t bone = 0; bone < rest.size(); ++bone) EXPECT_LT(distance(layer[bone], rest[bone]), 2e-5) << bone;
}

std::string name_of(const testing::TestParamInfo<Interpolation>& interpolation) {
  const std::string names[] = {"Step", "Linear", "Cubic"};
  return names[static_cast<std::size_t>(interpolation.param)];
}

INSTANTIATE_TEST_SUITE_P(Interpolations, AdditiveClip,
                         testing::Values(Interpolation::step, Interpolation::linear, Interpolation::cubic_spline),
                         name_of);

TEST(AdditiveClipOf, AClipWithoutTracksTakesTheReferenceAway) {
  const Model model = synthetic_model(6, 1);
  const Clip& stance = model.clips.front();
  const Clip additive = make_additive(model.skeleton, {.name = "rest", .duration = 1.0, .tracks = {}}, stance, 0.25);
  const std::vector<StateTransform> from = reference_pose(model.skeleton, &stance, 0.25).locals;
  const std::vector<StateTransform> rest = reference_pose(model.skeleton, nullptr, 0.0).locals;
  const std::vector<StateTransform> layer = reference_pose(model.skeleton, &additive, 0.5).locals;
  for (std::size_t bone = 0; bone < rest.size(); ++bone) {
    EXPECT_LT(distance(added(from[bone], layer[bone], rest[bone]), rest[bone]), 1e-5) << bone;
  }
}

}  // namespace
}  // namespace throng::anim::additive_clip_test
