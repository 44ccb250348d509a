#pragma once

#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "throng/channels.h"

#include "engine/anim/agent/in_step_players.h"

namespace throng::anim {

/// A clip, and the value of the parameter at which it is played alone.
struct BlendPoint {
  int clip = 0;
  float parameter = 0.0F;
  Pace pace = Pace::automatic;

  friend bool operator==(const BlendPoint&, const BlendPoint&) = default;
};

/// Plays looping clips along one parameter, such as idle, walk, jog and run by speed. It blends the two neighbours of
/// the parameter. Gaits keep step, foot by foot (`in_step_players.h`); a clip that is no gait, such as idle, plays at
/// its own rate.
///
/// Where the parameter is a ground speed, a gait is a point whose parameter is not 0; else, a clip with a speed over
/// ground (`ground_speed` in character.h). The root then moves at the parameter, so that feet do not slide. A walk
/// that is blended with idle shortens its steps and keeps its pace, which therefore needs no floor. Below the slowest
/// gait of a space without idle, the pace falls with the parameter.
class BlendSpaceChannel final : public Channel {
 public:
  /// Takes at least one of `points`, whose parameters ascend. Set `is_ground_speed` if the parameter is the speed over
  /// ground, in metres a second, at which each clip was made.
  BlendSpaceChannel(std::vector<BlendPoint> points, float parameter, bool is_ground_speed)
      : BlendSpaceChannel(std::make_shared<const std::vector<BlendPoint>>(std::move(points)), parameter,
                          is_ground_speed) {}
  /// Shares the points, which are not null, with others.
  BlendSpaceChannel(std::shared_ptr<const std::vector<BlendPoint>> points, float parameter, bool is_ground_speed);

  /// Sets the parameter at once, from the next update on. A caller that wants a slow change moves it slowly. A value
  /// that is not a number changes nothing.
  void set_parameter(float parameter);
  float parameter() const { return parameter_; }
  /// Returns the phase of the gait that leads at the clock, 0 to below 1; 0 where no gait plays.
  double phase(const EntityBuilder& build) const { return players_.phase(build); }

  const char* fault(const EntityBuilder& build) const override;
  Handle state() const override { return players_.state(); }
  bool update(const EntityBuilder& build) override;
  bool update_in_place(const EntityBuilder& build) override;
  Ticks next_update() const override { return players_.next_update(); }
  void visit_handles(const std::function<void(Handle&)>& visit) override { players_.visit_handles(visit); }
  void destroy_entities(const EntityBuilder& build) override { players_.destroy_entities(build); }
  std::unique_ptr<Channel> clone() const override { return std::make_unique<BlendSpaceChannel>(*this); }

 private:
  struct Place {
    std::size_t lower;  ///< the point at or below the parameter
    float fraction;     ///< the way towards the next point, 0 to below 1
  };
  Place place() const;
  PlayingPoints shown(const EntityBuilder& build) const;
  PlayingPoint playing(const EntityBuilder& build, std::size_t point, float weight) const;
  double cycles_per_second(const EntityBuilder& build, std::span<const PlayingPoint> playing) const;

  std::shared_ptr<const std::vector<BlendPoint>> points_;
  float parameter_ = 0.0F;
  bool is_ground_speed_;
  InStepPlayers players_;  // of the points around the parameter, the lower first
};

}  // namespace throng::anim
