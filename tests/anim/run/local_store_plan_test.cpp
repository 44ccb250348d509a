#include "engine/anim/run/local_store_plan.h"

#include <memory>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/anim/agent/animation_system.h"
#include "engine/anim/asset/synthetic_model.h"

namespace throng::anim::local_store_plan_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr std::size_t kib = 1024;

std::shared_ptr<const Character> character(int bones) {
  return std::make_shared<const Character>(bake_character(synthetic_model(bones, 2)));
}

std::string error_of(int bones, const SystemOptions& options) {
  const auto system = AnimationSystem::create(character(bones), options);
  return system ? "" : system.error().message;
}

int tile_of(const SystemOptions& options) {
  const auto system = AnimationSystem::create(character(62), options);
  EXPECT_TRUE(system.has_value()) << (system ? "" : system.error().message);
  return system ? (*system)->figures().schedule().plan.width : 0;
}

TEST(LocalStorePlan, ALargerStoreHoldsAWiderTile) {
  EXPECT_EQ(tile_of({.local_store_bytes = 64 * kib}), 16);
  const int in_16_kib = tile_of({.local_store_bytes = 16 * kib});
  EXPECT_LT(in_16_kib, 16);
  EXPECT_GE(in_16_kib, 1);
}

TEST(LocalStorePlan, ATileOfASizeThatIsAskedForIsOneStrip) {
  const auto strips_of = [](const SystemOptions& options) {
    return (*AnimationSystem::create(character(62), options))->figures().schedule().plan.strips;
  };
  EXPECT_EQ(strips_of({}), most_strips);
  EXPECT_EQ(strips_of({.tile = 16}), 1);
  EXPECT_EQ(strips_of({.schedule = Schedule::levels}), 1);
}

TEST(LocalStorePlan, ALargeStoreFetchesTwoStripsOfAnyUsualGraph) {
  const auto plan_of = [](const SystemOptions& options) {
    return (*AnimationSystem::create(character(62), options))->figures().schedule().plan;
  };
  const LocalStorePlan usual = plan_of({.local_store_bytes = 64 * kib});
  const LocalStorePlan large = plan_of({.local_store_bytes = 256 * kib});
  EXPECT_EQ(large.fetch_bytes, 2 * usual.fetch_bytes);
  EXPECT_GT(large.scratch_bytes, 2 * usual.scratch_bytes);
  EXPECT_EQ(plan_of({.local_store_bytes = 256 * kib, .tile = 16}).fetch_bytes, usual.fetch_bytes);
}

TEST(LocalStorePlan, ThePapersStoreOf16KiBHolds62BonesInEverySchedule) {
  EXPECT_EQ(error_of(62, {.local_store_bytes = 16 * kib}), "");
  EXPECT_EQ(error_of(62, {.local_store_bytes = 16 * kib, .schedule = Schedule::levels}), "");
  EXPECT_EQ(error_of(62, {.local_store_bytes = 16 * kib, .schedule = Schedule::levels, .stream = StreamKind::keyframe}),
            "");
}

TEST(LocalStorePlan, ASkeletonThatDoesNotFitIsNamedWithTheSmallestStoreThatWorks) {
  const std::string error =
      error_of(300, {.local_store_bytes = 16 * kib, .schedule = Schedule::levels, .stream = StreamKind::keyframe});
  constexpr std::string_view smallest = "the smallest that works is ";
  ASSERT_THAT(error, AllOf(HasSubstr("skeleton"), HasSubstr("levels"), HasSubstr("keyframe"), HasSubstr(smallest)));
  const std::size_t works = std::stoul(error.substr(error.find(smallest) + smallest.size()));
  const SystemOptions larger{.local_store_bytes = works, .schedule = Schedule::levels, .stream = StreamKind::keyframe};
  SystemOptions smaller = larger;
  smaller.local_store_bytes -= kib;
  EXPECT_EQ(error_of(300, larger), "");
  EXPECT_NE(error_of(300, smaller), "");
}

TEST(LocalStorePlan, ATileThatDoesNotFitIsRefusedWithTheLargestThatDoes) {
  const int fits = tile_of({.local_store_bytes = 16 * kib});
  const std::string error = error_of(62, {.local_store_bytes = 16 * kib, .tile = 16});
  EXPECT_THAT(error, HasSubstr("the largest tile that fits is " + std::to_string(fits)));
  EXPECT_EQ(tile_of({.local_store_bytes = 16 * kib, .tile = fits}), fits);
}

TEST(LocalStorePlan, AutomaticIs64KiBUntilACharacterNeedsMore) {
  const auto small = AnimationSystem::create(character(62), {});
  EXPECT_EQ((*small)->figures().schedule().local_store_bytes, 64 * kib);
  const auto large = AnimationSystem::create(character(600), {.stream = StreamKind::keyframe});
  ASSERT_TRUE(large.has_value());
  EXPECT_GT((*large)->figures().schedule().local_store_bytes, 64 * kib);
}

}  // namespace
}  // namespace throng::anim::local_store_plan_test
