#pragma once

#include <cstddef>
#include <cstdint>

#include <glm/vec3.hpp>

#include "app/show/stage/stage.h"
#include "engine/anim/asset/bone_mask.h"

namespace throng::app::test {

/// Returns the metres above the ground of a place in the right hand of an agent of the first character. `at_rest` is
/// the same place in the left hand in the bind pose, from the wrist. The stage keeps joints.
inline float height_in_hand(const Stage& stage, std::uint32_t agent, glm::vec3 at_rest) {
  const anim::Skeleton& skeleton = stage.characters()[0].character->skeleton;
  const auto bones = static_cast<std::size_t>(skeleton.bone_count());
  const auto hand = static_cast<std::size_t>(anim::find_bone(skeleton, "hand.R"));
  const auto& row = stage.posed().joints().of(agent, bones)[hand].rows[1];
  return -row[0] * at_rest.x + row[1] * at_rest.y + row[2] * at_rest.z + row[3];
}

}  // namespace throng::app::test
