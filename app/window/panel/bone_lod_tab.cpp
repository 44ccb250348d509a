#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string>

#include "app/window/panel/bone_list.h"
#include "app/window/panel/controls/plots.h"
#include "app/window/panel/tabs.h"

namespace throng::app {
namespace {

float longest_distance() { return static_cast<float>(scale_of("bone_level_distance_1").highest); }

/// Moves the neighbours of a distance that was moved, so that levels follow each other.
void keep_in_order(Tuning& tuning, std::size_t moved) {
  auto& distance = tuning.lod.level_distances;
  for (std::size_t i = moved + 1; i < distance.size(); ++i) distance[i] = std::max(distance[i], distance[i - 1]);
  for (std::size_t i = moved; i > 0; --i) distance[i - 1] = std::min(distance[i - 1], distance[i]);
}

std::string bones_of(const FrameReport& report, int level) {
  const auto index = static_cast<std::size_t>(level);
  return index < report.level_bone_counts.size() ? std::to_string(report.level_bone_counts[index]) : "-";
}

std::size_t nearest_divider(const Tuning& tuning, std::size_t dividers, float metres) {
  std::size_t nearest = 0;
  for (std::size_t i = 1; i < dividers; ++i) {
    const float now = std::abs(tuning.lod.level_distances[i] - metres);
    if (now < std::abs(tuning.lod.level_distances[nearest] - metres)) nearest = i;
  }
  return nearest;
}

void drag_dividers(const Area& band, std::size_t dividers, Tuning& tuning) {
  const float metres =
      std::clamp((ImGui::GetIO().MousePos.x - band.from.x) / band.width(), 0.0F, 1.0F) * longest_distance();
  ImGuiStorage& memory = *ImGui::GetStateStorage();
  const ImGuiID held = ImGui::GetID("held divider");
  if (ImGui::IsItemActivated()) memory.SetInt(held, static_cast<int>(nearest_divider(tuning, dividers, metres)));
  if (!ImGui::IsItemActive() || dividers == 0) return;
  const auto divider = static_cast<std::size_t>(memory.GetInt(held));
  tuning.lod.level_distances[divider] = std::round(2 * metres) / 2;
  keep_in_order(tuning, divider);
}

/// Shows the levels as a band over the distance; its dividers can be dragged.
void show_band(const TabContext& context) {
  const Theme& theme = context.widgets.theme();
  Tuning& tuning = context.tuning;
  const Area band = context.widgets.area("Level band", 26);
  const auto levels = static_cast<std::size_t>(level_count(context.report));
  drag_dividers(band, levels - 1, tuning);
  if (band.hovered) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const auto x_of = [&band](float metres) {
    return band.from.x + band.width() * std::min(1.0F, metres / longest_distance());
  };
  for (std::size_t level = 0; level < levels; ++level) {
    const float from = level == 0 ? band.from.x : x_of(tuning.lod.level_distances[level - 1]) + theme.px(1);
    const float to = level == levels - 1 ? band.to.x : x_of(tuning.lod.level_distances[level]) - theme.px(1);
    if (to <= from) continue;
    draw.AddRectFilled({from, band.from.y}, {to, band.to.y},
                       ImGui::GetColorU32(colour::with_alpha(colour::bone_level(static_cast<int>(level)), 0.85F)),
                       theme.px(3));
    const std::string words = bones_of(context.report, static_cast<int>(level));
    if (to - from > theme.px(20)) {
      draw_text(theme.small, {(from + to) / 2, band.from.y + theme.px(6)},
                colour::ink_on(colour::bone_level(static_cast<int>(level))), words, 0.5F);
    }
  }
}

void show_levels(const TabContext& context) {
  const auto& [widgets, report, tuning, standard, requests, memory] = context;
  widgets.section("Levels");
  context.row("bone_lod",
              {.what = "Distant agents are evaluated with fewer bones: each level keeps the front part of the ordered "
                       "list below, and a dropped bone follows its nearest kept ancestor.",
               .cost = "off evaluates all bones of every agent."});
  for (int level = 1; level < level_count(report); ++level) {
    const std::string number = std::to_string(level), key = "bone_level_distance_" + number;
    const std::string what =
        "Agents beyond it keep " + bones_of(report, level) + " bones. The next level moves with it.";
    if (context.row(key.c_str(), {.what = what.c_str(), .unit = "metres from the camera"})) {
      keep_in_order(tuning, static_cast<std::size_t>(level) - 1);
    }
  }
}

void show_distances_as_band(const TabContext& context) {
  const std::optional<std::string> idle =
      idle_reason("bone_level_distance_1", context.tuning, context.report.situation);
  ImGui::BeginDisabled(idle.has_value());
  show_band(context);
  ImGui::EndDisabled();
  context.widgets.caption(idle ? "These distances have no effect: " + *idle + "."
                               : "Bones kept over 0 to 150 m. Drag a border.");
}

void show_agents_by_level(const TabContext& context) {
  const std::vector<int>& counts = context.report.agents_by_bone_level;
  if (counts.empty()) return;
  context.widgets.section("Agents in view by level");
  const Area plot = context.widgets.area("Agents by level", 84);
  const FrameReport& report = context.report;
  draw_bars(context.widgets.theme(), plot,
            {.counts = counts,
             .colour_of = [](int i) { return colour::bone_level(i); },
             .name_of = [&report](int i) { return "level " + std::to_string(i) + ": " + bones_of(report, i); }});
}

}  // namespace

int level_count(const FrameReport& report) {
  return report.level_bone_counts.empty() ? 4 : std::min(4, static_cast<int>(report.level_bone_counts.size()));
}

void show_forced_level(const TabContext& context, const char* label, const char* what) {
  static constexpr std::array<const char*, 5> words = {"rule", "0", "1", "2", "3"};
  const auto levels = static_cast<std::size_t>(level_count(context.report));
  int& forced = context.tuning.inspection.forced_bone_level;
  int word = std::min(forced, static_cast<int>(levels) - 1) + 1;
  context.unless_idle("forced_bone_level", [&] {
    if (context.widgets.choose(label, word, context.standard.inspection.forced_bone_level + 1,
                               std::span(words).first(levels + 1), {.what = what})) {
      forced = word - 1;
    }
  });
}

void show_bone_lod_tab(const TabContext& context) {
  show_levels(context);
  context.when_not_searching(show_distances_as_band);
  // The same value as *Force level* of the other tab, beside the bones that it drops.
  show_forced_level(context, "Preview level",
                    "Shows all agents in view with the bones of this level, for a look at what it loses.");
  show_meshes(context);
  context.when_not_searching(show_agents_by_level);
  context.when_not_searching(show_bone_list);
}

}  // namespace throng::app
