#include "engine/anim/agent/agent_motion.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "engine/anim/asset/data_keys.h"
#include "engine/anim/base/elementary.h"
#include "engine/anim/entity/ease_blender.h"

namespace throng::anim {
namespace {

constexpr FineTicks farthest = (FineTicks{1} << 62U) - 1;  // the way between two such positions still fits

/// Returns the time within a clip at an unwrapped position.
Ticks time_within(Ticks duration, bool looping, FineTicks position) {
  const FineTicks length = duration * fine_ticks_per_tick;
  if (length <= 0) return Ticks{};
  const FineTicks in_clip =
      looping ? position - whole_loops(position, length) * length : std::clamp<FineTicks>(position, 0, length);
  return in_clip / fine_ticks_per_tick;
}

}  // namespace

PoseWeights AgentMotion::weights(Ticks at) const { return sharing(at).weights(PoseSharing::Part::motion); }

// It is counted from the loop in which the player stands, since only intervals matter: so a clip may loop for years.
FineTicks AgentMotion::position(const Player& player, Ticks at) const {
  const Ticks since = at - posed_at_ + player.state.delta_time;
  return std::clamp(player.position + distance(since, player.speed), -farthest, farthest);
}

// A gait in step moves as the leader does, evenly, and not from foot to foot as its pose does.
FineTicks AgentMotion::place_on_root_curve(std::size_t step, Ticks at) const {
  const std::optional<std::size_t> leader = leader_of(step);
  if (!leader) return position(player(step), at);
  const double own = to_seconds(clips_[player(step).clip].duration);
  const double leading = to_seconds(clips_[player(*leader).clip].duration);
  const double place = static_cast<double>(position(player(*leader), at)) * (own / leading);
  return std::llround(std::clamp(place, -0x1p61, 0x1p61));
}

RootMotion AgentMotion::displacement_of(std::size_t step, Ticks from, Ticks to) const {
  const Player& own = player(step);
  const RootCurve* const curve = clips_[own.clip].root_motion;
  if (curve == nullptr) return {};
  const bool looping = (own.flags & Player::looping) != 0;
  return anim::displacement(*curve, place_on_root_curve(step, from), place_on_root_curve(step, to), looping);
}

// Straight motions blend as vectors. Motions that turn blend as steady velocities, over steps in which none turns far,
// so that the result does not depend on where an interval was cut.
RootMotion AgentMotion::displacement(Ticks from, Ticks to) const {
  const PoseWeights shares = weights(to);
  RootMotion sum;
  double most_turn = 0.0;
  bool alone = true;
  for_each_player([&](std::size_t step, const Player&, const ClipStreams&) {
    if (shares[step] == 0.0F) return;
    const RootMotion one = displacement_of(step, from, to);
    sum.translation += one.translation * static_cast<double>(shares[step]);
    sum.yaw += one.yaw * static_cast<double>(shares[step]);
    most_turn = std::max(most_turn, std::abs(one.yaw));
    alone = alone && shares[step] == 1.0F;
  });
  return most_turn == 0.0 || alone ? sum : blended_turn(shares, from, to, most_turn);
}

RootMotion AgentMotion::blended_turn(const PoseWeights& shares, Ticks from, Ticks to, double most_turn) const {
  constexpr double turn_a_step = 0.5;  // radians
  const auto steps = static_cast<std::int64_t>(std::clamp(std::ceil(most_turn / turn_a_step), 1.0, 1024.0));
  RootMotion whole;
  for (std::int64_t i = 0; i < steps; ++i) {
    const Ticks begin = from + (to - from) * i / steps, end = from + (to - from) * (i + 1) / steps;
    RootVelocity blend;
    for_each_player([&](std::size_t step, const Player&, const ClipStreams&) {
      if (shares[step] == 0.0F) return;
      const RootVelocity one = steady_velocity(displacement_of(step, begin, end), 1.0);
      blend.linear += one.linear * static_cast<double>(shares[step]);
      blend.yaw += one.yaw * static_cast<double>(shares[step]);
    });
    whole = compose(whole, moved_by(blend, 1.0));
  }
  return whole;
}

bool AgentMotion::plays_morphs() const {
  bool plays = false;
  for_each_player(
      [&](std::size_t, const Player&, const ClipStreams& clip) { plays = plays || clip.morphs != nullptr; });
  return plays;
}

/// Returns whether some entity has one share in one bone and another in the next.
bool AgentMotion::differs_by_bone() const {
  return std::ranges::any_of(graph_->entities, [&](Handle entity) {
    if (entity.pool() == EntityPools::ease_blenders) {
      return pools_->as<EaseBlender>(entity).mask != EaseBlender::no_mask;
    }
    return entity.pool() == EntityPools::mixers || entity.pool() == EntityPools::additive_layers;
  });
}

bool AgentMotion::add_morph_weights(Ticks at, std::span<float> weights) const {
  assert(weights.size() == morphs_.bones.size());
  if (!plays_morphs()) return false;
  const bool all_alike = !differs_by_bone();
  for (std::size_t first = 0, end = 0; first < weights.size(); first = end) {
    const int bone = morphs_.bones[first];
    end = first + 1;
    while (end < weights.size() && (all_alike || morphs_.bones[end] == bone)) ++end;
    const PoseWeights shares = sharing(at).weights(PoseSharing::Part::bone, bone);
    for_each_player([&](std::size_t step, const Player& player, const ClipStreams& clip) {
      const float share = shares[step];
      if (clip.morphs == nullptr || share == 0.0F) return;
      const bool looping = (player.flags & Player::looping) != 0;
      const Ticks time = time_within(clip.duration, looping, position(player, at));
      anim::add_morph_weights(*clip.morphs, time, share, weights.subspan(first, end - first),
                              static_cast<std::uint32_t>(first));
    });
  }
  return true;
}

float AgentMotion::curve(std::uint32_t name, Ticks at) const {
  const auto curve_of = [name](const ClipStreams& clip) {
    return clip.curves == nullptr ? nullptr : find_curve(*clip.curves, name);
  };
  bool plays = false;
  for_each_player([&](std::size_t, const Player&, const ClipStreams& clip) { plays = plays || curve_of(clip); });
  if (!plays) return 0.0F;
  const PoseWeights felt = sharing(at).weights(PoseSharing::Part::anywhere);
  float sum = 0.0F, weight = 0.0F;
  for_each_player([&](std::size_t step, const Player& player, const ClipStreams& clip) {
    const UserCurve* const curve = curve_of(clip);
    if (curve == nullptr || felt[step] == 0.0F) return;
    const bool looping = (player.flags & Player::looping) != 0;
    sum += felt[step] * value_at(*curve, time_within(clip.duration, looping, position(player, at)));
    weight += felt[step];
  });
  return weight > 1.0F ? sum / weight : sum;
}

std::optional<AbsoluteRoot> AgentMotion::absolute_root(Ticks now) const {
  std::optional<AbsoluteRoot> root;
  float heaviest = 0.0F;
  const PoseWeights shares = weights(now);
  for_each_player([&](std::size_t step, const Player& player, const ClipStreams& clip) {
    if ((player.state.flags & AnimationStateHeader::has_absolute_root) == 0 || shares[step] <= heaviest) return;
    heaviest = shares[step];
    const double* const p = player.state.absolute_position;
    const float* const q = player.state.absolute_rotation;
    root = AbsoluteRoot{.position = {p[0], p[1], p[2]}, .rotation = {q[3], q[0], q[1], q[2]}};
    if (clip.root_motion == nullptr) return;
    const bool looping = (player.flags & Player::looping) != 0;
    const RootMotion loops = power(whole_motion(*clip.root_motion), player.loop_count);
    const RootMotion moved = compose(loops, anim::displacement(*clip.root_motion, 0, position(player, now), looping));
    root->position += glm::dquat(root->rotation) * moved.translation;
    root->rotation = root->rotation * angle_axis(static_cast<float>(moved.yaw), glm::vec3(0.0F, 1.0F, 0.0F));
  });
  return root;
}

}  // namespace throng::anim
