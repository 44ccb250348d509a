#include <algorithm>
#include <array>
#include <utility>

#include "app/overlay/tabs.h"
#include "app/settings/preset.h"

namespace throng::app {
namespace {

constexpr const char* no_name = "a name has letters, digits, - and _";
constexpr std::array<const char*, 2> pair_words = {"A", "B"};
constexpr float preset_height = 28, button_width = 66;

/// A name with buttons to its right.
class NameRow {
 public:
  NameRow(Widgets& widgets, const std::string& name) : widgets_(widgets), at_(ImGui::GetCursorScreenPos()) {
    right_ = at_.x + ImGui::GetContentRegionAvail().x;
    const Theme& theme = widgets.theme();
    draw_text(theme.regular, {at_.x, at_.y + theme.px(5)}, colour::text, name);
    ImGui::PushID(name.c_str());
  }
  ~NameRow() {
    ImGui::PopID();
    ImGui::SetCursorScreenPos(at_);
    ImGui::Dummy({0, widgets_.theme().px(preset_height)});
  }
  NameRow(const NameRow&) = delete;
  NameRow& operator=(const NameRow&) = delete;

  /// Shows a button, `place` of them from the right edge. Returns whether it was pressed.
  [[nodiscard]] bool button(int place, const char* words, const std::string& name, const Help& help) const {
    const float width = widgets_.theme().px(button_width), gap = widgets_.theme().px(6);
    ImGui::SetCursorScreenPos({right_ - width - static_cast<float>(place) * (width + gap), at_.y});
    return widgets_.named_button(words, name, help, width);
  }

 private:
  Widgets& widgets_;
  ImVec2 at_;
  float right_ = 0;
};

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
                  can_name_a_preset(name) ? nullptr : no_name)) {
    commands.save_preset = name;
  }
  commands.copy_command_line |=
      ButtonRow(widgets, 1)
          .button("Copy as command line",
                  {.what = "Puts the options that make this crowd into the clipboard: its models and roles, and "
                           "what differs from what no option means. Orders of bones and parts of the body are in "
                           "crowd files alone."});
}

void show_names(const TabContext& context) {
  const auto& [widgets, report, tuning, standard, commands, memory] = context;
  widgets.section("Kept");
  if (report.preset_names.empty()) widgets.caption("Nothing yet.");
  for (const std::string& name : report.preset_names) {
    const NameRow row(widgets, name);
    if (row.button(1, "Load", "Load " + name, {.what = "Its values and its camera, at the next frame."})) {
      commands.load_preset = name;
    }
    const bool asked = memory.about_to_delete == name;
    if (row.button(0, asked ? "Really?" : "Delete", "Delete " + name, {.what = "Removes its file."})) {
      if (asked) commands.delete_preset = name;
      memory.about_to_delete = asked ? "" : name;
    }
  }
}

void show_crowd_files(const TabContext& context) {
  const auto& [widgets, report, tuning, standard, commands, memory] = context;
  std::string& name = memory.crowd_name;
  widgets.section("Crowd files");
  widgets.text("Crowd name", name, "letters, digits, - and _", {.what = "NAME of NAME.throng, in the working folder."});
  const bool exists = std::ranges::binary_search(report.crowd_names, name);
  if (ButtonRow(widgets, 1)
          .button(exists ? "Replace crowd" : "Save crowd",
                  {.what = "Writes NAME.throng: the models and their shares, roles, parts of the body and orders of "
                           "bones, all values and the camera. throng NAME.throng, a drop on the window or Open brings "
                           "all of it back."},
                  can_name_a_preset(name) ? nullptr : no_name)) {
    commands.save_crowd = name;
  }
  if (widgets.is_searching()) return;
  for (const std::string& each : report.crowd_names) {
    const NameRow row(widgets, each);
    if (row.button(0, "Open", "Open " + each, {.what = "Its characters, values and camera. The crowd begins anew."})) {
      commands.open_crowd = each;
    }
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
  context.when_not_searching(show_names);
  show_crowd_files(context);
}

}  // namespace throng::app
