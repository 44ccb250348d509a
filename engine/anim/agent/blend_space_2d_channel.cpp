#include "engine/anim/agent/blend_space_2d_channel.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <glm/geometric.hpp>

#include "engine/anim/base/finite.h"
#include "engine/anim/base/misuse.h"

namespace throng::anim {

Result<std::shared_ptr<const BlendSpace2d>> BlendSpace2d::create(std::vector<BlendPoint2d> points, PlaneMeaning meaning,
                                                                 int clip_count) {
  std::vector<glm::vec2> places;
  for (const BlendPoint2d& point : points) {
    if (point.clip < 0 || point.clip >= clip_count) {
      return Error{"point " + std::to_string(places.size()) + " of a blend space plays clip " +
                   std::to_string(point.clip) + ", and the character has " + std::to_string(clip_count) +
                   ": give it one of these"};
    }
    places.push_back(point.place);
  }
  Result<BlendPlane> plane = BlendPlane::create(places);
  if (!plane) return plane.error();
  return std::shared_ptr<const BlendSpace2d>(new BlendSpace2d(std::move(points), meaning, std::move(*plane)));
}

BlendSpace2dChannel::BlendSpace2dChannel(std::shared_ptr<const BlendSpace2d> space, const glm::vec2& place)
    : space_(std::move(space)) {
  set_place(place);
}

const char* BlendSpace2dChannel::fault(const EntityBuilder& build) const {
  if (space_ == nullptr) return "the blend space is null";
  const bool has_clips =
      std::ranges::all_of(space_->all(), [&](const BlendPoint2d& one) { return build.has_clip(one.clip); });
  return has_clips ? nullptr : "the clip of a point is not one that the character has";
}

void BlendSpace2dChannel::set_place(const glm::vec2& place) {
  if (all_finite(place)) {
    place_ = place;
  } else {
    report_misuse({"Agent::set_parameters", "a place is of finite numbers"});
  }
}

bool BlendSpace2dChannel::is_gait(const EntityBuilder& build, const BlendPoint2d& point) const {
  if (point.pace != Pace::automatic) return point.pace == Pace::gait;
  switch (space_->meaning()) {
    case PlaneMeaning::velocity:
      return point.place != glm::vec2(0.0F);
    case PlaneMeaning::speed_and_turn:
      return point.place.x != 0.0F;
    default:
      return build.clip(point.clip).ground_speed > 0.0;
  }
}

// The strides of clips that go in several directions add up as vectors.
double BlendSpace2dChannel::cycles_per_second(const EntityBuilder& build, std::span<const PlayingPoint> playing) const {
  StrideSum across, along;
  for (const PlayingPoint& one : playing) {
    if (!one.is_gait) continue;
    const glm::dvec2 own(space_->point(one.point).place);
    across.add(build, one, own.x);
    along.add(build, one, own.y);
  }
  const bool by_turn = space_->meaning() == PlaneMeaning::speed_and_turn;
  const double stride =
      by_turn ? across.metres_a_cycle : glm::length(glm::dvec2(across.metres_a_cycle, along.metres_a_cycle));
  if (space_->meaning() == PlaneMeaning::plain || std::abs(stride) <= StrideSum::least) {
    return across.own_cycles_per_second();
  }
  const double speed = by_turn ? static_cast<double>(place_.x) : glm::length(glm::dvec2(place_));
  return speed / stride;
}

PlayingPoints BlendSpace2dChannel::shown(const EntityBuilder& build) const {
  const BlendPlane::Shares shares = space_->plane().shares(place_);
  PlayingPoints shown{.count = shares.count};
  std::ranges::transform(shares.all(), shown.of.begin(), [&](const BlendPlane::Share& share) {
    const BlendPoint2d& point = space_->point(share.point);
    return PlayingPoint{
        .point = share.point, .clip = point.clip, .weight = share.weight, .is_gait = is_gait(build, point)};
  });
  shown.cycles_per_second = cycles_per_second(build, shown.all());
  return shown;
}

bool BlendSpace2dChannel::update(const EntityBuilder& build) { return players_.play(build, shown(build)); }

bool BlendSpace2dChannel::update_in_place(const EntityBuilder& build) { return players_.play_on(build, shown(build)); }

}  // namespace throng::anim
