#include <limits>
#include <string>
#include <vector>

#include "app/overlay/numbers.h"
#include "app/overlay/tabs.h"
#include "app/settings/choices.h"

namespace throng::app {
namespace {

std::string file_name(const std::string& path) { return path.substr(path.find_last_of('/') + 1); }

// One is a fact; of several, the one whose roles and bones are shown is chosen.
void show_characters(const TabContext& context) {
  const auto& [widgets, report, tuning, standard, commands] = context;
  if (report.characters.size() < 2) {
    widgets.fact("Model", report.characters.empty() ? "" : report.characters.front(),
                 {.what = "The character of every agent. Give another file, or several, on the command line."});
    return;
  }
  std::vector<std::string> names;
  for (const std::string& character : report.characters) names.push_back(file_name(character));
  auto shown = static_cast<int>(report.character);
  if (widgets.pick("Model", shown, shown, names, nullptr,
                   {.what = "The characters of the crowd: whose roles are shown below, and whose bones."})) {
    commands.character = static_cast<std::size_t>(shown);
  }
}

void show_who(const TabContext& context) {
  const auto& [widgets, report, tuning, standard, commands] = context;
  widgets.section("Who");
  show_characters(context);
  widgets.choice("Scene", tuning.scene, standard.scene, scene_words,
                 {.what = "plaza: people cross, stop and talk. parade: companies march past spectators. "
                          "stadium: seats on tiers, and a wave that runs round. grid: everyone stands in rows. "
                          "film: a cut scene with an actor, a balloon and a camera.",
                  .cost = "Changing it places all agents anew."});
  widgets.number("Agents", tuning.agents, standard.agents, scale_of("agents"),
                 {.what = "Characters in the crowd, each in a pose of its own.",
                  .unit = "1 to 100,000",
                  .cost = "Animation grows with agents in view, memory with all of them."});
  auto seed = static_cast<int>(tuning.seed);
  widgets.number("Seed", seed, static_cast<int>(standard.seed), scale_of("seed"),
                 {.what = "Decides phases, speeds, heights, colours and places. The same seed is the same crowd.",
                  .unit = "0 to 9,999",
                  .cost = "Changing it places all agents anew."});
  tuning.seed = static_cast<std::uint32_t>(seed);
  widgets.toggle(
      "Placed feet", tuning.placed_feet, standard.placed_feet,
      {.what = "Feet near by stand where they came down; with LOD off everyone's. Off: they go as the clip has "
               "them, and slide in turns.",
       .cost = "Some microseconds an agent."});
}

void show_time(const TabContext& context) {
  const auto& [widgets, report, tuning, standard, commands] = context;
  widgets.section("Time");
  widgets.toggle("Pause", tuning.paused, standard.paused,
                 {.what = "Holds the crowd; the camera still flies. Space does the same."});
  widgets.number("Speed", tuning.time_scale, standard.time_scale, scale_of("time_scale"),
                 {.what = "How fast the crowd's clock runs.", .unit = "times real time, 0 to 4"});
  const float gap = ImGui::GetStyle().ItemSpacing.x, width = (ImGui::GetContentRegionAvail().x - gap) / 2;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::BeginDisabled(!tuning.paused);
  commands.step = widgets.button("Step", {.what = "One frame onwards, while paused."}, width) || commands.step;
  ImGui::EndDisabled();
  ImGui::SetCursorScreenPos({at.x + width + gap, at.y});
  ImGui::BeginDisabled(report.snapshots == 0);
  commands.rewind |= widgets.button("Rewind",
                                    {.what = "Back to the newest of up to ten snapshots, one each half second; pressed "
                                             "again, to the one before it. From there everything happens as it did.",
                                     .cost = "Memory of ten crowds; none are taken above 20,000 agents."},
                                    width);
  ImGui::EndDisabled();
  const std::string kept = report.snapshots == 0
                               ? "No snapshot yet."
                               : std::to_string(report.snapshots) + " snapshots, the newest " +
                                     fixed(static_cast<double>(report.snapshot_seconds), 1) + " s ago.";
  widgets.caption(kept);
}

void show_picture(const TabContext& context) {
  const auto& [widgets, report, tuning, standard, commands] = context;
  widgets.section("Picture");
  widgets.choice("Colours", tuning.debug_view, standard.debug_view, debug_view_words,
                 {.what = "none: everyone's own clothes. interval: frames between updates. bones: per-bone LOD level. "
                          "mesh: mesh LOD. Cool colours are full detail, warm ones the coarsest."});
  widgets.toggle("Bones as lines", tuning.bones_as_lines, standard.bones_as_lines,
                 {.what = "Draws the skeletons over the characters.", .cost = "One line a bone and agent in view."});
  const Theme& theme = widgets.theme();
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const float width = (ImGui::GetContentRegionAvail().x - 2 * gap) / 3;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  commands.frame_crowd |=
      widgets.button("Frame crowd", {.what = "Moves the camera until all are in view. Key F."}, width);
  ImGui::SetCursorScreenPos({at.x + width + gap, at.y});
  commands.copy_camera |=
      widgets.button("Copy camera", {.what = "Puts the camera as an option into the clipboard. Key C."}, width);
  ImGui::SetCursorScreenPos({at.x + 2 * (width + gap), at.y});
  commands.screenshot |= widgets.button("Screenshot", {.what = "Writes the picture as a PNG. Key F12."}, width);
  ImGui::Dummy({0, theme.px(2)});
  const CameraPlace& camera = report.camera;
  const auto number = [](float value) { return fixed(static_cast<double>(value), 1); };
  widgets.fact("Camera at", number(camera.x) + ", " + number(camera.y) + ", " + number(camera.z),
               {.what = "Where the camera stands.", .unit = "metres"});
  widgets.fact("Looks", number(camera.yaw) + "\xC2\xB0 yaw, " + number(camera.pitch) + "\xC2\xB0 pitch",
               {.what = "Yaw 0 looks along -Z; a positive pitch looks up.", .unit = "degrees"});
}

struct RoleRow {
  Role role;
  const char* label;
  const char* what;
};

constexpr RoleRow role_rows[] = {
    {Role::stand, "Stand", "The clip of those who stand. Without one, agents repeat what clips there are, in place."},
    {Role::look_around, "Look around", "The clip of those who stop to look. Without one they stand."},
    {Role::walk, "Walk", "The clip of those who walk. Without one nobody walks."},
    {Role::jog, "Jog", "The clip of those who jog. Without one they walk."},
    {Role::run, "Run", "The clip of those who run. Without one they jog or walk."},
    {Role::wave, "Wave", "The clip of those who greet somebody."},
    {Role::cheer, "Cheer", "The clip of those who cheer, and of the stadium's wave."},
    {Role::clap, "Clap", "The clip of those who applaud."},
    {Role::sit, "Sit", "The clip of those who have a seat. Without one they stand."},
};

void show_roles(const TabContext& context) {
  const auto& [widgets, report, tuning, standard, commands] = context;
  widgets.section("Roles");
  RoleClips clips = report.role_clips;
  for (const RoleRow& row : role_rows) {
    const std::size_t role = index_of(row.role);
    widgets.pick(row.label, clips[role], report.suggested_role_clips[role], report.clip_names, no_clip_name,
                 {.what = row.what, .cost = "Changing it places all agents anew."});
  }
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const float width = (ImGui::GetContentRegionAvail().x - gap) / 2;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  commands.save_roles |= widgets.button(
      "Save roles", {.what = "Keeps them beside the model, in MODEL.throng.json, for next time."}, width);
  ImGui::SetCursorScreenPos({at.x + width + gap, at.y});
  if (widgets.button("Reset roles", {.what = "Back to what the clips' names suggest."}, width)) {
    clips = report.suggested_role_clips;
  }
  if (clips != report.role_clips) commands.roles = clips;
}

void show_in_view(const TabContext& context) {
  const FrameReport& report = context.report;
  Widgets& widgets = context.widgets;
  const auto count = [](auto value) { return with_thousands(static_cast<std::uint64_t>(value)); };
  widgets.section("In this frame");
  widgets.fact("In view", count(report.visible) + " of " + count(report.agents),
               {.what = "Agents inside the camera's frustum."});
  widgets.fact("Poses computed", count(report.agents_updated),
               {.what = "Agents updated in this frame; the others blend towards the pose they were given earlier."});
  widgets.fact("Bones evaluated", count(report.bones_evaluated), {.what = "Over all agents updated in this frame."});
  widgets.fact("Draw calls", count(report.draw_calls),
               {.what = "They do not grow with the crowd: mesh LODs times materials times palette pages at most."});
  widgets.fact("Triangles", count(report.triangles), {.what = "Of the crowd, after culling and mesh LOD."});
}

}  // namespace

void show_crowd_tab(const TabContext& context) {
  show_who(context);
  show_time(context);
  show_picture(context);
  show_in_view(context);
  show_roles(context);
}

}  // namespace throng::app
