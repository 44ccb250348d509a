#include "app/settings/idle_values.h"

#include <algorithm>
#include <array>

namespace throng::app {
namespace {

using Reason = const char*;  // null: the value has an effect

constexpr Reason no_agent_selected = "it would be forced on the selected agent, and none is selected";
constexpr Reason time_stands_still = "No animation is on, so time stands still";
constexpr Reason nothing_drawn = "No drawing is on, so the picture stays";

/// Returns whether forced values are for all agents in view.
bool forces_everyone(const Tuning& tuning) { return !tuning.inspection.force_selected_only; }

bool forces_all_intervals(const Tuning& tuning) {
  return forces_everyone(tuning) && tuning.inspection.forced_interval > 0;
}

bool forces_all_levels(const Tuning& tuning) {
  return forces_everyone(tuning) && tuning.inspection.forced_bone_level >= 0;
}

/// Returns whether an agent may be posed more rarely than in each frame.
bool may_skip(const Tuning& tuning) { return tuning.lod.largest_interval > 1 || tuning.inspection.forced_interval > 1; }

Reason of_clock(const Tuning& tuning, const Situation&) {
  return tuning.taken_away.animation ? time_stands_still : nullptr;
}

Reason of_speed(const Tuning& tuning, const Situation& situation) {
  return tuning.paused ? "the crowd is paused" : of_clock(tuning, situation);
}

// Feet are placed for agents that are posed in each frame with all bones.
Reason of_feet(const Tuning& tuning, const Situation& situation) {
  if (!situation.places_feet) return "no character here has feet that are known; Show parts, below, can say them";
  if (forces_all_levels(tuning) && tuning.inspection.forced_bone_level > 0) {
    return "feet are placed with all bones, and all agents are forced to fewer";
  }
  const bool skips = tuning.lod.rule != LodRule::off && forces_all_intervals(tuning);
  return skips && tuning.inspection.forced_interval > 1
             ? "feet are placed of agents posed in each frame, and all are forced to be posed more rarely"
             : nullptr;
}

Reason of_distances(const Tuning& tuning, const Situation&) {
  if (tuning.lod.rule == LodRule::off) return "with the rule off no agent is skipped";
  if (tuning.lod.rule == LodRule::budget) return "the rule budget goes by pixels and milliseconds, not by metres";
  if (forces_all_intervals(tuning)) return "an interval is forced on all agents";
  return tuning.lod.largest_interval == 1 ? "the largest interval is one frame" : nullptr;
}

// The rule budget weighs intervals against bones, so there the largest one counts for bones too.
Reason of_largest_interval(const Tuning& tuning, const Situation&) {
  if (tuning.lod.rule == LodRule::off) return "with the rule off no agent is skipped";
  const bool forced = tuning.lod.rule == LodRule::distance && forces_all_intervals(tuning);
  return forced ? "an interval is forced on all agents" : nullptr;
}

Reason of_error_sample(const Tuning& tuning, const Situation&) {
  return tuning.debug_view == DebugView::error ? "the colours show the error, so all agents are measured" : nullptr;
}

// The error limit also chooses meshes, whatever the rule.
Reason of_error_limit(const Tuning& tuning, const Situation& situation) {
  const bool chooses_meshes = tuning.mesh_lod < 0 && situation.mesh_levels > 1;
  if (tuning.lod.rule == LodRule::budget || chooses_meshes) return nullptr;
  return "the rule goes by metres, and no mesh is chosen by its error";
}

Reason of_time_limit(const Tuning& tuning, const Situation&) {
  return tuning.lod.rule != LodRule::budget ? "only the rule budget has limits" : nullptr;
}

Reason of_forced_interval(const Tuning& tuning, const Situation& situation) {
  if (tuning.lod.rule == LodRule::off) return "with the rule off all agents are posed in each frame";
  return tuning.inspection.force_selected_only && !situation.selected ? no_agent_selected : nullptr;
}

Reason of_forced_level(const Tuning& tuning, const Situation& situation) {
  if (situation.bone_levels < 2) return "the character has one bone level";
  return tuning.inspection.force_selected_only && !situation.selected ? no_agent_selected : nullptr;
}

Reason of_selected_only(const Tuning& tuning, const Situation&) {
  const bool interval = tuning.inspection.forced_interval > 0 && tuning.lod.rule != LodRule::off;
  return interval || tuning.inspection.forced_bone_level >= 0 ? nullptr : "nothing is forced";
}

Reason of_smooth(const Tuning& tuning, const Situation&) {
  if (tuning.lod.rule == LodRule::off) return "with the rule off no agent is skipped, so there are no gaps";
  if (!may_skip(tuning)) return "the largest interval is one frame, so there are no gaps";
  const bool in_each_frame = forces_all_intervals(tuning) && tuning.inspection.forced_interval == 1;
  return tuning.lod.rule == LodRule::distance && in_each_frame ? "all agents are forced to be posed in each frame"
                                                               : nullptr;
}

Reason of_bone_lod(const Tuning& tuning, const Situation& situation) {
  if (situation.bone_levels < 2) return "the character has one bone level";
  return tuning.lod.rule != LodRule::budget && forces_all_levels(tuning) ? "a bone level is forced on all agents"
                                                                         : nullptr;
}

template <int level>
Reason of_level_distance(const Tuning& tuning, const Situation& situation) {
  if (level >= situation.bone_levels) return "no character here has this bone level";
  if (!tuning.lod.bone_lod) return "per-bone LOD is off";
  if (tuning.lod.rule == LodRule::budget) return "the rule budget chooses bone levels by the error limit";
  return forces_all_levels(tuning) ? "a bone level is forced on all agents" : nullptr;
}

Reason of_mesh_lod(const Tuning&, const Situation& situation) {
  return situation.mesh_levels < 2 ? "no character here has more than one mesh" : nullptr;
}

Reason of_mesh_error(const Tuning& tuning, const Situation& situation) {
  return tuning.mesh_lod >= 0 ? "one mesh is fixed for all agents" : of_mesh_lod(tuning, situation);
}

Reason of_variety(const Tuning& tuning, const Situation&) {
  return tuning.variety ? nullptr : "variety is off, so all of a character are alike";
}

Reason of_wardrobe(const Tuning&, const Situation& situation) {
  return situation.has_wardrobe ? nullptr : "no character here has parts to wear";
}

Reason of_weather(const Tuning& tuning, const Situation& situation) {
  return tuning.wardrobe ? of_wardrobe(tuning, situation) : "the wardrobe is off, so no agent dresses";
}

Reason of_grain(const Tuning&, const Situation& situation) {
  return situation.pus == 1 ? "there is one PU, and none to share with" : nullptr;
}

Reason of_palette(const Tuning&, const Situation& situation) {
  return situation.can_pack ? nullptr : "no skeleton here is rigid, so palettes stay float";
}

Reason of_colours(const Tuning& tuning, const Situation&) {
  if (tuning.taken_away.drawing) return nothing_drawn;
  return tuning.taken_away.upload ? "No upload is on, so the records of the last frame are drawn" : nullptr;
}

Reason of_plain_bodies(const Tuning& tuning, const Situation& situation) {
  switch (tuning.debug_view) {
    case DebugView::interval:
    case DebugView::bone_level:
    case DebugView::mesh_lod:
    case DebugView::speed:
      return "the colours cover all bodies";
    default:
      return of_colours(tuning, situation);
  }
}

template <DebugView view>
Reason of_scale(const Tuning& tuning, const Situation& situation) {
  return tuning.debug_view == view ? of_colours(tuning, situation) : "the colours show something else";
}

Reason of_what_is_drawn(const Tuning& tuning, const Situation&) {
  return tuning.taken_away.drawing ? nothing_drawn : nullptr;
}

Reason of_trails(const Tuning& tuning, const Situation& situation) {
  return tuning.scene == Scene::tracks ? of_what_is_drawn(tuning, situation)
                                       : "only people of a recorded crowd have trails";
}

Reason of_scenery(const Tuning& tuning, const Situation& situation) {
  return tuning.scene == Scene::grid ? "nothing stands around the grid" : of_what_is_drawn(tuning, situation);
}

Reason of_shadows(const Tuning& tuning, const Situation& situation) {
  if (!render::casts_shadows(tuning.light)) return "the sun is behind clouds";
  return of_what_is_drawn(tuning, situation);
}

Reason of_thresholds(const Tuning& tuning, const Situation& situation) {
  if (tuning.lod.rule == LodRule::off) return "with the rule off no agent is skipped";
  return of_what_is_drawn(tuning, situation);
}

Reason of_split(const Tuning& tuning, const Situation&) {
  return tuning.taken_away == TakenAway{} ? nullptr : "a part of the frame is taken away, below";
}

Reason of_split_line(const Tuning& tuning, const Situation& situation) {
  return tuning.inspection.split == Split::off ? "the picture is not split" : of_split(tuning, situation);
}

Reason of_agents(const Tuning& tuning, const Situation&) {
  return tuning.scene == Scene::tracks ? "the file says how many people are there" : nullptr;
}

struct Rule {
  std::string_view key;
  Reason (*reason)(const Tuning& tuning, const Situation& situation);
};

constexpr std::array idle_rules = std::to_array<Rule>({
    {"agents", of_agents},
    {"paused", of_clock},
    {"time_scale", of_speed},
    {"placed_feet", of_feet},
    {"full_rate_distance", of_distances},
    {"interval_growth", of_distances},
    {"largest_interval", of_largest_interval},
    {"error_sample", of_error_sample},
    {"error_px", of_error_limit},
    {"budget_ms", of_time_limit},
    {"forced_interval", of_forced_interval},
    {"forced_bone_level", of_forced_level},
    {"force_selected_only", of_selected_only},
    {"smooth", of_smooth},
    {"bone_lod", of_bone_lod},
    {"bone_level_distance_1", of_level_distance<1>},
    {"bone_level_distance_2", of_level_distance<2>},
    {"bone_level_distance_3", of_level_distance<3>},
    {"mesh_lod", of_mesh_lod},
    {"mesh_error_px", of_mesh_error},
    {"triangle_budget", of_mesh_error},
    {"tint", of_variety},
    {"size_variety", of_variety},
    {"wardrobe", of_wardrobe},
    {"weather", of_weather},
    {"cost_least_task_ns", of_grain},
    {"palette", of_palette},
    {"debug_view", of_colours},
    {"plain_bodies", of_plain_bodies},
    {"top_speed", of_scale<DebugView::speed>},
    {"top_density", of_scale<DebugView::density>},
    {"top_presence", of_scale<DebugView::presence>},
    {"density_cut_off", of_scale<DebugView::density>},
    {"trail_seconds", of_trails},
    {"picture_size", of_what_is_drawn},
    {"bones_as_lines", of_what_is_drawn},
    {"scenery", of_scenery},
    {"sun_elevation", of_what_is_drawn},
    {"sun_azimuth", of_what_is_drawn},
    {"clouds", of_what_is_drawn},
    {"exposure", of_what_is_drawn},
    {"shadows", of_shadows},
    {"crowd_shade", of_what_is_drawn},
    {"thresholds", of_thresholds},
    {"split", of_split},
    {"split_at", of_split_line},
    {"pixels", of_what_is_drawn},
});

Reason of_scene_of_tracks(const Tuning&, const Situation& situation) {
  return situation.has_tracks ? nullptr : "it shows a file of trajectories; drop one on the window";
}

Reason of_presence(const Tuning& tuning, const Situation&) {
  return tuning.scene == Scene::tracks ? nullptr : "only people of a recorded crowd come and go";
}

struct WordRule {
  std::string_view key, word;
  Reason (*reason)(const Tuning& tuning, const Situation& situation);
};

constexpr std::array word_rules = std::to_array<WordRule>({
    {"scene", "tracks", of_scene_of_tracks},
    {"debug_view", "presence", of_presence},
});

}  // namespace

const char* why_not_choose(std::string_view key, std::string_view word, const Tuning& tuning,
                           const Situation& situation) {
  const auto is_about = [&](const WordRule& rule) { return rule.key == key && rule.word == word; };
  const auto* const found = std::ranges::find_if(word_rules, is_about);
  return found == word_rules.end() ? nullptr : found->reason(tuning, situation);
}

std::optional<std::string> idle_reason(std::string_view key, const Tuning& tuning, const Situation& situation) {
  const auto* const found = std::ranges::find(idle_rules, key, &Rule::key);
  const Reason reason = found == idle_rules.end() ? nullptr : found->reason(tuning, situation);
  return reason == nullptr ? std::nullopt : std::optional<std::string>(reason);
}

}  // namespace throng::app
