// Clips that a host mixes, each at the weight and position that it says.

#include "engine/anim/agent/channel/clip_mix_channel.h"

#include <array>
#include <cstdint>

#include <gtest/gtest.h>

#include "engine/anim/entity/mixer.h"
#include "tests/anim/agent/gait_crowd.h"
#include "tests/anim/agent/heard_misuses.h"

namespace throng::anim::clip_mix_channel_test {
namespace {

constexpr FineTicks second = ticks_per_second * fine_ticks_per_tick;

struct Mixed : GaitCrowd {
  explicit Mixed(std::span<const MixedClip> clips) {
    const auto added = system->agent(0).add_channel(std::make_unique<ClipMixChannel>(clips));
    EXPECT_TRUE(added) << added.error().message;
  }
  void set(std::span<const MixedClip> clips) {
    const Status changed =
        system->agent(0).change<ClipMixChannel>({0}, [&](ClipMixChannel& channel) { channel.set(clips); });
    EXPECT_TRUE(changed) << changed.error().message;
  }
};

TEST(ClipMixChannel, PlaysEachClipAtItsPlaceAndSpeed) {
  Mixed mixed(std::array{MixedClip{.clip = gaits::walk, .weight = 3.0F, .position = second / 4, .speed = 0.5},
                         MixedClip{.clip = gaits::jog, .weight = 1.0F, .position = second / 8, .speed = 2.0}});
  mixed.step(ticks_per_second / 10);
  ASSERT_EQ(mixed.players().size(), 2U);
  EXPECT_EQ(mixed.player_of(gaits::walk)->position, second / 4 + second / 20);
  EXPECT_EQ(mixed.player_of(gaits::jog)->position, second / 8 + second / 5);
}

TEST(ClipMixChannel, APlaceThatIsSetAgainDoesNotDependOnTheWayThere) {
  const std::array there{MixedClip{.clip = gaits::walk, .position = second / 3},
                         MixedClip{.clip = gaits::idle, .weight = 0.2F, .position = second / 5},
                         MixedClip{.clip = gaits::run, .weight = 0.3F, .position = second / 6}};
  Mixed at_once(there), later(std::array{MixedClip{.clip = gaits::jog, .position = 7}});
  for (int i = 0; i < 50; ++i) later.step();
  later.set(there);
  at_once.step(Ticks{});
  later.step(Ticks{});
  for (const int clip : {gaits::walk, gaits::idle, gaits::run}) {
    EXPECT_EQ(at_once.player_of(clip)->position, later.player_of(clip)->position);
  }
  EXPECT_EQ(later.player_of(gaits::jog), nullptr);
}

TEST(ClipMixChannel, GoesBackwards) {
  Mixed mixed(std::array{MixedClip{.clip = gaits::walk, .position = second / 2, .speed = -1.0}});
  mixed.step(ticks_per_second / 4);
  EXPECT_EQ(mixed.player_of(gaits::walk)->position, second / 4);
}

TEST(ClipMixChannel, OneGaitTellsTheStepsOfAll) {
  Mixed mixed(std::array{MixedClip{.clip = gaits::walk, .weight = 0.6F, .voice = StepVoice::leads},
                         MixedClip{.clip = gaits::aside, .weight = 0.4F, .voice = StepVoice::follows}});
  std::size_t steps = 0;
  for (int frame = 0; frame < 60; ++frame) {
    const Ticks before = mixed.step();
    for (const DataKeyEvent& event : mixed.keys(before)) {
      EXPECT_FLOAT_EQ(event.weight, 1.0F);
      ++steps;
    }
  }
  EXPECT_GE(steps, 2U);
  EXPECT_LE(steps, 3U) << "each foot is heard once";
}

TEST(ClipMixChannel, RefusesWhatIsNoMix) {
  Mixed mixed(std::array{MixedClip{.clip = gaits::walk}});
  HeardMisuses heard;
  mixed.set({});
  mixed.set(std::array{MixedClip{.clip = gaits::walk}, MixedClip{.clip = gaits::walk}});
  mixed.set(std::array{MixedClip{.clip = gaits::walk, .weight = 0.0F}});
  EXPECT_EQ(heard.all().size(), 3U);
  EXPECT_EQ(mixed.players().size(), 1U);
}

}  // namespace
}  // namespace throng::anim::clip_mix_channel_test
