#include "throng/lod.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "throng/debug.h"

#include "engine/anim/base/misuse.h"
#include "engine/anim/door/convert.h"
#include "engine/anim/door/crowd_parts.h"
#include "engine/anim/lod/level_of_detail.h"

namespace throng {

struct Lod::State {
  anim::LevelOfDetail lod;
  std::uint64_t characters = UINT64_MAX;  // CrowdParts::version that the characters are of
  std::vector<glm::vec3> positions;       // [number, up to the room]
  std::vector<float> scales;
  std::vector<std::uint8_t> characters_of;
  std::vector<int> clips;
  std::vector<std::uint8_t> is_left_out;
  std::vector<std::uint32_t> generations;  // [number] of the agent that was seen last
  std::span<PoseRequest> requests;         // of the last selection
  bool has_selected = false;
};

namespace {

constexpr const char* selects = "Lod::select";
constexpr std::size_t least_room = 64;
constexpr Ticks longest_frame = 3600 * ticks_per_second;

/// No place of a crowd is farther off, in metres: squares of it are still numbers.
constexpr float farthest = 1e9F;

bool is_place(const Vec3& place) {
  return std::abs(place.x) <= farthest && std::abs(place.y) <= farthest && std::abs(place.z) <= farthest;
}

/// Returns why a camera is none, in one sentence; null if it is one.
const char* fault_of(const Camera& camera) {
  if (!is_place(camera.position) || !is_place(camera.forward)) return "a camera's place and direction are numbers";
  for (const std::array<float, 4>& plane : camera.frustum) {
    for (const float number : plane) {
      if (!(std::abs(number) <= farthest)) return "the planes of a camera are numbers";
    }
  }
  const bool is_scale = camera.pixels_per_unit > 0.0F && camera.pixels_per_unit <= farthest;
  return is_scale ? nullptr : "Camera::pixels_per_unit is above 0";
}

/// Returns why a frame cannot be decided, in one sentence; null if it can.
const char* fault_of(const LodFrame& frame, std::size_t numbers) {
  const LodRules& rules = frame.rules;
  if (frame.positions.size() < numbers) return "LodFrame::positions has no place for each agent's number";
  if (!frame.scales.empty() && frame.scales.size() < numbers) return "LodFrame::scales has no place for each number";
  if (rules.largest_interval < 1 || rules.largest_interval > anim::longest_interval) {
    return "LodRules::largest_interval is from 1 to 16 frames";
  }
  const auto is_within = [](auto number, auto least) {
    return number >= least && static_cast<float>(number) <= farthest;
  };
  if (!is_within(rules.interval_growth, 1e-3F) || !is_within(rules.full_rate_distance, 0.0F)) {
    return "the distances of LodRules are not negative, and interval_growth is at least a millimetre";
  }
  if (!is_within(rules.error_pixels, 0.0F) || !is_within(rules.budget_milliseconds, 0.0)) {
    return "the limits of LodRules are not negative";
  }
  if (frame.frame_step < Ticks{} || frame.frame_step > longest_frame)
    return "LodFrame::frame_step is from 0 to an hour";
  return fault_of(frame.camera);
}

}  // namespace

Lod::Lod() : state_(std::make_unique<State>()) {}
Lod::~Lod() = default;
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

void Lod::make_room(std::size_t numbers, const LodRules& rules) {
  State& s = *state_;
  if (numbers <= s.positions.size()) return;
  const std::size_t room = std::max({numbers, 2 * s.positions.size(), least_room});
  s.positions.resize(room);
  s.scales.resize(room, 1.0F);
  s.characters_of.resize(room, 0);
  s.clips.resize(room, -1);
  s.is_left_out.resize(room, 1);
  s.generations.resize(room, whichever);
  s.lod.reset(room, rules);
}

void Lod::take_agents(const Crowd& crowd, const LodFrame& frame) {
  State& s = *state_;
  const detail::AgentNotes& notes = crowd.parts().notes;
  std::ranges::fill(s.is_left_out, std::uint8_t{1});
  for (const AgentId agent : crowd.agents()) {
    const std::uint32_t number = agent.number;
    const float scale = frame.scales.empty() ? 1.0F : frame.scales[number];
    if (!is_place(frame.positions[number]) || !(scale > 0.0F && scale <= farthest)) {
      anim::report_misuse({selects, "positions and scales are numbers; an agent with others is left out"});
      continue;
    }
    s.is_left_out[number] = 0;
    s.positions[number] = to_glm(frame.positions[number]);
    s.scales[number] = scale;
    s.characters_of[number] = notes.characters[number];
    s.clips[number] = notes.clips[number];
    if (std::exchange(s.generations[number], agent.generation) != agent.generation) s.lod.make_due(number);
  }
}

std::span<PoseRequest> Lod::select(Crowd& crowd, const LodFrame& frame) {
  if (is_gone(selects)) return {};
  State& s = *state_;
  s.requests = {};
  s.has_selected = false;
  if (const char* fault = fault_of(frame, crowd.number_limit()); fault != nullptr) {
    anim::report_misuse({selects, fault});
    return {};
  }
  if (crowd.parts().characters.empty()) return {};  // it was moved from, as number_limit() has reported
  take_characters(crowd);
  make_room(crowd.number_limit(), frame.rules);
  if (s.positions.empty()) return {};
  take_agents(crowd, frame);
  anim::AnimationSystem& system = *crowd.parts().system;
  s.lod.select({.positions = s.positions,
                .scales = s.scales,
                .character_of = s.characters_of,
                .clips = s.clips,
                .left_out = s.is_left_out},
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
  if (agent.number < state_->positions.size()) state_->lod.make_due(agent.number);
}

bool Lod::is_visible(AgentId agent) const {
  if (is_gone("Lod::is_visible")) return false;
  return agent.number < state_->positions.size() && state_->lod.is_visible(agent.number);
}

}  // namespace throng
