// Level of detail, joints and exact poses through the functions for C.

#include <cmath>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/api/c/c_crowd.h"

namespace throng::c_lod_test {
namespace {

using api_test::ApiCrowd;
using api_test::CCrowd;
using api_test::first_character;
using testing::HasSubstr;

constexpr std::uint32_t agents = 200;

struct alignas(64) Line {
  float floats[16];
};

/// Returns the places of agents in a row that leads away from the camera.
std::vector<Vec3> row() {
  std::vector<Vec3> positions(agents);
  for (std::uint32_t agent = 0; agent < agents; ++agent) positions[agent].z = -0.5F * static_cast<float>(agent);
  return positions;
}

TEST(ApiCLod, ListsTheRequestsOfCpp) {
  const CCrowd c(agents);
  ApiCrowd cpp(agents);
  for (std::uint32_t agent = 0; agent < agents; ++agent) {
    c.play(agent, 1);
    cpp.agent(agent).play({.clip = {1}});
  }
  const std::vector<Vec3> positions = row();
  throng_lod_rules rules = throng_lod_rules_default();
  rules.rule = THRONG_LOD_BY_DISTANCE;
  rules.smooth = 1;
  throng_lod_frame frame = throng_lod_frame_default();
  frame.positions = &positions.front().x;
  frame.count = agents;
  frame.rules = &rules;
  frame.frame_step = 1.0 / 60.0;
  LodFrame own{.positions = positions, .scales = {}, .frame_step = ticks_per_second / 60};
  own.rules.rule = LodRule::distance;
  own.rules.smooth = true;
  throng_lod* const lod = throng_lod_create();
  Lod cpp_lod;
  std::vector<Line> palettes(agents * throng_crowd_palette_bytes(c.crowd, first_character) / sizeof(Line));
  const std::size_t lines = palettes.size() / agents;
  std::uint32_t listed = 0, ahead = 0;
  for (int number = 0; number < 40; ++number) {
    throng_crowd_advance(c.crowd, frame.frame_step);
    cpp->advance(own.frame_step);
    throng_pose_request* requests = nullptr;
    std::uint32_t count = 0;
    ASSERT_EQ(throng_lod_select(lod, c.crowd, &frame, &requests, &count), 0) << throng_last_error();
    listed += count;
    for (std::uint32_t i = 0; i < count; ++i) {
      if (requests[i].look_ahead > 0.0) ++ahead;
      requests[i].palette = palettes[lines * requests[i].agent.number].floats;
    }
    for (PoseRequest& request : cpp_lod.select(*cpp, own)) {
      request.palette = reinterpret_cast<std::byte*>(&palettes[lines * request.agent.number]);
    }
    EXPECT_EQ(throng_crowd_update(c.crowd, requests, count), 0);
    cpp->update(cpp_lod.requests());
    EXPECT_EQ(throng_lod_settle(lod, c.crowd), 0);
    cpp_lod.settle(*cpp);
    ASSERT_EQ(c.hash(), cpp.hash()) << "frame " << number;
    EXPECT_EQ(throng_crowd_posed_agents(c.crowd), count);
  }
  EXPECT_LT(listed, 40 * agents);
  EXPECT_GT(ahead, 0U) << "agents that are drawn are posed for later";
  EXPECT_NE(throng_lod_settle(lod, c.crowd), 0) << "there was no selection since";
  throng_lod_free(lod);
}

TEST(ApiCLod, SeesWhatIsBeforeItsCamera) {
  constexpr float near = 0.1F, far = 100.0F;
  const float projection[16] = {
      1, 0, 0, 0, 0, 1, 0, 0, 0, 0, (far + near) / (near - far), -1, 0, 0, 2 * far * near / (near - far), 0};
  const float here[3] = {}, ahead[3] = {0.0F, 0.0F, -1.0F}, sun[3] = {0.0F, std::sqrt(0.5F), -std::sqrt(0.5F)};
  throng_camera camera = throng_camera_default();
  ASSERT_EQ(throng_camera_set(&camera, here, ahead, projection, 1000), 0);
  EXPECT_FLOAT_EQ(camera.pixels_per_unit, 500.0F);
  const CCrowd c(2);
  const float positions[] = {0.0F, 0.0F, -10.0F, 0.0F, 0.0F, 10.0F};
  throng_lod_frame frame = throng_lod_frame_default();
  frame.positions = positions;
  frame.count = 2;
  frame.camera = &camera;
  frame.frame_step = 1.0 / 60.0;
  for (std::uint32_t agent = 0; agent < 2; ++agent) c.play(agent, 0);
  throng_lod* const lod = throng_lod_create();
  throng_pose_request* requests = nullptr;
  std::uint32_t count = 0;
  ASSERT_EQ(throng_lod_select(lod, c.crowd, &frame, &requests, &count), 0);
  EXPECT_EQ(throng_lod_is_visible(lod, c.ids[0]), 1);
  EXPECT_EQ(throng_lod_is_visible(lod, c.ids[1]), 0) << "it stands behind the camera";
  EXPECT_EQ(throng_lod_make_due(lod, c.ids[0]), 0);
  Camera own = camera_of({}, {0.0F, 0.0F, -1.0F}, projection, 1000);
  include_casters(own, {sun[0], sun[1], sun[2]}, 1.8F);
  ASSERT_EQ(throng_camera_include_casters(&camera, sun, 1.8F), 0);
  for (std::size_t plane = 0; plane < 6; ++plane) EXPECT_EQ(camera.frustum[plane][3], own.frustum[plane][3]);
  frame.count = 1;
  EXPECT_NE(throng_lod_select(lod, c.crowd, &frame, &requests, &count), 0);
  EXPECT_EQ(count, 0U);
  throng_lod_rules rules = throng_lod_rules_default();
  rules.rule = 9;
  frame.rules = &rules;
  EXPECT_NE(throng_lod_select(lod, c.crowd, &frame, &requests, &count), 0);
  EXPECT_THAT(throng_last_error(), HasSubstr("throng_lod_rules::rule is none of its constants"));
  throng_lod_free(lod);
}

TEST(ApiCJoints, AreWhereSocketsAndExactPosesSay) {
  const CCrowd c(1);
  c.play(0, c.clip("walk"));
  const std::uint32_t hand = c.bone("hand.R");
  throng_joint_output output = throng_joint_output_default();
  output.bones = &hand;
  output.bone_count = 1;
  ASSERT_EQ(throng_crowd_write_joints(c.crowd, first_character, &output), 0) << throng_last_error();
  ASSERT_EQ(throng_crowd_joint_bytes(c.crowd, first_character), 32U);
  throng_socket settings = throng_socket_default();
  settings.bone = hand;
  const std::uint32_t socket = throng_agent_add_socket(c.crowd, c.ids[0], &settings);
  struct alignas(32) Joint {
    float rotation[4];
    float position[3];
    float scale;
  } joint;
  throng_pose_request request{};
  request.agent = c.ids[0];
  request.joints = joint.rotation;
  throng_crowd_advance(c.crowd, 0.3);
  ASSERT_EQ(throng_crowd_update(c.crowd, &request, 1), 0) << throng_last_error();
  throng_place place;
  throng_agent_socket(c.crowd, c.ids[0], socket, &place);
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(joint.position[axis], place.position[axis], 1e-4F);

  std::vector<Line> palette(throng_crowd_palette_bytes(c.crowd, first_character) / sizeof(Line));
  request.joints = nullptr;
  request.palette = palette.front().floats;
  ASSERT_EQ(throng_crowd_pose_exactly(c.crowd, &request, 1), 0) << throng_last_error();
  EXPECT_NE(palette.front().floats[0], 0.0F);
  std::vector<throng_transform> bones(throng_character_bone_count(c.character));
  ASSERT_EQ(throng_crowd_local_pose(c.crowd, c.ids[0], bones.data(), static_cast<std::uint32_t>(bones.size())), 0);
  EXPECT_EQ(bones[hand].scale[0], 1.0F);
  EXPECT_NE(throng_crowd_local_pose(c.crowd, c.ids[0], bones.data(), 3), 0) << "there is no room";
  output.skin = 99;
  EXPECT_NE(throng_crowd_write_joints(c.crowd, first_character, &output), 0);
  EXPECT_THAT(throng_last_error(), HasSubstr("no skin 99"));
}

}  // namespace
}  // namespace throng::c_lod_test
