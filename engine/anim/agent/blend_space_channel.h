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

/// Plays looping clips along one parameter, such as walk, jog and run by speed. The two neighbours of the parameter are
/// blended cycle by cycle: their phases are the same, so that feet meet the ground together.
class BlendSpaceChannel final : public Channel {
 public:
  /// Takes at least one of `points`, whose parameters ascend. Set `is_ground_speed` if the parameter is the speed over
  /// ground, in metres a second, at which each clip was made. It sets the pace between the points so that feet do not
  /// slide.
  BlendSpaceChannel(std::vector<BlendPoint> points, float parameter, bool is_ground_speed);

  /// Sets the parameter at once, from the next update on. A caller that wants a slow change moves it slowly.
  void set_parameter(float parameter) { parameter_ = parameter; }
  float parameter() const { return parameter_; }
  /// Returns the phase of the current cycle at the clock, 0 to below 1; 0 before the first update.
  double phase(const EntityBuilder& build) const;

  Handle state() const override { return blender_.valid() ? blender_ : players_[0]; }
  bool update(const EntityBuilder& build) override;
  /// Returns when two players must be put in step again. Speeds are rounded to 1/65536, so two players would drift
  /// apart by up to 1e-3 of a cycle a minute.
  Ticks next_update() const override { return blender_.valid() ? in_step_at_ + in_step_for : never; }
  void visit_handles(const std::function<void(Handle&)>& visit) override;
  void destroy_entities(const EntityBuilder& build) override;
  std::unique_ptr<Channel> clone() const override { return std::make_unique<BlendSpaceChannel>(*this); }

 private:
  static constexpr Ticks in_step_for = 10 * ticks_per_second;

  struct Place {
    std::size_t lower;  ///< the point at or below the parameter
    float fraction;     ///< the way towards the next point, 0 to below 1
    double cycles_per_second;
  };
  Place place(const EntityBuilder& build) const;
  double duration(const EntityBuilder& build, std::size_t point) const;
  void set_in_step(const EntityBuilder& build, Handle player, std::size_t point, double phase, double cycles) const;

  std::vector<BlendPoint> points_;
  float parameter_;
  bool is_ground_speed_;
  std::array<Handle, 2> players_;         // the players of the points around the parameter, the lower first
  std::array<std::size_t, 2> playing_{};  // the points that they play
  Ticks in_step_at_{};
  Handle blender_;  // between the two; invalid where one plays alone
};

}  // namespace throng::anim
