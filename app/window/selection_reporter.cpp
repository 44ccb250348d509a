#include "app/window/selection_reporter.h"

#include <algorithm>

#include "app/show/stage/stage.h"
#include "app/window/agent_layers.h"
#include "engine/anim/entity/player.h"
#include "engine/base/text/joined.h"

namespace throng::app {
namespace {

Posture posture_of(const FallenAgents& fallen, std::uint32_t agent) {
  switch (fallen.phase(agent)) {
    case FallenAgents::Phase::letting_go:
      return Posture::falling;
    case FallenAgents::Phase::down:
      return fallen.at_rest(agent) ? Posture::down : Posture::falling;
    case FallenAgents::Phase::recovering:
      return Posture::getting_up;
    case FallenAgents::Phase::standing:
      break;
  }
  return Posture::upright;
}

bool is_player(anim::Handle entity) {
  const std::uint32_t pool = entity.pool();
  return pool == anim::EntityPools::sampled_players || pool == anim::EntityPools::keyframe_players;
}

template <class Element>
std::string vector_of(const Element* values, int count) {
  std::string words;
  for (int i = 0; i < count; ++i) words += (i == 0 ? "" : ", ") + fixed(static_cast<double>(values[i]), 3);
  return words;
}

void add_player(const anim::Player& player, std::vector<BlockField>& fields) {
  const double seconds = to_seconds(player.position / anim::fine_ticks_per_tick);
  fields.push_back({"Position", fixed(seconds, 3) + " s"});
  fields.push_back({"Clip", std::to_string(player.clip)});
  fields.push_back({"Speed", fixed(player.speed / 65536.0, 3)});
  fields.push_back({"Loops", std::to_string(player.loop_count)});
}

/// Returns the fields of an entity's header (paper 2.2.1), and a player's own fields (2.2.2).
std::vector<BlockField> block_fields(const anim::AnimationStateHeader& state) {
  const bool resident = state.transforms_offset != 0;
  std::vector<BlockField> fields = {
      {"Type", std::to_string(static_cast<unsigned>(state.type))},
      {"Total size", std::to_string(state.total_size) + " B"},
      {"Transforms at", resident ? "byte " + std::to_string(state.transforms_offset) : "none: transient"},
      {"Bones", std::to_string(state.bone_count)},
      {"Priority", state.priority == anim::highest_priority ? "highest" : std::to_string(state.priority)},
      {"Owner", std::to_string(state.owner)},
      {"Floats a bone", std::to_string(state.components)},
      {"Delta time", fixed(to_seconds(state.delta_time), 3) + " s"},
      {"Velocity", vector_of(state.linear_velocity, 3) + " m/s"},
      {"Turning", vector_of(state.angular_velocity, 3) + " rad/s"}};
  if ((state.flags & anim::AnimationStateHeader::has_absolute_root) != 0) {
    fields.push_back({"Absolute root", vector_of(state.absolute_position, 3) + " m"});
  }
  const bool plays = state.type == anim::EntityType::sampled_player || state.type == anim::EntityType::keyframe_player;
  if (plays) add_player(reinterpret_cast<const anim::Player&>(state), fields);
  return fields;
}

EntityRow row_of(anim::Handle entity, const anim::EntityPools& pools, const anim::Character& character) {
  const anim::EntityLayout& layout = pools.layout(entity);
  const anim::AnimationStateHeader& state = pools.state(entity);
  EntityRow row{.kind = layout.kind->name,
                .clip = {},
                .handle = entity,
                .priority = state.priority - anim::highest_priority,
                .resident = layout.is_resident(),
                .shared = anim::EntityPools::is_shared(entity)};
  const std::byte* const block = pools.block(entity);
  const auto* const bytes = reinterpret_cast<const std::uint8_t*>(block);
  row.block.assign(bytes, bytes + layout.total_size);
  row.fields = block_fields(state);
  if (!is_player(entity)) return row;
  const auto& player = pools.as<anim::Player>(entity);
  const anim::BakedClip& clip = character.clips[player.clip];
  row.clip = clip.name;
  row.position_seconds =
      static_cast<float>(to_seconds(anim::position_in_clip(player, clip.duration) / anim::fine_ticks_per_tick));
  row.duration_seconds = static_cast<float>(to_seconds(clip.duration));
  return row;
}

void add_graph(const anim::AnimationSystem& system, SelectionReport& report) {
  const std::vector<anim::Handle>& entities = system.agent(report.agent).graph().entities;
  const anim::PoseWeights weights = system.agent(report.agent).motion().weights(system.clock());
  for (std::size_t i = 0; i < entities.size(); ++i) {
    report.entities.push_back(
        row_of(entities[i], system.agent(report.agent).pools(), system.agent(report.agent).character()));
    report.entities.back().weight = weights[i];
    report.bytes += static_cast<std::uint32_t>(report.entities.back().block.size());
  }
  report.layers = agent_layers(system, report.agent);
}

void add_level_of_detail(const Stage& stage, SelectionReport& report) {
  const std::span<const anim::VisibleAgent> visible = stage.posed().selection().visible;
  const auto found = std::ranges::lower_bound(visible, report.agent, {}, &anim::VisibleAgent::agent);
  if (found == visible.end() || found->agent != report.agent) return;
  report.visible = true;
  report.interval = report.posture == Posture::upright ? found->interval : 1;
  report.mesh_lod = stage.posed().mesh_choice().lods()[static_cast<std::size_t>(found - visible.begin())];
  report.bone_level = stage.posed().shown().pose(report.agent).to_level;
  const anim::Skeleton& skeleton = stage.character_of(report.agent).character->skeleton;
  report.bones = skeleton.level_bone_counts[static_cast<std::size_t>(report.bone_level)];
}

}  // namespace

std::optional<SelectionReport> report_selection(const Stage& stage) {
  if (!stage.selected()) return std::nullopt;
  const std::uint32_t agent = *stage.selected();
  const Crowd& crowd = stage.crowd();
  const glm::vec3& position = crowd.positions()[agent];
  SelectionReport report{.agent = agent,
                         .role = crowd.minds().roles()[agent],
                         .habit = crowd.minds().habits()[agent],
                         .posture = posture_of(stage.animated().fallen(), agent),
                         .x = position.x,
                         .y = position.y,
                         .z = position.z,
                         .speed = crowd.speeds()[agent],
                         .can_fall = stage.animated().can_fall(agent),
                         .channels = static_cast<int>(stage.system().agent(agent).channel_count()),
                         .entities = {}};
  if (stage.animated().held_clip()) report.held_at = stage.animated().held_clip()->seconds;
  report.clip_seconds = stage.animated().clip_seconds(agent);
  add_level_of_detail(stage, report);
  add_graph(stage.system(), report);
  return report;
}

}  // namespace throng::app
