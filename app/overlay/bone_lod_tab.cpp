#include <algorithm>
#include <array>
#include <cmath>

#include "app/overlay/numbers.h"
#include "app/overlay/plots.h"
#include "app/overlay/tabs.h"

namespace throng::app {
namespace {

constexpr std::array<const char*, 3> level_distance_labels = {"Level 1 from", "Level 2 from", "Level 3 from"};
constexpr std::array<const char*, 5> mesh_words = {"auto", "0", "1", "2", "3"};
constexpr float longest_distance = 150;

ImU32 level_colour(int level) { return colour::step(level, 4); }

/// Levels follow each other: the neighbours of a distance that was moved give way.
void keep_in_order(Tuning& tuning, int moved) {
  auto& distance = tuning.bone_level_distance;
  for (int i = moved + 1; i < 3; ++i) distance[i] = std::max(distance[i], distance[i - 1]);
  for (int i = moved - 1; i >= 0; --i) distance[i] = std::min(distance[i], distance[i + 1]);
}

std::string bones_of(const FrameReport& report, int level) {
  const auto index = static_cast<std::size_t>(level);
  return index < report.level_bone_counts.size() ? std::to_string(report.level_bone_counts[index]) : "-";
}

int nearest_divider(const Tuning& tuning, int dividers, float metres) {
  int nearest = 0;
  for (int i = 1; i < dividers; ++i) {
    const float now = std::abs(tuning.bone_level_distance[i] - metres);
    if (now < std::abs(tuning.bone_level_distance[nearest] - metres)) nearest = i;
  }
  return nearest;
}

void drag_dividers(const Area& band, int dividers, Tuning& tuning) {
  const float metres =
      std::clamp((ImGui::GetIO().MousePos.x - band.from.x) / band.width(), 0.0F, 1.0F) * longest_distance;
  ImGuiStorage& memory = *ImGui::GetStateStorage();
  const ImGuiID held = ImGui::GetID("held divider");
  if (ImGui::IsItemActivated()) memory.SetInt(held, nearest_divider(tuning, dividers, metres));
  if (!ImGui::IsItemActive() || dividers == 0) return;
  const int divider = memory.GetInt(held);
  tuning.bone_level_distance[divider] = std::round(2 * metres) / 2;
  keep_in_order(tuning, divider);
}

/// The levels as a band over the distance; its dividers can be dragged.
void show_band(const TabContext& context) {
  const Theme& theme = context.widgets.theme();
  Tuning& tuning = context.tuning;
  const Area band = context.widgets.area("Level band", 26);
  const int levels = level_count(context.report);
  drag_dividers(band, levels - 1, tuning);
  if (band.hovered) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const auto x_of = [&band](float metres) {
    return band.from.x + band.width() * std::min(1.0F, metres / longest_distance);
  };
  for (int level = 0; level < levels; ++level) {
    const float from = level == 0 ? band.from.x : x_of(tuning.bone_level_distance[level - 1]) + theme.px(1);
    const float to = level == levels - 1 ? band.to.x : x_of(tuning.bone_level_distance[level]) - theme.px(1);
    if (to <= from) continue;
    draw.AddRectFilled({from, band.from.y}, {to, band.to.y},
                       ImGui::GetColorU32(colour::with_alpha(level_colour(level), 0.85F)), theme.px(3));
    const std::string words = bones_of(context.report, level);
    if (to - from > theme.px(20)) {
      draw_text(theme.small, {(from + to) / 2, band.from.y + theme.px(6)}, colour::on_accent, words, 0.5F);
    }
  }
}

void show_levels(const TabContext& context) {
  const auto& [widgets, report, tuning, standard, commands] = context;
  widgets.section("Levels");
  widgets.toggle(
      "Per-bone LOD", tuning.bone_lod, standard.bone_lod,
      {.what = "Distant agents are evaluated with fewer bones: each level keeps the front part of the ordered "
               "list below, and a dropped bone follows its nearest kept ancestor.",
       .cost = "off evaluates all bones of every agent."});
  ImGui::BeginDisabled(!tuning.bone_lod);
  for (int i = 0; i + 1 < level_count(report); ++i) {
    const std::string what =
        "Agents beyond it keep " + bones_of(report, i + 1) + " bones. The next level moves with it.";
    if (widgets.number(level_distance_labels.at(static_cast<std::size_t>(i)), tuning.bone_level_distance[i],
                       standard.bone_level_distance[i],
                       {.lowest = 0, .highest = longest_distance, .decimals = 1, .suffix = " m"},
                       {.what = what.c_str(), .unit = "metres from the camera"})) {
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
             .colour_of = [](int i) { return level_colour(i); },
             .name_of = [&report](int i) { return "level " + std::to_string(i) + ": " + bones_of(report, i); }});
}

void draw_bone(const Theme& theme, const BoneRow& bone, std::size_t place, int levels) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float right = at.x + ImGui::GetContentRegionAvail().x, middle = at.y + theme.px(9);
  const int level = std::clamp(bone.level, 0, 3);
  draw_text(theme.small, {at.x + theme.px(22), at.y + theme.px(1)}, colour::faint, std::to_string(place + 1), 1);
  const float indent = theme.px(30) + std::min(static_cast<float>(bone.depth) * theme.px(7), theme.px(110));
  draw_text(theme.small, {at.x + indent, at.y + theme.px(1)}, colour::text, bone.name);
  for (int kept = 0; kept < levels; ++kept) {
    const ImU32 ink = kept <= level ? level_colour(kept) : colour::well_hovered;
    ImGui::GetWindowDrawList()->AddCircleFilled(
        {right - theme.px(12) - theme.px(11) * static_cast<float>(levels - 1 - kept), middle}, theme.px(3),
        ImGui::GetColorU32(ink));
  }
  ImGui::Dummy({0, theme.px(18)});
}

void draw_divider(const Theme& theme, int level, std::size_t bones) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float right = at.x + ImGui::GetContentRegionAvail().x, middle = at.y + theme.px(8);
  const ImU32 ink = level_colour(level);
  const std::string words = "level " + std::to_string(level) + " keeps the " + std::to_string(bones) + " above";
  const float width = theme.small->CalcTextSizeA(theme.small->FontSize, FLT_MAX, 0, words.c_str()).x;
  draw_text(theme.small, {at.x + theme.px(30), at.y}, ink, words);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddLine({at.x, middle}, {at.x + theme.px(24), middle}, ImGui::GetColorU32(ink));
  draw.AddLine({at.x + width + theme.px(38), middle}, {right, middle}, ImGui::GetColorU32(ink));
  ImGui::Dummy({0, theme.px(17)});
}

void show_bones(const TabContext& context) {
  const Theme& theme = context.widgets.theme();
  const std::vector<BoneRow>& bones = context.report.bones;
  context.widgets.section("Bones, the most visible first");
  const float height = std::max(theme.px(150), ImGui::GetContentRegionAvail().y);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
  ImGui::PushStyleColor(ImGuiCol_ChildBg, colour::well);
  ImGui::BeginChild("Bone list", {0, height});
  context.widgets.record("Bone list", {.from = ImGui::GetWindowPos(),
                                       .to = {ImGui::GetWindowPos().x + ImGui::GetWindowWidth(),
                                              ImGui::GetWindowPos().y + ImGui::GetWindowHeight()}});
  ImGui::Dummy({0, theme.px(4)});
  for (std::size_t i = 0; i < bones.size(); ++i) {
    draw_bone(theme, bones[i], i, level_count(context.report));
    const int below = i + 1 < bones.size() ? bones[i + 1].level : 0;
    for (int level = std::min(bones[i].level, 3); level > below; --level) draw_divider(theme, level, i + 1);
  }
  ImGui::EndChild();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
}

}  // namespace

int level_count(const FrameReport& report) {
  return report.level_bone_counts.empty() ? 4 : std::min(4, static_cast<int>(report.level_bone_counts.size()));
}

void show_bone_lod_tab(const TabContext& context) {
  show_levels(context);
  show_agents_by_level(context);
  show_bones(context);
}

}  // namespace throng::app
