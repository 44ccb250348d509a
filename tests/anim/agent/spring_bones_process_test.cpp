#include "engine/anim/agent/spring_bones_process.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "engine/anim/agent/system_snapshot.h"
#include "tests/anim/agent/person_crowd.h"

namespace throng::anim::spring_bones_process_test {
namespace {

constexpr std::uint32_t people = 5;

/// Sleeves that hang from the elbows, and a head on a spring.
const SpringRig& loose_person() {
  static const SpringRig rig =
      make_spring_rig(
          marching_person().skeleton,
          std::vector<SpringChain>{{.first = "forearm.L", .last = "hand.L"},
                                   {.first = "forearm.R", .last = "hand.R", .options = {.stiffness = 20.0F}},
                                   {.first = "head", .last = "head", .tip = 0.2F}},
          std::vector<SpringCollider>{{.bone = "hips", .radius = 0.15F}})
          .value();
  return rig;
}

const EntityKind& springs() {
  static const EntityKind kind = spring_bones_kind(loose_person());
  return kind;
}

void add_springs(PersonCrowd& crowd) {
  const EntityPools::Kind kind = *crowd.system().characters().add_entity_kind(springs());
  for (std::uint32_t agent = 0; agent < crowd.system().agent_count(); ++agent) {
    EXPECT_TRUE(crowd.system().agent(agent).add_post_process(std::make_unique<SpringBonesProcess>(kind)));
  }
}

/// Everybody walks, each on a way of his own.
void walk(PersonCrowd& crowd, int first, int last) {
  for (int frame = first; frame < last; ++frame) {
    for (std::uint32_t agent = 0; agent < crowd.system().agent_count(); ++agent) {
      const auto time = static_cast<float>(frame) / 60.0F + static_cast<float>(agent);
      EXPECT_TRUE(crowd.system().agent(agent).change_process<SpringBonesProcess>({0}, [&](auto& hair) {
        hair.set_placement({.rotation = glm::angleAxis(std::sin(time), glm::vec3(0.0F, 1.0F, 0.0F)),
                            .position = {std::sin(2.0F * time), 0.0F, time}});
        if (frame == 20) hair.set_ground(0.9F);
        if (frame == 40) hair.restart();
      }));
    }
    crowd.step(1, static_cast<std::uint8_t>(frame % 10 == 9 ? 1 : 0));
  }
}

TEST(SpringBonesProcess, GivesOnePoseHashHoweverItIsRun) {
  const auto run = [](const SystemOptions& options) {
    PersonCrowd crowd(options, people);
    add_springs(crowd);
    walk(crowd, 0, 60);
    return crowd.system().figures().pose_hash();
  };
  const std::uint64_t expected = run({});
  for (const SystemOptions& options : many_options()) {
    EXPECT_EQ(run(options), expected) << "PUs " << options.pus << ", tile " << options.tile;
  }
}

TEST(SpringBonesProcess, GoesOnFromASnapshot) {
  PersonCrowd crowd({}, people);
  add_springs(crowd);
  walk(crowd, 0, 30);
  SystemSnapshot snapshot;
  crowd.system().snapshot(snapshot);
  walk(crowd, 30, 60);
  const std::uint64_t expected = crowd.system().figures().pose_hash();
  ASSERT_TRUE(crowd.system().restore(snapshot));
  walk(crowd, 30, 60);
  EXPECT_EQ(crowd.system().figures().pose_hash(), expected);
}

TEST(SpringBonesProcess, FollowsThePlacementInTheWorld) {
  PersonCrowd crowd({.schedule = Schedule::levels});
  add_springs(crowd);
  crowd.step(10);
  const auto hand = [&](float x) {
    EXPECT_TRUE(crowd.system().agent(0).change_process<SpringBonesProcess>({0}, [&](auto& hair) {
      hair.set_placement({.position = {x, 0.0F, 0.0F}});
    }));
    crowd.step();
    return crowd.joint("hand.R").position;
  };
  const glm::vec3 before = hand(0.0F);
  const glm::vec3 pulled = hand(0.1F);
  EXPECT_LT(pulled.x, before.x - 0.03F) << "it is left behind in the world";
  const auto& hair = *crowd.system().agent(0).post_process<SpringBonesProcess>({0});
  EXPECT_EQ(hair.joints(crowd.system().agent(0).pools()).size(), 3U);
}

TEST(SpringBonesProcess, IsTheSameBitsAsNoneWithoutWeight) {
  PersonCrowd none;
  PersonCrowd weightless;
  add_springs(weightless);
  EXPECT_TRUE(
      weightless.system().agent(0).change_process<SpringBonesProcess>({0}, [](auto& hair) { hair.set_weight(0.0F); }));
  none.step(20);
  weightless.step(20);
  EXPECT_EQ(weightless.system().figures().pose_hash(), none.system().figures().pose_hash());
}

}  // namespace
}  // namespace throng::anim::spring_bones_process_test
