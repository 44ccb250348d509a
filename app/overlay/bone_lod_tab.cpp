#include "app/overlay/bone_lod_tab.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "app/overlay/numbers.h"
#include "app/overlay/plots.h"

namespace throng::app {
namespace {

constexpr std::array<const char*, 3> level_distance_labels = {"Level 1 from", "Level 2 from", "Level 3 from"};
constexpr std::array<const char*, 5> mesh_words = {"auto", "0", "1", "2", "3"};

float longest_distance() { return static_cast<float>(scale_of("bone_level_distance_1").highest); }

/// Levels follow each other: the neighbours of a distance that was moved give way.
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

/// The levels as a band over the distance; its dividers can be dragged.
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
      draw_text(theme.small, {(from + to) / 2, band.from.y + theme.px(6)}, colour::on_accent, words, 0.5F);
    }
  }
}

void show_levels(const TabContext& context) {
  const auto& [widgets, report, tuning, standard, commands] = context;
  widgets.section("Levels");
  widgets.toggle(
      "Per-bone LOD", tuning.lod.bone_lod, standard.lod.bone_lod,
      {.what = "Distant agents are evaluated with fewer bones: each level keeps the front part of the ordered "
               "list below, and a dropped bone follows its nearest kept ancestor.",
       .cost = "off evaluates all bones of every agent."});
  ImGui::BeginDisabled(!tuning.lod.bone_lod);
  for (std::size_t i = 0; i + 1 < static_cast<std::size_t>(level_count(report)); ++i) {
    const std::string what =
        "Agents beyond it keep " + bones_of(report, static_cast<int>(i) + 1) + " bones. The next level moves with it.";
    if (widgets.number(level_distance_labels.at(i), tuning.lod.level_distances[i], standard.lod.level_distances[i],
                       scale_of("bone_level_distance_1"), {.what = what.c_str(), .unit = "metres from the camera"})) {
      keep_in_order(tuning, i);
    }
  }
  show_band(context);
  widgets.caption("Bones kept over 0 to 150 m. Drag a border.");
  ImGui::EndDisabled();
  int mesh = tuning.mesh_lod + 1;
  widgets.choose("Mesh LOD", mesh, standard.mesh_lod + 1, mesh_words,
                 {.what = "auto: chosen by the agent's size on the screen. A number: that one for everyone, 0 is the "
                          "full mesh.",
                  .cost = "Triangles; on a software renderer most of the frame."});
  tuning.mesh_lod = mesh - 1;
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

constexpr std::array<const char*, 5> preview_words = {"rule", "0", "1", "2", "3"};

// The same value as *Force level* of the other tab, where one looks at what it does.
void show_preview(const TabContext& context) {
  const auto& [widgets, report, tuning, standard, commands] = context;
  const int levels = level_count(report);
  int word = std::min(tuning.inspection.forced_bone_level, levels - 1) + 1;
  if (widgets.choose("Preview level", word, standard.inspection.forced_bone_level + 1,
                     std::span(preview_words).first(static_cast<std::size_t>(levels) + 1),
                     {.what = "Shows everyone in view with the bones of this level, to look at what it loses."})) {
    tuning.inspection.forced_bone_level = word - 1;
  }
}

}  // namespace

int level_count(const FrameReport& report) {
  return report.level_bone_counts.empty() ? 4 : std::min(4, static_cast<int>(report.level_bone_counts.size()));
}

void BoneLodTab::show(const TabContext& context) {
  show_levels(context);
  show_preview(context);
  show_agents_by_level(context);
  list_.show(context);
}

}  // namespace throng::app
