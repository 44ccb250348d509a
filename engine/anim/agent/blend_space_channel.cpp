#include "engine/anim/agent/blend_space_channel.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace throng::anim {

BlendSpaceChannel::BlendSpaceChannel(std::vector<BlendPoint> points, float parameter, bool is_ground_speed)
    : points_(std::move(points)), parameter_(parameter), is_ground_speed_(is_ground_speed) {
  assert(!points_.empty());
  assert(std::ranges::is_sorted(points_, {}, &BlendPoint::parameter));
}

double BlendSpaceChannel::duration(const EntityBuilder& build, std::size_t point) const {
  return std::max(to_seconds(build.clip(points_[point].clip).duration), 1e-3);
}

BlendSpaceChannel::Place BlendSpaceChannel::place(const EntityBuilder& build) const {
  const auto above = std::ranges::upper_bound(points_, parameter_, {}, &BlendPoint::parameter);
  const std::size_t lower = above == points_.begin() ? 0 : static_cast<std::size_t>(above - points_.begin()) - 1;
  Place place{.lower = lower, .fraction = 0.0F, .cycles_per_second = 0.0};
  if (above != points_.begin() && above != points_.end()) {
    place.fraction = (parameter_ - points_[lower].parameter) / (above->parameter - points_[lower].parameter);
  }
  double stride = 0.0;
  for (std::size_t i = 0; i < (place.fraction > 0.0F ? 2U : 1U); ++i) {
    const auto weight = static_cast<double>(i == 0 ? 1.0F - place.fraction : place.fraction);
    const double seconds = duration(build, lower + i);
    place.cycles_per_second += weight / seconds;
    stride += weight * static_cast<double>(points_[lower + i].parameter) * seconds;
  }
  if (is_ground_speed_ && stride > 1e-3) place.cycles_per_second = static_cast<double>(parameter_) / stride;
  return place;
}

double BlendSpaceChannel::phase(const EntityBuilder& build) const {
  if (!players_[0].valid()) return 0.0;
  const auto position =
      static_cast<double>(build.position(players_[0])) / static_cast<double>(fine_ticks_per_tick.count());
  const double cycles = position / static_cast<double>(ticks_per_second.count()) / duration(build, playing_[0]);
  return cycles - std::floor(cycles);
}

void BlendSpaceChannel::set_in_step(const EntityBuilder& build, Handle player, std::size_t point, double phase,
                                    double cycles) const {
  const double seconds = duration(build, point);
  build.set_speed(player, cycles * seconds);
  build.seek(player, to_ticks(phase * seconds) * fine_ticks_per_tick);
}

bool BlendSpaceChannel::update(const EntityBuilder& build) {
  const Place at = place(build);
  const double phase_now = phase(build);
  in_step_at_ = build.now();
  const bool two = at.fraction > 0.0F;
  const bool same = players_[0].valid() && playing_[0] == at.lower && blender_.valid() == two;
  if (!same) {
    destroy_entities(build);
    for (std::size_t i = 0; i < (two ? 2U : 1U); ++i) {
      playing_[i] = at.lower + i;
      players_[i] = build.player({.clip = points_[playing_[i]].clip});
    }
    if (two) blender_ = build.hold(players_[0], players_[1], at.fraction);
  }
  if (two) build.as<EaseBlender>(blender_).fraction = at.fraction;
  for (std::size_t i = 0; i < (two ? 2U : 1U); ++i) {
    set_in_step(build, players_[i], playing_[i], phase_now, at.cycles_per_second);
  }
  return !same;
}

void BlendSpaceChannel::visit_handles(const std::function<void(Handle&)>& visit) {
  for (Handle* handle : {&players_[0], &players_[1], &blender_}) {
    if (handle->valid()) visit(*handle);
  }
}

void BlendSpaceChannel::destroy_entities(const EntityBuilder& build) {
  visit_handles([&](Handle& handle) {
    build.destroy(handle);
    handle = {};
  });
}

}  // namespace throng::anim
