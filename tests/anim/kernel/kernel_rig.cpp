#include "tests/anim/kernel/kernel_rig.h"

#include <algorithm>
#include <numeric>

#include <glm/gtc/matrix_transform.hpp>

namespace throng::anim::kernel_rig {
namespace {

using Random = std::mt19937;

double between(Random& random, double lowest, double highest) {
  return lowest + (highest - lowest) * (static_cast<double>(random()) / 4294967296.0);
}

glm::dvec3 direction(Random& random) {
  for (;;) {
    const glm::dvec3 v(between(random, -1, 1), between(random, -1, 1), between(random, -1, 1));
    const double length = glm::length(v);
    if (length > 0.1 && length < 1.0) return v / length;
  }
}

glm::dquat rotation(Random& random, double most_radians) {
  return glm::angleAxis(between(random, -most_radians, most_radians), direction(random));
}

glm::dmat4 matrix(const StateTransform& t) {
  return glm::translate(glm::dmat4(1.0), t.position) * glm::mat4_cast(t.rotation) *
         glm::scale(glm::dmat4(1.0), t.scale);
}

StateTransform rest_of(const Bone& bone) {
  return {glm::dquat(bone.rest.rotation), glm::dvec3(bone.rest.translation), glm::dvec3(bone.rest.scale)};
}

std::vector<glm::dmat4> global_matrices(const Skeleton& skeleton, const LocalPose& pose) {
  std::vector<glm::dmat4> globals;
  for (std::size_t i = 0; i < pose.size(); ++i) {
    const Bone& bone = skeleton.bones[i];
    const glm::dmat4 local = bone.prefix * matrix(pose[i]);
    globals.push_back(bone.parent < 0 ? local : globals[static_cast<std::size_t>(bone.parent)] * local);
  }
  return globals;
}

glm::dmat4 random_shear(Random& random) {
  glm::dmat4 m = glm::mat4_cast(rotation(random, 1.0));
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) m[column][row] += between(random, -0.2, 0.2);
  }
  m[3] = glm::dvec4(0.1 * direction(random), 1.0);
  return m;
}

Skeleton bare_skeleton(const std::vector<int>& parents, Random& random) {
  Skeleton skeleton;
  for (const int parent : parents) {
    Bone bone;
    bone.node = static_cast<int>(parents.size()) - static_cast<int>(skeleton.bones.size());
    bone.parent = parent;
    bone.rest.translation = glm::vec3(between(random, 0.1, 0.3) * direction(random));
    bone.rest.rotation = glm::quat(rotation(random, 1.5));
    skeleton.bones.push_back(bone);
  }
  skeleton.references.resize(parents.size());
  skeleton.level_bone_counts = {static_cast<int>(parents.size())};
  return skeleton;
}

glm::dquat rotation_part(const glm::dmat4& m, double scale) { return glm::quat_cast(glm::dmat3(m) / scale); }

double uniform_scale(const glm::dmat4& m) { return glm::length(glm::dvec3(m[0])); }

/// skeleton.h, ReferenceFrame.
StateTransform rigid_state(const Skeleton& skeleton, std::size_t index, const StateTransform& local) {
  const Bone& bone = skeleton.bones[index];
  const ReferenceFrame& own = skeleton.references[index];
  const ReferenceFrame parent =
      bone.parent < 0 ? ReferenceFrame{} : skeleton.references[static_cast<std::size_t>(bone.parent)];
  const glm::dquat prefix_rotation = rotation_part(bone.prefix, uniform_scale(bone.prefix));
  const glm::dvec3 translation(bone.prefix * glm::dvec4(local.position, 1.0));
  StateTransform state;
  state.rotation = parent.rotation * (prefix_rotation * local.rotation) * glm::inverse(own.rotation);
  state.position = parent.origin + parent.rotation * (parent.scale * translation) - own.origin;
  return state;
}

}  // namespace

std::vector<int> chain_parents(int bones) {
  std::vector<int> parents(static_cast<std::size_t>(bones));
  std::iota(parents.begin(), parents.end(), -1);
  return parents;
}

std::vector<int> branching_parents(int bones) {
  std::vector<int> parents;
  int trunk = -1;
  int limb = -1;
  for (int bone = 0; bone < bones; ++bone) {
    if (bone % 11 == 0) {
      parents.push_back(trunk);
      trunk = limb = bone;
    } else if (bone % 5 == 0) {
      parents.push_back(limb);
    } else if (bone % 7 == 3) {
      parents.push_back(trunk);
      limb = bone;
    } else {
      parents.push_back(bone - 1);
    }
  }
  return parents;
}

Skeleton rigid_skeleton(const std::vector<int>& parents, unsigned seed) {
  Random random(seed);
  Skeleton skeleton = bare_skeleton(parents, random);
  for (std::size_t i = 0; i < parents.size(); ++i) {
    Bone& bone = skeleton.bones[i];
    if (i % 9 == 4) bone.rest.scale = glm::vec3(static_cast<float>(between(random, 0.8, 1.25)));
    if (i % 8 == 3) {
      bone.prefix = glm::translate(glm::dmat4(1.0), 0.1 * direction(random)) * glm::mat4_cast(rotation(random, 1.0)) *
                    glm::scale(glm::dmat4(1.0), glm::dvec3(1.1));
    }
    skeleton.palette.push_back({static_cast<int>(i), glm::dmat4(1.0)});
  }
  const std::vector<glm::dmat4> binds = global_matrices(skeleton, rest_pose(skeleton));
  for (std::size_t i = 0; i < parents.size(); ++i) {
    const double scale = uniform_scale(binds[i]);
    skeleton.references[i] = {glm::normalize(rotation_part(binds[i], scale)), glm::dvec3(binds[i][3]), scale};
  }
  return skeleton;
}

Skeleton general_skeleton(const std::vector<int>& parents, unsigned seed) {
  Random random(seed);
  Skeleton skeleton = bare_skeleton(parents, random);
  skeleton.rigid = false;
  for (std::size_t i = 0; i < parents.size(); ++i) {
    Bone& bone = skeleton.bones[i];
    if (i % 4 == 1) bone.prefix = random_shear(random);
    for (std::size_t entry = 0; entry < i * 5 % 4; ++entry) {
      skeleton.palette.push_back({static_cast<int>(i), random_shear(random)});
    }
  }
  return skeleton;
}

LocalPose rest_pose(const Skeleton& skeleton) {
  LocalPose pose;
  for (const Bone& bone : skeleton.bones) pose.push_back(rest_of(bone));
  return pose;
}

LocalPose random_pose(const Skeleton& skeleton, unsigned seed) {
  Random random(seed * 7919U + 17U);
  LocalPose pose = rest_pose(skeleton);
  for (StateTransform& bone : pose) {
    bone.rotation = bone.rotation * rotation(random, 1.2);
    bone.position += between(random, 0.0, 0.05) * direction(random);
    if (!skeleton.rigid) {
      bone.scale = glm::dvec3(between(random, 0.8, 1.2), between(random, 0.8, 1.2), between(random, 0.8, 1.2));
      if (random() % 5U == 0U) bone.scale.y = -bone.scale.y;
    }
  }
  return pose;
}

StatePose::StatePose(const Skeleton& skeleton, const LocalPose& pose)
    : components_(skeleton.components()), packets_(static_cast<std::size_t>(packets_for(skeleton.bone_count()))) {
  for (std::size_t i = 0; i < packets_.size() * packet_bones; ++i) {
    StateTransform state;
    if (i < pose.size()) state = skeleton.rigid ? rigid_state(skeleton, i, pose[i]) : pose[i];
    const glm::dquat& q = state.rotation;
    const double values[general_components] = {
        q.x,           q.y,           q.z,          q.w, state.position.x, state.position.y, state.position.z,
        state.scale.x, state.scale.y, state.scale.z};
    float* lanes = packets_[i / packet_bones].lanes;
    for (std::size_t component = 0; component < static_cast<std::size_t>(components_); ++component) {
      lanes[component * packet_bones + i % packet_bones] = static_cast<float>(values[component]);
    }
  }
}

std::vector<StatePose> displaced_in(QuadMask quads, std::vector<StatePose> poses, float elsewhere) {
  for (StatePose& pose : poses) {
    for (PosePacket& packet : pose.packets_) {
      for (int lane = 4 * packet_bones; lane < rigid_components * packet_bones; ++lane) {
        if (!is_in(quads, lane % packet_bones / quad_bones)) packet.lanes[lane] = elsewhere;
      }
    }
  }
  return poses;
}

std::vector<glm::dmat4> reference_palette(const Skeleton& skeleton, const LocalPose& pose) {
  const std::vector<glm::dmat4> globals = global_matrices(skeleton, pose);
  const std::vector<glm::dmat4> binds = global_matrices(skeleton, rest_pose(skeleton));
  std::vector<glm::dmat4> palette;
  for (const PaletteEntry& entry : skeleton.palette) {
    const auto bone = static_cast<std::size_t>(entry.bone);
    palette.push_back(globals[bone] * (skeleton.rigid ? glm::inverse(binds[bone]) : entry.post));
  }
  return palette;
}

double largest_error(const Skeleton& skeleton, const std::vector<glm::dmat4>& reference,
                     const std::vector<PaletteMatrix>& palette) {
  const glm::dvec3 offsets[] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
  double largest = 0.0;
  for (std::size_t i = 0; i < palette.size(); ++i) {
    const glm::dvec3 origin = skeleton.references[static_cast<std::size_t>(skeleton.palette[i].bone)].origin;
    for (const glm::dvec3& offset : offsets) {
      const glm::dvec4 point(origin + offset, 1.0);
      const glm::dvec4 expected = reference[i] * point;
      glm::dvec3 actual;
      for (int row = 0; row < 3; ++row) {
        const float* m = palette[i].rows[row];
        actual[row] = glm::dot(glm::dvec4(m[0], m[1], m[2], m[3]), point);
      }
      largest = std::max(largest, glm::length(actual - glm::dvec3(expected)));
    }
  }
  return largest;
}

}  // namespace throng::anim::kernel_rig
