#include "engine/anim/entity/additive_layer.h"

#include <gtest/gtest.h>

#include "tests/anim/entity/entity_rig.h"

namespace throng::anim::additive_layer_test {
namespace {

struct Lean {
  Lean()
      : base(rig.held(0.5F, 1.0F)),
        layer(rig.held(0.3F, 0.4F)),
        reference(rig.held(0.1F, 0.1F)),
        entity(rig.create(EntityPools::additive_layers)) {
    auto& additive = get();
    additive.base = base;
    additive.layer = layer;
    additive.reference = reference;
    additive.mask = EaseBlender::no_mask;
  }
  AdditiveLayer& get() { return rig.as<AdditiveLayer>(entity); }
  void weigh(float weight) { get().weight = get().target_weight = weight; }

  EntityRig rig;
  Handle base;
  Handle layer;
  Handle reference;
  Handle entity;
};

TEST(AdditiveLayer, AddsWhatTheLayerDiffersInFromItsReference) {
  Lean lean;
  lean.weigh(1.0F);
  lean.rig.update(lean.entity, Ticks{1});
  for (int bone = 0; bone < EntityRig::bones; ++bone) {
    EXPECT_NEAR(lean.rig.angle(lean.entity, bone), 0.5F + (0.3F - 0.1F), 1e-6F) << bone;
    EXPECT_NEAR(lean.rig.place(lean.entity, bone), 1.0F + (0.4F - 0.1F), 1e-6F) << bone;
  }
}

TEST(AdditiveLayer, AddsAsMuchOfItAsItWeighs) {
  Lean lean;
  lean.weigh(0.5F);
  lean.rig.update(lean.entity, Ticks{1});
  EXPECT_NEAR(lean.rig.angle(lean.entity, 3), 0.6F, 1e-4F);
  EXPECT_NEAR(lean.rig.place(lean.entity, 3), 1.15F, 1e-6F);
}

TEST(AdditiveLayer, OfWeightZeroHasTheBitsOfItsBase) {
  Lean lean;
  lean.rig.update(lean.entity, Ticks{1});
  EXPECT_EQ(lean.rig.floats(lean.entity), lean.rig.floats(lean.base));
}

TEST(AdditiveLayer, LeavesBonesThatItsMaskLeavesOutTheirBits) {
  Lean lean;
  lean.weigh(1.0F);
  lean.get().mask = lean.rig.mask_from(5);
  lean.rig.update(lean.entity, Ticks{1});
  EXPECT_EQ(lean.rig.pose(lean.entity).rotation(4), lean.rig.pose(lean.base).rotation(4));
  EXPECT_NEAR(lean.rig.angle(lean.entity, 5), 0.7F, 1e-6F);
}

TEST(AdditiveLayer, MovesItsWeightAtItsRateAndStaysThere) {
  Lean lean;
  lean.get().target_weight = 1.0F;
  lean.get().weight_per_second = 2.0F;
  lean.rig.update(lean.entity, ticks_per_second / 4);
  EXPECT_FLOAT_EQ(lean.get().weight, 0.5F);
  lean.rig.update(lean.entity, ticks_per_second);
  EXPECT_EQ(lean.get().weight, 1.0F);
  lean.get().target_weight = 0.25F;
  lean.rig.update(lean.entity, ticks_per_second / 4);
  EXPECT_FLOAT_EQ(lean.get().weight, 0.5F);
  EXPECT_EQ(lean.get().state.delta_time, Ticks{});
}

TEST(AdditiveLayer, KeepsItsWeightWhereTimeGoesBack) {
  Lean lean;
  lean.weigh(1.0F);
  lean.get().weight_per_second = 2.0F;
  lean.rig.update(lean.entity, Ticks{} - ticks_per_second / 4);
  EXPECT_EQ(lean.get().weight, 1.0F);
}

TEST(AdditiveLayer, WithoutARateIsAtItsTargetAtOnce) {
  Lean lean;
  lean.get().target_weight = 0.75F;
  lean.rig.update(lean.entity, Ticks{});
  EXPECT_EQ(lean.get().weight, 0.75F);
}

TEST(AdditiveLayer, MovesAsItsBaseDoes) {
  Lean lean;
  lean.rig.as<HeldState>(lean.base).state.linear_velocity[2] = 1.4F;
  lean.rig.as<HeldState>(lean.layer).state.linear_velocity[2] = 9.0F;
  lean.rig.update(lean.entity, Ticks{1});
  EXPECT_EQ(lean.get().state.linear_velocity[2], 1.4F);
}

}  // namespace
}  // namespace throng::anim::additive_layer_test
