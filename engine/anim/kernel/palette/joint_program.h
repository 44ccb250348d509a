#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "throng/formats.h"

#include "engine/anim/asset/joint_list.h"
#include "engine/anim/kernel/palette/hierarchy.h"

namespace throng::anim {

constexpr std::size_t joint_bytes(JointFormat format) {
  constexpr std::size_t bytes[] = {sizeof(JointTransform), sizeof(PaletteMatrix), sizeof(Matrix4x4)};
  return bytes[static_cast<std::size_t>(format)];
}

/// A joint of a list as the kernel writes it: what a bone carries, times `post`. On rigid skeletons a bone carries its
/// motion from the bind pose, which turns about the bone's origin there.
struct PlacedJoint {
  float rows[3][4];     ///< post, 3x4 row-major; rigid: its translation is from the bone's origin
  float rotation[4];    ///< rigid: that of `post`, of length 1 / root of two
  float scale = 1.0F;   ///< rigid: that of `post`
  std::int32_t at = 0;  ///< floats from the beginning of an agent's output
  bool turns = false;   ///< `post` is more than a translation
  bool moves = false;   ///< the translation is not zero
};

/// A list of joints, compiled for the kernel at one bone level. It knows the bones alone that the list needs: those
/// that carry a joint, and their ancestors. A joint that the level lacks stands still on its nearest bone that is
/// there.
struct JointProgram {
  JointFormat format = JointFormat::matrices;
  HierarchyProgram hierarchy;               ///< of the bones that are needed; its bones are the steps below
  std::vector<std::int16_t> bones;          ///< [step] the bone of the skeleton, ascending
  std::vector<std::int32_t> first_step;     ///< [packet of the skeleton, and one more]
  std::vector<std::int32_t> first_joint;    ///< [step, and one more]
  std::vector<PlacedJoint> joints;          ///< by the steps that carry them
  std::vector<std::int16_t> carriers;       ///< the steps that carry joints, ascending
  std::vector<std::int32_t> first_carrier;  ///< [packet of the skeleton, and one more]
  std::size_t bytes = 0;                    ///< of an agent's output

  bool needs(int packet) const {
    const auto at = static_cast<std::size_t>(packet);
    return at + 1 < first_step.size() && first_step[at] < first_step[at + 1];
  }
  /// Returns whether a bone of a packet carries a joint.
  bool carries(int packet) const {
    const auto at = static_cast<std::size_t>(packet);
    return at + 1 < first_carrier.size() && first_carrier[at] < first_carrier[at + 1];
  }
};

/// Compiles a list for a bone level of so many bones. Errors: the list is empty, a bone is none, the format is none, a
/// `post` has a number that is not finite, or `transforms` are wanted of a skeleton that is not rigid or of a `post`
/// that is not a rotation, a translation and a uniform scale.
Result<JointProgram> compile_joints(const Skeleton& skeleton, const JointList& list, JointFormat format,
                                    int bone_count);

}  // namespace throng::anim
