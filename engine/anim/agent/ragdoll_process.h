#pragma once

#include <cmath>

#include "engine/anim/agent/post_process.h"
#include "engine/anim/base/misuse.h"
#include "engine/anim/entity/ragdoll_entity.h"
#include "engine/anim/kernel/lanes/rotations.h"

namespace throng::anim {

/// Lets an agent fall over when it is pushed, and come back to its animation by recover(). It has no entities while the
/// agent stands.
///
///     source ──┬──────────── blender         the source still plays below, so that the agent's time goes on
///              └─ rag-doll ──┘               it reads the source until it is let go, two updates after the push
///
///     standing --push()--> letting_go --> down --recover()--> recovering --> standing
///                                           ^------push()--------'
class RagdollProcess final : public PostProcess {
 public:
  enum class Phase : std::uint8_t { standing, letting_go, down, recovering };

  /// `kind` is RigKinds::ragdoll. `fade` is the time from the animation to the rag-doll, once it is let go.
  explicit RagdollProcess(EntityPools::Kind kind, Ticks fade = ticks_per_second / 10) : kind_(kind), fade_(fade) {}

  /// Pushes with an impulse (kg m/s) at a place in model space; the nearest body takes it. A second push before the
  /// next update takes the place of the first.
  void push(const glm::vec3& impulse, const glm::vec3& place) {
    if (!is_place(impulse) || !is_place(place)) {
      report_misuse({"Processes::push", "an impulse and its place are of finite numbers, below a billion"});
      return;
    }
    impulse_ = impulse;
    place_ = place;
    pushed_ = true;
  }
  /// Blends back to the animation when the rag-doll is down, wherever it lies.
  void recover(Ticks fade) {
    if (!is_fade(fade)) {
      report_misuse({"Processes::recover", not_a_fade});
      return;
    }
    recovery_ = fade;
    recovers_ = true;
  }
  /// Sets the ground in model space. It counts for the next fall.
  void set_ground(const GroundPlane& ground) {
    const float squared = glm::dot(ground.normal, ground.normal);
    if (std::abs(squared - 1.0F) < 1e-3F && std::abs(ground.height) <= farthest_place) {
      ground_ = ground;
    } else {
      report_misuse({"RagdollProcess::set_ground", "a ground has a unit normal and a height in metres"});
    }
  }

  Phase phase() const { return phase_; }
  /// Returns whether the body lies still.
  bool is_asleep(const EntityPools& pools) const;
  /// Returns the place of its first body, the hips, at the last update, in model space; 0 while it stands.
  glm::vec3 hips(const EntityPools& pools) const;

  const char* fault(const EntityBuilder& build) const override {
    if (!is_fade(fade_)) return not_a_fade;
    const bool has_kind = build.has_kind(kind_, EntityType::ragdoll);
    return has_kind ? nullptr : "its kind of entity was not added to this character";
  }
  Handle attach(const EntityBuilder& build, Handle source) override;
  bool update(const EntityBuilder& build) override;
  Ticks next_update() const override;
  void visit_handles(const std::function<void(Handle&)>& visit) override;
  void destroy_entities(const EntityBuilder& build) override;
  std::unique_ptr<PostProcess> clone() const override { return std::make_unique<RagdollProcess>(*this); }

 private:
  void begin(const EntityBuilder& build);
  bool take_push(const EntityBuilder& build);
  void turn_round(const EntityBuilder& build, Phase phase, Ticks fade);

  EntityPools::Kind kind_;
  Ticks fade_;
  GroundPlane ground_;
  glm::vec3 impulse_{0.0F};
  glm::vec3 place_{0.0F};
  bool pushed_ = false;
  bool recovers_ = false;
  Ticks recovery_{};

  Phase phase_ = Phase::standing;
  Handle ragdoll_;
  Handle blender_;  // between the animation and the rag-doll
  Ticks fade_end_{};
};

}  // namespace throng::anim
