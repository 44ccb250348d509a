// A system refuses options that it cannot run, and keeps those that it has.

#include "engine/anim/agent/animation_system.h"

#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "engine/anim/asset/synthetic_model.h"

namespace throng::anim::animation_system_test {
namespace {

std::shared_ptr<const Character> character() {
  return std::make_shared<const Character>(bake_character(synthetic_model(12, 1)));
}

TEST(AnimationSystem, IsRefusedWithNoPuAndWithMoreThanItHolds) {
  for (const int pus : {-1, 0, max_pus + 1}) {
    const auto system = AnimationSystem::create(character(), {.pus = pus});
    ASSERT_FALSE(system.has_value()) << pus;
    EXPECT_EQ(system.error().message, std::to_string(pus) + " PUs: give 1 to 256");
  }
}

TEST(AnimationSystem, KeepsItsPusWhenOtherOptionsAreRefused) {
  const auto system = std::move(*AnimationSystem::create(character(), {.pus = 2}));
  EXPECT_FALSE(system->configure({.pus = 0}).has_value());
  EXPECT_EQ(system->options().pus, 2);
}

}  // namespace
}  // namespace throng::anim::animation_system_test
