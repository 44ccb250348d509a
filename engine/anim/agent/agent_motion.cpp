#include "engine/anim/agent/agent_motion.h"

#include <algorithm>
#include <cassert>

#include "engine/anim/asset/data_keys.h"
#include "engine/anim/entity/additive_layer.h"
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

constexpr int no_bone = -1;

/// Says how a step's weight is shared out among its sources: at a bone, or, with no_bone, of the agent's motion, which
/// knows no masks.
struct Sharing {
  const EntityPools& pools;
  std::span<const float* const> masks;
  int bone;
  Ticks since_posed;

  float mask_weight(std::int16_t mask) const {
    return mask == EaseBlender::no_mask ? 1.0F : masks[static_cast<std::size_t>(mask)][bone];
  }
  // A blend under a mask moves some bones and not the agent.
  float fraction(const EaseBlender& blender) const {
    if (bone == no_bone && blender.mask != EaseBlender::no_mask) return 0.0F;
    return fraction_at(blender, since_posed) * mask_weight(blender.mask);
  }
};

void share_mixed(const Sharing& sharing, const PoseStep& step, Handle entity, float weight, PoseWeights& weights) {
  const auto& mixer = sharing.pools.as<Mixer>(entity);
  const MixerSources& mixed = mixer_sources(sharing.pools.block(entity), sharing.pools.layout(entity));
  const auto own = [&](std::size_t i) {
    return sharing.bone == no_bone ? mixed.weights[i] : mixed.weights[i] * sharing.mask_weight(mixer.masks[i]);
  };
  float sum = 0.0F;
  for (std::size_t i = 0; i < step.source_count; ++i) sum += own(i);
  for (std::size_t i = 0; i < step.source_count && sum > 0.0F; ++i) weights[step.sources[i]] += weight * own(i) / sum;
}

void share(const Sharing& sharing, const PoseStep& step, Handle entity, float weight, PoseWeights& weights) {
  if (step.source_count == 0) return;
  if (entity.pool() == EntityPools::ease_blenders) {
    const float to = sharing.fraction(sharing.pools.as<EaseBlender>(entity));
    weights[step.sources[0]] += weight * (1.0F - to);
    weights[step.sources[1]] += weight * to;
  } else if (entity.pool() == EntityPools::mixers) {
    share_mixed(sharing, step, entity, weight, weights);
  } else {
    weights[step.sources[0]] += weight;
    if (entity.pool() != EntityPools::additive_layers || sharing.bone == no_bone) return;
    const auto& layer = sharing.pools.as<AdditiveLayer>(entity);
    const float added = weight * layer.weight * sharing.mask_weight(layer.mask);
    weights[step.sources[1]] += added;
    weights[step.sources[2]] -= added;
  }
}

/// Returns the time within a clip at an unwrapped position.
Ticks time_within(Ticks duration, bool looping, FineTicks position) {
  const FineTicks length = duration * fine_ticks_per_tick;
  if (length <= 0) return Ticks{};
  const FineTicks in_clip =
      looping ? position - whole_loops(position, length) * length : std::clamp<FineTicks>(position, 0, length);
  return in_clip / fine_ticks_per_tick;
}

bool is_player(Handle entity) {
  return entity.pool() == EntityPools::sampled_players || entity.pool() == EntityPools::keyframe_players;
}

}  // namespace

PoseWeights AgentMotion::weights(Ticks at) const { return weights_at_bone(at, no_bone); }

PoseWeights AgentMotion::weights_at_bone(Ticks at, int bone) const {
  PoseWeights weights{};
  if (graph_->empty()) return weights;
  const std::vector<PoseStep>& steps = graph_->program->steps;
  weights[steps.size() - 1] = 1.0F;
  const Sharing sharing{.pools = *pools_, .masks = morphs_.masks, .bone = bone, .since_posed = at - posed_at_};
  for (std::size_t i = steps.size(); i-- > 0;) share(sharing, steps[i], graph_->entities[i], weights[i], weights);
  return weights;
}

template <typename Visit>
void AgentMotion::for_each_player(const PoseWeights& shares, Visit&& visit) const {
  for (std::size_t i = graph_->entities.size(); i-- > 0;) {
    if (!is_player(graph_->entities[i])) continue;
    const auto& player = pools_->as<Player>(graph_->entities[i]);
    visit(player, clips_[player.clip], shares[i]);
  }
}

FineTicks AgentMotion::position(const Player& player, Ticks at) const {
  const Ticks since = at - posed_at_ + player.state.delta_time;
  return unwrapped_position(player, clips_[player.clip].duration) + since.count() * player.speed;
}

RootMotion AgentMotion::displacement(Ticks from, Ticks to) const {
  RootMotion sum;
  for_each_player(weights(to), [&](const Player& player, const ClipStreams& clip, float weight) {
    if (clip.root_motion == nullptr || weight == 0.0F) return;
    const bool looping = (player.flags & Player::looping) != 0;
    const RootMotion one = anim::displacement(*clip.root_motion, position(player, from), position(player, to), looping);
    sum.translation += one.translation * static_cast<double>(weight);
    sum.yaw += one.yaw * static_cast<double>(weight);
  });
  return sum;
}

void AgentMotion::for_each_data_key(Ticks from, Ticks to, const std::function<void(const DataKeyEvent&)>& visit) const {
  for_each_player(weights(to), [&](const Player& player, const ClipStreams& clip, float weight) {
    const FineTicks begin = position(player, from);
    anim::for_each_data_key(clip.data_keys, clip.duration, (player.flags & Player::looping) != 0, begin,
                            position(player, to), [&](const DataKey& key, FineTicks at) {
                              const Ticks since{player.speed == 0 ? 0 : (at - begin) / player.speed};
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
    for_each_player(weights_at_bone(at, bone), [&](const Player& player, const ClipStreams& clip, float share) {
      if (clip.morphs == nullptr || share == 0.0F) return;
      const bool looping = (player.flags & Player::looping) != 0;
      const Ticks time = time_within(clip.duration, looping, position(player, at));
      anim::add_morph_weights(*clip.morphs, time, share, weights.subspan(first, end - first),
                              static_cast<std::uint32_t>(first));
    });
  }
  return true;
}

std::optional<AbsoluteRoot> AgentMotion::absolute_root(Ticks now) const {
  std::optional<AbsoluteRoot> root;
  float heaviest = 0.0F;
  for_each_player(weights(now), [&](const Player& player, const ClipStreams& clip, float weight) {
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
