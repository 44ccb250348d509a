#include "tests/anim/kernel/ragdoll/ragdoll_stage.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace throng::anim::ragdoll_stage {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

int add(Model& model, const std::string& name, int parent, const glm::dvec3& origin) {
  Skeleton& skeleton = model.skeleton;
  const int bone = skeleton.bone_count();
  const glm::dvec3 above = parent < 0 ? glm::dvec3(0.0) : skeleton.references[at(parent)].origin;
  skeleton.bones.emplace_back();
  skeleton.bones.back().name = name;
  skeleton.bones.back().node = bone;
  skeleton.bones.back().parent = parent;
  skeleton.bones.back().rest.translation = origin - above;
  skeleton.references.push_back({.origin = origin});
  skeleton.palette.push_back({.bone = bone});
  skeleton.level_bone_counts = {bone + 1};
  return bone;
}

void add_arm(Model& model, int chest, double side, const std::string& suffix) {
  const int shoulder = add(model, "shoulder" + suffix, chest, {0.03 * side, 1.44, 0.005});
  const int upper = add(model, "upper_arm" + suffix, shoulder, {0.17 * side, 1.43, -0.02});
  add(model, "upper_arm_twist" + suffix, upper, {0.22 * side, 1.37, -0.02});
  const int forearm = add(model, "forearm" + suffix, upper, {0.36 * side, 1.22, -0.02});
  const int hand = add(model, "hand" + suffix, forearm, {0.53 * side, 1.03, 0.0});
  add(model, "middle.1" + suffix, hand, {0.585 * side, 0.965, 0.01});
}

void add_leg(Model& model, int hips, double side, const std::string& suffix) {
  const int thigh = add(model, "thigh" + suffix, hips, {0.092 * side, 0.925, 0.0});
  const int shin = add(model, "shin" + suffix, thigh, {0.098 * side, 0.495, 0.004});
  const int foot = add(model, "foot" + suffix, shin, {0.102 * side, 0.085, -0.022});
  add(model, "toe" + suffix, foot, {0.106 * side, 0.016, 0.106});
}

/// Angle of the swing or twist of a joint beyond its limit, straight from the definition in RagdollLimit.
double outside(const RagdollLimit& limit, const glm::dquat& parent, const glm::dquat& body) {
  const glm::dquat turn = glm::conjugate(parent * glm::dquat(limit.parent_axes)) * body * glm::dquat(limit.axes);
  const glm::dvec3 x = turn * glm::dvec3(1.0, 0.0, 0.0);
  const double twist = 2.0 * std::atan2(turn.x * std::copysign(1.0, turn.w), std::abs(turn.w));
  const double swing = limit.hinge ? std::atan2(x.y, x.x) : std::acos(std::clamp(x.x, -1.0, 1.0));
  const double sideways = limit.hinge ? std::asin(std::clamp(x.z, -1.0, 1.0)) : 0.0;
  return std::max({std::abs(swing) - static_cast<double>(limit.swing),
                   std::abs(sideways) - static_cast<double>(limit.sideways),
                   std::abs(twist) - static_cast<double>(limit.twist)});
}

}  // namespace

Model person() {
  Model model;
  const int root = add(model, "root", -1, {0.0, 0.0, 0.0});
  const int hips = add(model, "hips", root, {0.0, 0.95, -0.005});
  const int spine = add(model, "spine", hips, {0.0, 1.05, -0.01});
  const int chest = add(model, "chest", spine, {0.0, 1.165, -0.015});
  const int upper = add(model, "upper_chest", chest, {0.0, 1.29, -0.015});
  const int neck = add(model, "neck", upper, {0.0, 1.475, -0.022});
  add(model, "head", neck, {0.0, 1.565, -0.008});
  add_arm(model, upper, 1.0, ".L");
  add_arm(model, upper, -1.0, ".R");
  add_leg(model, hips, 1.0, ".L");
  add_leg(model, hips, -1.0, ".R");
  return model;
}

Model chain(int bones) {
  Model model;
  for (int bone = 0; bone < bones; ++bone) add(model, "link" + std::to_string(bone), bone - 1, {0.1 * bone, 1.0, 0.0});
  return model;
}

Model octopus() {
  Model model;
  const int root = add(model, "stem", -1, {0.0, 0.0, 0.0});
  const int head = add(model, "mantle", root, {0.0, 0.9, 0.0});
  for (int arm = 0; arm < 8; ++arm) {
    const double angle = glm::radians(45.0 * arm);
    int parent = head;
    for (int bone = 1; bone <= 6; ++bone) {
      const double out = 0.12 * bone;
      parent = add(model, "arm" + std::to_string(arm) + "." + std::to_string(bone), parent,
                   {out * std::cos(angle), 0.9 - 0.02 * bone, out * std::sin(angle)});
    }
  }
  return model;
}

RagdollRig rig_of(const Model& model) { return build_ragdoll_rig(model).value(); }

Pose::Pose(int bones) : bones_(bones), packets_(at(packets_for(bones))) {
  for (int bone = 0; bone < static_cast<int>(packets_.size()) * packet_bones; ++bone) {
    view().set_rotation(bone, {1.0F, 0.0F, 0.0F, 0.0F});
  }
}

RagdollState standing(const RagdollRig& rig) {
  Pose bind(max_bones);
  RagdollState state;
  ragdoll_from_pose(rig, {.before = bind.view(), .now = bind.view(), .velocity = {0.1F, 0.0F, 0.6F}}, state);
  return state;
}

RagdollState fallen(const RagdollRig& rig, double seconds) {
  RagdollState state = standing(rig);
  run(rig, seconds, state);
  return state;
}

void run(const RagdollRig& rig, double seconds, RagdollState& state, const GroundPlane& ground) {
  ragdoll_step(rig, {&ground, 1}, to_ticks(seconds), state);
}

std::vector<glm::dvec3> bone_origins(const Skeleton& skeleton, const PoseView& pose) {
  std::vector<glm::dvec3> origins;
  std::vector<glm::dquat> motions;
  for (int bone = 0; bone < skeleton.bone_count(); ++bone) {
    const int parent = skeleton.bones[at(bone)].parent;
    const glm::dquat above = parent < 0 ? glm::dquat(1.0, 0.0, 0.0, 0.0) : motions[at(parent)];
    const glm::dvec3 bind_above = parent < 0 ? glm::dvec3(0.0) : skeleton.references[at(parent)].origin;
    const glm::dvec3 offset = skeleton.references[at(bone)].origin - bind_above + glm::dvec3(pose.position(bone));
    origins.push_back((parent < 0 ? glm::dvec3(0.0) : origins[at(parent)]) + above * offset);
    motions.push_back(glm::normalize(above * glm::dquat(pose.rotation(bone))));
  }
  return origins;
}

std::vector<glm::dvec3> bone_origins(const Model& model, const RagdollRig& rig, const RagdollState& state) {
  Pose pose(model.skeleton.bone_count());
  ragdoll_to_pose(rig, state, pose.view());
  return bone_origins(model.skeleton, pose.view());
}

glm::vec3 joint_of(const RagdollRig& rig, const RagdollState& state, int body) {
  return state.bodies[body].position + state.bodies[body].rotation * rig.bodies[at(body)].joint;
}

float deepest(const RagdollRig& rig, const RagdollState& state, const GroundPlane& ground) {
  float depth = -1e30F;
  for (std::size_t b = 0; b < rig.bodies.size(); ++b) {
    for (const float side : {-1.0F, 1.0F}) {
      const glm::vec3 end = state.bodies[b].position +
                            state.bodies[b].rotation * (rig.bodies[b].axis * (side * rig.bodies[b].half_length));
      depth = std::max(depth, ground.height + rig.bodies[b].radius - glm::dot(ground.normal, end));
    }
  }
  return depth;
}

float widest_gap(const RagdollRig& rig, const RagdollState& state) {
  float widest = 0.0F;
  for (std::size_t b = 1; b < rig.bodies.size(); ++b) {
    const RagdollBodyState& parent = state.bodies[rig.bodies[b].parent];
    const glm::vec3 there = parent.position + parent.rotation * rig.bodies[b].joint_in_parent;
    widest = std::max(widest, glm::distance(there, joint_of(rig, state, static_cast<int>(b))));
  }
  return widest;
}

double farthest_outside_limits(const RagdollRig& rig, const RagdollState& state) {
  double worst = -1e30;
  for (std::size_t b = 1; b < rig.bodies.size(); ++b) {
    const glm::dquat parent(state.bodies[rig.bodies[b].parent].rotation);
    worst = std::max(worst, outside(rig.bodies[b].limit, parent, glm::dquat(state.bodies[b].rotation)));
  }
  return worst;
}

double energy(const RagdollRig& rig, const RagdollState& state) {
  double joules = 0.0;
  for (std::size_t b = 0; b < rig.bodies.size(); ++b) {
    const RagdollBody& body = rig.bodies[b];
    const RagdollBodyState& own = state.bodies[b];
    const glm::dvec3 spin(own.angular_velocity);
    const double along = glm::dot(spin, glm::dvec3(own.rotation * body.axis));
    const double mass = 1.0 / static_cast<double>(body.inverse_mass);
    joules += mass * (9.81 * static_cast<double>(own.position.y) +
                      0.5 * glm::dot(glm::dvec3(own.velocity), glm::dvec3(own.velocity)));
    joules += 0.5 * along * along / static_cast<double>(body.inverse_axial_inertia);
    joules += 0.5 * (glm::dot(spin, spin) - along * along) / static_cast<double>(body.inverse_inertia);
  }
  return joules;
}

bool same_bits(const RagdollState& a, const RagdollState& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

bool is_finite(const RagdollRig& rig, const RagdollState& state) {
  const auto finite = [](const RagdollBodyState& body) {
    const float sum = glm::dot(body.position, body.position) + glm::dot(body.rotation, body.rotation) +
                      glm::dot(body.velocity, body.velocity) + glm::dot(body.angular_velocity, body.angular_velocity);
    return std::isfinite(sum);
  };
  return std::all_of(state.bodies, state.bodies + rig.bodies.size(), finite);
}

}  // namespace throng::anim::ragdoll_stage
