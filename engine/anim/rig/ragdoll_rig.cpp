#include "engine/anim/rig/ragdoll_rig.h"

#include <algorithm>
#include <cassert>
#include <cstddef>

#include "engine/anim/rig/ragdoll_bones.h"
#include "engine/anim/rig/ragdoll_limits.h"
#include "engine/anim/rig/ragdoll_shapes.h"

namespace throng::anim {
namespace {

glm::vec3 offset_from_parent(const Skeleton& skeleton, int bone) {
  const int parent = skeleton.parent(bone);
  const glm::dvec3 above = parent < 0 ? glm::dvec3(0.0) : skeleton.references[static_cast<std::size_t>(parent)].origin;
  return skeleton.references[static_cast<std::size_t>(bone)].origin - above;
}

/// Finds the body above in the skeleton, and lists the bones from there.
void link(const Skeleton& skeleton, RagdollBody& body, RagdollRig& rig) {
  const auto body_at = [&](int bone) { return std::ranges::find(rig.bodies, bone, &RagdollBody::bone); };
  std::vector<RagdollLink> upwards;
  int bone = body.bone;
  do {
    upwards.push_back({bone, offset_from_parent(skeleton, bone)});
    bone = skeleton.parent(bone);
  } while (bone >= 0 && body_at(bone) == rig.bodies.end());
  body.pose_parent = bone < 0 ? -1 : static_cast<int>(body_at(bone) - rig.bodies.begin());
  body.first_link = static_cast<int>(rig.links.size());
  body.link_count = static_cast<int>(upwards.size());
  rig.links.insert(rig.links.end(), upwards.rbegin(), upwards.rend());
}

}  // namespace

Result<RagdollRig> build_ragdoll_rig(const Model& model, const RagdollOptions& options) {
  assert(options.mass > 0.0 && options.metre > 0.0);
  const Skeleton& skeleton = model.skeleton;
  if (!skeleton.rigid) {
    return Error{"skeleton '" + skeleton.name +
                 "' is sheared or scaled unevenly, and a rag-doll has rigid bones; export it without such scales"};
  }
  std::vector<RagdollBone> chosen = choose_humanoid_bones(skeleton);
  if (chosen.empty()) chosen = choose_longest_bones(model);
  if (chosen.size() < 2) {
    return Error{"skeleton '" + skeleton.name +
                 "' has no two bones of some length, and a rag-doll needs a joint; give it a skeleton with one"};
  }
  RagdollRig rig{.bodies = {}, .links = {}, .metre = static_cast<float>(options.metre)};
  for (const RagdollBone& bone : chosen) rig.bodies.push_back({.bone = bone.bone, .parent = bone.parent});
  set_ragdoll_masses(fit_ragdoll_shapes(model, chosen), options.mass, rig.bodies);
  set_ragdoll_limits(chosen, rig.bodies);
  for (RagdollBody& body : rig.bodies) {
    link(skeleton, body, rig);
    if (body.parent < 0) continue;
    const RagdollBody& parent = rig.bodies[static_cast<std::size_t>(body.parent)];
    body.joint_in_parent = body.center + body.joint - parent.center;
  }
  return rig;
}

}  // namespace throng::anim
