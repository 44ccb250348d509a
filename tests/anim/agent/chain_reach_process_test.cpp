
#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "engine/anim/agent/targeted_processes.h"
#include "engine/anim/asset/bone_mask.h"
#include "tests/anim/agent/person_crowd.h"

namespace throng::anim::chain_reach_process_test {
namespace {

/// From the hips to the head, and from the left shoulder to the hand.
const std::vector<ReachChain>& chains() {
  static const std::vector<ReachChain> all = [] {
    const Skeleton& skeleton = marching_person().skeleton;
    const auto chain = [&](const char* first, const char* last) {
      return make_reach_chain(skeleton, find_bone(skeleton, first), find_bone(skeleton, last)).value();
    };
    return std::vector{chain("spine", "head"), chain("upper_arm.L", "hand.L")};
  }();
  return all;
}

const EntityKind& reaching() {
  static const EntityKind kind = chain_reach_kind(chains());
  return kind;
}

TEST(ChainReachProcess, BringsTheEndOfAChainToItsTarget) {
  PersonCrowd crowd({.schedule = Schedule::levels});
  const EntityPools::Kind kind = *crowd.system().characters().add_entity_kind(reaching());
  const glm::vec3 target(0.35F, 1.25F, 0.25F);
  auto reach = std::make_unique<ChainReachProcess>(kind, ChainReachProcess::Settings{.chain = 1, .iterations = 64});
  reach->set_target(target);
  reach->set_weight(1.0F, ticks_per_second / 4);
  ASSERT_TRUE(crowd.system().agent(0).add_post_process(std::move(reach)));
  crowd.step(1);
  EXPECT_GT(glm::distance(crowd.joint("hand.L").position, target), 0.05F);
  crowd.step(20);
  EXPECT_LT(glm::distance(crowd.joint("hand.L").position, target), 2e-3F);
  EXPECT_LT(crowd.system().agent(0).post_process<ChainReachProcess>({0})->missed_by(crowd.system().agent(0).pools()),
            2e-3F);
}

TEST(ChainReachProcess, GivesOnePoseHashHoweverItIsRun) {
  constexpr std::uint32_t people = 5;
  const auto run = [](const SystemOptions& options) {
    PersonCrowd crowd(options, people);
    const EntityPools::Kind kind = *crowd.system().characters().add_entity_kind(reaching());
    for (std::uint32_t agent = 0; agent < people; ++agent) {
      auto reach = std::make_unique<ChainReachProcess>(kind, ChainReachProcess::Settings{.chain = agent % 2});
      reach->set_weight(agent == 3 ? 0.5F : 1.0F);
      EXPECT_TRUE(crowd.system().agent(agent).add_post_process(std::move(reach)));
    }
    for (int frame = 0; frame < 30; ++frame) {
      for (std::uint32_t agent = 0; agent < people; ++agent) {
        EXPECT_TRUE(crowd.system().agent(agent).change_process<ChainReachProcess>({0}, [&](auto& reach) {
          reach.set_target({std::sin(0.1F * static_cast<float>(frame)), 1.3F, 0.3F});
        }));
      }
      crowd.step(1, static_cast<std::uint8_t>(frame % 10 == 9 ? 1 : 0));
    }
    return crowd.system().figures().pose_hash();
  };
  const std::uint64_t expected = run({});
  for (const SystemOptions& options : many_options()) {
    EXPECT_EQ(run(options), expected) << "PUs " << options.pus << ", tile " << options.tile;
  }
}

}  // namespace
}  // namespace throng::anim::chain_reach_process_test
