#include "engine/anim/agent/ragdoll_process.h"

#include <algorithm>
#include <utility>

namespace throng::anim {

bool RagdollProcess::is_asleep(const EntityPools& pools) const {
  return ragdoll_.valid() && is_loose(pools.as<RagdollEntity>(ragdoll_)) &&
         pools.private_as<RagdollMemory>(ragdoll_).bodies.asleep != 0;
}

glm::vec3 RagdollProcess::hips(const EntityPools& pools) const {
  if (!ragdoll_.valid()) return glm::vec3(0.0F);
  return pools.private_as<RagdollMemory>(ragdoll_).bodies.bodies[0].position;
}

// The blender is there from the push on, showing nothing of the rag-doll until it is let go: the agent's share of the
// local store does not grow while it falls.
void RagdollProcess::begin(const EntityBuilder& build) {
  ragdoll_ = build.create(kind_);
  blender_ = build.hold({}, ragdoll_, 0.0F);
  phase_ = Phase::letting_go;
  build.private_as<RagdollMemory>(ragdoll_).ground = ground_;
  let_go(build.as<RagdollEntity>(ragdoll_));
}

bool RagdollProcess::take_push(const EntityBuilder& build) {
  if (!std::exchange(pushed_, false)) return false;
  const bool was_standing = phase_ == Phase::standing;
  if (was_standing) begin(build);
  auto& ragdoll = build.as<RagdollEntity>(ragdoll_);
  for (int axis = 0; axis < 3; ++axis) {
    ragdoll.impulse[axis] = impulse_[axis];
    ragdoll.push_place[axis] = place_[axis];
  }
  recovers_ = false;
  if (phase_ != Phase::recovering) return was_standing;
  turn_round(build, Phase::down, build.as<EaseBlender>(blender_).total);  // back as fast as it came
  return true;
}

// Easing is symmetric: the rest of one way is the done part of the other.
void RagdollProcess::turn_round(const EntityBuilder& build, Phase phase, Ticks fade) {
  auto& blender = build.as<EaseBlender>(blender_);
  const auto elapsed = static_cast<double>((blender.elapsed - build.lead()).count());
  const double done =
      blender.total > Ticks{} ? std::clamp(elapsed / static_cast<double>(blender.total.count()), 0.0, 1.0) : 1.0;
  const Ticks ahead = to_ticks((1.0 - done) * to_seconds(fade));
  blender.elapsed = build.lead() + ahead;
  blender.total = fade;
  phase_ = phase;
  fade_end_ = build.now() + fade - ahead;
}

bool RagdollProcess::update(const EntityBuilder& build) {
  const bool changed = take_push(build);
  if (phase_ == Phase::letting_go && is_loose(build.as<RagdollEntity>(ragdoll_))) {
    build.as<RagdollEntity>(ragdoll_).source = {};
    auto& blender = build.as<EaseBlender>(blender_);
    blender.flags = 0;
    blender.elapsed = Ticks{};  // from the pose in which it was let go
    blender.total = fade_;
    phase_ = Phase::down;
    return true;
  }
  if (phase_ == Phase::down && std::exchange(recovers_, false)) {
    turn_round(build, Phase::recovering, recovery_);
    return true;
  }
  if (phase_ == Phase::recovering && build.now() >= fade_end_) {
    destroy_entities(build);
    return true;
  }
  return changed;
}

Ticks RagdollProcess::next_update() const {
  if (phase_ == Phase::letting_go || (phase_ == Phase::down && recovers_)) return Ticks{};
  return phase_ == Phase::recovering ? fade_end_ : never;
}

Handle RagdollProcess::attach(const EntityBuilder& build, Handle source) {
  if (phase_ == Phase::standing) return source;
  auto& blender = build.as<EaseBlender>(blender_);
  if (phase_ == Phase::letting_go) build.as<RagdollEntity>(ragdoll_).source = source;
  const bool recovers = phase_ == Phase::recovering;
  blender.from = recovers ? ragdoll_ : source;
  blender.to = recovers ? source : ragdoll_;
  return blender_;
}

void RagdollProcess::visit_handles(const std::function<void(Handle&)>& visit) {
  if (!ragdoll_.valid()) return;
  visit(ragdoll_);
  visit(blender_);
}

void RagdollProcess::destroy_entities(const EntityBuilder& build) {
  phase_ = Phase::standing;
  if (!ragdoll_.valid()) return;
  build.destroy(std::exchange(ragdoll_, {}));
  build.destroy(std::exchange(blender_, {}));
}

}  // namespace throng::anim
