#include "engine/anim/kernel/limb/spring_bones.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>

#include <glm/geometric.hpp>

#include "engine/anim/kernel/lanes/rotations.h"

namespace throng::anim {
namespace {

constexpr glm::vec3 upwards{0.0F, 1.0F, 0.0F};
constexpr float fastest_bone = 100.0F;  // metres a second

std::size_t at(int index) { return static_cast<std::size_t>(index); }

/// Memory for motions that is not initialised.
template <std::size_t count>
class Motions {
 public:
  JointMotion& operator[](std::size_t i) { return reinterpret_cast<JointMotion*>(room_)[i]; }
  const JointMotion& operator[](std::size_t i) const { return reinterpret_cast<const JointMotion*>(room_)[i]; }

 private:
  alignas(JointMotion) std::byte room_[count * sizeof(JointMotion)];
};

JointMotion carried(const JointMotion& parent, const glm::vec3& offset, const glm::quat& rotation) {
  return {.rotation = renormalised(parent.rotation * rotation), .position = parent.position + parent.rotation * offset};
}

JointMotion between(const JointMotion& from, const JointMotion& to, float share) {
  return {.rotation = mix_rotations(from.rotation, to.rotation, share),
          .position = from.position + share * (to.position - from.position)};
}

/// The closest point of a segment.
glm::vec3 nearest(const glm::vec3& from, const glm::vec3& to, const glm::vec3& point) {
  const glm::vec3 way = to - from;
  const float square = glm::dot(way, way);
  const float share = square > 0.0F ? glm::dot(point - from, way) / square : 0.0F;
  return from + std::clamp(share, 0.0F, 1.0F) * way;
}

class Springs {
 public:
  explicit Springs(const SpringBonesJob& job) : job_(job), rig_(*job.rig) { pose_nodes(); }

  void swing() {
    if (begins_anew()) {
      rest();
    } else {
      move();
    }
    if (!is_sound()) rest();
    write();
    keep_carriers();
  }

 private:
  void pose_nodes() {
    for (std::size_t n = 0; n < rig_.nodes.size(); ++n) {
      const SpringNode& node = rig_.nodes[n];
      nodes_[n] = carried(node.parent < 0 ? job_.body->model_in_world : nodes_[at(node.parent)],
                          node.offset + job_.pose.position(node.bone), job_.pose.rotation(node.bone));
    }
  }
  const JointMotion& base_now(const SpringRig::Chain& chain) const {
    return chain.base < 0 ? job_.body->model_in_world : nodes_[at(chain.base)];
  }

  bool begins_anew() const {
    const SpringBody& body = *job_.body;
    return !body.started || body.restarts != body.restarted || job_.seconds > longest_spring_seconds;
  }
  bool is_sound() const {
    return std::ranges::all_of(job_.joints, [](const SpringJointState& joint) {
      return is_place(joint.tail) && is_place(joint.velocity) && is_place(joint.head);
    });
  }

  void rest() {
    for (std::size_t j = 0; j < rig_.joints.size(); ++j) {
      const JointMotion& joint = nodes_[at(rig_.joints[j].node)];
      job_.joints[j] = {.tail = joint.position + joint.rotation * rig_.joints[j].tail, .head = joint.position};
    }
  }

  void move() {
    const float steps = std::max(std::ceil(job_.seconds / spring_step_seconds - 0.01F), 1.0F);
    if (job_.seconds <= 0.0F) return;
    for (float step = 1.0F; step <= steps; step += 1.0F) {
      share_ = step / steps;
      seconds_ = job_.seconds / steps;
      place_colliders();
      for (std::size_t c = 0; c < rig_.chains.size(); ++c) {
        swing_chain(rig_.chains[c], between(job_.carriers[c], base_now(rig_.chains[c]), share_));
      }
    }
  }

  void place_colliders() {
    for (std::size_t c = 0; c < rig_.colliders.size(); ++c) {
      const SpringRig::Collider& collider = rig_.colliders[c];
      const JointMotion motion = between(job_.carriers[rig_.chains.size() + c], nodes_[at(collider.node)], share_);
      collider_ends_[c][0] = motion.position + motion.rotation * collider.from;
      collider_ends_[c][1] = motion.position + motion.rotation * collider.to;
    }
  }

  /// Where a joint is in its pose if `parent` carries it.
  JointMotion posed(const SpringJoint& joint, const JointMotion& parent) const {
    const SpringNode& node = rig_.nodes[at(joint.node)];
    return carried(parent, node.offset + job_.pose.position(node.bone), job_.pose.rotation(node.bone));
  }
  /// Turns a joint so that its end is in the direction of its tail.
  static JointMotion turned(const JointMotion& posed, const SpringJoint& joint, const glm::vec3& tail) {
    const glm::vec3 rest = unit_or(posed.rotation * joint.tail, upwards);
    const glm::quat turn = shortest_turn(rest, unit_or(tail - posed.position, rest));
    return {.rotation = renormalised(turn * posed.rotation), .position = posed.position};
  }

  void swing_chain(const SpringRig::Chain& chain, JointMotion parent) {
    for (int j = chain.first; j < chain.first + chain.count; ++j) {
      const SpringJoint& joint = rig_.joints[at(j)];
      const JointMotion motion = posed(joint, parent);
      swing_joint(chain.options, joint, motion, job_.joints[at(j)]);
      parent = turned(motion, joint, job_.joints[at(j)].tail);
    }
  }

  void swing_joint(const SpringOptions& options, const SpringJoint& joint, const JointMotion& motion,
                   SpringJointState& state) {
    const glm::vec3 rest = motion.position + motion.rotation * joint.tail;
    const glm::vec3 head_velocity = (motion.position - state.head) / seconds_;
    const glm::vec3 pulled =
        options.stiffness * (rest - state.tail) + options.damping * head_velocity + options.gravity;
    const float held = 1.0F + seconds_ * (options.damping + options.drag) + seconds_ * seconds_ * options.stiffness;
    const glm::vec3 before = state.tail;
    state.tail += seconds_ * ((state.velocity + seconds_ * pulled) / held);
    const auto at_length = [&] {
      const glm::vec3 otherwise = unit_or(rest - motion.position, upwards);
      state.tail = motion.position + joint.length * unit_or(state.tail - motion.position, otherwise);
    };
    at_length();
    for (int pass = 0; pass < 2 && push_out(options.radius, state.tail); ++pass) at_length();
    state.velocity = (state.tail - before) / seconds_;
    const float speed = glm::length(state.velocity);
    if (speed > fastest_bone) state.velocity *= fastest_bone / speed;
    state.head = motion.position;
  }

  /// Moves a point out of colliders and the ground. Returns whether it was in one.
  bool push_out(float radius, glm::vec3& point) const {
    bool touched = false;
    for (std::size_t c = 0; c < rig_.colliders.size(); ++c) {
      const glm::vec3 middle = nearest(collider_ends_[c][0], collider_ends_[c][1], point);
      const float least = radius + rig_.colliders[c].radius;
      const glm::vec3 away = point - middle;
      if (glm::dot(away, away) >= least * least) continue;
      point = middle + least * unit_or(away, upwards);
      touched = true;
    }
    const float lowest = job_.body->ground + radius;
    if (point.y < lowest) {
      point.y = lowest;
      touched = true;
    }
    return touched;
  }

  void write() const {
    for (const SpringRig::Chain& chain : rig_.chains) {
      JointMotion parent = base_now(chain);
      for (int j = chain.first; j < chain.first + chain.count; ++j) {
        const SpringJoint& joint = rig_.joints[at(j)];
        const int bone = rig_.nodes[at(joint.node)].bone;
        const JointMotion motion = turned(posed(joint, parent), joint, job_.joints[at(j)].tail);
        const glm::quat local = renormalised(glm::conjugate(parent.rotation) * motion.rotation);
        const bool whole = job_.weight >= 1.0F;
        job_.pose.set_rotation(bone, whole ? local : mix_rotations(job_.pose.rotation(bone), local, job_.weight));
        parent = motion;
      }
    }
  }

  void keep_carriers() const {
    for (std::size_t c = 0; c < rig_.chains.size(); ++c) job_.carriers[c] = base_now(rig_.chains[c]);
    for (std::size_t c = 0; c < rig_.colliders.size(); ++c) {
      job_.carriers[rig_.chains.size() + c] = nodes_[at(rig_.colliders[c].node)];
    }
    job_.body->started = true;
    job_.body->restarted = job_.body->restarts;
  }

  const SpringBonesJob& job_;
  const SpringRig& rig_;
  Motions<max_spring_nodes> nodes_;  // world space
  glm::vec3 collider_ends_[max_spring_colliders][2];
  float share_ = 1.0F;    // of the time since the last update
  float seconds_ = 0.0F;  // of a step
};

}  // namespace

void swing_bones(const SpringBonesJob& job) {
  assert(is_valid(job));
  if (job.rig->bone_end > job.pose.bone_count || job.weight <= 0.0F) {
    job.body->started = false;
    return;
  }
  Springs(job).swing();
}

}  // namespace throng::anim
