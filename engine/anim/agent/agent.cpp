#include "engine/anim/agent/agent.h"

#include <cassert>

#include "engine/anim/agent/wind_back.h"

namespace throng::anim {

bool AgentView::can_pose_exactly() const { return anim::can_pose_exactly(*population_, number_); }

bool AgentView::can_wind_back() const { return anim::can_wind_back(*population_, number_); }

std::span<const float> AgentView::pose() const {
  const auto& state = pools().as<AnimationStateHeader>(graph().root());
  return {transforms_of(state), pose_bytes(state.bone_count, state.components) / sizeof(float)};
}

bool Agent::play(const PlayRequest& request) {
  assert(request.mask >= PlayRequest::no_mask &&
         request.mask < static_cast<int>(system_->population.character_of(number()).masks.size()) &&
         "PlayRequest::mask is not one that add_mask returned");
  const EntityBuilder build = builder();
  if (channel_count() == 0) {
    [[maybe_unused]] const Status added =
        own_graphs().add_channel(build, index(), std::make_unique<CrossFadeChannel>(), {});
    assert(added && "a channel that plays nothing yet");
  }
  assert(dynamic_cast<CrossFadeChannel*>(&own_graphs().channel(index(), 0)) != nullptr &&
         "another kind of channel was added");
  auto& channel = static_cast<CrossFadeChannel&>(own_graphs().channel(index(), 0));
  const bool taken = channel.play(build, request);
  if (settle([&] { return own_graphs().rebuild(build, index()); })) return taken;
  PlayRequest at_once = request;
  at_once.fade = Ticks{};
  at_once.held_fraction.reset();
  at_once.mask = PlayRequest::no_mask;
  channel.play(build, at_once);
  [[maybe_unused]] const Status cut = settle([&] { return own_graphs().rebuild(build, index()); });
  assert(cut && "a player alone is the least that there can be");
  return false;
}

void Agent::set_speed(double speed) {
  static_cast<CrossFadeChannel&>(own_graphs().channel(index(), 0)).set_speed(builder(), speed);
}

Status Agent::add_channel(std::unique_ptr<Channel> channel, const LayerSettings& settings) {
  const EntityBuilder build = builder();
  Status added = settle([&] { return own_graphs().add_channel(build, index(), std::move(channel), settings); });
  if (!added) own_graphs().remove_channel(build, index(), channel_count() - 1);
  return added;
}

void Agent::remove_channel(std::size_t place) { own_graphs().remove_channel(builder(), index(), place); }

void Agent::set_channel_weight(std::size_t place, float weight) { own_graphs().set_weight(index(), place, weight); }

Status Agent::channel_changed() {
  return settle([&] { return own_graphs().update(builder(), index()); });
}

Status Agent::add_post_process(std::unique_ptr<PostProcess> process) {
  const EntityBuilder build = builder();
  Status added = settle([&] { return own_graphs().add_post_process(build, index(), std::move(process)); });
  if (!added) own_graphs().remove_post_processes(build, index(), post_process_count() - 1);
  return added;
}

void Agent::remove_post_processes() { own_graphs().remove_post_processes(builder(), index()); }

std::unique_ptr<PostProcess> Agent::take_last_post_process() {
  return own_graphs().take_last_post_process(builder(), index());
}

Status Agent::process_changed(std::size_t place) {
  Status changed = settle([&] { return own_graphs().update_post_process(builder(), index(), place); });
  if (changed) return changed;
  own_graphs().post_process(index(), place).destroy_entities(builder());
  [[maybe_unused]] const Status rebuilt = own_graphs().rebuild(builder(), index());
  assert(rebuilt && "it did before");
  return changed;
}

}  // namespace throng::anim
