#pragma once

#include <vector>

#include <glm/mat4x4.hpp>

#include "engine/anim/kernel/kernels.h"
#include "tests/anim/kernel/kernel_rig.h"

/// Listed joints of those skeletons by the kernels.
namespace throng::anim::kernel_rig {

/// Lists what a palette has, entry by entry.
JointList palette_joints(const Skeleton& skeleton);

/// Returns [character] what the kernel writes, in strips of `width`; guards behind each are checked. Packets that the
/// program does not need are left out.
std::vector<std::vector<float>> compute_joints(const Kernels& kernels, const JointProgram& program,
                                               const std::vector<StatePose>& characters, int width,
                                               QuadMask displaced = all_quads);

/// Returns the matrix of a joint that was written.
glm::dmat4 written_joint(JointFormat format, const std::vector<float>& written, std::size_t joint);

/// Returns global * post of each listed joint, in double, of a skeleton in this pose.
std::vector<glm::dmat4> reference_joints(const Skeleton& skeleton, const LocalPose& pose, const JointList& list);

/// Returns the largest difference of two matrices' numbers.
double largest_difference(const glm::dmat4& a, const glm::dmat4& b);

}  // namespace throng::anim::kernel_rig
