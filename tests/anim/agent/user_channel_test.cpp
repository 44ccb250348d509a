// A channel of your own (paper 2.1.2: "an abstract interface and can be specialized through derivation").

#include <random>

#include <gtest/gtest.h>

#include "tests/anim/agent/crowd_rig.h"

namespace throng::anim::user_channel_test {
namespace {

/// Stands about: plays one idle of a list after the other, in random order, each once to its end.
class RandomIdleChannel final : public Channel {
 public:
  RandomIdleChannel(std::vector<int> idles, unsigned seed) : idles_(std::move(idles)), random_(seed) {}

  // 1. Which entity is the result.
  Handle state() const override { return player_; }

  // 2. Make entities when there is something to make, and say whether there was.
  bool update(const EntityBuilder& build) override {
    if (player_.valid() && build.now() < ends_at_) return false;
    destroy_entities(build);
    const int clip = idles_[random_() % idles_.size()];
    player_ = build.player({.clip = clip, .loop = false});
    ends_at_ = build.now() + build.clip(clip).duration;
    ++idles_played_;
    return true;
  }

  // 3. When to be asked again; channels that change only when somebody sets a parameter leave it at never.
  Ticks next_update() const override { return ends_at_; }

  // 4. What is yours: to be renamed, to be given back, to be remembered by a snapshot.
  void visit_handles(const std::function<void(Handle&)>& visit) override {
    if (player_.valid()) visit(player_);
  }
  void destroy_entities(const EntityBuilder& build) override {
    if (player_.valid()) build.destroy(player_);
    player_ = {};
  }
  std::unique_ptr<Channel> clone() const override { return std::make_unique<RandomIdleChannel>(*this); }

  int idles_played() const { return idles_played_; }

 private:
  std::vector<int> idles_;
  std::minstd_rand random_;  // part of the channel, so that a snapshot goes on to the same idles
  Handle player_;
  Ticks ends_at_{};
  int idles_played_ = 0;
};

CrowdRig idling(unsigned seed, const SystemOptions& options = {}) {
  CrowdRig crowd(options);
  const Status added = crowd->agent(0).add_channel(std::make_unique<RandomIdleChannel>(std::vector{1, 2, 4}, seed));
  EXPECT_TRUE(added) << added.error().message;
  return crowd;
}

const RandomIdleChannel& channel_of(const CrowdRig& crowd) { return *crowd->agent(0).channel<RandomIdleChannel>({0}); }

TEST(UserChannel, PlaysOneIdleAfterTheOther) {
  CrowdRig crowd = idling(1);
  EXPECT_EQ(channel_of(crowd).idles_played(), 1);
  crowd.step(600);
  EXPECT_GE(channel_of(crowd).idles_played(), 9) << "none is longer than 1.1 s";
  EXPECT_LE(channel_of(crowd).idles_played(), 12) << "none is shorter than 0.9 s";
  EXPECT_EQ(crowd.entities(), 1U);
  EXPECT_EQ(crowd->characters().pools(0).pool(EntityPools::sampled_players).alive_count(), 1U)
      << "the others went back";
}

TEST(UserChannel, ShowsTheClipThatItPlays) {
  CrowdRig crowd(SystemOptions{});
  ASSERT_TRUE(crowd->agent(0).add_channel(std::make_unique<RandomIdleChannel>(std::vector{3}, 1U)));
  CrowdRig plain;
  plain->agent(0).play({.clip = 3, .loop = false});
  crowd.step(20);
  plain.step(20);
  EXPECT_TRUE(crowd.bones_unlike(plain).empty());
}

TEST(UserChannel, IsTheSameUnderEverySchedule) {
  CrowdRig fused = idling(7, {.pus = 2, .schedule = Schedule::fused});
  CrowdRig levels = idling(7, {.schedule = Schedule::levels});
  CrowdRig other = idling(8);
  fused.step(300);
  levels.step(300);
  other.step(300);
  EXPECT_EQ(fused->figures().pose_hash(), levels->figures().pose_hash());
  EXPECT_NE(fused->figures().pose_hash(), other->figures().pose_hash());
}

TEST(UserChannel, GoesOnAcrossAChangeOfStream) {
  CrowdRig crowd = idling(1);
  crowd.step(30);
  ASSERT_TRUE(crowd->configure({.stream = StreamKind::keyframe}));
  crowd.step(300);
  EXPECT_EQ(crowd->characters().pools(0).pool(EntityPools::sampled_players).alive_count(), 0U);
  EXPECT_EQ(crowd->characters().pools(0).pool(EntityPools::keyframe_players).alive_count(), 1U);
}

TEST(UserChannel, PlaysTheSameIdlesAgainAfterARewind) {
  CrowdRig crowd = idling(5);
  crowd.step(100);
  SystemSnapshot snapshot;
  crowd->snapshot(snapshot);
  crowd.step(300);
  const std::uint64_t hash = crowd->figures().pose_hash();
  ASSERT_TRUE(crowd->restore(snapshot));
  crowd.step(300);
  EXPECT_EQ(crowd->figures().pose_hash(), hash);
}

}  // namespace
}  // namespace throng::anim::user_channel_test
