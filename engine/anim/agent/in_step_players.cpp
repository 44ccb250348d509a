#include "engine/anim/agent/in_step_players.h"

#include <algorithm>
#include <cassert>
#include <cstdlib>
#include <utility>

#include "engine/anim/entity/mixer.h"

namespace throng::anim {
namespace {

constexpr Ticks in_step_for = 10 * ticks_per_second;
constexpr double fastest = 32767.0;  // what a player holds, whatever pace a far place asks for

MarkedClip marked(const EntityBuilder& build, int clip) {
  const ClipStreams& streams = build.clip(clip);
  return {.keys = streams.data_keys, .duration = std::max(streams.duration, Ticks{1})};
}

FineTicks length_of(const EntityBuilder& build, int clip) { return marked(build, clip).duration * fine_ticks_per_tick; }

/// Returns the ticks until a position leaves a way at that speed, which is not 0.
Ticks ticks_until_left(FineTicks position, const MarkerMap::Way& way, FineTicks speed) {
  const FineTicks left = speed > 0 ? way.end - position : position - way.begin + 1;
  return Ticks{(left + std::abs(speed) - 1) / std::abs(speed)};
}

}  // namespace

// Keeps the players of keys that go on, so that nothing jumps.
bool BlendedPlayers::take(const EntityBuilder& build, std::span<const Wanted> wanted) {
  const std::array<Handle, most> before = players_;
  const std::array<std::size_t, most> played = keys_;
  const std::size_t had = std::exchange(count_, wanted.size());
  bool changed = had != count_;
  std::array<bool, most> kept{};
  for (std::size_t i = 0; i < count_; ++i) {
    keys_[i] = wanted[i].key;
    players_[i] = {};
    for (std::size_t old = 0; old < had; ++old) {
      if (played[old] != wanted[i].key) continue;
      players_[i] = before[old];
      kept[old] = true;
      changed = changed || old != i;
    }
    if (players_[i].valid()) continue;
    players_[i] = build.player({.clip = wanted[i].clip});
    changed = true;
  }
  for (std::size_t old = 0; old < had; ++old) {
    if (!kept[old]) build.destroy(before[old]);
  }
  for (std::size_t i = count_; i < most; ++i) players_[i] = {};
  return changed;
}

bool BlendedPlayers::blend(const EntityBuilder& build, std::span<const float> weights) {
  const Handle before = blend_;
  const bool is_mixer = blend_.valid() && build.pools().state(blend_).type == EntityType::mixer;
  const bool fits = count_ > 1 && is_mixer == (count_ > 2);
  if (blend_.valid() && !fits) build.destroy(std::exchange(blend_, {}));
  if (count_ == 2) {
    if (!blend_.valid()) blend_ = build.hold(players_[0], players_[1], weights[1]);
    auto& blender = build.as<EaseBlender>(blend_);
    blender.from = players_[0];
    blender.to = players_[1];
  } else if (count_ > 2) {
    if (!blend_.valid()) blend_ = build.create(EntityPools::mixers);
    auto& mixer = build.as<Mixer>(blend_);
    mixer.source_count = static_cast<std::uint32_t>(count_);
    std::ranges::fill(mixer.masks, EaseBlender::no_mask);
    std::copy_n(players_.begin(), count_, build.private_as<MixerSources>(blend_).sources);
  }
  weigh(build, weights);
  return blend_ != before;
}

void BlendedPlayers::weigh(const EntityBuilder& build, std::span<const float> weights) const {
  if (count_ == 2) build.as<EaseBlender>(blend_).fraction = weights[1];
  if (count_ > 2) std::copy_n(weights.begin(), count_, build.private_as<MixerSources>(blend_).weights);
}

void BlendedPlayers::visit_handles(const std::function<void(Handle&)>& visit) {
  for (std::size_t i = 0; i < count_; ++i) visit(players_[i]);
  if (blend_.valid()) visit(blend_);
}

void BlendedPlayers::destroy_entities(const EntityBuilder& build) {
  for (std::size_t i = 0; i < count_; ++i) build.destroy(players_[i]);
  if (blend_.valid()) build.destroy(blend_);
  *this = {};
}

void StrideSum::add(const EntityBuilder& build, const PlayingPoint& gait, double speed) {
  const auto share = static_cast<double>(gait.weight);
  const double seconds = to_seconds(marked(build, gait.clip).duration);
  weight += share;
  cycles += share / seconds;
  metres_a_cycle += share * speed * seconds;
}

InStepPlayers::Stride InStepPlayers::stride(const EntityBuilder& build, const Players& players) const {
  if (leader_ == no_player) return {};
  const int clip = points_[leader_].clip;
  const FineTicks length = length_of(build, clip);
  const FineTicks position = build.position(*players[leader_]);
  return {.clip = clip, .position = position - whole_loops(position, length) * length};
}

double InStepPlayers::phase(const EntityBuilder& build) const {
  if (leader_ == no_player) return 0.0;
  const Stride now = stride(build, players(build));
  return static_cast<double>(now.position) / static_cast<double>(length_of(build, now.clip));
}

bool InStepPlayers::take_players(const EntityBuilder& build, std::span<const PlayingPoint> points) {
  const bool has_leader = leader_ != no_player;
  const std::size_t leading = has_leader ? points_[leader_].point : 0;
  std::array<BlendedPlayers::Wanted, most> wanted;
  count_ = points.size();
  leader_ = no_player;
  for (std::size_t i = 0; i < count_; ++i) {
    points_[i] = points[i];
    wanted[i] = {.key = points[i].point, .clip = points[i].clip};
    if (has_leader && points[i].point == leading) leader_ = i;
  }
  return players_.take(build, std::span(wanted).first(count_));
}

// The leader of before stays as long as no gait is heavier.
std::size_t InStepPlayers::choose_leader() const {
  std::size_t best = leader_;
  for (std::size_t i = 0; i < count_; ++i) {
    if (points_[i].is_gait && (best == no_player || points_[i].weight > points_[best].weight)) best = i;
  }
  return best;
}

InStepPlayers::Players InStepPlayers::players(const EntityBuilder& build) const {
  Players players{};
  for (std::size_t i = 0; i < count_; ++i) players[i] = &build.as<Player>(players_.player(i));
  return players;
}

bool InStepPlayers::play_on(const EntityBuilder& build, const PlayingPoints& points) {
  const auto playing = std::span(points_).first(count_);
  if (!std::ranges::equal(points.all(), playing, {}, &PlayingPoint::point, &PlayingPoint::point)) return false;
  const Players own = players(build);
  const Stride before = stride(build, own);
  std::ranges::copy(points.all(), points_.begin());
  keep_step(build, own, before, points.cycles_per_second);
  players_.weigh(build, points.weights());
  return true;
}

bool InStepPlayers::play(const EntityBuilder& build, const PlayingPoints& points) {
  assert(points.count > 0);
  const Stride before = stride(build, players(build));
  const bool changed = take_players(build, points.all());
  keep_step(build, players(build), before, points.cycles_per_second);
  return players_.blend(build, points.weights()) || changed;
}

void InStepPlayers::keep_step(const EntityBuilder& build, const Players& players, const Stride& before,
                              double cycles_per_second) {
  next_update_ = never;
  for (std::size_t i = 0; i < count_; ++i) {
    players[i]->flags &= ~(Player::leads_step | Player::in_step);
    if (!points_[i].is_gait) build.set_speed(*players[i], 1.0);
  }
  const std::size_t old_leader = leader_;
  leader_ = choose_leader();
  if (leader_ == no_player) return;
  lead(build, *players[leader_], old_leader == leader_ ? Stride{} : before, cycles_per_second);
  const Stride now = stride(build, players);
  for (std::size_t i = 0; i < count_; ++i) {
    if (i != leader_ && points_[i].is_gait) follow(build, players, i, now);
  }
}

// Without a stride of `before` the leader goes on where it stands.
void InStepPlayers::lead(const EntityBuilder& build, Player& leader, const Stride& before,
                         double cycles_per_second) const {
  const MarkedClip clip = marked(build, points_[leader_].clip);
  build.set_speed(leader, std::clamp(cycles_per_second * to_seconds(clip.duration), -fastest, fastest));
  if (before.clip < 0) return;
  build.seek(leader, MarkerMap(marked(build, before.clip), clip).way(before.position).position(before.position));
}

void InStepPlayers::follow(const EntityBuilder& build, const Players& players, std::size_t place,
                           const Stride& leader) {
  const int clip = points_[place].clip;
  Step& step = steps_[place];
  if (step.leader != leader.clip || step.clip != clip || !step.way.holds(leader.position)) {
    const MarkerMap map(marked(build, leader.clip), marked(build, clip));
    step = {.leader = leader.clip, .clip = clip, .way = map.way(leader.position)};
  }
  Player &leading = *players[leader_], &player = *players[place];
  build.set_speed(player, std::clamp(step.way.rate * static_cast<double>(leading.speed) / 65536.0, -fastest, fastest));
  build.seek(player, step.way.position(leader.position));
  Ticks wait = in_step_for;
  if (step.way.has_markers) {
    leading.flags |= Player::leads_step;
    player.flags |= Player::in_step;
    if (leading.speed != 0) wait = std::min(wait, ticks_until_left(leader.position, step.way, leading.speed));
  }
  next_update_ = std::min(next_update_, build.now() + wait);
}

}  // namespace throng::anim
