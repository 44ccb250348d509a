#include "engine/anim/agent/agent_graphs.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "engine/anim/base/room.h"
#include "engine/anim/entity/reorder_lanes.h"

namespace throng::anim {
namespace {

template <typename Part>
OwnedPart<Part> copy_of(const OwnedPart<Part>& own) {
  return {.part = own.part->clone(), .type = own.type, .id = own.id};
}

constexpr std::size_t usual_steps = 6;      // a fade that was interrupted, and feet
constexpr std::size_t usual_processes = 2;  // feet and a rag-doll

}  // namespace

std::uint32_t AgentGraphs::add() {
  if (!free_.empty()) {
    const std::uint32_t again = free_.back();
    free_.pop_back();
    return again;
  }
  agents_.emplace_back().processes.reserve(usual_processes);
  graphs_.emplace_back().entities.reserve(usual_steps);
  next_updates_.push_back(never);
  newest_players_.emplace_back();
  return count() - 1;
}

void AgentGraphs::remove(std::uint32_t agent) {
  destroy(agents_[agent]);
  graphs_[agent].clear();
  next_updates_[agent] = never;
  newest_players_[agent] = {};
  free_.push_back(agent);
}

void AgentGraphs::make_room(std::uint32_t agents) {
  const std::size_t fresh = agents > free_.size() ? agents - free_.size() : 0;
  anim::make_room(agents_, agents_.size() + fresh);
  anim::make_room(graphs_, graphs_.size() + fresh);
  anim::make_room(next_updates_, next_updates_.size() + fresh);
  anim::make_room(newest_players_, newest_players_.size() + fresh);
  free_.reserve(agents_.capacity());
  spare_channels_.reserve(agents_.capacity());
}

std::unique_ptr<CrossFadeChannel> AgentGraphs::take_cross_fade_channel() {
  if (spare_channels_.empty()) return std::make_unique<CrossFadeChannel>();
  std::unique_ptr<CrossFadeChannel> spare = std::move(spare_channels_.back());
  spare_channels_.pop_back();
  return spare;
}

// The vectors keep their memory for the next agent of this number.
void AgentGraphs::destroy(Agent& agent) {
  const EntityBuilder build(*pools_, {}, {});
  for (Layer& layer : agent.layers) {
    layer.own.part->destroy_entities(build);
    if (layer.blender.valid()) pools_->destroy(layer.blender);
    if (layer.own.type != type_tag<CrossFadeChannel>()) continue;
    spare_channels_.emplace_back(static_cast<CrossFadeChannel*>(layer.own.part.release()));
  }
  for (const OwnedProcess& process : agent.processes) process.part->destroy_entities(build);
  agent.layers.clear();
  agent.processes.clear();
}

std::optional<std::size_t> AgentGraphs::place(std::uint32_t agent, ChannelId channel) const {
  const std::vector<Layer>& layers = agents_[agent].layers;
  for (std::size_t place = 0; place < layers.size(); ++place) {
    if (layers[place].own.id == channel.number) return place;
  }
  return std::nullopt;
}

std::optional<std::size_t> AgentGraphs::place(std::uint32_t agent, ProcessId process) const {
  const std::vector<OwnedProcess>& processes = agents_[agent].processes;
  for (std::size_t place = 0; place < processes.size(); ++place) {
    if (processes[place].id == process.number) return place;
  }
  return std::nullopt;
}

Status AgentGraphs::add_channel(const EntityBuilder& build, std::uint32_t agent, std::unique_ptr<Channel> channel,
                                TypeTag type, const LayerSettings& settings) {
  Agent& owner = agents_[agent];
  owner.layers.push_back({.own = {.part = std::move(channel), .type = type, .id = owner.channels_given++},
                          .settings = settings,
                          .blender = {}});
  return update(build, agent) ? Status(Done{}) : rebuild(build, agent);
}

Status AgentGraphs::add_post_process(const EntityBuilder& build, std::uint32_t agent,
                                     std::unique_ptr<PostProcess> process, TypeTag type) {
  Agent& owner = agents_[agent];
  owner.processes.push_back({.part = std::move(process), .type = type, .id = owner.processes_given++});
  return rebuild(build, agent);
}

void AgentGraphs::remove_channel(const EntityBuilder& build, std::uint32_t agent, std::size_t place) {
  std::vector<Layer>& layers = agents_[agent].layers;
  const auto layer = layers.begin() + static_cast<std::ptrdiff_t>(place);
  layer->own.part->destroy_entities(build);
  if (layer->blender.valid()) build.destroy(layer->blender);
  layers.erase(layer);
  rebuild_with_less(build, agent);
}

std::unique_ptr<PostProcess> AgentGraphs::take_post_process(const EntityBuilder& build, std::uint32_t agent,
                                                            std::size_t place) {
  std::vector<OwnedProcess>& processes = agents_[agent].processes;
  std::unique_ptr<PostProcess> taken = std::move(processes[place].part);
  processes.erase(processes.begin() + static_cast<std::ptrdiff_t>(place));
  taken->destroy_entities(build);
  rebuild_with_less(build, agent);
  return taken;
}

void AgentGraphs::rebuild_with_less(const EntityBuilder& build, std::uint32_t agent) {
  [[maybe_unused]] const Status rebuilt = rebuild(build, agent);
  assert(rebuilt && "fewer entities make no cycle");
}

void AgentGraphs::set_weight(const EntityBuilder& build, std::uint32_t agent, std::size_t channel, float weight,
                             Ticks fade) {
  Layer& layer = agents_[agent].layers[channel];
  const LinearWeight before{.target = layer.settings.weight, .per_second = layer.weight_per_second};
  const float now = layer.faded_at == never ? before.target : value(before, build.now() - layer.faded_at);
  layer.settings.weight = weight;
  layer.faded_at = fade > Ticks{} ? build.now() + fade : never;
  layer.weight_per_second = fade > Ticks{} ? (weight - now) / static_cast<float>(to_seconds(fade)) : 0.0F;
  if (layer.blender.valid()) write_weight(build, layer);
  find_next_update(agent);
}

void AgentGraphs::write_weight(const EntityBuilder& build, const Layer& layer) {
  auto& blender = build.as<EaseBlender>(layer.blender);
  const bool fades = layer.faded_at != never;
  blender.flags = fades ? EaseBlender::linear : EaseBlender::held;
  blender.fraction = layer.settings.weight;
  if (!fades) return;
  blender.weight = {.target = layer.settings.weight, .per_second = layer.weight_per_second};
  blender.elapsed = build.now() + build.lead() - layer.faded_at;
}

void AgentGraphs::end_fade(const EntityBuilder& build, Layer& layer) {
  if (layer.faded_at > build.now()) return;
  layer.faded_at = never;
  if (layer.blender.valid()) write_weight(build, layer);
}

bool AgentGraphs::update(const EntityBuilder& build, std::uint32_t agent) {
  bool changed = graphs_[agent].empty();
  for (Layer& layer : agents_[agent].layers) end_fade(build, layer);
  for (const Layer& layer : agents_[agent].layers) changed = layer.own.part->update(build) || changed;
  for (const OwnedProcess& process : agents_[agent].processes) changed = process.part->update(build) || changed;
  if (!changed) find_next_update(agent);
  return !changed;
}

void AgentGraphs::find_next_update(std::uint32_t agent) {
  Ticks next = never;
  for (const Layer& layer : agents_[agent].layers)
    next = std::min({next, layer.own.part->next_update(), layer.faded_at});
  for (const OwnedProcess& process : agents_[agent].processes) next = std::min(next, process.part->next_update());
  next_updates_[agent] = next;
}

void AgentGraphs::find_newest_player(std::uint32_t agent) {
  const std::vector<Layer>& layers = agents_[agent].layers;
  const bool fades = !layers.empty() && layers.front().own.type == type_tag<CrossFadeChannel>();
  newest_players_[agent] =
      fades ? static_cast<const CrossFadeChannel&>(*layers.front().own.part).newest_player() : Handle{};
}

// A layer whose channel plays nothing leaves what is below as it is.
Handle AgentGraphs::lay(const EntityBuilder& build, Layer& layer, Handle below) const {
  layer.own.part->lie_over(build, below);
  const Handle state = layer.own.part->state();
  if (!state.valid() || !below.valid()) {
    if (layer.blender.valid()) build.destroy(std::exchange(layer.blender, {}));
    return state.valid() ? state : below;
  }
  if (!layer.blender.valid()) {
    layer.blender = build.hold(below, state, layer.settings.weight, layer.settings.mask);
    write_weight(build, layer);
  }
  auto& blender = build.as<EaseBlender>(layer.blender);
  blender.from = below;
  blender.to = state;
  return layer.blender;
}

Status AgentGraphs::rebuild(const EntityBuilder& build, std::uint32_t agent_index, Fades fades) {
  Agent& agent = agents_[agent_index];
  Handle root;
  if (fades == Fades::are_cut) {
    for (const Layer& layer : agent.layers) layer.own.part->cut_fades(build);
  }
  find_next_update(agent_index);
  find_newest_player(agent_index);
  for (Layer& layer : agent.layers) root = lay(build, layer, root);
  if (!root.valid()) {
    graphs_[agent_index].clear();
    return Done{};
  }
  for (const OwnedProcess& process : agent.processes) root = process.part->attach(build, root);
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

void AgentGraphs::reorder_bones(std::span<const int> places) {
  for (Agent& agent : agents_) {
    visit_handles(agent, [&](Handle& handle) {
      const EntityLayout& layout = pools_->layout(handle);
      auto& state = pools_->as<AnimationStateHeader>(handle);
      if (layout.kind->keeps_transforms) reorder_lanes(places, state.components, transforms_of(state));
      if (layout.kind->reorder_bones != nullptr) {
        layout.kind->reorder_bones(reinterpret_cast<std::byte*>(&state), layout, places);
      }
    });
  }
}

void AgentGraphs::visit_handles(Agent& agent, const std::function<void(Handle&)>& visit) const {
  for (Layer& layer : agent.layers) {
    layer.own.part->visit_handles(visit);
    if (layer.blender.valid()) visit(layer.blender);
  }
  for (const OwnedProcess& process : agent.processes) process.part->visit_handles(visit);
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
  find_newest_player(agent_index);
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
  copy.newest_players_ = newest_players_;
  copy.graphs_ = graphs_;
  copy.free_ = free_;
  copy.agents_.reserve(agents_.size());
  for (const Agent& agent : agents_) {
    Agent& other = copy.agents_.emplace_back();
    other.channels_given = agent.channels_given;
    other.processes_given = agent.processes_given;
    for (const Layer& layer : agent.layers) {
      other.layers.push_back({.own = copy_of(layer.own),
                              .settings = layer.settings,
                              .blender = layer.blender,
                              .weight_per_second = layer.weight_per_second,
                              .faded_at = layer.faded_at});
    }
    for (const OwnedProcess& process : agent.processes) other.processes.push_back(copy_of(process));
  }
  return copy;
}

std::size_t AgentGraphs::bytes() const {
  std::size_t bytes = agents_.capacity() * sizeof(Agent) + graphs_.capacity() * sizeof(PoseGraph) +
                      next_updates_.capacity() * sizeof(Ticks) + newest_players_.capacity() * sizeof(Handle);
  for (const Agent& agent : agents_) {
    bytes += agent.layers.capacity() * sizeof(Layer) + agent.processes.capacity() * sizeof(OwnedProcess);
  }
  for (const PoseGraph& graph : graphs_) bytes += graph.entities.capacity() * sizeof(Handle);
  return bytes;
}

}  // namespace throng::anim
