// The room that characters, clips and agents take.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/anim/agent/heard_misuses.h"
#include "tests/api/api_crowd.h"
#include "tests/api/smiling.h"

namespace throng::bounds_test {
namespace {

using anim::HeardMisuses;
using api_test::ApiCrowd;
using api_test::mannequin;
using testing::ElementsAre;

/// Calls visit(place) for each vertex of a character, as a palette of matrices poses it.
template <typename Visit>
void for_each_vertex(const Character& character, const float* palette, const Visit& visit) {
  for (std::size_t m = 0; m < character.mesh_count(); ++m) {
    const MeshView mesh = character.mesh(m);
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
      const Vec3 p = mesh.positions[v];
      float out[3] = {};
      for (std::size_t i = 0; i < 4; ++i) {
        const float* const rows = palette + std::size_t{12} * mesh.palette_entries[v][i];
        for (int r = 0; r < 3; ++r) {
          const float* const row = rows + 4 * r;
          out[r] += mesh.weights[v][i] * (row[0] * p.x + row[1] * p.y + row[2] * p.z + row[3]);
        }
      }
      visit(Vec3{out[0], out[1], out[2]});
    }
  }
}

/// Returns the least box that holds the surface of an agent at its last update.
BoundingBox box_of_vertices(const ApiCrowd& crowd, AgentId agent) {
  BoundingBox box{.low = {1e9F, 1e9F, 1e9F}, .high = {-1e9F, -1e9F, -1e9F}};
  for_each_vertex(mannequin(), crowd.palette(agent), [&](const Vec3& p) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y), std::min(box.low.z, p.z)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y), std::max(box.high.z, p.z)};
  });
  return box;
}

/// Returns how far a box is inside of another, in metres: the least of its six sides.
float margin(const BoundingBox& outer, const BoundingBox& inner) {
  return std::min({inner.low.x - outer.low.x, inner.low.y - outer.low.y, inner.low.z - outer.low.z,
                   outer.high.x - inner.high.x, outer.high.y - inner.high.y, outer.high.z - inner.high.z});
}

/// Returns how far a box is larger than another, in metres: the most of its six sides.
float excess(const BoundingBox& outer, const BoundingBox& inner) {
  return std::max({inner.low.x - outer.low.x, inner.low.y - outer.low.y, inner.low.z - outer.low.z,
                   outer.high.x - inner.high.x, outer.high.y - inner.high.y, outer.high.z - inner.high.z});
}

TEST(BoundsOfAnAgent, HoldEveryVertexOfItsPoseAndLittleMore) {
  ApiCrowd crowd(mannequin().clip_count());
  for (const AgentId agent : crowd->agents()) crowd.agent(agent.number).play({.clip = {agent.number}});
  for (int time = 0; time < 4; ++time) {
    crowd.step(17);
    for (const AgentId agent : crowd->agents()) {
      const BoundingBox vertices = box_of_vertices(crowd, agent), bounds = crowd->bounds(agent);
      EXPECT_GE(margin(bounds, vertices), 0.0F) << mannequin().clip({agent.number}).name;
      EXPECT_LT(excess(bounds, vertices), 0.3F) << mannequin().clip({agent.number}).name;
    }
  }
}

TEST(BoundsOfAnAgent, FollowABodyThatFalls) {
  ApiCrowd crowd(1);
  crowd.agent(0).play({.clip = mannequin().find_clip("idle")});
  const auto fall = crowd.agent(0).add(Ragdoll{});
  ASSERT_TRUE(fall);
  crowd.step();
  EXPECT_TRUE(crowd.agent(0).processes().push(*fall, {0.0F, 0.0F, 120.0F}, {0.0F, 1.3F, 0.0F}));
  for (int second = 0; second < 3; ++second) {
    crowd.step(60);
    EXPECT_GE(margin(crowd->bounds({0}), box_of_vertices(crowd, {0})), 0.0F);
  }
  EXPECT_LT(crowd->bounds({0}).high.y, 0.7 * mannequin().height()) << "it lies";
}

TEST(BoundsOfAnAgent, ThatPlaysNothingAreThoseOfItsCharacter) {
  ApiCrowd crowd(1);
  const BoundingSphere sphere = mannequin().bounds();
  EXPECT_EQ(crowd->bounds({0}).high.y, sphere.centre.y + sphere.radius);
  const HeardMisuses heard;
  EXPECT_EQ(crowd->bounds({7}), BoundingBox{});
  EXPECT_THAT(heard.all(), ElementsAre(testing::HasSubstr("Crowd::bounds")));
}

TEST(BoundsOfAClip, HoldItsPoses) {
  ApiCrowd crowd(1);
  for (std::uint32_t clip = 0; clip < mannequin().clip_count(); ++clip) {
    const BoundingBox bounds = mannequin().bounds(ClipId{clip});
    crowd.agent(0).play({.clip = {clip}});
    for (int time = 0; time < 5; ++time) {
      crowd.step(13);
      EXPECT_GE(margin(bounds, box_of_vertices(crowd, {0})), -0.005F) << mannequin().clip({clip}).name;
    }
  }
  EXPECT_EQ(mannequin().bounds(ClipId{99}), BoundingBox{});
}

TEST(BoundsOfAClip, OfABodyInTheAirEndAboveTheGround) {
  CharacterBuilder builder("bird");
  builder.add_bone({.name = "body", .rest = {.translation = {0.0F, 5.0F, 0.0F}}});
  builder.add_bone({.name = "head", .parent = 0, .rest = {.translation = {0.0F, 1.0F, 0.0F}}});
  const BoundingBox bounds = builder.build()->characters.front().bounds(ClipId{0});
  EXPECT_NEAR(bounds.low.y, 5.0F, 0.001F);
  EXPECT_NEAR(bounds.high.y, 6.0F, 0.001F);
}

TEST(BoundsOfAnAgent, HaveRoomForWhatMorphsAdd) {
  Crowd crowd = std::move(*Crowd::create(api_test::smiling()));
  const AgentId agent = crowd.add_agent();
  crowd.agent(agent).play({.clip = {0}});
  const BoundingBox bounds = crowd.bounds(agent);
  const float thinnest =
      std::min({bounds.high.x - bounds.low.x, bounds.high.y - bounds.low.y, bounds.high.z - bounds.low.z});
  EXPECT_GE(thinnest, 1.0F) << "half a metre on each side of a line";
}

TEST(BoundsOfACharacter, HoldThePosesOfAllItsClips) {
  ApiCrowd crowd(mannequin().clip_count());
  const BoundingSphere sphere = mannequin().bounds();
  for (const AgentId agent : crowd->agents()) crowd.agent(agent.number).play({.clip = {agent.number}});
  for (int time = 0; time < 4; ++time) {
    crowd.step(17);
    for (const AgentId agent : crowd->agents()) {
      float farthest = 0.0F;
      for_each_vertex(mannequin(), crowd.palette(agent), [&](const Vec3& p) {
        farthest = std::max(farthest, std::hypot(p.x - sphere.centre.x, p.y - sphere.centre.y, p.z - sphere.centre.z));
      });
      EXPECT_LE(farthest, sphere.radius) << mannequin().clip({agent.number}).name;
    }
  }
  EXPECT_EQ(Character().bounds(), BoundingSphere{});
}

}  // namespace
}  // namespace throng::bounds_test
