#include "engine/anim/agent/agent_motion.h"

#include <algorithm>

#include "engine/anim/asset/data_keys.h"
#include "engine/anim/entity/ease_blender.h"
#include "engine/anim/entity/mixer.h"

namespace throng::anim {
namespace {

float fraction_at(const EaseBlender& blender, Ticks since_posed) {
  EaseBlender moved = blender;
  moved.state.delta_time += since_posed;
  advance_blender(moved);
  return moved.fraction;
}

// How the weight of a step is shared out among its sources. What a mask lays over some bones moves nothing.
void share(const EntityPools& pools, const PoseStep& step, Handle entity, Ticks since_posed, float weight,
           PoseWeights& weights) {
  if (step.source_count == 0) return;
  if (entity.pool() == EntityPools::ease_blenders) {
    const auto& blender = pools.as<EaseBlender>(entity);
    const float to = blender.mask == EaseBlender::no_mask ? fraction_at(blender, since_posed) : 0.0F;
    weights[step.sources[0]] += weight * (1.0F - to);
    weights[step.sources[1]] += weight * to;
  } else if (entity.pool() == EntityPools::mixers) {
    const MixerSources& mixed = mixer_sources(pools.block(entity), pools.layout(entity));
    float sum = 0.0F;
    for (std::size_t i = 0; i < step.source_count; ++i) sum += mixed.weights[i];
    for (std::size_t i = 0; i < step.source_count && sum > 0.0F; ++i) {
      weights[step.sources[i]] += weight * mixed.weights[i] / sum;
    }
  } else {
    weights[step.sources[0]] += weight;
  }
}

/// Returns the time within a clip at an unwrapped position.
Ticks time_within(Ticks duration, bool looping, FineTicks position) {
  const FineTicks length = duration * fine_ticks_per_tick;
  if (length <= 0) return 0;
  const FineTicks in_clip =
      looping ? position - whole_loops(position, length) * length : std::clamp<FineTicks>(position, 0, length);
  return in_clip / fine_ticks_per_tick;
}

bool is_player(Handle entity) {
  return entity.pool() == EntityPools::sampled_players || entity.pool() == EntityPools::keyframe_players;
}

}  // namespace

PoseWeights AgentMotion::weights(Ticks at) const {
  PoseWeights weights{};
  if (graph_->empty()) return weights;
  const std::vector<PoseStep>& steps = graph_->program->steps;
  weights[steps.size() - 1] = 1.0F;
  for (std::size_t i = steps.size(); i-- > 0;) {
    share(*pools_, steps[i], graph_->entities[i], at - posed_at_, weights[i], weights);
  }
  return weights;
}

template <typename Visit>
void AgentMotion::for_each_player(Ticks at, Visit&& visit) const {
  const PoseWeights shares = weights(at);
  for (std::size_t i = graph_->entities.size(); i-- > 0;) {
    if (!is_player(graph_->entities[i])) continue;
    const auto& player = pools_->as<Player>(graph_->entities[i]);
    visit(player, clips_[player.clip], shares[i]);
  }
}

FineTicks AgentMotion::position(const Player& player, Ticks at) const {
  const Ticks since = at - posed_at_ + player.state.delta_time;
  return unwrapped_position(player, clips_[player.clip].duration) + since * player.speed;
}

RootMotion AgentMotion::displacement(Ticks from, Ticks to) const {
  RootMotion sum;
  for_each_player(to, [&](const Player& player, const ClipStreams& clip, float weight) {
    if (clip.root_motion == nullptr || weight == 0.0F) return;
    const bool looping = (player.flags & Player::looping) != 0;
    const RootMotion one = anim::displacement(*clip.root_motion, position(player, from), position(player, to), looping);
    sum.translation += one.translation * static_cast<double>(weight);
    sum.yaw += one.yaw * static_cast<double>(weight);
  });
  return sum;
}

void AgentMotion::for_each_data_key(Ticks from, Ticks to, const std::function<void(const DataKeyEvent&)>& visit) const {
  for_each_player(to, [&](const Player& player, const ClipStreams& clip, float weight) {
    const FineTicks begin = position(player, from);
    anim::for_each_data_key(clip.data_keys, clip.duration, (player.flags & Player::looping) != 0, begin,
                            position(player, to), [&](const DataKey& key, FineTicks at) {
                              const Ticks since = player.speed == 0 ? 0 : (at - begin) / player.speed;
                              visit({.name = key.name, .clip = player.clip, .time = from + since, .weight = weight});
                              return true;
                            });
  });
}

bool AgentMotion::plays_morphs() const {
  return std::ranges::any_of(graph_->entities, [&](Handle entity) {
    return is_player(entity) && clips_[pools_->as<Player>(entity).clip].morphs != nullptr;
  });
}

bool AgentMotion::add_morph_weights(Ticks at, std::span<float> weights) const {
  if (!plays_morphs()) return false;
  for_each_player(at, [&](const Player& player, const ClipStreams& clip, float share) {
    if (clip.morphs == nullptr || share == 0.0F) return;
    const bool looping = (player.flags & Player::looping) != 0;
    anim::add_morph_weights(*clip.morphs, time_within(clip.duration, looping, position(player, at)), share, weights);
  });
  return true;
}

std::optional<AbsoluteRoot> AgentMotion::absolute_root(Ticks now) const {
  std::optional<AbsoluteRoot> root;
  float heaviest = 0.0F;
  for_each_player(now, [&](const Player& player, const ClipStreams& clip, float weight) {
    if ((player.state.flags & AnimationStateHeader::has_absolute_root) == 0 || weight <= heaviest) return;
    heaviest = weight;
    const double* const p = player.state.absolute_position;
    const float* const q = player.state.absolute_rotation;
    root = AbsoluteRoot{.position = {p[0], p[1], p[2]}, .rotation = {q[3], q[0], q[1], q[2]}};
    if (clip.root_motion == nullptr) return;
    const bool looping = (player.flags & Player::looping) != 0;
    const RootMotion moved = anim::displacement(*clip.root_motion, 0, position(player, now), looping);
    root->position += glm::dquat(root->rotation) * moved.translation;
    root->rotation = root->rotation * glm::angleAxis(static_cast<float>(moved.yaw), glm::vec3(0.0F, 1.0F, 0.0F));
  });
  return root;
}

}  // namespace throng::anim
