#include "engine/anim/agent/channel/state_tree.h"

#include <algorithm>
#include <utility>

namespace throng::anim {

PlayedState::PlayedState(const EntityBuilder& build, const StateMachine::State& state,
                         const StateMachine::Inputs& inputs)
    : played_(make(state, inputs)) {
  channel()->update(build);
}

PlayedState::Played PlayedState::make(const StateMachine::State& state, const StateMachine::Inputs& inputs) {
  const float x = inputs[state.by[0]], y = inputs[state.by[1]];
  if (state.points != nullptr) return BlendSpaceChannel(state.points, x, state.is_ground_speed);
  if (state.plane != nullptr) return BlendSpace2dChannel(state.plane, {x, y});
  return SimpleChannel(state.clip);
}

Channel* PlayedState::channel() {
  struct Held {
    Channel* operator()(std::monostate&) const { return nullptr; }
    Channel* operator()(Channel& own) const { return &own; }
  };
  return std::visit(Held{}, played_);
}

bool PlayedState::follow(const EntityBuilder& build, const StateMachine::State& state,
                         const StateMachine::Inputs& inputs) {
  const float x = inputs[state.by[0]], y = inputs[state.by[1]];
  if (auto* const space = std::get_if<BlendSpaceChannel>(&played_); space != nullptr) {
    if (space->parameter() == x) return false;
    space->set_parameter(x);
    return space->update(build);
  }
  auto* const plane = std::get_if<BlendSpace2dChannel>(&played_);
  if (plane == nullptr || plane->place() == glm::vec2(x, y)) return false;
  plane->set_place({x, y});
  return plane->update(build);
}

bool PlayedState::update(const EntityBuilder& build) {
  return next_update() <= build.now() && channel()->update(build);
}

void PlayedState::visit_handles(const std::function<void(Handle&)>& visit) {
  if (channel() != nullptr) channel()->visit_handles(visit);
}

void PlayedState::destroy(const EntityBuilder& build) {
  if (channel() != nullptr) channel()->destroy_entities(build);
  played_ = {};
}

Handle StateTree::root() const {
  if (empty()) return {};
  return count == 2 ? fade : played[0].root();
}

void StateTree::add(const EntityBuilder& build, PlayedState state, std::uint8_t number, Ticks over) {
  if (count == 1) {
    fade = build.ease(played[0].root(), state.root(), over);
    faded_at = build.now() + over;
  }
  states[count] = number;
  played[count++] = std::move(state);
}

bool StateTree::end_fade(const EntityBuilder& build) {
  if (count < 2 || is_fading(build.now())) return false;
  played[0].destroy(build);
  build.destroy(std::exchange(fade, {}));
  played[0] = std::exchange(played[1], {});
  states[0] = states[1];
  count = 1;
  return true;
}

void StateTree::join(const EntityBuilder& build) const {
  if (count < 2) return;
  auto& blender = build.as<EaseBlender>(fade);
  blender.from = played[0].root();
  blender.to = played[1].root();
}

Ticks StateTree::next_update() const {
  Ticks next = count == 2 ? faded_at : never;
  for (std::size_t i = 0; i < count; ++i) next = std::min(next, played[i].next_update());
  return next;
}

void StateTree::visit_handles(const std::function<void(Handle&)>& visit) {
  for (std::size_t i = 0; i < count; ++i) played[i].visit_handles(visit);
  if (fade.valid()) visit(fade);
}

void StateTree::destroy(const EntityBuilder& build) {
  for (std::size_t i = 0; i < count; ++i) played[i].destroy(build);
  if (fade.valid()) build.destroy(fade);
  *this = {};
}

}  // namespace throng::anim
