#include "engine/anim/kernel/pose/pose_view.h"

#include <array>

#include <gtest/gtest.h>

namespace throng::anim::pose_view_test {
namespace {

TEST(PoseView, HasNoPositionsButOfDisplacedQuadsWhateverLiesThere) {
  constexpr int packets = 2, packet_floats = rigid_components * packet_bones;
  std::array<float, packets * packet_floats> floats;
  floats.fill(7.0F);
  const PoseView pose{.first = floats.data(),
                      .packet_stride = packet_floats,
                      .bone_count = packets * packet_bones,
                      .displaced_quads = 0b0100'0001};
  for (int bone = 0; bone < pose.bone_count; ++bone) {
    const bool is_displaced = bone < quad_bones || (bone >= 24 && bone < 24 + quad_bones);
    EXPECT_EQ(pose.position(bone), glm::vec3(is_displaced ? 7.0F : 0.0F)) << bone;
    EXPECT_EQ(pose.rotation(bone).w, 7.0F);
  }
}

}  // namespace
}  // namespace throng::anim::pose_view_test
