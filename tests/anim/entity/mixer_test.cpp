#include "engine/anim/entity/mixer.h"

#include <initializer_list>

#include <gtest/gtest.h>

#include "tests/anim/entity/entity_rig.h"

namespace throng::anim::mixer_test {
namespace {

struct Part {
  Handle source;
  float weight;
  std::int16_t mask = EaseBlender::no_mask;
};

Handle mix(EntityRig& rig, std::initializer_list<Part> parts) {
  const Handle handle = rig.create(EntityPools::mixers);
  auto& mixer = rig.as<Mixer>(handle);
  MixerSources& mixed = mixer_sources(rig.pools().block(handle), rig.pools().layout(handle));
  for (const Part& part : parts) {
    mixed.sources[mixer.source_count] = part.source;
    mixed.weights[mixer.source_count] = part.weight;
    mixer.masks[mixer.source_count++] = part.mask;
  }
  return handle;
}

TEST(Mixer, WeighsItsSourcesByTheirShareOfTheSum) {
  EntityRig rig;
  const Handle mixer =
      mix(rig, {{rig.held(0.0F, 1.0F), 1.0F}, {rig.held(0.0F, 2.0F), 1.0F}, {rig.held(0.0F, 4.0F), 2.0F}});
  rig.update(mixer, Ticks{1});
  for (int bone = 0; bone < EntityRig::bones; ++bone) EXPECT_FLOAT_EQ(rig.place(mixer, bone), 2.75F) << bone;
}

TEST(Mixer, MeetsHalfWayBetweenTwoEqualTurns) {
  EntityRig rig;
  const Handle mixer = mix(rig, {{rig.held(0.2F), 3.0F}, {rig.held(0.6F), 3.0F}});
  rig.update(mixer, Ticks{1});
  EXPECT_NEAR(rig.angle(mixer, 7), 0.4F, 1e-6F);
}

TEST(Mixer, OfOneSourceHasItsBits) {
  EntityRig rig;
  const Handle source = rig.held(0.3F, 0.1F);
  const Handle mixer = mix(rig, {{source, 0.2F}});
  rig.update(mixer, Ticks{1});
  EXPECT_EQ(rig.floats(mixer), rig.floats(source));
}

TEST(Mixer, ASourceOfWeightZeroChangesNoBit) {
  EntityRig rig;
  const Handle one = rig.held(0.3F, 0.1F);
  const Handle other = rig.held(-0.8F, 0.7F);
  const Handle with = mix(rig, {{one, 1.0F}, {rig.held(2.0F, 9.0F), 0.0F}, {other, 0.5F}});
  const Handle without = mix(rig, {{one, 1.0F}, {other, 0.5F}});
  rig.update(with, Ticks{1});
  rig.update(without, Ticks{1});
  EXPECT_EQ(rig.floats(with), rig.floats(without));
}

TEST(Mixer, TakesEachBoneFromTheSourceWhoseMaskWeighsIt) {
  EntityRig rig;
  const std::int16_t upper = rig.mask_from(12);
  const Handle below = rig.held(0.0F, 1.0F);
  const Handle above = rig.held(0.0F, 3.0F);
  const Handle mixer = mix(rig, {{below, 1.0F}, {above, 1.0F, upper}});
  rig.update(mixer, Ticks{1});
  EXPECT_FLOAT_EQ(rig.place(mixer, 11), 1.0F) << "nobody else weighs anything here";
  EXPECT_FLOAT_EQ(rig.place(mixer, 12), 2.0F);
  EXPECT_FLOAT_EQ(rig.place(mixer, EntityRig::bones - 1), 2.0F);
}

TEST(Mixer, MovesAtTheVelocityOfItsSourcesWeighedAlike) {
  EntityRig rig;
  const Handle slow = rig.held(0.0F);
  const Handle fast = rig.held(0.0F);
  rig.as<HeldState>(slow).state.linear_velocity[2] = 1.0F;
  rig.as<HeldState>(fast).state.linear_velocity[2] = 3.0F;
  rig.as<HeldState>(fast).state.angular_velocity[1] = 0.4F;
  const Handle mixer = mix(rig, {{slow, 3.0F}, {fast, 1.0F}});
  rig.update(mixer, Ticks{1});
  EXPECT_FLOAT_EQ(rig.as<Mixer>(mixer).state.linear_velocity[2], 1.5F);
  EXPECT_FLOAT_EQ(rig.as<Mixer>(mixer).state.angular_velocity[1], 0.1F);
  rig.update(mixer, Ticks{1});
  EXPECT_FLOAT_EQ(rig.as<Mixer>(mixer).state.linear_velocity[2], 1.5F) << "not added up from update to update";
}

TEST(Mixer, UsesUpItsDeltaTime) {
  EntityRig rig;
  const Handle mixer = mix(rig, {{rig.held(0.0F), 1.0F}});
  rig.update(mixer, Ticks{1234});
  EXPECT_EQ(rig.as<Mixer>(mixer).state.delta_time, Ticks{});
}

}  // namespace
}  // namespace throng::anim::mixer_test
