// A sword in a hand: where it is, without reading a palette back.

#include "engine/anim/agent/socket_process.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "tests/anim/agent/person_crowd.h"

namespace throng::anim::socket_process_test {
namespace {

constexpr Schedule schedules[] = {Schedule::fused, Schedule::levels};

int bone(std::string_view name) { return find_bone(marching_person().skeleton, name); }

TEST(Socket, IsWhereItsJointIs) {
  const SocketPlaces places{*make_socket_place(marching_person().skeleton, bone("hand.R"))};
  const EntityKind kind = socket_kind(places);
  PersonCrowd crowd({.schedule = Schedule::levels});
  const auto index = *crowd.system().characters().add_entity_kind(kind);
  ASSERT_TRUE(crowd.system().agent(0).add_post_process(std::make_unique<SocketProcess>(index, 0)));
  for (int frame = 0; frame < 30; ++frame) {
    crowd.step();
    const JointMotion hand = crowd.joint("hand.R");
    const auto& socket = *crowd.system().agent(0).post_process<SocketProcess>({0});
    EXPECT_LT(glm::distance(socket.motion(crowd.system().characters().pools(0)).position, hand.position), 1e-6F)
        << frame;
  }
}

TEST(Socket, CarriesWhatIsAttachedByItsJointsTurn) {
  const glm::vec3 blade(0.0F, 0.8F, 0.1F);
  const SocketPlaces places{*make_socket_place(marching_person().skeleton, bone("hand.R")),
                            *make_socket_place(marching_person().skeleton, bone("hand.R"), {.position = blade})};
  const EntityKind kind = socket_kind(places);
  PersonCrowd crowd;
  const auto index = *crowd.system().characters().add_entity_kind(kind);
  for (const std::uint32_t place : {0U, 1U}) {
    ASSERT_TRUE(crowd.system().agent(0).add_post_process(std::make_unique<SocketProcess>(index, place)));
  }
  crowd.step(7);
  const EntityPools& pools = crowd.system().characters().pools(0);
  const JointMotion hand = crowd.system().agent(0).post_process<SocketProcess>({0})->motion(pools);
  const JointMotion tip = crowd.system().agent(0).post_process<SocketProcess>({1})->motion(pools);
  EXPECT_LT(glm::distance(tip.position, hand.position + hand.rotation * blade), 1e-5F);
  EXPECT_NEAR(glm::distance(tip.position, hand.position), glm::length(blade), 1e-5F);
}

TEST(Socket, PassesThePoseOnToTheBit) {
  const SocketPlaces places{*make_socket_place(marching_person().skeleton, bone("head"))};
  const EntityKind kind = socket_kind(places);
  for (const Schedule schedule : schedules) {
    PersonCrowd plain({.schedule = schedule}), watched({.schedule = schedule});
    const auto index = *watched.system().characters().add_entity_kind(kind);
    ASSERT_TRUE(watched.system().agent(0).add_post_process(std::make_unique<SocketProcess>(index, 0)));
    plain.step(10);
    watched.step(10);
    EXPECT_EQ(watched.system().figures().pose_hash(), plain.system().figures().pose_hash());
  }
}

TEST(Socket, StaysWhereItWasWhileALevelOfDetailLacksItsJoint) {
  const SocketPlaces places{*make_socket_place(marching_person().skeleton, bone("hand.R"))};
  const EntityKind kind = socket_kind(places);
  PersonCrowd crowd;
  const auto index = *crowd.system().characters().add_entity_kind(kind);
  ASSERT_TRUE(crowd.system().agent(0).add_post_process(std::make_unique<SocketProcess>(index, 0)));
  crowd.step(3);
  const auto& socket = *crowd.system().agent(0).post_process<SocketProcess>({0});
  const glm::vec3 before = socket.motion(crowd.system().characters().pools(0)).position;
  crowd.step(5, 2);
  EXPECT_EQ(socket.motion(crowd.system().characters().pools(0)).position, before);
}

TEST(Socket, IsRefusedAtABoneThatIsNotThere) {
  EXPECT_FALSE(make_socket_place(marching_person().skeleton, -1).has_value());
}

}  // namespace
}  // namespace throng::anim::socket_process_test
