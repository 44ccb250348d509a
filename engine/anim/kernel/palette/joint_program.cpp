#include "engine/anim/kernel/palette/joint_program.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <glm/gtc/quaternion.hpp>

#include "engine/anim/asset/reference_pose.h"
#include "engine/anim/base/finite.h"
#include "engine/anim/base/pose.h"

namespace throng::anim {
namespace {

bool is_similarity(const glm::dmat4& matrix) {
  const glm::dmat3 linear(matrix);
  const double scale = glm::length(linear[0]);
  const glm::dmat3 unlike = glm::transpose(linear) * linear - glm::dmat3(scale * scale);
  constexpr double most_unlike = 1e-5;
  double worst = 0.0;
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) worst = std::max(worst, std::abs(unlike[column][row]));
  }
  return glm::determinant(linear) > 0.0 && worst <= most_unlike * scale * scale;
}

/// Returns the matrix without the remains of sums that cancel out in double.
glm::dmat4 without_dust(glm::dmat4 matrix) {
  constexpr double dust = 1e-12;
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      if (std::abs(matrix[column][row]) < dust) matrix[column][row] = 0.0;
    }
  }
  return matrix;
}

/// Returns the transform of a bone that stands still, in the space of its parent.
glm::dmat4 still_local(const Skeleton& skeleton, const std::vector<float>& still, int bone) {
  const float* at = still.data() + bone / packet_bones * general_components * packet_bones + bone % packet_bones;
  const auto value = [&](int component) { return static_cast<double>(at[component * packet_bones]); };
  const StateTransform local{.rotation = glm::dquat(value(3), value(0), value(1), value(2)),
                             .position = {value(4), value(5), value(6)},
                             .scale = {value(7), value(8), value(9)}};
  return skeleton.bones[static_cast<std::size_t>(bone)].prefix * compose(local);
}

struct Carried {
  int bone;         // that is there at the level
  glm::dmat4 post;  // see PlacedJoint
};

/// `still` is the still pose of a skeleton that is not rigid.
Carried carried(const Skeleton& skeleton, const std::vector<float>& still, const ListedJoint& joint, int bone_count) {
  const int carrier = nearest_kept_bone(skeleton, joint.bone, bone_count);
  if (skeleton.rigid) return {carrier, without_dust(bind_global(skeleton, joint.bone) * joint.post)};
  glm::dmat4 post = joint.post;
  for (int bone = joint.bone; bone != carrier; bone = skeleton.bones[static_cast<std::size_t>(bone)].parent) {
    post = still_local(skeleton, still, bone) * post;
  }
  return {carrier, post};
}

PlacedJoint placed(const Skeleton& skeleton, const Carried& carried) {
  PlacedJoint placed{};
  glm::dmat4 post = carried.post;
  if (skeleton.rigid) {
    const glm::dmat3 linear(post);
    const glm::dvec3 origin = skeleton.references[static_cast<std::size_t>(carried.bone)].origin;
    post[3] = glm::dvec4(glm::dvec3(post[3]) - origin, 1.0);
    post = without_dust(post);
    const double scale = glm::length(linear[0]);
    const glm::dquat turn = glm::normalize(glm::quat_cast(linear / scale)) * std::sqrt(0.5);
    const double rotation[4] = {turn.x, turn.y, turn.z, turn.w};
    for (int i = 0; i < 4; ++i) placed.rotation[i] = static_cast<float>(rotation[i]);
    placed.scale = static_cast<float>(scale);
  }
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) {
      placed.rows[row][column] = static_cast<float>(post[column][row]);
      if (column < 3) placed.turns = placed.turns || placed.rows[row][column] != (row == column ? 1.0F : 0.0F);
    }
    placed.moves = placed.moves || placed.rows[row][3] != 0.0F;
  }
  return placed;
}

Status check(const Skeleton& skeleton, const JointList& list, JointFormat format) {
  const std::string whose = "the joints of \"" + skeleton.name + "\": ";
  if (list.empty()) return Error{whose + "the list is empty"};
  if (format > JointFormat::matrices_4x4) return Error{whose + "the format is none of JointFormat"};
  if (format == JointFormat::transforms && !skeleton.rigid) {
    return Error{whose + "its bones are stretched or sheared, which no JointTransform says: ask for matrices"};
  }
  for (std::size_t i = 0; i < list.size(); ++i) {
    const std::string which = "joint " + std::to_string(i);
    if (list[i].bone < 0 || list[i].bone >= skeleton.bone_count()) {
      return Error{whose + which + " is of bone " + std::to_string(list[i].bone) + ": give 0 to " +
                   std::to_string(skeleton.bone_count() - 1)};
    }
    if (!all_finite(glm::dmat4(glm::mat4(list[i].post))))
      return Error{whose + which + " has a matrix that is not finite"};
    if (format == JointFormat::transforms && !is_similarity(bind_global(skeleton, list[i].bone) * list[i].post)) {
      return Error{whose + which + " has a matrix with shear or uneven scale: ask for matrices"};
    }
  }
  return Done{};
}

/// Compiles the bones that are needed as a skeleton of their own.
void compile_steps(const Skeleton& skeleton, const std::vector<bool>& needed, JointProgram& program) {
  Skeleton pruned;
  pruned.rigid = skeleton.rigid;
  std::vector<int> step_of(needed.size(), -1);
  program.first_step = {0};
  for (int bone = 0; bone < skeleton.bone_count(); ++bone) {
    const auto at = static_cast<std::size_t>(bone);
    if (needed[at]) {
      step_of[at] = static_cast<int>(program.bones.size());
      program.bones.push_back(static_cast<std::int16_t>(bone));
      pruned.bones.push_back(skeleton.bones[at]);
      int& parent = pruned.bones.back().parent;
      if (parent >= 0) parent = step_of[static_cast<std::size_t>(parent)];
      pruned.references.push_back(skeleton.references[at]);
    }
    const bool ends_packet = bone % packet_bones == packet_bones - 1 || bone + 1 == skeleton.bone_count();
    if (ends_packet) program.first_step.push_back(static_cast<std::int32_t>(program.bones.size()));
  }
  program.hierarchy = compile_hierarchy(pruned);
}

void list_carriers(JointProgram& program) {
  program.first_carrier = {0};
  for (std::size_t packet = 0; packet + 1 < program.first_step.size(); ++packet) {
    for (std::int32_t step = program.first_step[packet]; step < program.first_step[packet + 1]; ++step) {
      const auto at = static_cast<std::size_t>(step);
      if (program.first_joint[at] < program.first_joint[at + 1]) {
        program.carriers.push_back(static_cast<std::int16_t>(step));
      }
    }
    program.first_carrier.push_back(static_cast<std::int32_t>(program.carriers.size()));
  }
}

}  // namespace

Result<JointProgram> compile_joints(const Skeleton& skeleton, const JointList& list, JointFormat format,
                                    int bone_count) {
  if (Status checked = check(skeleton, list, format); !checked) return checked.error();
  JointProgram program;
  program.format = format;
  program.bytes = list.size() * joint_bytes(format);
  std::vector<bool> needed(skeleton.bones.size());
  std::vector<std::vector<PlacedJoint>> joints(skeleton.bones.size());
  const std::vector<float> still = skeleton.rigid ? std::vector<float>() : still_pose(skeleton);
  for (std::size_t i = 0; i < list.size(); ++i) {
    const Carried joint = carried(skeleton, still, list[i], bone_count);
    joints[static_cast<std::size_t>(joint.bone)].push_back(placed(skeleton, joint));
    joints[static_cast<std::size_t>(joint.bone)].back().at =
        static_cast<std::int32_t>(i * joint_bytes(format) / sizeof(float));
    for (int bone = joint.bone; bone >= 0; bone = skeleton.bones[static_cast<std::size_t>(bone)].parent) {
      needed[static_cast<std::size_t>(bone)] = true;
    }
  }
  compile_steps(skeleton, needed, program);
  program.first_joint = {0};
  for (const std::int16_t bone : program.bones) {
    const std::vector<PlacedJoint>& own = joints[static_cast<std::size_t>(bone)];
    program.joints.insert(program.joints.end(), own.begin(), own.end());
    program.first_joint.push_back(static_cast<std::int32_t>(program.joints.size()));
  }
  list_carriers(program);
  return program;
}

}  // namespace throng::anim
