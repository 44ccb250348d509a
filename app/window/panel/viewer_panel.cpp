#include "app/window/panel/viewer_panel.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "app/window/panel/controls/numbers.h"

namespace throng::app {
namespace {

constexpr float joint_reach = 14;  // pixels
constexpr float clip_height = 20, most_clips_seen = 7;

/// All that the parts of the panel share. They edit `settings`.
struct Panel {
  Widgets& widgets;
  const ViewerReport& report;
  ViewerPanelMemory& memory;
  Requests& requests;
  ViewerSettings settings;
};

void show_way_back(const Panel& panel, const std::string& name) {
  Widgets& widgets = panel.widgets;
  widgets.section(name.c_str());
  if (wide_button(widgets, "Back to the crowd", {.what = "The crowd goes on where it waits. Key Esc."}))
    panel.requests.ask(LeaveViewer{});
}

void show_preview(const Panel& panel) {
  if (!panel.report.preview) return;
  Widgets& widgets = panel.widgets;
  const std::string role = role_names.at(index_of(panel.report.preview->role));
  widgets.section("A clip for a role");
  widgets.caption("Choose below what plays for " + role + ". The crowd plays it once you apply it.");
  if (wide_button(widgets, "Apply to the crowd",
                  {.what = "Agents keep their places, unless the character begins or ceases to walk."}))
    panel.requests.ask(ApplyPreview{});
}

void draw_clip(const Theme& theme, const Area& row, const ViewedClip& clip, bool is_chosen) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  if (is_chosen) draw.AddRectFilled(row.from, row.to, colour::accent_soft, theme.px(3));
  if (!is_chosen && row.hovered) draw.AddRectFilled(row.from, row.to, colour::well_hovered, theme.px(3));
  const float y = row.from.y + theme.px(2), figures = row.to.x - theme.px(8);
  ImGui::PushClipRect(row.from, {figures - theme.px(84), row.to.y}, true);
  draw_text(theme.small, {row.from.x + theme.px(8), y}, is_chosen ? colour::text : colour::dim, clip.name);
  ImGui::PopClipRect();
  draw_text(theme.small, {figures, y}, colour::dim, (clip.loops ? "loops   " : "") + fixed(clip.seconds, 2) + " s", 1);
}

void show_clip_rows(Panel& panel, const std::vector<std::size_t>& shown) {
  Widgets& widgets = panel.widgets;
  const Theme& theme = widgets.theme();
  for (const std::size_t clip : shown) {
    ImGui::PushID(static_cast<int>(clip));  // names may be alike
    const std::string name = "Clip:" + panel.report.clips[clip].name;
    const Area row = widgets.area(name.c_str(), clip_height);
    const bool clicked = ImGui::IsItemClicked();
    const bool taken = widgets.stop(name, row).take_activation();
    ImGui::PopID();
    if (clicked || taken) {
      panel.settings.clip = static_cast<int>(clip);
      panel.settings.bind_pose = false;
    }
    draw_clip(theme, row, panel.report.clips[clip], panel.settings.clip == static_cast<int>(clip));
  }
}

void show_clips(Panel& panel) {
  Widgets& widgets = panel.widgets;
  const std::vector<ViewedClip>& clips = panel.report.clips;
  widgets.section("Clips");
  widgets.text("Search clips", panel.memory.search, "part of a name", {.what = "Shows the clips whose names have it."});
  std::vector<std::size_t> shown;
  for (std::size_t clip = 0; clip < clips.size(); ++clip) {
    if (has_letters(clips[clip].name, panel.memory.search)) shown.push_back(clip);
  }
  const float rows = std::clamp(static_cast<float>(shown.size()), 1.0F, most_clips_seen);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
  ImGui::BeginChild("Clip list", {0, widgets.theme().px(clip_height * rows)});
  show_clip_rows(panel, shown);
  ImGui::EndChild();
  ImGui::PopStyleVar();
  widgets.caption(std::to_string(shown.size()) + " of " + counted(clips.size(), "clip"));
}

void show_time(Panel& panel) {
  const auto& [widgets, report, memory, requests, now] = panel;
  ViewerSettings& settings = panel.settings;
  widgets.section("Time");
  const auto at = static_cast<double>(report.seconds);
  double seconds = at;
  const double length = std::max(static_cast<double>(report.length), 0.001);
  if (widgets.number("At", seconds, at, {.highest = length, .decimals = 3, .suffix = " s"},
                     {.what = "Drag to stop the clip and to move through it.", .unit = "seconds from its start"})) {
    requests.ask(ScrubViewer{static_cast<float>(seconds)});
  }
  if (wide_button(widgets, settings.plays ? "Pause" : "Play", {.what = "Key Space."},
                  settings.bind_pose ? "nothing moves in the bind pose" : nullptr)) {
    settings.plays = !settings.plays;
  }
  widgets.toggle("Loop", settings.loops, true, {.what = "On: the clip begins anew at its end. Off: it stops there."});
  widgets.number("Clip speed", settings.speed, 1, {.lowest = -2, .highest = 4, .decimals = 2},
                 {.what = "How fast the clip plays; below 0: backwards.", .unit = "times its own speed"});
}

void show_blend(Panel& panel) {
  Widgets& widgets = panel.widgets;
  ViewerSettings& settings = panel.settings;
  std::vector<std::string> names;
  for (const ViewedClip& clip : panel.report.clips) names.push_back(clip.name);
  widgets.section("Blend");
  widgets.pick("Second clip", settings.blended, no_clip, names, no_clip_name,
               {.what = "A clip that is blended with the first. Both go in step, in the time between theirs."});
  ImGui::BeginDisabled(settings.blended == no_clip);
  widgets.number("Weight", settings.weight, 0.5F, {.decimals = 2},
                 {.what = "How much of the second clip is in the pose.", .unit = "0 to 1"});
  ImGui::EndDisabled();
}

/// Offers the numbers from 0 to below `count`; one alone is no choice.
void choose_number(Widgets& widgets, const char* label, int& index, std::size_t count, const Help& help) {
  static constexpr const char* numbers[] = {"0", "1", "2", "3"};
  if (count > 1) widgets.choose(label, index, 0, std::span(numbers).first(std::min<std::size_t>(count, 4)), help);
}

void show_look(Panel& panel) {
  const auto& [widgets, report, memory, requests, now] = panel;
  ViewerSettings& settings = panel.settings;
  widgets.section("Look");
  widgets.toggle("Bind pose", settings.bind_pose, false,
                 {.what = "The pose that the skin was made in, without a clip."});
  widgets.toggle("Bones", settings.bones, false, {.what = "A line from each joint to that of its parent."});
  widgets.toggle("Bounds", settings.bounds, false,
                 {.what = "The sphere that no pose of any clip leaves, which culling goes by, and the cylinder of the "
                          "body, which a click is aimed at."});
  widgets.pick("Weights of", settings.weighed_bone, -1, report.bones, "none",
               {.what = "Colours show how much of each part of the surface follows a bone: from blue, nothing, over "
                        "green to yellow, all."});
  choose_number(widgets, "Bone level", settings.bone_level, report.level_bones.size(),
                {.what = "The bones that a level of detail keeps; 0 has all."});
  choose_number(widgets, "Mesh LOD", settings.mesh_lod, report.meshes.size(),
                {.what = "The triangles that a level of detail keeps; 0 has all."});
  widgets.toggle("Turn", settings.turns, false, {.what = "The turntable goes round. A drag turns it by hand."});
  if (wide_button(widgets, "Front", {.what = "Back to where the turntable began. Key F."})) requests.ask(FaceFront{});
}

std::string metres(float value) { return fixed(value, value < 0.1F ? 4 : (value < 10 ? 2 : 1)) + " m"; }

void show_facts(const Panel& panel) {
  const auto& [widgets, report, memory, requests, settings] = panel;
  widgets.section("What is seen");
  widgets.fact("Height", metres(report.height), {.what = "Of its rest pose, above the ground."});
  widgets.fact("Reach", metres(report.reach), {.what = "Radius of the sphere that no pose of any clip leaves."});
  widgets.fact("Drawn", fixed(report.drawn_scale, report.drawn_scale < 10 ? 3 : 0) + " times as large",
               {.what = "The viewer draws each character so large that it fills the picture."});
  const auto level = static_cast<std::size_t>(settings.bone_level), mesh = static_cast<std::size_t>(settings.mesh_lod);
  if (level < report.level_bones.size()) {
    widgets.fact("Bones drawn", std::to_string(report.level_bones[level]), {.what = "At the bone level."});
  }
  if (mesh >= report.meshes.size()) return;
  widgets.fact("Triangles drawn", with_thousands(report.meshes[mesh].triangles), {.what = "At the mesh LOD."});
  if (mesh == 0) return;
  widgets.fact("Mesh error", metres(report.meshes[mesh].error_metres),
               {.what = "How far the surface of this mesh LOD is off the full one, at most."});
}

}  // namespace

void show_bone_name(const Theme& theme, const Area& picture, const ViewerReport& report) {
  const ImVec2 size = ImGui::GetIO().DisplaySize, pointer = ImGui::GetIO().MousePos;
  if (pointer.x >= picture.to.x) return;
  float nearest = theme.px(joint_reach);
  const ViewedJoint* found = nullptr;
  for (const ViewedJoint& joint : report.joints) {
    const float away = std::hypot(joint.x * size.x - pointer.x, joint.y * size.y - pointer.y);
    if (away >= nearest) continue;
    nearest = away;
    found = &joint;
  }
  if (found != nullptr) show_lines({report.bones[found->bone]});
}

void show_viewer_panel(Widgets& widgets, const std::string& name, const ViewerReport& report, ViewerPanelMemory& memory,
                       Requests& requests) {
  const SetViewer* const asked = last_of<SetViewer>(requests);
  Panel panel{widgets, report, memory, requests, asked != nullptr ? asked->settings : report.settings};
  show_way_back(panel, name);
  show_preview(panel);
  show_clips(panel);
  show_time(panel);
  show_look(panel);
  show_blend(panel);
  show_facts(panel);
  if (panel.settings != report.settings) requests.ask(SetViewer{panel.settings});
}

}  // namespace throng::app
