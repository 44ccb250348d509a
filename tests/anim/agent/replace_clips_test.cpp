// Clips come and go while agents play: nobody jumps, nothing restarts, and who needs a clip keeps it.

#include <chrono>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "engine/anim/agent/blend_space_channel.h"
#include "engine/anim/agent/simple_channel.h"
#include "engine/anim/agent/system_snapshot.h"
#include "engine/anim/asset/skeleton_order.h"
#include "engine/anim/bake/clip_set.h"
#include "tests/anim/agent/crowd_rig.h"
#include "tests/anim/agent/heard_misuses.h"
#include "tests/anim/asset/clip_fixtures.h"
#include "tests/anim/bake/clip_parts.h"

namespace throng::anim::replace_clips_test {
namespace {

using namespace std::chrono_literals;

using Shared = std::shared_ptr<const Character>;

Shared baked(const Model& model) { return std::make_shared<const Character>(bake_character(model)); }

Shared made(Result<Character> result) {
  EXPECT_TRUE(result) << (result ? "" : result.error().message);
  return std::make_shared<const Character>(std::move(*result));
}

const Model& whole() {
  static const Model model = named_model(40, 5);
  return model;
}

/// The character with the first three clips.
Shared base() {
  static const Shared character = baked(part_of(whole(), 0, 3));
  return character;
}

/// A file with the other two.
const Shared& more() {
  static const Shared character = baked(part_of(whole(), 3, 5));
  return character;
}

/// A crowd whose agents play what they are told, and the hash of all that they show.
struct Crowd {
  explicit Crowd(const Shared& character, const SystemOptions& options = {.hash = true})
      : system(std::move(*AnimationSystem::create(character, options))) {}

  Agent add(int clip) {
    Agent agent = system->agent(system->add_agent());
    EXPECT_TRUE(agent.play({.clip = clip, .start = ticks_per_second / 7}));
    return agent;
  }
  void step(int frames = 1) {
    std::vector<PoseRequest> updates;
    for (const AgentId agent : system->agents()) updates.push_back({.agent = agent});
    for (int frame = 0; frame < frames; ++frame) {
      system->advance(frame_ticks);
      system->update(updates);
    }
  }
  std::uint64_t hash() const { return system->figures().pose_hash(); }
  Status replace(Shared other) { return system->characters().replace_clips(0, std::move(other)); }
  std::string refusal(Shared other) {
    const Status refused = replace(std::move(other));
    return refused ? "" : refused.error().message;
  }

  std::unique_ptr<AnimationSystem> system;
};

/// Adds agents that walk, fade, interrupt a fade and blend by speed.
void fill(Crowd& crowd) {
  for (int i = 0; i < 6; ++i) crowd.add(i % 3);
  crowd.step(3);
  crowd.system->agent(1).play({.clip = 0, .fade = 300ms});
  crowd.system->agent(2).play({.clip = 1, .fade = 300ms});
  crowd.step(5);
  crowd.system->agent(2).play({.clip = 0, .fade = 200ms});
  std::vector<BlendPoint> points{{.clip = 0, .parameter = 0.0F}, {.clip = 1, .parameter = 2.0F}};
  EXPECT_TRUE(crowd.system->agent(3).add_channel(std::make_unique<BlendSpaceChannel>(std::move(points), 1.0F, true),
                                                 {.weight = 0.5F}));
  crowd.step();
}

TEST(ReplacedClips, LeaveThePosesOfWhoPlaysOnToTheBit) {
  for (const Schedule schedule : {Schedule::fused, Schedule::levels}) {
    for (const StreamKind stream : {StreamKind::sampled, StreamKind::keyframe}) {
      const SystemOptions options{.schedule = schedule, .stream = stream, .hash = true};
      Crowd quiet(base(), options), changing(base(), options);
      fill(quiet);
      fill(changing);
      const Shared larger = made(with_clips(base(), more()));
      for (int frame = 0; frame < 30; ++frame) {
        std::string refusal;
        if (frame == 2) refusal = changing.refusal(larger);
        if (frame == 12) refusal = changing.refusal(made(without_clip(larger, 3)));
        ASSERT_EQ(refusal, "");
        quiet.step();
        changing.step();
        ASSERT_EQ(changing.hash(), quiet.hash()) << "frame " << frame;
      }
    }
  }
}

TEST(ReplacedClips, PlayLikeThoseOfACharacterThatHadThemFromTheStart) {
  Crowd streamed(base()), full(baked(whole()));
  for (Crowd* crowd : {&streamed, &full}) {
    for (int i = 0; i < 3; ++i) crowd->add(i);
    crowd->step(4);
  }
  ASSERT_EQ(streamed.refusal(made(with_clips(base(), more()))), "");
  for (Crowd* crowd : {&streamed, &full}) {
    EXPECT_TRUE(crowd->system->agent(0).play({.clip = 3, .fade = 200ms}));
    EXPECT_TRUE(crowd->system->agent(1).play({.clip = 4}));
  }
  for (int frame = 0; frame < 30; ++frame) {
    streamed.step();
    full.step();
    ASSERT_EQ(streamed.hash(), full.hash()) << "frame " << frame;
  }
}

TEST(ReplacedClips, OfAnotherOrderOfBonesPlayLikeThoseOfThisOne) {
  Model turned = part_of(whole(), 3, 5);
  reorder_bones(turned, other_order(turned.skeleton));
  Crowd in_order(made(with_clips(base(), more()))), streamed(base());
  ASSERT_EQ(streamed.refusal(made(with_clips(base(), baked(turned)))), "");
  for (Crowd* crowd : {&in_order, &streamed}) {
    crowd->add(3);
    crowd->add(4);
    crowd->step(20);
  }
  EXPECT_EQ(streamed.hash(), in_order.hash());
}

TEST(ReplacedClips, AreRefusedWhileAgentsPlayOneThatLeaves) {
  const Shared larger = made(with_clips(base(), more()));
  const Shared smaller = made(without_clip(larger, 4));
  Crowd crowd(larger), quiet(larger);
  for (Crowd* one : {&crowd, &quiet}) {
    for (const int clip : {4, 4, 4, 1}) one->add(clip);
    one->step();
  }
  EXPECT_EQ(crowd.refusal(smaller), "3 agents play \"clip 4\": let them play something else first");
  EXPECT_EQ(crowd.refusal(base()), "3 agents play \"clip 4\": let them play something else first");
  EXPECT_EQ(&crowd.system->characters()[0], larger.get());
  crowd.step();
  quiet.step();
  EXPECT_EQ(crowd.hash(), quiet.hash()) << "nothing has changed";

  for (std::uint32_t agent = 0; agent < 2; ++agent) crowd.system->agent(agent).play({.clip = 0});
  crowd.system->agent(2).play({.clip = 0, .fade = 200ms});
  crowd.step(2);
  EXPECT_EQ(crowd.refusal(smaller), "1 agent plays \"clip 4\": let it play something else first") << "it fades away";
  crowd.step(15);
  EXPECT_EQ(crowd.refusal(smaller), "");
  crowd.step(2);
}

TEST(ReplacedClips, MayLeaveWhenAFadeAwayFromThemIsOverThoughNobodyWasPosed) {
  const Shared larger = made(with_clips(base(), more()));
  Crowd unseen(larger), quiet(larger);
  for (Crowd* crowd : {&unseen, &quiet}) {
    crowd->add(4);
    crowd->step(3);
    crowd->system->agent(0).play({.clip = 1, .fade = 200ms});
    crowd->system->advance(150ms);
  }
  EXPECT_NE(unseen.refusal(base()), "") << "it still fades";
  for (Crowd* crowd : {&unseen, &quiet}) crowd->system->advance(60ms);
  EXPECT_EQ(unseen.refusal(base()), "");
  for (int frame = 0; frame < 5; ++frame) {
    unseen.step();
    quiet.step();
    ASSERT_EQ(unseen.hash(), quiet.hash());
  }
}

TEST(ReplacedClips, AreRefusedWhileABlendSpaceHasOneThatLeavesThoughNobodyPlaysIt) {
  const Shared larger = made(with_clips(base(), more()));
  Crowd crowd(larger);
  Agent agent = crowd.add(0);
  std::vector<BlendPoint> points{
      {.clip = 0, .parameter = 0.0F}, {.clip = 1, .parameter = 1.0F}, {.clip = 3, .parameter = 9.0F}};
  const auto space = agent.add_channel(std::make_unique<BlendSpaceChannel>(std::move(points), 0.5F, true));
  ASSERT_TRUE(space);
  crowd.step();
  EXPECT_NE(crowd.refusal(made(without_clip(larger, 3))).find("a channel of 1 agent could not play"),
            std::string::npos);
  EXPECT_EQ(crowd.refusal(made(without_clip(larger, 4))), "");
  agent.remove_channel(*space);
  EXPECT_EQ(crowd.refusal(base()), "");
}

TEST(ReplacedClips, AreRefusedWhileASharedGraphPlaysOneThatLeaves) {
  const Shared larger = made(with_clips(base(), more()));
  Crowd crowd(larger);
  ASSERT_TRUE(crowd.system->characters().add_shared(std::make_unique<SimpleChannel>(PlayerStart{.clip = 3})));
  EXPECT_NE(crowd.refusal(base()).find("a shared graph plays \"clip 3\""), std::string::npos);
  EXPECT_EQ(crowd.refusal(made(without_clip(larger, 4))), "");
}

TEST(ReplacedClips, LeaveTheirPlaceBeforeAnotherComes) {
  const Shared larger = made(with_clips(base(), baked(part_of(whole(), 3, 4))));
  const Shared empty = made(without_clip(larger, 3));
  const Shared other = made(with_clips(empty, baked(part_of(whole(), 4, 5))));
  Crowd crowd(larger);
  crowd.add(0);
  EXPECT_NE(crowd.refusal(other).find("place 3 would go from \"clip 3\" to \"clip 4\" at once"), std::string::npos);
  EXPECT_EQ(crowd.refusal(empty), "");
  EXPECT_EQ(crowd.refusal(other), "");
}

TEST(ReplacedClips, AreOfTheSameSkeletonInTheSameOrder) {
  Crowd crowd(base());
  crowd.add(0);
  EXPECT_NE(crowd.refusal(baked(named_model(39, 3))).find("is not in"), std::string::npos);
  Model turned = part_of(whole(), 0, 3);
  reorder_bones(turned, other_order(turned.skeleton));
  EXPECT_NE(crowd.refusal(baked(turned)).find("another order"), std::string::npos);
  const HeardMisuses heard;
  EXPECT_NE(crowd.refusal(nullptr), "");
  EXPECT_NE(crowd.refusal(std::make_shared<const Character>()), "");
  EXPECT_FALSE(crowd.system->characters().replace_clips(7, base()));
  EXPECT_EQ(HeardMisuses::all().size(), 3U);
}

TEST(ReplacedClips, ThatALocalStoreOfFixedSizeCannotHoldAreRefused) {
  Model wild = part_of(whole(), 0, 0);
  wild.clips.push_back(wild_clip(wild.skeleton, Interpolation::step, 1.5, 7));
  wild.clips.back().name = "wild";
  const Shared larger = made(with_clips(base(), baked(wild)));
  ASSERT_EQ(larger->clips[3].sampled(), nullptr) << "it needs larger players";
  std::size_t bytes = 4096;
  while (!AnimationSystem::create(base(), {.local_store_bytes = bytes})) bytes += 64;
  Crowd crowd(base(), {.local_store_bytes = bytes, .hash = true}), quiet(base(), {.hash = true});
  for (Crowd* one : {&crowd, &quiet}) one->add(1);
  EXPECT_NE(crowd.refusal(larger).find("bytes of local store"), std::string::npos);
  EXPECT_EQ(&crowd.system->characters()[0], base().get());
  for (Crowd* one : {&crowd, &quiet}) one->step(3);
  EXPECT_EQ(crowd.hash(), quiet.hash());
  EXPECT_EQ(quiet.refusal(larger), "") << "automatic stores grow";
  EXPECT_EQ(crowd.refusal(made(without_clip(base(), 2))), "") << "an empty place asks for nothing";
}

TEST(ReplacedClips, MakeOlderSnapshotsInvalid) {
  Crowd crowd(base());
  crowd.add(0);
  SystemSnapshot snapshot;
  crowd.system->snapshot(snapshot);
  ASSERT_EQ(crowd.refusal(made(with_clips(base(), more()))), "");
  const Status restored = crowd.system->restore(snapshot);
  ASSERT_FALSE(restored);
  EXPECT_NE(restored.error().message.find("has other clips"), std::string::npos);
}

TEST(ReplacedClips, AHundredFilesComeAndGoWhileOthersPlay) {
  Crowd busy(base()), quiet(base());
  for (Crowd* crowd : {&busy, &quiet}) crowd->add(0);
  Agent guest = busy.add(1);
  Shared played = base();
  const AgentId lasting = busy.system->agents().front();
  for (int round = 0; round < 100; ++round) {
    std::weak_ptr<const Character> file;
    {
      const Shared loaded = baked(part_of(whole(), 3, 4));
      file = loaded;
      played = made(with_clips(played, loaded));
    }
    ASSERT_EQ(busy.refusal(played), "") << "round " << round;
    ASSERT_TRUE(guest.play({.clip = 3, .fade = 40ms}));
    busy.step(4);
    ASSERT_TRUE(guest.play({.clip = 1, .fade = 40ms}));
    busy.step(4);
    quiet.step(8);
    played = made(without_clip(played, 3));
    ASSERT_EQ(busy.refusal(played), "") << "round " << round;
    ASSERT_EQ(played->clips.size(), 4U);
    ASSERT_TRUE(file.expired()) << "round " << round;
  }
  EXPECT_EQ(busy.system->figures().agent_hashes()[lasting.number], quiet.system->figures().agent_hashes()[0]);
  const HeardMisuses heard;
  EXPECT_FALSE(guest.play({.clip = 3})) << "the place is empty";
  EXPECT_EQ(HeardMisuses::all().size(), 1U);
}

}  // namespace
}  // namespace throng::anim::replace_clips_test
