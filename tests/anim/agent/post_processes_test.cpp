// Tweaks of whole poses through the façade: what does nothing changes no bit, and nothing depends on how it is run.

#include <functional>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "engine/anim/agent/foot_placement_process.h"
#include "engine/anim/agent/noise_process.h"
#include "engine/anim/agent/ragdoll_process.h"
#include "engine/anim/agent/system_snapshot.h"
#include "engine/anim/agent/targeted_processes.h"
#include "tests/anim/agent/person_crowd.h"

namespace throng::anim::post_processes_test {
namespace {

constexpr std::uint32_t people = 21;
constexpr Footing slope{.place = {0.0F, 0.1F, 0.0F}, .normal = {0.0F, 0.9396926F, -0.3420201F}};

enum Place : std::size_t { looks, stands, reaches, shakes, falls };

/// All of them at work, one after the other.
void add_everything(PersonCrowd& crowd) {
  AnimationSystem& system = crowd.system();
  const RigKinds& kinds = crowd.kinds();
  for (std::uint32_t agent = 0; agent < people; ++agent) {
    auto look = std::make_unique<LookAtProcess>(*kinds.look_at);
    look->look_at({1.0F, 1.4F, 2.0F}, to_ticks(0.1));
    auto feet = std::make_unique<FootPlacementProcess>(*kinds.foot_placement);
    feet->set_ground(slope);
    auto reach = std::make_unique<ReachProcess>(
        *kinds.limbs, ReachProcess::Settings{.limb = *person_rigs().limb(CharacterRigs::Limb::left_arm)});
    reach->set_target({0.4F, 1.3F, 0.3F});
    reach->set_weight(0.7F, to_ticks(0.2));
    EXPECT_TRUE(system.agent(agent).add_post_process(std::move(look)));
    EXPECT_TRUE(system.agent(agent).add_post_process(std::move(feet)));
    EXPECT_TRUE(system.agent(agent).add_post_process(std::move(reach)));
    EXPECT_TRUE(
        system.agent(agent).add_post_process(std::make_unique<NoiseProcess>(NoiseProcess::Settings{.seed = agent})));
    EXPECT_TRUE(system.agent(agent).add_post_process(std::make_unique<RagdollProcess>(*kinds.ragdoll)));
  }
}

/// What a host does over time: targets and the ground move, people are pushed and get up.
void play_on(PersonCrowd& crowd, int first, int last) {
  AnimationSystem& system = crowd.system();
  for (int frame = first; frame < last; ++frame) {
    for (std::uint32_t agent = 0; agent < people; ++agent) {
      const auto time = static_cast<float>(frame) * 0.05F + static_cast<float>(agent);
      EXPECT_TRUE(system.agent(agent).change_process<LookAtProcess>({looks}, [&](auto& look) {
        look.look_at({2.0F * std::sin(time), 1.5F, 2.0F});
      }));
      EXPECT_TRUE(system.agent(agent).change_process<FootPlacementProcess>({stands}, [&](auto& feet) {
        feet.set_placement({.rotation = {1.0F, 0.0F, 0.0F, 0.0F}, .position = {0.01F * time, 0.1F, 0.0F}});
      }));
      if (frame % 40 == static_cast<int>(agent)) {
        EXPECT_TRUE(system.agent(agent).change_process<RagdollProcess>({falls}, [](auto& ragdoll) {
          ragdoll.push({0.0F, 5.0F, -60.0F}, {0.0F, 1.3F, 0.1F});
        }));
      }
      if (frame % 40 == static_cast<int>(agent) + 18) {
        EXPECT_TRUE(system.agent(agent).change_process<RagdollProcess>(
            {falls}, [](auto& ragdoll) { ragdoll.recover(ticks_per_second / 5); }));
      }
    }
    crowd.step(1, static_cast<std::uint8_t>(frame % 10 == 9 ? 1 : 0));
  }
}

std::uint64_t hash_after(const SystemOptions& options, int frames, const std::function<void(PersonCrowd&)>& add,
                         std::uint8_t level = 0) {
  PersonCrowd crowd(options, people);
  add(crowd);
  crowd.step(frames, level);
  return crowd.system().figures().pose_hash();
}

void add_nothing(PersonCrowd&) {}

TEST(PostProcesses, WithoutWeightAreTheSameBitsAsNone) {
  const std::uint64_t none = hash_after({}, 12, add_nothing);
  const auto add_twice = [](PersonCrowd& crowd) {
    for (std::uint32_t agent = 0; agent < people; ++agent) {
      for (int time = 0; time < 2; ++time) {
        AnimationSystem& system = crowd.system();
        auto feet = std::make_unique<FootPlacementProcess>(*crowd.kinds().foot_placement);
        feet->set_ground(slope);
        feet->set_weight(0.0F);
        EXPECT_TRUE(system.agent(agent).add_post_process(std::make_unique<LookAtProcess>(*crowd.kinds().look_at)));
        EXPECT_TRUE(system.agent(agent).add_post_process(std::move(feet)));
        EXPECT_TRUE(system.agent(agent).add_post_process(
            std::make_unique<ReachProcess>(*crowd.kinds().limbs, ReachProcess::Settings{})));
        EXPECT_TRUE(system.agent(agent).add_post_process(std::make_unique<RagdollProcess>(*crowd.kinds().ragdoll)));
      }
    }
  };
  for (const SystemOptions& options : many_options()) {
    EXPECT_EQ(hash_after(options, 12, add_twice), none) << "PUs " << options.pus << ", tile " << options.tile;
  }
}

TEST(PostProcesses, LeaveALevelOfDetailAloneThatLacksTheirJoints) {
  constexpr std::uint8_t hips_alone = 2;
  const auto add = [](PersonCrowd& crowd) {
    for (std::uint32_t agent = 0; agent < people; ++agent) {
      auto look = std::make_unique<LookAtProcess>(*crowd.kinds().look_at);
      look->look_at({1.0F, 1.4F, 2.0F});
      auto feet = std::make_unique<FootPlacementProcess>(*crowd.kinds().foot_placement);
      feet->set_ground(slope);
      EXPECT_TRUE(crowd.system().agent(agent).add_post_process(std::move(look)));
      EXPECT_TRUE(crowd.system().agent(agent).add_post_process(std::move(feet)));
    }
  };
  EXPECT_EQ(hash_after({}, 5, add, hips_alone), hash_after({}, 5, add_nothing, hips_alone));
  EXPECT_NE(hash_after({}, 5, add), hash_after({}, 5, add_nothing));
}

TEST(PostProcesses, GiveOnePoseHashHoweverTheyAreRun) {
  const auto run = [](const SystemOptions& options) {
    PersonCrowd crowd(options, people);
    add_everything(crowd);
    play_on(crowd, 0, 70);
    return crowd.system().figures().pose_hash();
  };
  const std::uint64_t expected = run({});
  for (const SystemOptions& options : many_options()) {
    EXPECT_EQ(run(options), expected) << "PUs " << options.pus << ", tile " << options.tile;
  }
}

TEST(PostProcesses, GoOnThroughChangesOfTheSchedule) {
  const auto run = [](bool changes) {
    PersonCrowd crowd({}, people);
    add_everything(crowd);
    play_on(crowd, 0, 25);
    EXPECT_TRUE(!changes || crowd.system().configure({.pus = 2, .schedule = Schedule::levels}));
    play_on(crowd, 25, 50);
    EXPECT_TRUE(!changes || crowd.system().configure({}));
    play_on(crowd, 50, 60);
    return crowd.system().figures().pose_hash();
  };
  EXPECT_EQ(run(true), run(false));
}

TEST(PostProcesses, AreRestoredFromASnapshotTheSameBits) {
  for (const Schedule schedule : {Schedule::fused, Schedule::levels}) {
    PersonCrowd crowd({.pus = 2, .schedule = schedule}, people);
    add_everything(crowd);
    play_on(crowd, 0, 30);
    SystemSnapshot snapshot;
    crowd.system().snapshot(snapshot);
    play_on(crowd, 30, 80);
    const std::uint64_t expected = crowd.system().figures().pose_hash();
    ASSERT_TRUE(crowd.system().restore(snapshot));
    play_on(crowd, 30, 80);
    EXPECT_EQ(crowd.system().figures().pose_hash(), expected);
  }
}

TEST(PostProcesses, GiveEveryEntityBackWhenTheyAreRemoved) {
  PersonCrowd crowd({}, people);
  add_everything(crowd);
  play_on(crowd, 0, 30);
  for (std::uint32_t number = 0; number < people; ++number) {
    Agent agent = crowd.system().agent(number);
    while (agent.post_process_count() > 0) agent.remove_post_process(agent.post_process_id(0));
  }
  const EntityPools& pools = crowd.system().characters().pools(0);
  for (const auto kind :
       {crowd.kinds().look_at, crowd.kinds().foot_placement, crowd.kinds().limbs, crowd.kinds().ragdoll}) {
    EXPECT_EQ(pools.pool(*kind).memory().bytes_alive, 0U);
  }
}

}  // namespace
}  // namespace throng::anim::post_processes_test
