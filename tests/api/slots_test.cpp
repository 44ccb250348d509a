// One-shots in slots, and layers that fade, through the public headers.

#include <gtest/gtest.h>

#include "tests/anim/agent/heard_misuses.h"
#include "tests/api/api_crowd.h"

namespace throng::slots_test {
namespace {

using anim::HeardMisuses;
using api_test::ApiCrowd;

constexpr Ticks fade = ticks_per_second / 4;

/// Two agents who walk; the second has a slot.
class Slots : public testing::Test {
 protected:
  Slots() {
    for (std::uint32_t agent = 0; agent < 2; ++agent) crowd_.agent(agent).play({.clip = {0}});
    slot_ = *crowd_.agent(1).add_slot();
  }
  bool are_alike() {
    const float* const one = crowd_.palette(crowd_->agents()[0]);
    const float* const other = crowd_.palette(crowd_->agents()[1]);
    for (std::uint32_t i = 0; i < 12 * crowd_->character(0).palette_entries(); ++i) {
      if (one[i] != other[i]) return false;
    }
    return true;
  }
  /// Steps until the slot is done, and returns the frames that it took.
  int play_to_the_end() {
    int frames = 0;
    for (; crowd_.agent(1).is_playing(slot_) && frames < 1000; ++frames) crowd_.step();
    return frames;
  }

  ApiCrowd crowd_{2};
  ChannelId slot_;
};

TEST_F(Slots, PlayOnceAndLeaveWhatIsBelow) {
  EXPECT_FALSE(crowd_.agent(1).is_playing(slot_));
  ASSERT_TRUE(crowd_.agent(1).play_once(slot_, {.clip = {1}, .fade_in = fade, .fade_out = fade}));
  EXPECT_TRUE(crowd_.agent(1).is_playing(slot_));
  crowd_.step(20);
  EXPECT_FALSE(are_alike());
  EXPECT_GT(play_to_the_end(), 0);
  EXPECT_TRUE(are_alike());
}

TEST_F(Slots, PlayTheQueueOneAfterTheOther) {
  ASSERT_TRUE(crowd_.agent(1).play_once(slot_, {.clip = {1}}));
  const int alone = play_to_the_end();
  for (int shot = 0; shot < 3; ++shot) {
    ASSERT_TRUE(crowd_.agent(1).play_once(slot_, {.clip = {1}, .queued = true}));
  }
  EXPECT_NEAR(play_to_the_end(), 3 * alone, 3);
}

TEST_F(Slots, TellTheEndAsMotionDoes) {
  ASSERT_TRUE(crowd_.agent(1).play_once(slot_, {.clip = {1}, .fade_in = fade, .fade_out = fade}));
  int ends = 0;
  while (crowd_.agent(1).is_playing(slot_)) {
    const Ticks before = crowd_->clock();
    crowd_->advance(ticks_per_second / 60);
    crowd_.agent(1).motion().for_each_end(before, crowd_->clock(), [&](const ClipEnd& end) {
      EXPECT_EQ(end.clip.number, 1U);
      ++ends;
    });
    ASSERT_LT(crowd_->clock(), 60 * ticks_per_second);
  }
  EXPECT_EQ(ends, 1);
}

TEST_F(Slots, RefuseWhatIsNoShotOrNoSlot) {
  const HeardMisuses heard;
  EXPECT_FALSE(crowd_.agent(1).play_once(slot_, {.clip = {99}}));
  EXPECT_FALSE(crowd_.agent(1).play_once(slot_, {.clip = {1}, .speed = 0.0}));
  EXPECT_FALSE(crowd_.agent(1).play_once({0}, {.clip = {1}}));
  EXPECT_FALSE(crowd_.agent(0).is_playing(slot_));
  EXPECT_EQ(heard.all().size(), 4U);
  crowd_.step();
  EXPECT_TRUE(are_alike());
}

TEST_F(Slots, GoOnAfterASnapshot) {
  ASSERT_TRUE(crowd_.agent(1).play_once(slot_, {.clip = {1}, .fade_in = fade, .fade_out = fade}));
  crowd_.step(5);
  Snapshot snapshot;
  crowd_->snapshot(snapshot);
  crowd_.step(60);
  const std::uint64_t hash = crowd_.hash();
  ASSERT_TRUE(crowd_->restore(snapshot));
  EXPECT_TRUE(crowd_.agent(1).is_playing(slot_));
  crowd_.step(60);
  EXPECT_EQ(crowd_.hash(), hash);
}

TEST_F(Slots, AndOtherLayersFadeByThemselves) {
  Agent one = crowd_.agent(0);
  const auto layer = one.add_clips({.weight = 0.0F});
  ASSERT_TRUE(layer);
  ASSERT_TRUE(one.play(*layer, {.clip = {1}}));
  ASSERT_TRUE(one.set_weight(*layer, 1.0F, fade));
  crowd_.step(5);
  EXPECT_FALSE(are_alike());
  ASSERT_TRUE(one.set_weight(*layer, 0.0F, fade));
  crowd_.step(16);
  EXPECT_TRUE(are_alike());
}

}  // namespace
}  // namespace throng::slots_test
