#pragma once

#include <utility>

#include "engine/anim/agent/one_entity_process.h"
#include "engine/anim/base/finite.h"
#include "engine/anim/base/misuse.h"
#include "engine/anim/entity/fading_weight.h"

namespace throng::anim {

/// A post process of one entity with a FadingWeight `weight`, whose other parameters a derived process writes to its
/// block.
template <typename Entity>
class WeightedProcess : public OneEntityProcess<Entity> {
 public:
  /// Sets the weight, and fades to it from where it is. The pose is left as it is, to the bit, at 0; the process has
  /// its full effect at 1.
  void set_weight(float weight, Ticks fade = {}) {
    if (!(weight >= 0.0F && weight <= 1.0F && is_fade(fade))) {
      report_misuse({"Processes::set_weight", "a weight is from 0 to 1, and a fade takes from no time to a day"});
      return;
    }
    weight_ = weight;
    fade_ = fade;
    fades_ = true;
  }

  /// Returns the weight that the last update reached on its way to the weight that was set; 0 before the first update.
  float weight(const EntityPools& pools) const {
    return this->entity().valid() ? value(pools.as<Entity>(this->entity()).weight) : 0.0F;
  }

  bool update(const EntityBuilder& build) final {
    if (this->entity().valid()) bring(build, this->entity());
    return false;
  }
  bool update_in_place(const EntityBuilder& build) final { return !update(build); }

 protected:
  WeightedProcess(EntityPools::Kind kind, float weight) : OneEntityProcess<Entity>(kind), weight_(weight) {}

  /// Fills the private part of a new entity.
  virtual void begin_private(const EntityBuilder& build, Handle entity) const = 0;
  /// Brings the parameters of a frame to the block.
  virtual void write(const EntityBuilder& build, Handle entity) const = 0;

 private:
  void begin(const EntityBuilder& build, Handle entity) final {
    begin_private(build, entity);
    fades_ = true;
    bring(build, entity);
  }
  void bring(const EntityBuilder& build, Handle entity) {
    if (std::exchange(fades_, false)) {
      fade_to(build.as<Entity>(entity).weight, weight_, static_cast<float>(to_seconds(fade_)),
              static_cast<float>(to_seconds(build.lead())));
    }
    write(build, entity);
  }

  float weight_;
  Ticks fade_{};
  bool fades_ = false;
};

/// The reason why a placement is refused.
inline constexpr const char* not_a_placement = "a placement is of finite metres and a unit quaternion";

}  // namespace throng::anim
