#include <algorithm>
#include <array>
#include <utility>

#include "app/overlay/tabs.h"
#include "app/settings/preset.h"

namespace throng::app {
namespace {

constexpr std::array<const char*, 2> pair_words = {"A", "B"};
constexpr float preset_height = 28, button_width = 66;

void show_pair(const TabContext& context) {
  const auto& [widgets, report, tuning, standard, commands, memory] = context;
  widgets.section("Compare");
  int shown = memory.pair.shows_b() ? 1 : 0;
  if (widgets.choose("In use", shown, shown, pair_words,
                     {.what = "Two tunings; the other one waits. Change some values, then go to and fro. Key B."})) {
    memory.pair.change_places(tuning);
  }
  const char* const label = memory.pair.shows_b() ? "Copy B to A" : "Copy A to B";
  if (ButtonRow(widgets, 1).button(label, {.what = "The other one becomes what is in use."})) {
    memory.pair.copy_to_other(tuning);
  }
}

void show_saving(const TabContext& context) {
  const auto& [widgets, report, tuning, standard, commands, memory] = context;
  std::string& name = memory.preset_name;
  widgets.section("Keep");
  widgets.text("Name", name, "letters, digits, - and _", {.what = "What the tuning and the camera are kept under."});
  const bool exists = std::ranges::binary_search(report.preset_names, name);
  if (ButtonRow(widgets, 1)
          .button(exists ? "Replace preset" : "Save preset",
                  {.what = "Writes all values and the camera to NAME.json in the folder of presets. A "
                           "preset of that name is replaced."},
                  can_name_a_preset(name) ? nullptr : "a name has letters, digits, - and _")) {
    commands.save_preset = name;
  }
  commands.copy_command_line |=
      ButtonRow(widgets, 1)
          .button("Copy as command line",
                  {.what = "Puts the options that make this crowd into the clipboard: only what differs "
                           "from what no option means."});
}

void show_names(const TabContext& context) {
  const auto& [widgets, report, tuning, standard, commands, memory] = context;
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
    const bool asked = memory.about_to_delete == name;
    if (widgets.named_button(asked ? "Really?" : "Delete", "Delete " + name, {.what = "Removes its file."}, width)) {
      if (asked) commands.delete_preset = name;
      memory.about_to_delete = asked ? "" : name;
    }
    ImGui::PopID();
    ImGui::SetCursorScreenPos(at);
    ImGui::Dummy({0, theme.px(preset_height)});
  }
}

}  // namespace

void TuningPair::change_places(Tuning& tuning) {
  shows_b_ = !shows_b_;
  if (!other_) other_ = tuning;
  other_->paused = tuning.paused;
  other_->inspection = tuning.inspection;
  std::swap(*other_, tuning);
}

void show_presets_tab(const TabContext& context) {
  show_pair(context);
  show_saving(context);
  show_names(context);
}

}  // namespace throng::app
