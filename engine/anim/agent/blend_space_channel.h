#pragma once

#include <array>
#include <vector>

#include "engine/anim/agent/channel.h"

namespace throng::anim {

/// A clip, and the value of the parameter at which it is played alone.
struct BlendPoint {
  int clip = 0;
  float parameter = 0.0F;
};

/// Walk, jog and run by speed; any looping clips along one parameter. The two neighbours of the parameter are blended,
/// cycle by cycle: their phases are the same, so that feet meet the ground together.
class BlendSpaceChannel final : public Channel {
 public:
  /// `points`: at least one, parameters ascending. Where the parameter is the speed over ground, in metres a second, at
  /// which each clip was made, `is_ground_speed` sets the pace between the points so that feet do not slide.
  BlendSpaceChannel(std::vector<BlendPoint> points, float parameter, bool is_ground_speed);

  /// From the next update on, at once: what should come slowly is moved slowly by the caller.
  void set_parameter(float parameter) { parameter_ = parameter; }
  float parameter() const { return parameter_; }
  /// Of the current cycle, 0 to below 1, at the clock; 0 before the first update.
  double phase(const EntityBuilder& build) const;

  Handle state() const override { return blender_.valid() ? blender_ : players_[0]; }
  bool update(const EntityBuilder& build) override;
  /// Speeds are rounded to 1/65536: two players drift apart by up to 1e-3 of a cycle a minute unless put in step again.
  Ticks next_update() const override { return blender_.valid() ? in_step_at_ + in_step_for : never; }
  void visit_handles(const std::function<void(Handle&)>& visit) override;
  void destroy_entities(const EntityBuilder& build) override;
  std::unique_ptr<Channel> clone() const override { return std::make_unique<BlendSpaceChannel>(*this); }

 private:
  static constexpr Ticks in_step_for = 10 * ticks_per_second;

  struct Place {
    std::size_t lower;  ///< point at or below the parameter
    float fraction;     ///< towards the next one, 0 to below 1
    double cycles_per_second;
  };
  Place place(const EntityBuilder& build) const;
  double duration(const EntityBuilder& build, std::size_t point) const;
  void set_in_step(const EntityBuilder& build, Handle player, std::size_t point, double phase, double cycles) const;

  std::vector<BlendPoint> points_;
  float parameter_;
  bool is_ground_speed_;
  std::array<Handle, 2> players_;         // of the points around the parameter, the lower first
  std::array<std::size_t, 2> playing_{};  // which points these are
  Ticks in_step_at_ = 0;
  Handle blender_;  // between the two; invalid where one plays alone
};

}  // namespace throng::anim
