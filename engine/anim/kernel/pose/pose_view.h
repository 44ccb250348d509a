#pragma once

#include <cstddef>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include "engine/anim/base/pose.h"

namespace throng::anim {

/// A whole local pose in the local store, for code that reads or changes single bones. It has packets as in pose.h,
/// each [components][16], with `packet_stride` floats from one to the next. It owns nothing.
struct PoseView {
  float* first = nullptr;
  std::size_t packet_stride = 0;  ///< floats, at least components * 16
  int components = rigid_components;
  int bone_count = 0;  ///< bones at and above it (another level of detail's) are not there
  std::uint64_t displaced_quads = ~std::uint64_t{0};  ///< others' positions are 0 and need not be there; see displaces

  float* packet(int index) const { return first + static_cast<std::size_t>(index) * packet_stride; }

  glm::quat rotation(int bone) const {
    const float* lane = packet(bone / packet_bones) + bone % packet_bones;
    return {lane[3 * packet_bones], lane[0], lane[packet_bones], lane[2 * packet_bones]};  // GLM takes w first
  }
  void set_rotation(int bone, const glm::quat& rotation) const {
    float* lane = packet(bone / packet_bones) + bone % packet_bones;
    lane[0] = rotation.x;
    lane[packet_bones] = rotation.y;
    lane[2 * packet_bones] = rotation.z;
    lane[3 * packet_bones] = rotation.w;
  }

  bool displaces(int bone) const {
    return is_in(quads_of_packet(displaced_quads, bone / packet_bones), bone % packet_bones / quad_bones);
  }
  glm::vec3 position(int bone) const {
    if (!displaces(bone)) return glm::vec3(0.0F);
    const float* lane = packet(bone / packet_bones) + 4 * packet_bones + bone % packet_bones;
    return {lane[0], lane[packet_bones], lane[2 * packet_bones]};
  }
  void set_position(int bone, const glm::vec3& position) const {
    float* lane = packet(bone / packet_bones) + 4 * packet_bones + bone % packet_bones;
    lane[0] = position.x;
    lane[packet_bones] = position.y;
    lane[2 * packet_bones] = position.z;
  }
};
bool is_valid(const PoseView& pose);

}  // namespace throng::anim
