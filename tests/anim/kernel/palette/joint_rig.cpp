#include "tests/anim/kernel/palette/joint_rig.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "engine/anim/asset/reference_pose.h"
#include "engine/anim/base/aligned_bytes.h"

namespace throng::anim::kernel_rig {
namespace {

constexpr float guard = -77.0F;
constexpr std::size_t guard_floats = 16;

/// Aligned floats.
class Floats {
 public:
  explicit Floats(std::size_t count) : bytes_(allocate_aligned(std::max<std::size_t>(count, 1) * sizeof(float))) {}
  float* at(std::size_t index = 0) const { return reinterpret_cast<float*>(bytes_.get()) + index; }

 private:
  AlignedBytes bytes_;
};

}  // namespace

JointList palette_joints(const Skeleton& skeleton) {
  JointList list;
  for (const PaletteEntry& entry : skeleton.palette) {
    const glm::dmat4 post = skeleton.rigid ? glm::inverse(bind_global(skeleton, entry.bone)) : entry.post;
    list.push_back({.bone = entry.bone, .post = post});
  }
  return list;
}

std::vector<std::vector<float>> compute_joints(const Kernels& kernels, const JointProgram& program,
                                               const std::vector<StatePose>& characters, int width,
                                               QuadMask displaced) {
  const auto lanes = static_cast<std::size_t>(width);
  const std::size_t count = program.bytes / sizeof(float), stride = (count + guard_floats + 3) / 4 * 4;
  const std::size_t packet_floats = packet_bytes(characters.front().components()) / sizeof(float);
  const Floats written((characters.size() + 1) * stride), local(lanes * packet_floats);
  std::fill_n(written.at(), (characters.size() + 1) * stride, guard);
  const Floats carry(lanes * branch_slot_floats);
  const Floats slots(lanes * branch_slot_floats * static_cast<std::size_t>(program.hierarchy.slot_count));
  for (std::size_t first = 0; first < characters.size(); first += lanes) {
    std::array<float*, widest_strip> to{};
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      to[lane] = written.at(std::min(first + lane, characters.size()) * stride);
    }
    for (int packet = 0; packet + 1 < static_cast<int>(program.first_step.size()); ++packet) {
      if (!program.needs(packet)) continue;
      for (std::size_t lane = 0; lane < lanes; ++lane) {
        const StatePose& pose = characters[std::min(first + lane, characters.size() - 1)];
        std::memcpy(local.at(lane * packet_floats), pose.packet(packet), packet_floats * sizeof(float));
      }
      kernels.model_joints({.program = &program,
                            .packet = packet,
                            .width = width,
                            .local = local.at(),
                            .displaced = displaced,
                            .carry = carry.at(),
                            .branch_slots = slots.at(),
                            .to = to.data()});
    }
  }
  std::vector<std::vector<float>> result;
  for (std::size_t i = 0; i < characters.size(); ++i) {
    const float* const begin = written.at(i * stride);
    result.emplace_back(begin, begin + count);
    EXPECT_TRUE(std::all_of(begin + count, begin + stride, [](float value) { return value == guard; }));
  }
  return result;
}

glm::dmat4 written_joint(JointFormat format, const std::vector<float>& written, std::size_t joint) {
  const float* const at = &written[joint * joint_bytes(format) / sizeof(float)];
  glm::dmat4 matrix(1.0);
  if (format == JointFormat::transforms) {
    matrix = glm::mat4_cast(glm::dquat(at[3], at[0], at[1], at[2])) * glm::scale(glm::dmat4(1.0), glm::dvec3(at[7]));
    matrix[3] = glm::dvec4(at[4], at[5], at[6], 1.0);
    return matrix;
  }
  const bool columns = format == JointFormat::matrices_4x4;
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < (columns ? 4 : 3); ++row) {
      matrix[column][row] = columns ? at[column * 4 + row] : at[row * 4 + column];
    }
  }
  return matrix;
}

std::vector<glm::dmat4> reference_joints(const Skeleton& skeleton, const LocalPose& pose, const JointList& list) {
  const ReferencePose reference = pose_from_locals(skeleton, pose);
  std::vector<glm::dmat4> joints;
  for (const ListedJoint& joint : list) {
    joints.push_back(reference.globals[static_cast<std::size_t>(joint.bone)] * joint.post);
  }
  return joints;
}

double largest_difference(const glm::dmat4& a, const glm::dmat4& b) {
  double largest = 0.0;
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) largest = std::max(largest, std::abs(a[column][row] - b[column][row]));
  }
  return largest;
}

}  // namespace throng::anim::kernel_rig
