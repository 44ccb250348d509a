#include "engine/anim/agent/agent_graphs.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace throng::anim {
namespace {

/// A pose, [packet][components][16], whose bones move to other places.
void reorder_lanes(std::span<const int> places, int components, float* pose) {
  const auto lane = [&](int bone, int component) {
    const int packet = bone / packet_bones;
    const int index = (packet * components + component) * packet_bones + bone % packet_bones;
    return static_cast<std::size_t>(index);
  };
  const std::size_t floats = pose_bytes(static_cast<int>(places.size()), components) / sizeof(float);
  const std::vector<float> before(pose, pose + floats);
  for (int bone = 0; bone < static_cast<int>(places.size()); ++bone) {
    for (int component = 0; component < components; ++component) {
      pose[lane(places[static_cast<std::size_t>(bone)], component)] = before[lane(bone, component)];
    }
  }
}

constexpr std::size_t usual_steps = 6;      // a fade that was interrupted, and feet
constexpr std::size_t usual_processes = 2;  // feet and a rag-doll

}  // namespace

void AgentGraphs::resize(std::uint32_t count) {
  for (std::size_t i = count; i < agents_.size(); ++i) destroy(agents_[i]);
  const std::size_t before = agents_.size();
  agents_.resize(count);
  graphs_.resize(count);
  for (std::size_t i = before; i < agents_.size(); ++i) {
    graphs_[i].entities.reserve(usual_steps);
    agents_[i].processes.reserve(usual_processes);
  }
  next_updates_.resize(count, never);
}

void AgentGraphs::destroy(Agent& agent) const {
  const EntityBuilder build(*pools_, {}, {});
  for (const Layer& layer : agent.layers) {
    layer.channel->destroy_entities(build);
    if (layer.blender.valid()) pools_->destroy(layer.blender);
  }
  for (const auto& process : agent.processes) process->destroy_entities(build);
}

Status AgentGraphs::add_channel(const EntityBuilder& build, std::uint32_t agent, std::unique_ptr<Channel> channel,
                                const LayerSettings& settings) {
  agents_[agent].layers.push_back({.channel = std::move(channel), .settings = settings, .blender = {}});
  return update(build, agent);
}

Status AgentGraphs::add_post_process(const EntityBuilder& build, std::uint32_t agent,
                                     std::unique_ptr<PostProcess> process) {
  agents_[agent].processes.push_back(std::move(process));
  return rebuild(build, agent);
}

void AgentGraphs::remove_channel(const EntityBuilder& build, std::uint32_t agent, std::size_t index) {
  std::vector<Layer>& layers = agents_[agent].layers;
  const auto layer = layers.begin() + static_cast<std::ptrdiff_t>(index);
  layer->channel->destroy_entities(build);
  if (layer->blender.valid()) build.destroy(layer->blender);
  layers.erase(layer);
  [[maybe_unused]] const Status rebuilt = rebuild(build, agent);
  assert(rebuilt && "fewer entities make no cycle");
}

void AgentGraphs::remove_post_processes(const EntityBuilder& build, std::uint32_t agent, std::size_t kept) {
  std::vector<std::unique_ptr<PostProcess>>& processes = agents_[agent].processes;
  for (std::size_t i = kept; i < processes.size(); ++i) processes[i]->destroy_entities(build);
  processes.resize(kept);
  [[maybe_unused]] const Status rebuilt = rebuild(build, agent);
  assert(rebuilt && "fewer entities make no cycle");
}

std::unique_ptr<PostProcess> AgentGraphs::take_last_post_process(const EntityBuilder& build, std::uint32_t agent) {
  std::unique_ptr<PostProcess> last = std::move(agents_[agent].processes.back());
  agents_[agent].processes.pop_back();
  last->destroy_entities(build);
  [[maybe_unused]] const Status rebuilt = rebuild(build, agent);
  assert(rebuilt && "fewer entities make no cycle");
  return last;
}

void AgentGraphs::set_weight(std::uint32_t agent, std::size_t channel, float weight) {
  Layer& layer = agents_[agent].layers[channel];
  layer.settings.weight = weight;
  if (layer.blender.valid()) pools_->as<EaseBlender>(layer.blender).fraction = weight;
}

Status AgentGraphs::update(const EntityBuilder& build, std::uint32_t agent) {
  bool changed = graphs_[agent].empty();
  for (const Layer& layer : agents_[agent].layers) changed = layer.channel->update(build) || changed;
  for (const auto& process : agents_[agent].processes) changed = process->update(build) || changed;
  if (changed) return rebuild(build, agent);
  find_next_update(agent);
  return Done{};
}

Status AgentGraphs::update_post_process(const EntityBuilder& build, std::uint32_t agent, std::size_t index) {
  if (agents_[agent].processes[index]->update(build)) return rebuild(build, agent);
  find_next_update(agent);
  return Done{};
}

void AgentGraphs::find_next_update(std::uint32_t agent) {
  Ticks next = never;
  for (const Layer& layer : agents_[agent].layers) next = std::min(next, layer.channel->next_update());
  for (const auto& process : agents_[agent].processes) next = std::min(next, process->next_update());
  next_updates_[agent] = next;
}

// A layer whose channel plays nothing leaves what is below as it is.
Handle AgentGraphs::lay(const EntityBuilder& build, Layer& layer, Handle below) const {
  const Handle state = layer.channel->state();
  if (!state.valid() || !below.valid()) {
    if (layer.blender.valid()) build.destroy(std::exchange(layer.blender, {}));
    return state.valid() ? state : below;
  }
  if (!layer.blender.valid()) layer.blender = build.hold(below, state, layer.settings.weight, layer.settings.mask);
  auto& blender = build.as<EaseBlender>(layer.blender);
  blender.from = below;
  blender.to = state;
  return layer.blender;
}

Status AgentGraphs::rebuild(const EntityBuilder& build, std::uint32_t agent_index) {
  Agent& agent = agents_[agent_index];
  Handle root;
  find_next_update(agent_index);
  for (Layer& layer : agent.layers) root = lay(build, layer, root);
  if (!root.valid()) {
    graphs_[agent_index].clear();
    return Done{};
  }
  for (const auto& process : agent.processes) root = process->attach(build, root);
  PoseGraph& graph = graphs_[agent_index];
  Status compiled = compile_graph(*pools_, root, owners_ | agent_index, *programs_, graph);
  if (!compiled && !all_alive(graph)) graph.clear();
  return compiled;
}

bool AgentGraphs::all_alive(const PoseGraph& graph) const {
  return std::ranges::all_of(graph.entities, [&](Handle entity) { return pools_->alive(entity); });
}

void AgentGraphs::recompile() {
  for (std::uint32_t agent = 0; agent < count(); ++agent) {
    PoseGraph& graph = graphs_[agent];
    if (graph.empty()) continue;
    [[maybe_unused]] const Status compiled = compile_graph(*pools_, graph.root(), owners_ | agent, *programs_, graph);
    assert(compiled && "it did before");
  }
}

void AgentGraphs::restart_keyframes() {
  for (Agent& agent : agents_) {
    visit_handles(agent, [&](Handle& handle) {
      if (handle.pool() == EntityPools::keyframe_players) pools_->as<Player>(handle).cursor = {};
    });
  }
}

void AgentGraphs::reorder_kept_transforms(std::span<const int> places) {
  for (Agent& agent : agents_) {
    visit_handles(agent, [&](Handle& handle) {
      if (!pools_->layout(handle).kind->keeps_transforms) return;
      auto& state = pools_->as<AnimationStateHeader>(handle);
      reorder_lanes(places, state.components, transforms_of(state));
    });
  }
}

void AgentGraphs::visit_handles(Agent& agent, const std::function<void(Handle&)>& visit) const {
  for (Layer& layer : agent.layers) {
    layer.channel->visit_handles(visit);
    if (layer.blender.valid()) visit(layer.blender);
  }
  for (const auto& process : agent.processes) process->visit_handles(visit);
}

void AgentGraphs::restream(const EntityBuilder& build, std::uint32_t agent_index) {
  Agent& agent = agents_[agent_index];
  std::vector<std::pair<Handle, Handle>> renamed;
  visit_handles(agent, [&](Handle& handle) {
    if (handle.pool() != EntityPools::sampled_players && handle.pool() != EntityPools::keyframe_players) return;
    const EntityPools::Kind kind = build.player_kind(build.as<Player>(handle).clip);
    if (kind == handle.pool()) return;
    const Handle moved = build.create(kind);
    auto& player = build.as<Player>(moved);
    const AnimationStateHeader header = player.state;
    player = build.as<Player>(handle);
    player.state.type = header.type;
    player.state.total_size = header.total_size;
    player.state.transforms_offset = header.transforms_offset;
    player.cursor = {};
    renamed.emplace_back(handle, moved);
    handle = moved;
  });
  if (renamed.empty()) return;
  const auto rename = [&](Handle& handle) {
    for (const auto& [from, to] : renamed) {
      if (handle == from) handle = to;
    }
  };
  visit_handles(agent, [&](Handle& handle) {
    for (Handle& source : pools_->sources(handle)) rename(source);
  });
  for (Handle& entity : graphs_[agent_index].entities) rename(entity);
  for (const auto& [from, to] : renamed) build.destroy(from);
}

StoreNeeds AgentGraphs::largest_needs() const {
  StoreNeeds needs;
  for (const PoseGraph& graph : graphs_) needs.widen(graph.program->needs);
  return needs;
}

AgentGraphs AgentGraphs::clone() const {
  AgentGraphs copy(*pools_, *programs_, owners_);
  copy.next_updates_ = next_updates_;
  copy.graphs_ = graphs_;
  copy.agents_.reserve(agents_.size());
  for (const Agent& agent : agents_) {
    Agent& other = copy.agents_.emplace_back();
    for (const Layer& layer : agent.layers) {
      other.layers.push_back({.channel = layer.channel->clone(), .settings = layer.settings, .blender = layer.blender});
    }
    for (const auto& process : agent.processes) other.processes.push_back(process->clone());
  }
  return copy;
}

std::size_t AgentGraphs::bytes() const {
  std::size_t bytes = agents_.capacity() * sizeof(Agent) + graphs_.capacity() * sizeof(PoseGraph) +
                      next_updates_.capacity() * sizeof(Ticks);
  for (const Agent& agent : agents_) {
    bytes += agent.layers.capacity() * sizeof(Layer) + agent.processes.capacity() * sizeof(void*);
  }
  for (const PoseGraph& graph : graphs_) bytes += graph.entities.capacity() * sizeof(Handle);
  return bytes;
}

}  // namespace throng::anim
