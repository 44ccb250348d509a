#include "engine/anim/agent/agent.h"

#include <cassert>

#include "engine/anim/agent/wind_back.h"
#include "engine/base/compiler.h"

namespace throng::anim {
namespace {

constexpr const char* no_channel = "the agent has no channel of this id";
constexpr const char* no_process = "the agent has no post process of this id";

}  // namespace

const CharacterAgents& AgentView::agents() const {
  return exists() ? population_->character_of(number()) : no_agents();
}

CharacterId AgentView::character_id() const {
  return exists() ? population_->id_of_character(population_->numbers().member(number()).character) : CharacterId{};
}

ChannelId AgentView::channel_id(std::size_t place) const {
  return place < channel_count() ? ChannelId{graphs().channel(index(), place).id} : ChannelId{};
}

ProcessId AgentView::post_process_id(std::size_t place) const {
  return place < post_process_count() ? ProcessId{graphs().post_process(index(), place).id} : ProcessId{};
}

void AgentView::prefetch() const {
  constexpr std::size_t line = 64, lines = 2;
  for (const Handle entity : graph().entities) {
    for (std::size_t i = 0; i < lines; ++i) prefetch_to_write(pools().block(entity) + i * line);
  }
  if (channel_count() > 0) prefetch_to_write(graphs().channel(index(), 0).part.get());
}

bool AgentView::can_pose_exactly() const { return exists() && anim::can_pose_exactly(*population_, number()); }

bool AgentView::can_wind_back() const { return exists() && anim::can_wind_back(*population_, number()); }

std::span<const float> AgentView::pose() const {
  if (graph().empty()) return {};
  const auto& state = pools().as<AnimationStateHeader>(graph().root());
  if (state.transforms_offset == 0) return {};
  return {transforms_of(state), pose_bytes(state.bone_count, state.components) / sizeof(float)};
}

bool Agent::play(const PlayRequest& request) {
  const Turn turn(system_->turn, "Agent::play");
  if (!turn) return false;
  if (const char* fault = fault_of(request); fault != nullptr) return turn.report(fault);
  if (channel_count() == 0) {
    [[maybe_unused]] const Status added = own_graphs().add_channel(
        builder(), index(), own_graphs().take_cross_fade_channel(), type_tag<CrossFadeChannel>(), {});
    assert(added && "a channel that plays nothing yet");
  }
  CrossFadeChannel* const channel = first_channel();
  if (channel == nullptr)
    return turn.report("the agent's first channel does not fade between clips: it was added as another kind");
  return play(*channel, request);
}

bool Agent::play(ChannelId channel, const PlayRequest& request) {
  const Turn turn(system_->turn, "Agent::play");
  if (!turn) return false;
  if (const char* fault = fault_of(request); fault != nullptr) return turn.report(fault);
  auto* const own_channel = as<CrossFadeChannel, Channel>(own(channel));
  if (own_channel == nullptr) return turn.report("the agent has no channel of this id that fades between clips");
  return play(*own_channel, request);
}

bool Agent::play(CrossFadeChannel& channel, const PlayRequest& request) {
  const EntityBuilder build = builder();
  const bool taken = channel.play(build, request);
  if (settle([&] { return own_graphs().rebuild(build, index()); })) return taken;
  PlayRequest at_once = request;
  at_once.fade = Ticks{};
  at_once.held_fraction.reset();
  at_once.mask = PlayRequest::no_mask;
  channel.play(build, at_once);
  if (settle([&] { return own_graphs().rebuild(build, index()); })) return false;
  channel.destroy_entities(build);  // a layer that played nothing may have no room for a player either
  [[maybe_unused]] const Status silent = settle([&] { return own_graphs().rebuild(build, index()); });
  assert(silent && "the layers below were there before");
  return false;
}

const char* Agent::fault_of(const PlayRequest& request) const {
  if (!exists()) return no_agent;
  const EntityBuilder build = builder();
  if (const char* fault = build.fault_of(start_of(request)); fault != nullptr) return fault;
  if (!is_fade(request.fade)) return not_a_fade;
  if (!build.has_room()) return too_many_entities;
  const bool is_fraction = !request.held_fraction || (*request.held_fraction >= 0.0F && *request.held_fraction <= 1.0F);
  if (!is_fraction) return "held_fraction is from 0 to 1";
  return build.has_mask(request.mask) ? nullptr : not_a_mask;
}

CrossFadeChannel* Agent::first_channel() const {
  return channel_count() == 0 ? nullptr : as<CrossFadeChannel, Channel>(&graphs().channel(index(), 0));
}

bool Agent::set_speed(double speed) {
  const Turn turn(system_->turn, "Agent::set_speed");
  if (!turn) return false;
  const char* const fault = try_set_speed(speed);
  return fault == nullptr || turn.report(fault);
}

const char* Agent::try_set_speed(double speed) const {
  if (!exists()) return no_agent;
  if (!is_speed(speed)) return not_a_speed;
  const Handle player = newest_player(graphs(), index());
  if (!player.valid() || !pools().alive(player)) return "the agent's first channel plays no clip";
  builder().set_speed(pools().as<Player>(player), speed);
  return nullptr;
}

Result<ChannelId> Agent::add_channel(std::unique_ptr<Channel> channel, TypeTag type, const LayerSettings& settings) {
  const Turn turn(system_->turn, "Agent::add");
  if (!turn) return Turn::refusal();
  if (!exists()) return turn.refuse(no_agent);
  if (channel == nullptr) return turn.refuse("the channel is null");
  const EntityBuilder build = builder();
  if (!(settings.weight >= 0.0F && settings.weight <= 1.0F)) return turn.refuse("a weight is from 0 to 1");
  if (!build.has_mask(settings.mask)) return turn.refuse(not_a_mask);
  if (!build.has_room()) return turn.refuse(too_many_entities);
  if (const char* fault = channel->fault(build); fault != nullptr) return turn.refuse(fault);
  const Status added =
      settle([&] { return own_graphs().add_channel(build, index(), std::move(channel), type, settings); });
  const std::size_t place = channel_count() - 1;
  if (added) return channel_id(place);
  own_graphs().remove_channel(build, index(), place);
  return added.error();
}

bool Agent::remove_channel(ChannelId channel) {
  const Turn turn(system_->turn, "Agent::remove");
  if (!turn) return false;
  const std::optional<std::size_t> place = graphs().place(index(), channel);
  if (!place) return turn.report(exists() ? no_channel : no_agent);
  own_graphs().remove_channel(builder(), index(), *place);
  return true;
}

bool Agent::set_channel_weight(ChannelId channel, float weight, Ticks fade) {
  const Turn turn(system_->turn, "Agent::set_weight");
  if (!turn) return false;
  const std::optional<std::size_t> place = graphs().place(index(), channel);
  if (!place) return turn.report(exists() ? no_channel : no_agent);
  if (!(weight >= 0.0F && weight <= 1.0F)) return turn.report("a weight is from 0 to 1");
  if (!is_fade(fade)) return turn.report(not_a_fade);
  own_graphs().set_weight(builder(), index(), *place, weight, fade);
  return true;
}

Status Agent::channel_changed(ChannelId channel, const char* call) {
  const Turn turn(system_->turn, call);
  if (!turn) return Turn::refusal();
  const std::optional<std::size_t> place = graphs().place(index(), channel);
  if (!place) return turn.refuse(no_channel);
  if (!builder().has_room()) return turn.refuse(too_many_entities);
  return system_->pus.update_channel(system_->population, number(), *place);
}

Result<ProcessId> Agent::add_post_process(std::unique_ptr<PostProcess> process, TypeTag type) {
  const Turn turn(system_->turn, "Agent::add");
  if (!turn) return Turn::refusal();
  if (!exists()) return turn.refuse(no_agent);
  if (process == nullptr) return turn.refuse("the post process is null");
  const EntityBuilder build = builder();
  if (!build.has_room()) return turn.refuse(too_many_entities);
  if (const char* fault = process->fault(build); fault != nullptr) return turn.refuse(fault);
  const Status added = settle([&] { return own_graphs().add_post_process(build, index(), std::move(process), type); });
  const std::size_t place = post_process_count() - 1;
  if (added) return post_process_id(place);
  own_graphs().take_post_process(build, index(), place);
  return added.error();
}

bool Agent::remove_post_process(ProcessId process) {
  const Turn turn(system_->turn, "Agent::remove");
  if (!turn) return false;
  const std::optional<std::size_t> place = graphs().place(index(), process);
  if (!place) return turn.report(exists() ? no_process : no_agent);
  own_graphs().take_post_process(builder(), index(), *place);
  return true;
}

std::unique_ptr<PostProcess> Agent::take(ProcessId process) {
  const Turn turn(system_->turn, "Agent::take_post_process");
  const std::optional<std::size_t> place = graphs().place(index(), process);
  return turn && place ? own_graphs().take_post_process(builder(), index(), *place) : nullptr;
}

Status Agent::process_changed(ProcessId process, const char* call) {
  const Turn turn(system_->turn, call);
  if (!turn) return Turn::refusal();
  const std::optional<std::size_t> place = graphs().place(index(), process);
  if (!place) return turn.refuse(no_process);
  if (!builder().has_room()) return turn.refuse(too_many_entities);
  Status changed = settle([&] {
    const EntityBuilder build = builder();
    PostProcess& own_process = *own_graphs().post_process(index(), *place).part;
    const bool is_done = own_graphs().update_alone(build, index(), own_process, AgentGraphs::Entities::may_change);
    return is_done ? Status(Done{}) : own_graphs().rebuild(build, index());
  });
  if (changed) return changed;
  own_graphs().post_process(index(), *place).part->destroy_entities(builder());
  [[maybe_unused]] const Status rebuilt = own_graphs().rebuild(builder(), index());
  assert(rebuilt && "it did before");
  return changed;
}

}  // namespace throng::anim
