#include "tests/anim/rig/named_skeleton.h"

#include <algorithm>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

namespace throng::anim {

Skeleton named_skeleton(const std::vector<NamedJoint>& joints) {
  Skeleton skeleton;
  skeleton.name = "person";
  for (const NamedJoint& joint : joints) {
    const auto parent = std::ranges::find(skeleton.bones, joint.parent, &Bone::name);
    const auto count = static_cast<double>(skeleton.bones.size());
    const int parent_index = joint.parent.empty() ? -1 : static_cast<int>(parent - skeleton.bones.begin());
    const ReferenceFrame above =
        parent_index < 0 ? ReferenceFrame{} : skeleton.references[static_cast<std::size_t>(parent_index)];
    const ReferenceFrame own{.rotation = glm::angleAxis(0.7 * count, glm::normalize(glm::dvec3(1.0, count, -2.0))),
                             .origin = joint.origin};
    const glm::dquat to_parent = glm::conjugate(above.rotation);
    skeleton.palette.push_back({.bone = static_cast<int>(skeleton.bones.size())});
    skeleton.bones.push_back({.name = joint.name,
                              .node = static_cast<int>(skeleton.bones.size()),
                              .parent = parent_index,
                              .rest = {.translation = glm::vec3(to_parent * (own.origin - above.origin)),
                                       .rotation = glm::quat(to_parent * own.rotation)}});
    skeleton.references.push_back(own);
  }
  skeleton.level_bone_counts = {skeleton.bone_count()};
  return skeleton;
}

std::vector<NamedJoint> person_joints() {
  std::vector<NamedJoint> joints{{"root", "", {0, 0, 0}},          {"hips", "root", {0, 0.95F, 0}},
                                 {"spine", "hips", {0, 1.05F, 0}}, {"chest", "spine", {0, 1.25F, 0}},
                                 {"neck", "chest", {0, 1.45F, 0}}, {"head", "neck", {0, 1.55F, 0.02F}}};
  for (const char* side : {".L", ".R"}) {
    const float x = side[1] == 'L' ? 1.0F : -1.0F;
    const auto add = [&](const char* name, const char* parent, glm::vec3 origin) {
      const bool from_trunk = std::string(parent) == "hips" || std::string(parent) == "chest";
      joints.push_back({std::string(name) + side,
                        from_trunk ? parent : std::string(parent) + side,
                        {x * origin.x, origin.y, origin.z}});
    };
    add("thigh", "hips", {0.09F, 0.92F, 0.0F});
    add("shin", "thigh", {0.095F, 0.5F, 0.03F});
    add("foot", "shin", {0.1F, 0.08F, -0.02F});
    add("toe", "foot", {0.11F, 0.02F, 0.11F});
    add("upper_arm", "chest", {0.18F, 1.4F, 0.0F});
    add("forearm", "upper_arm", {0.19F, 1.12F, -0.02F});
    add("hand", "forearm", {0.2F, 0.86F, 0.01F});
  }
  return joints;
}

}  // namespace throng::anim
