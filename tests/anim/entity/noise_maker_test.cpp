#include "engine/anim/entity/noise_maker.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/anim/entity/entity_rig.h"

namespace throng::anim::noise_maker_test {
namespace {

constexpr float amplitude = 0.05F;  // radians

struct Fidget {
  Fidget() : source(rig.held(0.4F, 0.2F)), entity(rig.create(EntityPools::noise_makers)) {
    get().source = source;
    get().frequency = 2.0F;
    get().amplitude = amplitude;
    get().seed = 3;
    get().mask = EaseBlender::no_mask;
  }
  NoiseMaker& get() { return rig.as<NoiseMaker>(entity); }
  std::vector<float> after(Ticks delta) {
    rig.update(entity, delta);
    return rig.floats(entity);
  }
  float turned(int bone) {
    const glm::quat difference = glm::inverse(rig.pose(source).rotation(bone)) * rig.pose(entity).rotation(bone);
    return 2.0F * std::asin(std::min(1.0F, std::hypot(difference.x, difference.y, difference.z)));
  }
  EntityRig rig;
  Handle source;
  Handle entity;
};

TEST(NoiseMaker, TurnsEveryBoneALittleAndMovesNone) {
  Fidget fidget;
  float largest = 0.0F;
  for (int frame = 0; frame < 600; ++frame) {
    fidget.after(ticks_per_second / 60);
    for (int bone = 0; bone < EntityRig::bones; ++bone) {
      largest = std::max(largest, fidget.turned(bone));
      EXPECT_EQ(fidget.rig.place(fidget.entity, bone), 0.2F);
    }
  }
  EXPECT_LE(largest, amplitude + 1e-4F);
  EXPECT_GT(largest, amplitude / 3.0F);
}

TEST(NoiseMaker, IsTheSameHoweverTimeWasCutIntoSteps) {
  Fidget once;
  Fidget often;
  for (int frame = 0; frame < 60; ++frame) often.after(ticks_per_second / 60);
  EXPECT_EQ(often.after(Ticks{}), once.after(ticks_per_second));
}

TEST(NoiseMaker, DiffersBySeed) {
  Fidget one;
  Fidget other;
  other.get().seed = 4;
  EXPECT_NE(one.after(ticks_per_second), other.after(ticks_per_second));
}

TEST(NoiseMaker, OfNoAmplitudeOrOutsideItsMaskChangesNoBit) {
  Fidget still;
  still.get().amplitude = 0.0F;
  EXPECT_EQ(still.after(ticks_per_second), still.rig.floats(still.source));
  Fidget masked;
  masked.get().mask = masked.rig.mask_from(10);
  masked.after(ticks_per_second);
  EXPECT_EQ(masked.rig.pose(masked.entity).rotation(9), masked.rig.pose(masked.source).rotation(9));
  EXPECT_NE(masked.rig.pose(masked.entity).rotation(10), masked.rig.pose(masked.source).rotation(10));
}

}  // namespace
}  // namespace throng::anim::noise_maker_test
