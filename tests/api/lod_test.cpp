// Level of detail through the public headers.

#include <gtest/gtest.h>

#include "tests/anim/agent/heard_misuses.h"
#include "tests/api/api_crowd.h"

namespace throng::lod_test {
namespace {

using anim::HeardMisuses;
using api_test::ApiCrowd;

/// Agents in a row that leads away from the camera.
struct Row {
  explicit Row(std::uint32_t agents) : crowd(agents), positions(agents) {
    for (std::uint32_t agent = 0; agent < agents; ++agent) {
      crowd.agent(agent).play({.clip = {0}});
      positions[agent].z = -0.5F * static_cast<float>(agent);
    }
    frame.positions = positions;
    frame.frame_step = ticks_per_second / 60;
  }

  /// Returns how often each agent was posed in so many frames.
  std::vector<int> posed(int frames) {
    std::vector<int> counts(crowd->number_limit());
    for (int number = 0; number < frames; ++number) {
      crowd->advance(frame.frame_step);
      for (const PoseRequest& request : lod.select(*crowd, frame)) ++counts[request.agent.number];
      crowd->update(lod.requests());
      lod.settle(*crowd);
    }
    return counts;
  }

  ApiCrowd crowd;
  std::vector<Vec3> positions;
  Lod lod;
  LodFrame frame;
};

TEST(ApiLod, PosesWhoIsFarOffMoreSeldom) {
  Row row(200);
  for (const LodRule rule : {LodRule::distance, LodRule::budget}) {
    row.frame.rules.rule = rule;
    row.posed(20);
    const std::vector<int> counts = row.posed(120);
    EXPECT_EQ(counts.front(), 120);
    EXPECT_LT(counts.back(), 60);
    EXPECT_GT(counts.back(), 0);
  }
}

TEST(ApiLod, PosesAnAgentFarOffAtOnceThatIsAskedForAClip) {
  Row row(200);
  row.frame.rules.rule = LodRule::distance;
  row.posed(20);
  for (int again = 0; again < 8; ++again) {
    row.crowd.agent(199).play({.clip = {1}, .fade = to_ticks(0.25)});
    EXPECT_EQ(row.posed(1)[199], 1) << again;
  }
}

TEST(ApiLod, KeepsUpWithAgentsThatComeAndGo) {
  Row row(10);
  row.posed(3);
  row.crowd->remove_agent(row.crowd->agents()[4]);
  const std::vector<int> without = row.posed(8);
  EXPECT_EQ(without[4], 0);
  const AgentId heir = row.crowd->add_agent();
  ASSERT_EQ(heir.number, 4U);
  row.crowd->agent(heir).play({.clip = {1}});
  row.positions.resize(400);
  for (std::uint32_t more = 0; more < 300; ++more) row.crowd->agent(row.crowd->add_agent()).play({.clip = {2}});
  row.frame.positions = row.positions;
  const std::vector<int> counts = row.posed(8);
  for (const AgentId agent : row.crowd->agents()) EXPECT_GT(counts[agent.number], 0) << agent.number;
}

TEST(ApiLod, ACameraSeesWhatIsBeforeIt) {
  // Looks along -Z with a right angle from top to bottom and from side to side.
  constexpr float near = 0.1F, far = 100.0F;
  const float projection[16] = {
      1, 0, 0, 0, 0, 1, 0, 0, 0, 0, (far + near) / (near - far), -1, 0, 0, 2 * far * near / (near - far), 0};
  Row row(2);
  row.positions = {{0.0F, 0.0F, -10.0F}, {0.0F, 0.0F, 10.0F}};
  row.frame.positions = row.positions;
  row.frame.camera = camera_of({}, {0.0F, 0.0F, -1.0F}, projection, 1000);
  EXPECT_FLOAT_EQ(row.frame.camera.pixels_per_unit, 500.0F);
  row.posed(2);
  EXPECT_TRUE(row.lod.is_visible(row.crowd->agents()[0]));
  EXPECT_FALSE(row.lod.is_visible(row.crowd->agents()[1])) << "it stands behind the camera";
}

TEST(ApiLod, ACopyBesideASnapshotGoesOnToTheSameChoices) {
  Row row(200);
  row.posed(20);
  row.crowd.agent(199).play({.clip = {1}, .fade = to_ticks(0.25)});
  row.posed(1);
  Snapshot snapshot;
  row.crowd->snapshot(snapshot);
  const Lod copy = row.lod;
  const std::vector<int> counts = row.posed(50);
  const std::uint64_t hash = row.crowd.hash();
  ASSERT_TRUE(row.crowd->restore(snapshot));
  row.lod = copy;
  EXPECT_EQ(row.posed(50), counts);
  EXPECT_EQ(row.crowd->debug().pose_hash(), hash);
}

TEST(ApiLod, ACopyHasRequestsOfItsOwn) {
  Row row(3);
  row.crowd->advance(row.frame.frame_step);
  row.lod.select(*row.crowd, row.frame);
  Lod copy = row.lod;
  ASSERT_EQ(copy.requests().size(), row.lod.requests().size());
  EXPECT_NE(copy.requests().data(), row.lod.requests().data());
}

TEST(ApiLod, RefusesFramesThatAreNone) {
  const HeardMisuses heard;
  Row row(10);
  LodFrame frame = row.frame;
  frame.positions = frame.positions.first(5);
  EXPECT_TRUE(row.lod.select(*row.crowd, frame).empty());
  frame = row.frame;
  frame.rules.largest_interval = 99;
  EXPECT_TRUE(row.lod.select(*row.crowd, frame).empty());
  frame = row.frame;
  frame.camera.forward = {};
  EXPECT_TRUE(row.lod.select(*row.crowd, frame).empty());
  row.lod.settle(*row.crowd);
  EXPECT_EQ(heard.all().size(), 4U);
}

}  // namespace
}  // namespace throng::lod_test
