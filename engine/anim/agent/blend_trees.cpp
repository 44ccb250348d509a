#include "engine/anim/agent/blend_trees.h"

#include <cassert>
#include <cmath>
#include <limits>

#include "engine/anim/entity/ease_blender.h"

namespace throng::anim {
namespace {

constexpr Ticks never = std::numeric_limits<Ticks>::max();

constexpr std::size_t player_place(std::size_t player) { return player == 0 ? 0 : 2 * player - 1; }
constexpr std::size_t player_count(const BlendTree& tree) { return (tree.count + 1U) / 2U; }

}  // namespace

void BlendTrees::resize(std::uint32_t agents) {
  for (std::size_t i = agents; i < agents_.size(); ++i) {
    for (const Handle entity : agents_[i].tree.all()) pools_->destroy(entity);
  }
  const std::size_t before = agents_.size();
  agents_.resize(agents);
  for (std::size_t i = before; i < agents; ++i) agents_[i].program.steps.reserve(usual_steps);
  pools_->pool(EntityPools::ease_blenders).reserve(agents);
}

EntityPools::Kind BlendTrees::player_kind(std::uint32_t clip, StreamKind stream) const {
  const bool sampled = stream == StreamKind::sampled && clips_[clip].sampled != nullptr;
  return sampled ? EntityPools::sampled_players : EntityPools::keyframe_players;
}

bool BlendTrees::play(std::uint32_t agent_index, const PlayRequest& request, StreamKind stream, Ticks now,
                      Ticks posed_at) {
  Agent& agent = agents_[agent_index];
  BlendTree& tree = agent.tree;
  const Ticks lead = posed_at - now;  // the new entities start as far from now as the old ones stand
  const bool stays = request.held_fraction.has_value() || request.mask != PlayRequest::no_mask;
  if (tree.count == 0 || (request.fade <= 0 && !stays)) {
    for (const Handle entity : tree.all()) pools_->destroy(entity);
    tree.entities[0] = make_player(agent_index, request, stream, lead);
    tree.count = 1;
    compile(agent_index);
    return true;
  }
  if (player_count(tree) == BlendTree::max_players) return false;
  const Handle from = tree.root();
  const Handle to = make_player(agent_index, request, stream, lead);
  agent.fade_end[player_count(tree)] = stays ? never : now + request.fade;
  tree.entities[tree.count++] = to;
  tree.entities[tree.count++] = make_blender(agent_index, request, from, to, lead);
  compile(agent_index);
  return true;
}

void BlendTrees::compile(std::uint32_t agent) {
  [[maybe_unused]] const Status compiled =
      compile_program(*pools_, agents_[agent].tree.root(), agent, agents_[agent].program);
  assert(compiled && "a blend tree is a tree of its agent's own entities");
}

void BlendTrees::recompile() {
  for (std::uint32_t agent = 0; agent < agent_count(); ++agent) {
    if (agents_[agent].tree.count > 0) compile(agent);
  }
}

Handle BlendTrees::make_player(std::uint32_t agent, const PlayRequest& request, StreamKind stream, Ticks lead) {
  const auto clip = static_cast<std::uint32_t>(request.clip);
  const Handle handle = pools_->create(player_kind(clip, stream));
  auto& player = pools_->as<Player>(handle);
  player.state.owner = agent;
  player.clip = clip;
  player.speed = static_cast<std::int32_t>(std::lround(request.speed * 65536.0));
  player.flags = request.loop ? Player::looping : 0;
  player.position = request.start * fine_ticks_per_tick + lead * player.speed;
  return handle;
}

Handle BlendTrees::make_blender(std::uint32_t agent, const PlayRequest& request, Handle from, Handle to, Ticks lead) {
  const Handle handle = pools_->create(EntityPools::ease_blenders);
  auto& blender = pools_->as<EaseBlender>(handle);
  blender.state.owner = agent;
  blender.from = from;
  blender.to = to;
  blender.elapsed = lead;
  blender.total = request.fade;
  blender.mask = static_cast<std::int16_t>(request.mask);
  blender.flags = request.held_fraction ? EaseBlender::held : 0;
  blender.fraction = request.held_fraction.value_or(0.0F);
  return handle;
}

void BlendTrees::end_fades(std::uint32_t agent_index, Ticks time) {
  Agent& agent = agents_[agent_index];
  BlendTree& tree = agent.tree;
  if (tree.count == 0) return;
  std::size_t over = player_count(tree);
  while (--over > 0 && agent.fade_end[over] > time) {
  }
  if (over == 0) return;
  const std::size_t kept = player_place(over);
  for (std::size_t i = 0; i < kept; ++i) pools_->destroy(tree.entities[i]);
  pools_->destroy(tree.entities[kept + 1]);
  BlendTree shorter;
  shorter.entities[shorter.count++] = tree.entities[kept];
  for (std::size_t i = kept + 2; i < tree.count; ++i) shorter.entities[shorter.count++] = tree.entities[i];
  for (std::size_t i = 1; i < player_count(shorter); ++i) agent.fade_end[i] = agent.fade_end[over + i];
  if (shorter.count > 1) pools_->as<EaseBlender>(shorter.entities[2]).from = shorter.entities[0];
  tree = shorter;
  compile(agent_index);
}

void BlendTrees::set_stream(StreamKind stream) {
  for (Agent& agent : agents_) {
    for (std::size_t i = 0; i < player_count(agent.tree) && agent.tree.count > 0; ++i) {
      move_player(agent, player_place(i), stream);
    }
  }
  recompile();
}

void BlendTrees::move_player(Agent& agent, std::size_t place, StreamKind stream) {
  const Handle old_handle = agent.tree.entities[place];
  const EntityPools::Kind kind = player_kind(pools_->as<Player>(old_handle).clip, stream);
  if (kind == old_handle.pool()) return;
  const Handle new_handle = pools_->create(kind);
  auto& player = pools_->as<Player>(new_handle);
  const AnimationStateHeader header = player.state;
  player = pools_->as<Player>(old_handle);
  player.state.type = header.type;
  player.state.total_size = header.total_size;
  player.state.transforms_offset = header.transforms_offset;
  player.cursor = {};
  pools_->destroy(old_handle);
  agent.tree.entities[place] = new_handle;
  if (place > 0) pools_->as<EaseBlender>(agent.tree.entities[place + 1]).to = new_handle;
  if (place == 0 && agent.tree.count > 1) pools_->as<EaseBlender>(agent.tree.entities[2]).from = new_handle;
}

}  // namespace throng::anim
