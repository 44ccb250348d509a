#include "throng/agent.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "throng/state_machine.h"

#include "engine/anim/agent/blend_space_2d_channel.h"
#include "engine/anim/agent/blend_space_channel.h"
#include "engine/anim/agent/channel/slot_channel.h"
#include "engine/anim/agent/channel/state_machine_channel.h"
#include "engine/anim/agent/cross_fade_channel.h"
#include "engine/anim/api/convert.h"
#include "engine/anim/api/crowd_parts.h"
#include "engine/anim/api/machine_data.h"
#include "engine/anim/base/misuse.h"
#include "engine/base/glm_numbers.h"

namespace throng {
namespace {

anim::PlayRequest request_of(const Play& play) {
  anim::PlayRequest request{.clip = detail::number_of(play.clip),
                            .fade = play.fade,
                            .speed = play.speed,
                            .start = play.start,
                            .loop = play.loop,
                            .mask = detail::number_of(play.mask)};
  if (play.absolute_root) {
    request.absolute_root = {.position = glm::dvec3(to_glm(play.absolute_root->position)),
                             .rotation = to_glm(play.absolute_root->rotation)};
  }
  return request;
}

anim::LayerSettings settings_of(const Layer& layer) {
  return {.weight = layer.weight, .mask = detail::number_of(layer.mask)};
}

/// Returns why an agent cannot play one of these points, as CrowdParts::fault_of does.
template <typename Point>
const char* fault_of(const detail::CrowdParts& crowd, AgentId agent, std::span<const Point> points) {
  for (const Point& point : points) {
    if (const char* const fault = crowd.fault_of(agent, point.clip); fault != nullptr) return fault;
  }
  return nullptr;
}

constexpr const char* not_a_parameter = "the parameter of a blend space is a finite number";
constexpr Ticks rounding_of_start = ticks_per_second / 1000;  // hosts multiply floats

/// Returns why an agent cannot play a clip from a position, as CrowdParts::fault_of does. The system takes positions
/// beyond the clip, which its channels need.
const char* fault_of(const detail::CrowdParts& crowd, AgentId agent, const Play& play) {
  if (const char* const fault = crowd.fault_of(agent, play.clip); fault != nullptr) return fault;
  const anim::AgentView own = std::as_const(*crowd.system).agent(agent);
  if (!own.exists() || play.clip.number >= own.character().clips.size()) return nullptr;
  const Ticks duration = own.character().clips[play.clip.number].duration;
  const bool is_within = play.start >= Ticks{} && play.start <= duration + rounding_of_start;
  return is_within ? nullptr : "start is from 0 to the clip's duration";
}

}  // namespace

bool Agent::exists() const { return crowd_->system->agent(id_).exists(); }
CharacterId Agent::character() const { return crowd_->system->agent(id_).character_id(); }

bool Agent::play(const Play& request) const {
  if (const char* const fault = fault_of(*crowd_, id_, request); fault != nullptr)
    return anim::report_misuse({"Agent::play", fault});
  if (!crowd_->system->agent(id_).play(request_of(request))) return false;
  crowd_->note_clip(id_, request.clip, request.fade);
  return true;
}

bool Agent::play(ChannelId channel, const Play& request) const {
  if (const char* const fault = fault_of(*crowd_, id_, request); fault != nullptr)
    return anim::report_misuse({"Agent::play", fault});
  if (!crowd_->system->agent(id_).play(channel, request_of(request))) return false;
  crowd_->note_request(id_, request.fade);
  return true;
}

bool Agent::set_speed(double speed) const { return crowd_->system->agent(id_).set_speed(speed); }

Result<ChannelId> Agent::add_clips(const Layer& layer) const {
  return crowd_->system->agent(id_).add_channel(std::make_unique<anim::CrossFadeChannel>(), settings_of(layer));
}

Result<ChannelId> Agent::add(const BlendSpace& space, const Layer& layer) const {
  if (space.points.empty()) return anim::refuse({"Agent::add", "a blend space has at least one point"});
  if (const char* const fault = fault_of(*crowd_, id_, space.points); fault != nullptr)
    return anim::refuse({"Agent::add", fault});
  if (!std::isfinite(space.parameter)) return anim::refuse({"Agent::add", not_a_parameter});
  std::vector<anim::BlendPoint> points;
  for (const BlendPoint& point : space.points) {
    points.push_back({.clip = detail::number_of(point.clip), .parameter = point.parameter, .pace = point.pace});
  }
  auto& shared = crowd_->spaces.line;
  if (shared == nullptr || *shared != points) {
    shared = std::make_shared<const std::vector<anim::BlendPoint>>(std::move(points));
  }
  auto channel = std::make_unique<anim::BlendSpaceChannel>(shared, space.parameter, space.is_ground_speed);
  Result<ChannelId> added = crowd_->system->agent(id_).add_channel(std::move(channel), settings_of(layer));
  if (added) crowd_->note_clip(id_, space.points.back().clip);
  return added;
}

Result<ChannelId> Agent::add(const BlendSpace2d& space, const Layer& layer) const {
  if (const char* const fault = fault_of(*crowd_, id_, space.points); fault != nullptr)
    return anim::refuse({"Agent::add", fault});
  if (!std::isfinite(space.x) || !std::isfinite(space.y)) return anim::refuse({"Agent::add", not_a_parameter});
  const anim::Agent agent = crowd_->system->agent(id_);
  std::vector<anim::BlendPoint2d> points;
  for (const BlendPoint2d& point : space.points) {
    points.push_back({.clip = detail::number_of(point.clip), .place = {point.x, point.y}, .pace = point.pace});
  }
  const auto clip_count = static_cast<int>(agent.character().clips.size());
  auto& shared = crowd_->spaces.plane;
  if (shared == nullptr || shared->meaning() != space.meaning || !std::ranges::equal(shared->all(), points)) {
    auto plane = anim::BlendSpace2d::create(std::move(points), space.meaning, clip_count);
    if (!plane) return plane.error();
    shared = std::move(*plane);
  }
  auto channel = std::make_unique<anim::BlendSpace2dChannel>(shared, glm::vec2(space.x, space.y));
  Result<ChannelId> added = crowd_->system->agent(id_).add_channel(std::move(channel), settings_of(layer));
  if (added) crowd_->note_clip(id_, space.points.front().clip);
  return added;
}

Result<ChannelId> Agent::add(const StateMachine& machine, const Layer& layer) const {
  if (!machine) return anim::refuse({"Agent::add", "the state machine is empty"});
  const detail::CrowdCharacter* const own = crowd_->character_of(id_, "Agent::add");
  if (own == nullptr) return Error{detail::no_agent};
  const detail::MachineData& data = *machine.data();
  for (std::size_t i = 0; i < data.clips.size(); ++i) {
    const std::string_view name = own->character.clip({data.clips[i].number}).name;
    if (!name.empty() && name != data.names[i])
      return anim::refuse({"Agent::add", "the state machine was made for another character"});
    if (const char* const fault = crowd_->fault_of(id_, data.clips[i]); fault != nullptr)
      return anim::refuse({"Agent::add", fault});
  }
  auto channel = std::make_unique<anim::StateMachineChannel>(machine.data()->machine);
  return crowd_->system->agent(id_).add_channel(std::move(channel), settings_of(layer));
}

Result<ChannelId> Agent::add_slot(const Layer& layer) const {
  return crowd_->system->agent(id_).add_channel(std::make_unique<anim::SlotChannel>(), settings_of(layer));
}

bool Agent::play_once(ChannelId slot, const OneShot& shot) const {
  anim::Agent agent = crowd_->system->agent(id_);
  const auto* const own = agent.channel<anim::SlotChannel>(slot);
  if (own == nullptr) return anim::report_misuse({"Agent::play_once", "the agent has no slot of this id"});
  if (const char* const fault = crowd_->fault_of(id_, shot.clip); fault != nullptr)
    return anim::report_misuse({"Agent::play_once", fault});
  const anim::OneShot request{.clip = detail::number_of(shot.clip),
                              .fade_in = shot.fade_in,
                              .fade_out = shot.fade_out,
                              .speed = shot.speed,
                              .queued = shot.queued};
  const Status played = agent.change<anim::SlotChannel>(
      slot, [&](auto& channel) { channel.play(request); }, "Agent::play_once");
  if (played) crowd_->note_request(id_, shot.fade_in);
  if (played) return own->took_all();
  static_cast<void>(agent.change<anim::SlotChannel>(slot, [](auto& channel) { channel.stop(); }));
  return false;
}

bool Agent::is_playing(ChannelId slot) const {
  const anim::Agent agent = crowd_->system->agent(id_);
  const auto* const own = agent.channel<anim::SlotChannel>(slot);
  if (own == nullptr) return anim::report_misuse({"Agent::is_playing", "the agent has no slot of this id"});
  return own->is_playing(crowd_->system->clock());
}

bool Agent::set_parameter(ChannelId channel, float parameter) const {
  constexpr const char* call = "Agent::set_parameter";
  if (!std::isfinite(parameter)) return anim::report_misuse({call, not_a_parameter});
  const auto set = [parameter](anim::BlendSpaceChannel& space) { space.set_parameter(parameter); };
  return crowd_->system->agent(id_).change<anim::BlendSpaceChannel>(channel, set, call).has_value();
}

bool Agent::set_parameters(ChannelId channel, float x, float y) const {
  constexpr const char* call = "Agent::set_parameters";
  if (!std::isfinite(x) || !std::isfinite(y)) return anim::report_misuse({call, not_a_parameter});
  const auto set = [x, y](anim::BlendSpace2dChannel& space) { space.set_place({x, y}); };
  return crowd_->system->agent(id_).change<anim::BlendSpace2dChannel>(channel, set, call).has_value();
}

bool Agent::set_weight(ChannelId channel, float weight, Ticks fade) const {
  return crowd_->system->agent(id_).set_channel_weight(channel, weight, fade);
}

bool Agent::remove(ChannelId channel) const { return crowd_->system->agent(id_).remove_channel(channel); }
Processes Agent::processes() const { return {*crowd_, id_}; }
Motion Agent::motion() const { return {*crowd_, id_}; }

}  // namespace throng
