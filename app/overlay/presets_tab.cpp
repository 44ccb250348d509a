#include "app/overlay/presets_tab.h"

#include <algorithm>
#include <array>

#include "app/overlay/preset_name.h"

namespace throng::app {
namespace {

constexpr std::array<const char*, 2> pair_words = {"A", "B"};
constexpr float preset_height = 28, button_width = 66;

}  // namespace

void PresetsTab::show_pair(const TabContext& context) {
  const auto& [widgets, report, tuning, standard, commands] = context;
  widgets.section("Compare");
  int shown = pair.shows_b() ? 1 : 0;
  if (widgets.choose("In use", shown, shown, pair_words,
                     {.what = "Two tunings; the other one waits. Change some values, then go to and fro. Key B."})) {
    pair.change_places(tuning);
  }
  const char* const label = pair.shows_b() ? "Copy B to A" : "Copy A to B";
  if (widgets.button(label, {.what = "The other one becomes what is in use."}, ImGui::GetContentRegionAvail().x)) {
    pair.copy_to_other(tuning);
  }
}

void PresetsTab::show_saving(const TabContext& context) {
  const auto& [widgets, report, tuning, standard, commands] = context;
  widgets.section("Keep");
  widgets.text("Name", name_, "letters, digits, - and _", {.what = "What the tuning and the camera are kept under."});
  const bool fits = can_name_a_preset(name_), exists = std::ranges::binary_search(report.preset_names, name_);
  ImGui::BeginDisabled(!fits);
  const Help help{.what =
                      "Writes all values and the camera to NAME.json in the folder of presets. A preset of that "
                      "name is replaced."};
  if (widgets.button(exists ? "Replace preset" : "Save preset", help, ImGui::GetContentRegionAvail().x)) {
    commands.save_preset = name_;
  }
  ImGui::EndDisabled();
  commands.copy_command_line |=
      widgets.button("Copy as command line",
                     {.what = "Puts the options that make this crowd into the clipboard: only "
                              "what differs from what no option means."},
                     ImGui::GetContentRegionAvail().x);
}

void PresetsTab::show_names(const TabContext& context) {
  const auto& [widgets, report, tuning, standard, commands] = context;
  widgets.section("Kept");
  if (report.preset_names.empty()) widgets.caption("Nothing yet.");
  const Theme& theme = widgets.theme();
  for (const std::string& name : report.preset_names) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float right = at.x + ImGui::GetContentRegionAvail().x, width = theme.px(button_width), gap = theme.px(6);
    draw_text(theme.regular, {at.x, at.y + theme.px(5)}, colour::text, name);
    ImGui::PushID(name.c_str());
    ImGui::SetCursorScreenPos({right - 2 * width - gap, at.y});
    if (widgets.named_button("Load", "Load " + name, {.what = "Its values and its camera, at the next frame."},
                             width)) {
      commands.load_preset = name;
    }
    ImGui::SetCursorScreenPos({right - width, at.y});
    const bool asked = about_to_delete_ == name;
    if (widgets.named_button(asked ? "Really?" : "Delete", "Delete " + name, {.what = "Removes its file."}, width)) {
      if (asked) commands.delete_preset = name;
      about_to_delete_ = asked ? "" : name;
    }
    ImGui::PopID();
    ImGui::SetCursorScreenPos(at);
    ImGui::Dummy({0, theme.px(preset_height)});
  }
}

void PresetsTab::show(const TabContext& context) {
  show_pair(context);
  show_saving(context);
  show_names(context);
}

}  // namespace throng::app
