#include <algorithm>
#include <cstdlib>

#include "engine/anim/agent/agent_motion.h"
#include "engine/anim/asset/data_keys.h"

namespace throng::anim {
namespace {

bool has_key(const ClipStreams& clip, std::uint32_t name) {
  return std::ranges::find(clip.data_keys, name, &DataKey::name) != clip.data_keys.end();
}

bool reads(const PoseStep& step, std::size_t source) {
  const auto end = step.sources.begin() + step.source_count;
  return std::find(step.sources.begin(), end, source) != end;
}

}  // namespace

// The leader is blended by the same entity.
std::optional<std::size_t> AgentMotion::leader_of(std::size_t step) const {
  if ((player(step).flags & Player::in_step) == 0) return std::nullopt;
  for (const PoseStep& reader : graph_->program->steps) {
    if (!reads(reader, step)) continue;
    for (std::size_t i = 0; i < reader.source_count; ++i) {
      const std::size_t other = reader.sources[i];
      if (is_player(other) && (player(other).flags & Player::leads_step) != 0) return other;
    }
  }
  return std::nullopt;
}

// The leader speaks for the players that follow it.
float AgentMotion::weight_of_key(std::size_t step, std::uint32_t name, const PoseWeights& felt) const {
  float weight = felt[step];
  if ((player(step).flags & Player::leads_step) == 0) return std::min(weight, 1.0F);
  for_each_player([&](std::size_t other, const Player&, const ClipStreams& clip) {
    if (leader_of(other) == step && has_key(clip, name)) weight += felt[other];
  });
  return std::min(weight, 1.0F);
}

// Gaits in step are one: the leader, with the weight of all.
std::size_t AgentMotion::heaviest_player(const PoseWeights& felt) const {
  PoseWeights sums = felt;
  for_each_player([&](std::size_t step, const Player&, const ClipStreams&) {
    const std::optional<std::size_t> leader = leader_of(step);
    if (!leader) return;
    sums[*leader] += felt[step];
    sums[step] = 0.0F;
  });
  std::size_t best = felt.size();
  for_each_player([&](std::size_t step, const Player&, const ClipStreams&) {
    if (best == felt.size() || sums[step] > sums[best]) best = step;
  });
  return best;
}

void AgentMotion::visit_data_keys(std::size_t step, Ticks from, Ticks to,
                                  const std::function<void(const DataKey&, Ticks)>& visit) const {
  const Player& own = player(step);
  const ClipStreams& clip = clips_[own.clip];
  const FineTicks begin = position(own, from);
  anim::for_each_data_key(clip.data_keys, clip.duration, (own.flags & Player::looping) != 0, begin, position(own, to),
                          [&](const DataKey& key, FineTicks at) {
                            visit(key, from + Ticks{own.speed == 0 ? 0 : (at - begin) / own.speed});
                            return true;
                          });
}

void AgentMotion::for_each_data_key(Ticks from, Ticks to, const std::function<void(const DataKeyEvent&)>& visit,
                                    KeyChoice choice) const {
  const PoseWeights felt = sharing(to).weights(PoseSharing::Part::anywhere);
  const std::size_t heaviest = choice == KeyChoice::heaviest ? heaviest_player(felt) : felt.size();
  for_each_player([&](std::size_t step, const Player& own, const ClipStreams& clip) {
    if (clip.data_keys.empty() || (choice == KeyChoice::heaviest && step != heaviest)) return;
    const std::optional<std::size_t> leader = leader_of(step);
    visit_data_keys(step, from, to, [&](const DataKey& key, Ticks time) {
      if (leader && has_key(clips_[player(*leader).clip], key.name)) return;
      const float weight = weight_of_key(step, key.name, felt);
      if (weight <= 0.0F && choice == KeyChoice::felt) return;
      visit({.name = key.name, .clip = own.clip, .time = time, .weight = weight});
    });
  });
}

void AgentMotion::for_each_end(Ticks from, Ticks to, const std::function<void(const ClipEnd&)>& visit) const {
  const PoseWeights felt = sharing(to).weights(PoseSharing::Part::anywhere);
  for_each_player([&](std::size_t step, const Player& own, const ClipStreams& clip) {
    if ((own.flags & Player::looping) != 0 || own.speed == 0) return;
    const FineTicks end = own.speed > 0 ? clip.duration * fine_ticks_per_tick : 0;
    const FineTicks left = std::abs(end - position(own, from));
    const bool is_before = own.speed > 0 ? position(own, from) < end : position(own, from) > end;
    const bool arrives = own.speed > 0 ? position(own, to) >= end : position(own, to) <= end;
    if (!is_before || !arrives) return;
    const FineTicks speed = std::abs(FineTicks{own.speed});
    visit({.clip = own.clip, .time = from + Ticks{(left + speed - 1) / speed}, .weight = std::min(felt[step], 1.0F)});
  });
}

}  // namespace throng::anim
