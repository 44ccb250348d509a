#include "tests/anim/retarget/figures.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>

#include "engine/anim/asset/reference_pose.h"
#include "engine/anim/retarget/body_pose.h"
#include "engine/anim/retarget/two_bone_reach.h"
#include "engine/anim/rig/rig_map.h"
#include "tests/anim/rig/named_skeleton.h"

namespace throng::anim::figures {
namespace {

constexpr float hips_height = 0.95F;
constexpr float shoulder_height = 1.4F;
constexpr float foot_height = 0.08F;

bool is_part_of(const std::string& name, std::initializer_list<const char*> parts) {
  return std::ranges::any_of(parts, [&](const char* part) { return name.starts_with(part); });
}

glm::vec3 place_of(const NamedJoint& joint, const Build& build) {
  const auto legs = static_cast<float>(build.legs), trunk = static_cast<float>(build.trunk);
  glm::vec3 place = joint.origin;
  const float longer = (legs - 1.0F) * (hips_height - foot_height);
  if (build.arms_out && is_part_of(joint.name, {"forearm", "hand"})) {
    const float side = place.x > 0.0F ? 1.0F : -1.0F;
    place = {side * (0.18F + (shoulder_height - place.y)), shoulder_height, place.z};
  }
  if (is_part_of(joint.name, {"thigh", "shin", "foot"})) {
    place.y = foot_height + (place.y - foot_height) * legs;
    place.x *= static_cast<float>(build.hips);
  } else if (is_part_of(joint.name, {"toe"})) {
    place.x *= static_cast<float>(build.hips);
  } else if (joint.name != "root") {
    place.y = hips_height + longer + (place.y - hips_height) * trunk;
  }
  return build.backwards ? glm::vec3(-place.x, place.y, -place.z) : place;
}

/// Poses the body of a skeleton joint by joint, in model space.
class Poser {
 public:
  explicit Poser(const Skeleton& skeleton)
      : skeleton_(skeleton), rig_(find_rig(skeleton)), bind_(bind_pose(skeleton)) {}

  std::vector<StateTransform> at(double seconds, double metres) const {
    const double phase = 0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * seconds);
    std::vector<glm::dquat> rotations = bind_.rotations;
    const glm::dvec3 forward(rig_.limbs.forward);
    const glm::dvec3 moved = forward * (metres * seconds) - glm::dvec3(0.0, 0.15 * phase, 0.0);
    for (const bool left : {true, false}) {
      bend_leg(left ? *rig_.limbs.left_leg : *rig_.limbs.right_leg, moved, step(left, seconds, metres, forward),
               forward, rotations);
      lift_arm(left ? *rig_.limbs.left_arm : *rig_.limbs.right_arm, (left ? 1.0 : -1.0) * phase, forward, rotations);
    }
    return locals(rotations, moved, left_step(seconds, metres, forward));
  }

 private:
  glm::dvec3 left_step(double seconds, double metres, const glm::dvec3& forward) const {
    return step(true, seconds, metres, forward);
  }

  /// The left foot goes along, lifted; the right one slides along on the ground.
  static glm::dvec3 step(bool left, double seconds, double metres, const glm::dvec3& forward) {
    const double lift = left ? 0.1 * std::max(0.0, std::sin(2.0 * std::numbers::pi * seconds)) : 0.0;
    return forward * (metres * seconds) + glm::dvec3(0.0, lift, 0.0);
  }

  void bend_leg(const LimbBones& leg, const glm::dvec3& hips, const glm::dvec3& foot, const glm::dvec3& forward,
                std::vector<glm::dquat>& rotations) const {
    const LegPlaces places{bind_.place(leg.upper) + hips, bind_.place(leg.middle) + hips, bind_.place(leg.end) + hips};
    const LegTurns turns = reach(places, bind_.place(leg.end) + foot, forward);
    const auto turn = [&](int bone, const glm::dquat& by) {
      rotations[static_cast<std::size_t>(bone)] = by * bind_.rotation(bone);
    };
    turn(leg.upper, turns.upper);
    turn(leg.middle, turns.lower);
  }

  void lift_arm(const LimbBones& arm, double amount, const glm::dvec3& forward,
                std::vector<glm::dquat>& rotations) const {
    const glm::dquat lift = glm::angleAxis(amount, forward);
    for (const int bone : {arm.upper, arm.middle, arm.end}) {
      rotations[static_cast<std::size_t>(bone)] = lift * bind_.rotation(bone);
    }
  }

  /// Everything hangs on the root, which goes along; the hips sink from it.
  std::vector<StateTransform> locals(const std::vector<glm::dquat>& rotations, const glm::dvec3& moved,
                                     const glm::dvec3& left_foot) const {
    std::vector<StateTransform> result;
    std::vector<glm::dvec3> places(bind_.places);
    for (std::size_t b = 0; b < skeleton_.bones.size(); ++b) {
      const int parent = skeleton_.bones[b].parent;
      result.push_back(rest_transform(skeleton_.bones[b]));
      const glm::dquat above =
          parent < 0 ? glm::dquat(1.0, 0.0, 0.0, 0.0) : rotations[static_cast<std::size_t>(parent)];
      result[b].rotation = glm::conjugate(above) * rotations[b];
      if (parent < 0) result[b].position += glm::dvec3(moved.x, 0.0, moved.z);
      if (static_cast<int>(b) == rig_.at(BodyRole::hips)) {
        result[b].position += glm::conjugate(above) * glm::dvec3(0.0, moved.y, 0.0);
      }
      if (static_cast<int>(b) == rig_.at(BodyRole::left_foot) && rig_.limbs.left_leg->end_stands_apart) {
        result[b].position += glm::conjugate(above) * glm::dvec3(0.0, left_foot.y, 0.0);
      }
    }
    return result;
  }

  const Skeleton& skeleton_;
  RigMap rig_;
  BodyPose bind_;
};

}  // namespace

Skeleton person(const Build& build) {
  std::vector<NamedJoint> joints = person_joints();
  for (NamedJoint& joint : joints) {
    joint.origin = place_of(joint, build);
    if (build.feet_apart && joint.name.starts_with("foot")) joint.parent = "root";
  }
  for (NamedJoint& joint : joints) {
    joint.name = build.prefix + joint.name;
    if (!joint.parent.empty()) joint.parent = build.prefix + joint.parent;
  }
  return named_skeleton(joints);
}

Clip knee_bend(const Skeleton& skeleton, double metres) {
  const Poser poser(skeleton);
  Clip clip{.name = "knee bend", .duration = 1.0, .tracks = {}};
  for (int bone = 0; bone < skeleton.bone_count(); ++bone) {
    clip.tracks.push_back({.bone = bone, .translation = {}, .rotation = {}, .scale = {}});
  }
  for (int frame = 0; frame <= 30; ++frame) {
    const auto seconds = static_cast<float>(frame) / 30.0F;
    const std::vector<StateTransform> locals = poser.at(static_cast<double>(seconds), metres);
    for (std::size_t bone = 0; bone < locals.size(); ++bone) {
      clip.tracks[bone].rotation.times.push_back(seconds);
      clip.tracks[bone].rotation.values.emplace_back(locals[bone].rotation);
      clip.tracks[bone].translation.times.push_back(seconds);
      clip.tracks[bone].translation.values.emplace_back(locals[bone].position);
    }
  }
  return clip;
}

}  // namespace throng::anim::figures
