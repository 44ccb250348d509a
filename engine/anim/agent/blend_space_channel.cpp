#include "engine/anim/agent/blend_space_channel.h"

#include <algorithm>
#include <cmath>

#include "engine/anim/base/misuse.h"

namespace throng::anim {

BlendSpaceChannel::BlendSpaceChannel(std::shared_ptr<const std::vector<BlendPoint>> points, float parameter,
                                     bool is_ground_speed)
    : points_(std::move(points)), is_ground_speed_(is_ground_speed) {
  set_parameter(parameter);
}

void BlendSpaceChannel::set_parameter(float parameter) {
  if (std::isfinite(parameter)) {
    parameter_ = parameter;
  } else {
    report_misuse({"Agent::set_parameter", "a parameter is a finite number"});
  }
}

const char* BlendSpaceChannel::fault(const EntityBuilder& build) const {
  const std::vector<BlendPoint>& points = *points_;
  if (points.empty()) return "a blend space has points";
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!build.has_clip(points[i].clip)) return "the clip of a point is not one that the character has";
    if (!std::isfinite(points[i].parameter)) return "the parameter of a point is a number";
    if (i > 0 && !(points[i - 1].parameter < points[i].parameter)) return "the parameters of points ascend";
  }
  return nullptr;
}

BlendSpaceChannel::Place BlendSpaceChannel::place() const {
  const auto above = std::ranges::upper_bound(*points_, parameter_, {}, &BlendPoint::parameter);
  const std::size_t lower = above == points_->begin() ? 0 : static_cast<std::size_t>(above - points_->begin()) - 1;
  if (above == points_->begin() || above == points_->end()) return {.lower = lower, .fraction = 0.0F};
  const float below = (*points_)[lower].parameter;
  return {.lower = lower, .fraction = (parameter_ - below) / (above->parameter - below)};
}

PlayingPoint BlendSpaceChannel::playing(const EntityBuilder& build, std::size_t point, float weight) const {
  const BlendPoint& own = (*points_)[point];
  const bool travels = is_ground_speed_ ? own.parameter != 0.0F : build.clip(own.clip).ground_speed > 0.0;
  const bool is_gait = own.pace == Pace::automatic ? travels : own.pace == Pace::gait;
  return {.point = point, .clip = own.clip, .weight = weight, .is_gait = is_gait};
}

double BlendSpaceChannel::cycles_per_second(const EntityBuilder& build, std::span<const PlayingPoint> playing) const {
  StrideSum sum;
  for (const PlayingPoint& one : playing) {
    if (one.is_gait) sum.add(build, one, static_cast<double>((*points_)[one.point].parameter));
  }
  return is_ground_speed_ && sum.metres_a_cycle > StrideSum::least
             ? static_cast<double>(parameter_) / sum.metres_a_cycle
             : sum.own_cycles_per_second();
}

PlayingPoints BlendSpaceChannel::shown(const EntityBuilder& build) const {
  const auto [lower, fraction] = place();
  PlayingPoints shown{.of = {playing(build, lower, 1.0F - fraction)}, .count = 1};
  if (fraction > 0.0F) shown.of[shown.count++] = playing(build, lower + 1, fraction);
  shown.cycles_per_second = cycles_per_second(build, shown.all());
  return shown;
}

bool BlendSpaceChannel::update(const EntityBuilder& build) { return players_.play(build, shown(build)); }

bool BlendSpaceChannel::update_in_place(const EntityBuilder& build) { return players_.play_on(build, shown(build)); }

}  // namespace throng::anim
