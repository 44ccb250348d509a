#include "app/show/stage/followed_mix.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <glm/common.hpp>

#include "app/character/gait_plane.h"
#include "engine/base/random.h"

namespace throng::app {
namespace {

constexpr double rest_seconds = 7.0, rest_fade = 1.2;  // of one way to stand, and from it to the next
constexpr float least_walk = 0.12F;                    // share of gaits below which no foot is lifted
constexpr float least_seen_weight = 0.002F;            // a lighter clip is not seen

anim::FineTicks fine(double seconds) { return to_ticks(seconds) * anim::fine_ticks_per_tick; }

/// Writes clips into a mix so that the moment is reached when its time has come.
class MixWriter {
 public:
  MixWriter(const FollowedMoment& moment, const anim::Character& character) : moment_(moment), character_(character) {}

  /// Returns the phase of the gait's clip. `in_step` maps the reference's clip to it.
  double add_gait(const GaitPoint& gait, const GaitPoint& reference, const anim::MarkerMap& in_step, float weight,
                  double cycles_per_second) {
    const double cycle = moment_.step.cycles - std::floor(moment_.step.cycles);
    const anim::FineTicks length = ticks_of(reference.clip) * anim::fine_ticks_per_tick;
    const auto at = std::min(static_cast<anim::FineTicks>(cycle * static_cast<double>(length)), length - 1);
    const anim::MarkerMap::Way way = in_step.way(at);
    const anim::FineTicks position = way.position(at);
    const double speed = way.rate * cycles_per_second * to_seconds(ticks_of(reference.clip)) * moment_.rate;
    add(gait.clip, weight, position, speed, anim::StepVoice::follows);
    return static_cast<double>(position) / static_cast<double>(ticks_of(gait.clip) * anim::fine_ticks_per_tick);
  }

  void add_rest(int rest, float weight) {
    constexpr double spread = 0.37;  // seconds from one person's rest to the next one's
    const double at = moment_.seconds + spread * static_cast<double>(moment_.person % 97);
    const double length = to_seconds(ticks_of(rest));
    const double into = at - length * std::floor(at / length);
    add(rest, weight, fine(into), moment_.rate, anim::StepVoice::own);
  }

  /// Lets the heaviest gait speak for all.
  FollowedMix finished() {
    anim::MixedClip* leader = nullptr;
    for (anim::MixedClip& one : std::span(mix_.of).first(mix_.count)) {
      if (one.voice == anim::StepVoice::own || (leader != nullptr && leader->weight >= one.weight)) continue;
      leader = &one;
    }
    if (leader != nullptr) leader->voice = anim::StepVoice::leads;
    return mix_;
  }

 private:
  Ticks ticks_of(int index) const {
    return std::max(character_.clips[static_cast<std::size_t>(index)].duration, Ticks{1});
  }

  void add(int index, float weight, anim::FineTicks position, double speed, anim::StepVoice voice) {
    if (weight < least_seen_weight && mix_.count > 0) return;
    const auto before = std::span(mix_.of).first(mix_.count);
    const auto same = std::ranges::find(before, index, &anim::MixedClip::clip);
    if (same != before.end()) {
      same->weight += weight;
      return;
    }
    if (mix_.count == mix_.of.size()) {  // a sixth clip hardly weighs anything
      mix_.of.back().weight += weight;
      return;
    }
    const auto way = static_cast<anim::FineTicks>(speed * 65536.0) * moment_.ahead.count();
    mix_.of.at(mix_.count++) = {index, std::max(weight, least_seen_weight), position - way, speed, voice};
  }

  const FollowedMoment& moment_;
  const anim::Character& character_;
  FollowedMix mix_;
};

/// Returns the clip with which a person stands in a turn.
int rest_of(const CharacterRoles& roles, int stand, std::uint32_t person, std::int64_t turn) {
  constexpr std::uint32_t in_all = 10, looks_around = 3;
  const int look = roles.clip(Role::look_around);
  return look != no_clip && Random(static_cast<std::uint64_t>(turn), person).below(in_all) < looks_around ? look
                                                                                                          : stand;
}

/// Adds ways to stand, one of which fades to the next every few seconds.
void add_rests(const FollowedMoment& moment, const CharacterRoles& roles, float weight, MixWriter& writer) {
  const double turns = moment.seconds / rest_seconds + 0.61 * static_cast<double>(moment.person);
  const auto turn = static_cast<std::int64_t>(std::floor(turns));
  const auto t = static_cast<float>((turns - std::floor(turns)) * rest_seconds / rest_fade);
  const float arrived = glm::smoothstep(0.0F, 1.0F, t);
  const int stand = standing_clip(roles), talk = roles.clip(Role::talk);
  const float talks = talk != no_clip ? weight * moment.speaks : 0.0F;
  if (talks > 0.0F) writer.add_rest(talk, talks);
  const auto rest = [&](std::int64_t at, float share) {
    if (share > 0.0F) writer.add_rest(rest_of(roles, stand, moment.person, at), share);
  };
  rest(turn, (weight - talks) * arrived);
  rest(turn - 1, (weight - talks) * (1.0F - arrived));
}

}  // namespace

FollowedMix followed_mix(const FollowedMoment& moment, const StridePlane& plane, const Stances& stances,
                         const CharacterRoles& roles, const anim::Character& character) {
  MixWriter writer(moment, character);
  const StridePlane::Stride stride = plane.stride(moment.step.velocity);
  const std::span<const StridePoint> points = plane.points();
  std::array<float, person_legs> margins{};
  float walks = 0.0F, stands = stride.stands;
  for (const auto& share : stride.shares.all()) {
    const float weight = share.weight * (1.0F - stride.stands);
    if (!points[share.point].gait.is_gait) {
      stands += weight;
      continue;
    }
    if (weight < least_seen_weight) continue;
    const double phase = writer.add_gait(points[share.point].gait, points[plane.reference()].gait,
                                         stances.in_step(share.point), weight, stride.cycles_per_second);
    walks += weight;
    for (std::size_t leg = 0; leg < person_legs; ++leg) {
      margins[leg] += weight * stances.margin(share.point, leg, phase);
    }
  }
  if (stands > least_seen_weight) add_rests(moment, roles, stands, writer);
  FollowedMix mix = writer.finished();
  // Steps that are hardly seen are none, and both feet stand.
  const float rests = 1.0F - std::min(walks / least_walk, 1.0F);
  for (std::size_t leg = 0; leg < person_legs; ++leg) {
    const float of_gaits = walks > 0.0F ? std::clamp(margins[leg] / walks, 0.0F, 1.0F) : 1.0F;
    mix.planted[leg] = std::min(of_gaits + rests, 1.0F);
  }
  return mix;
}

}  // namespace throng::app
