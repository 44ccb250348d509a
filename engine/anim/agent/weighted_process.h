#pragma once

#include <utility>

#include "engine/anim/agent/post_process.h"
#include "engine/anim/entity/fading_weight.h"

namespace throng::anim {

/// A post process of one entity with a `source` and a FadingWeight `weight`, whose other parameters a derived process
/// writes to its block.
template <typename Entity>
class WeightedProcess : public PostProcess {
 public:
  /// 0: the pose is left as it is, to the bit; 1: all of it. Fades from where it is.
  void set_weight(float weight, Ticks fade = 0) {
    weight_ = weight;
    fade_ = fade;
    fades_ = true;
  }

  Handle attach(const EntityBuilder& build, Handle source) final {
    if (!entity_.valid()) {
      entity_ = build.create(kind_);
      begin(build, entity_);
      fades_ = true;
      update(build);
    }
    build.as<Entity>(entity_).source = source;
    return entity_;
  }
  bool update(const EntityBuilder& build) final {
    if (!entity_.valid()) return false;
    if (std::exchange(fades_, false)) {
      fade_to(build.as<Entity>(entity_).weight, weight_, static_cast<float>(to_seconds(fade_)),
              static_cast<float>(to_seconds(build.lead())));
    }
    write(build, entity_);
    return false;
  }
  void visit_handles(const std::function<void(Handle&)>& visit) final {
    if (entity_.valid()) visit(entity_);
  }
  void destroy_entities(const EntityBuilder& build) final {
    if (entity_.valid()) build.destroy(std::exchange(entity_, {}));
  }

 protected:
  WeightedProcess(EntityPools::Kind kind, float weight) : kind_(kind), weight_(weight) {}
  WeightedProcess(const WeightedProcess&) = default;
  WeightedProcess& operator=(const WeightedProcess&) = default;

  /// Fills the private part of a new entity.
  virtual void begin(const EntityBuilder& build, Handle entity) const = 0;
  /// Brings the parameters of a frame to the block.
  virtual void write(const EntityBuilder& build, Handle entity) const = 0;

  Handle entity() const { return entity_; }

 private:
  EntityPools::Kind kind_;
  Handle entity_;
  float weight_;
  Ticks fade_ = 0;
  bool fades_ = false;
};

}  // namespace throng::anim
