#include "throng/lod.h"

#include <utility>
#include <vector>

#include "throng/debug.h"

#include "engine/anim/api/crowd_parts.h"
#include "engine/anim/api/taken_agents.h"
#include "engine/anim/base/misuse.h"
#include "engine/anim/base/zone.h"
#include "engine/anim/lod/level_of_detail.h"

namespace throng {

struct Lod::State {
  anim::LevelOfDetail lod;
  std::uint64_t characters = UINT64_MAX;  // CrowdParts::version that the characters are of
  detail::TakenAgents agents;
  std::span<PoseRequest> requests;  // of the last selection
  bool has_selected = false;
};

namespace {

constexpr const char* selects = "Lod::select";

/// Returns why a frame cannot be decided, in one sentence; null if it can.
const char* fault_of(const LodFrame& frame, std::size_t numbers) {
  for (const char* fault : {detail::fault_of({frame.positions, frame.scales}, numbers), detail::fault_of(frame.rules),
                            detail::fault_of_step(frame.frame_step), detail::fault_of(frame.camera)}) {
    if (fault != nullptr) return fault;
  }
  return nullptr;
}

}  // namespace

Lod::Lod() : state_(std::make_unique<State>()) {}
Lod::~Lod() = default;
Lod::Lod(const Lod& other) : state_(other.state_ == nullptr ? nullptr : std::make_unique<State>(*other.state_)) {
  if (state_ != nullptr && !state_->requests.empty()) state_->requests = state_->lod.updates();
}
Lod& Lod::operator=(const Lod& other) { return *this = Lod(other); }
Lod::Lod(Lod&&) noexcept = default;
Lod& Lod::operator=(Lod&&) noexcept = default;

bool Lod::is_gone(const char* call) const {
  return state_ == nullptr && !anim::report_misuse({call, detail::was_moved_from});
}

void Lod::take_characters(const Crowd& crowd) {
  const detail::CrowdParts& parts = crowd.parts();
  if (state_->characters == parts.version) return;
  state_->characters = parts.version;
  std::vector<anim::LodCharacter> characters;
  for (const detail::CrowdCharacter& one : parts.characters) {
    characters.push_back(one.character ? anim::lod_character(*one.character.data()->baked) : anim::LodCharacter{});
  }
  state_->lod.set_characters(std::move(characters));
}

std::span<PoseRequest> Lod::select(Crowd& crowd, const LodFrame& frame) {
  if (is_gone(selects)) return {};
  const anim::Zone zone(selects, 0);
  State& s = *state_;
  s.requests = {};
  s.has_selected = false;
  if (const char* fault = fault_of(frame, crowd.number_limit()); fault != nullptr) {
    anim::report_misuse({selects, fault});
    return {};
  }
  if (crowd.parts().characters.empty()) return {};  // it was moved from, as number_limit() has reported
  take_characters(crowd);
  if (s.agents.make_room(crowd.number_limit())) s.lod.reset(s.agents.room(), frame.rules);
  if (s.agents.room() == 0) return {};
  s.agents.take(crowd, {frame.positions, frame.scales}, selects);
  s.agents.tell(crowd, s.lod);
  anim::AnimationSystem& system = *crowd.parts().system;
  s.lod.select(s.agents.agents(),
               {.camera = frame.camera, .rules = frame.rules, .now = crowd.clock(), .frame_step = frame.frame_step},
               system.executor(), system.options().pus);
  s.has_selected = true;
  for (PoseRequest& request : s.lod.updates()) request.agent = system.id(request.agent.number);
  s.requests = s.lod.updates();
  return s.requests;
}

std::span<PoseRequest> Lod::requests() {
  if (is_gone("Lod::requests")) return {};
  return state_->requests;
}

void Lod::settle(const Crowd& crowd) {
  if (is_gone("Lod::settle")) return;
  if (!std::exchange(state_->has_selected, false)) {
    anim::report_misuse({"Lod::settle", "there was no selection since the last call"});
    return;
  }
  state_->lod.settle(crowd.debug().predicted_nanoseconds());
}

void Lod::make_due(AgentId agent) {
  if (is_gone("Lod::make_due")) return;
  if (agent.number < state_->agents.room()) state_->lod.make_due(agent.number);
}

bool Lod::is_visible(AgentId agent) const {
  if (is_gone("Lod::is_visible")) return false;
  return agent.number < state_->agents.room() && state_->lod.is_visible(agent.number);
}

}  // namespace throng
