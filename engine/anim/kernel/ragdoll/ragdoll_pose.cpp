#include <cassert>
#include <cstddef>
#include <span>

#include "engine/anim/kernel/ragdoll/ragdoll.h"
#include "engine/anim/kernel/ragdoll/ragdoll_substep.h"

namespace throng::anim {
namespace {

std::span<const RagdollLink> links_of(const RagdollRig& rig, const RagdollBody& body) {
  return std::span(rig.links).subspan(static_cast<std::size_t>(body.first_link),
                                      static_cast<std::size_t>(body.link_count));
}

/// Where a pose has the bone of a body.
struct BonePlace {
  glm::quat rotation{1.0F, 0.0F, 0.0F, 0.0F};
  glm::vec3 origin{0.0F};
};

BonePlace follow(std::span<const RagdollLink> links, const PoseView& pose, BonePlace place) {
  for (const RagdollLink& link : links) {
    const bool is_there = link.bone < pose.bone_count;
    place.origin += place.rotation * (is_there ? link.offset + pose.position(link.bone) : link.offset);
    if (is_there) place.rotation = glm::normalize(place.rotation * pose.rotation(link.bone));
  }
  return place;
}

/// Joins the bodies of a pose at their joints; the first stays where it is in the pose.
void place_bodies(const RagdollRig& rig, const PoseView& pose, std::span<RagdollBodyState> states) {
  BonePlace places[max_ragdoll_bodies];
  for (std::size_t b = 0; b < rig.bodies.size(); ++b) {
    const RagdollBody& body = rig.bodies[b];
    assert(body.pose_parent < static_cast<int>(b));
    places[b] = follow(links_of(rig, body), pose, body.pose_parent < 0 ? BonePlace{} : places[body.pose_parent]);
    glm::vec3 joint = places[b].origin;
    if (body.parent >= 0) {
      const RagdollBodyState& parent = states[static_cast<std::size_t>(body.parent)];
      joint = parent.position + parent.rotation * body.joint_in_parent;
    }
    states[b].rotation = places[b].rotation;
    states[b].position = joint - places[b].rotation * body.joint;
  }
}

void set_velocities(std::span<const RagdollBodyState> before, float seconds, std::span<RagdollBodyState> now) {
  for (std::size_t b = 0; b < now.size(); ++b) {
    now[b].velocity += (now[b].position - before[b].position) / seconds;
    const glm::quat turned = now[b].rotation * glm::conjugate(before[b].rotation);
    const float twice = (turned.w < 0.0F ? -2.0F : 2.0F) / seconds;
    now[b].angular_velocity = twice * glm::vec3(turned.x, turned.y, turned.z);
  }
}

/// Where a body has the origin of its bone.
glm::vec3 origin_of(const RagdollBody& body, const RagdollBodyState& state) {
  return state.position + state.rotation * body.joint;
}

}  // namespace

void ragdoll_from_pose(const RagdollRig& rig, const RagdollStart& start, RagdollState& state) {
  assert(start.elapsed >= Ticks{});
  state = {};
  const std::span now(state.bodies, rig.bodies.size());
  place_bodies(rig, start.now, now);
  for (RagdollBodyState& body : now) body.velocity = start.velocity;
  if (start.elapsed == Ticks{}) return;
  RagdollBodyState before[max_ragdoll_bodies];
  place_bodies(rig, start.before, before);
  set_velocities(before, static_cast<float>(to_seconds(start.elapsed)), now);
}

void ragdoll_to_pose(const RagdollRig& rig, const RagdollState& state, const PoseView& pose) {
  constexpr glm::quat none(1.0F, 0.0F, 0.0F, 0.0F);
  for (std::size_t b = 0; b < rig.bodies.size(); ++b) {
    const RagdollBody& body = rig.bodies[b];
    if (body.bone >= pose.bone_count) continue;
    const std::span<const RagdollLink> links = links_of(rig, body);
    glm::vec3 offset(0.0F);
    for (const RagdollLink& link : links) {
      offset += link.offset;
      pose.set_rotation(link.bone, none);
      pose.set_position(link.bone, glm::vec3(0.0F));
    }
    BonePlace above;
    if (body.pose_parent >= 0) {
      const auto parent = static_cast<std::size_t>(body.pose_parent);
      above = {state.bodies[parent].rotation, origin_of(rig.bodies[parent], state.bodies[parent])};
    }
    const glm::quat back = glm::conjugate(above.rotation);
    pose.set_rotation(body.bone, glm::normalize(back * state.bodies[b].rotation));
    if (body.pose_parent >= 0 && body.pose_parent == body.parent) continue;
    pose.set_position(body.bone, back * (origin_of(body, state.bodies[b]) - above.origin) - offset);
  }
}

}  // namespace throng::anim
