#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/settings/preset.h"
#include "app/window/panel/tabs.h"

namespace throng::app {
namespace {

constexpr const char* no_name = "a name has letters, digits, - and _";
constexpr std::size_t most_differences = 6;
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

const char* why_alone(const TuningPair& pair) { return pair.has_two() ? nullptr : "B is empty. Copy A to B first."; }

/// Shows the name of A or B, with a mark if it is in use.
void show_tuning_name(const TabContext& context, std::size_t place) {
  Widgets& widgets = context.widgets;
  TuningPair& pair = context.memory.pair;
  const char* const letter = TuningPair::letters.at(place);
  if (pair.has_two() && pair.shows_b() == (place == 1)) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const Theme& theme = widgets.theme();
    ImGui::GetWindowDrawList()->AddRectFilled({at.x - theme.px(8), at.y + theme.px(4)},
                                              {at.x - theme.px(5), at.y + theme.px(21)}, colour::accent, theme.px(1));
  }
  const bool is_there = place == 0 || pair.has_two();
  widgets.begin_idle(is_there ? std::nullopt : std::optional<std::string>(why_alone(pair)));
  widgets.text(letter, pair.names.at(place), is_there ? "a name, if you like" : "empty",
               {.what = "What this tuning is called. The badge over the crowd names the one in use."});
  widgets.end_idle();
}

void show_differences(const TabContext& context) {
  const TuningPair& pair = context.memory.pair;
  const Tuning& a = pair.shows_b() ? pair.other() : context.tuning;
  const Tuning& b = pair.shows_b() ? context.tuning : pair.other();
  const std::vector<TuningDifference> found = differences(a, b);
  context.widgets.caption(found.empty()
                              ? "No value differs yet. Change some, then press B."
                              : counted(found.size(), "value") + (found.size() == 1 ? " differs:" : " differ:"));
  const std::size_t shown = std::min(found.size(), most_differences);
  for (const TuningDifference& each : std::span(found).first(shown)) {
    context.widgets.fact(find_tuning_value(each.key)->name().c_str(), "A " + each.first + "   B " + each.second, {});
  }
  if (shown < found.size()) context.widgets.caption("and " + std::to_string(found.size() - shown) + " more.");
}

void show_pair(const TabContext& context) {
  const auto& [widgets, report, tuning, standard, requests, memory] = context;
  TuningPair& pair = memory.pair;
  widgets.section("Compare");
  for (std::size_t place = 0; place < TuningPair::letters.size(); ++place) show_tuning_name(context, place);
  if (pair.has_two()) {
    int shown = pair.shows_b() ? 1 : 0;
    if (widgets.choose("In use", shown, shown, TuningPair::letters,
                       {.what = "The tuning that the crowd has now; the other one waits. Key B."})) {
      pair.change_places(tuning);
    }
    show_differences(context);
  } else {
    widgets.caption("Copy A to B, change some values, and go to and fro by B.");
  }
  const std::string other = pair.other_letter();
  ButtonRow buttons(widgets, 2);
  if (buttons.button((std::string("Copy ") + pair.letter_in_use() + " to " + other).c_str(),
                     {.what = "The other one becomes what is in use."})) {
    pair.copy_to_other(tuning);
  }
  if (buttons.button(("Forget " + other).c_str(), {.what = "Ends the comparison. What is in use stays, as A."},
                     why_alone(pair))) {
    pair.forget_other();
  }
}

void show_saving(const TabContext& context) {
  const auto& [widgets, report, tuning, standard, requests, memory] = context;
  std::string& name = memory.preset_name;
  widgets.section("Keep");
  widgets.text("Name", name, "letters, digits, - and _", {.what = "What the tuning and the camera are kept under."});
  const bool exists = std::ranges::binary_search(report.preset_names, name);
  if (wide_button(widgets, exists ? "Replace preset" : "Save preset",
                  {.what = "Writes all values and the camera to NAME.json in the folder of presets. A "
                           "preset of that name is replaced."},
                  can_name_a_preset(name) ? nullptr : no_name)) {
    requests.ask(SavePreset{name});
  }
  if (wide_button(widgets, "Copy as command line",
                  {.what = "Puts a command into the clipboard that opens all of this again: the models, a recorded "
                           "crowd, what differs from what no option means, and cameras. What no option says is in "
                           "its --crowd."}))
    requests.ask(CopyCommandLine{});
}

void show_names(const TabContext& context) {
  const auto& [widgets, report, tuning, standard, requests, memory] = context;
  widgets.section("Kept");
  if (report.preset_names.empty()) widgets.caption("Nothing yet.");
  const std::string into_other = std::string("To ") + memory.pair.other_letter();
  for (const std::string& name : report.preset_names) {
    const NameRow row(widgets, name);
    if (row.button(2, into_other.c_str(), into_other + " " + name,
                   {.what = "Its values become the other tuning, to compare with what is in use."})) {
      requests.ask(LoadIntoOther{name});
    }
    if (row.button(1, "Load", "Load " + name, {.what = "Its values and its camera, at the next frame."})) {
      requests.ask(LoadPreset{name});
    }
    const bool asked = memory.about_to_delete == name;
    if (row.button(0, asked ? "Really?" : "Delete", "Delete " + name, {.what = "Removes its file."})) {
      if (asked) requests.ask(DeletePreset{name});
      memory.about_to_delete = asked ? "" : name;
    }
  }
}

void show_crowd_files(const TabContext& context) {
  const auto& [widgets, report, tuning, standard, requests, memory] = context;
  std::string& name = memory.crowd_name;
  widgets.section("Crowd files");
  widgets.text("Crowd name", name, "letters, digits, - and _", {.what = "NAME of NAME.throng, in the working folder."});
  const bool exists = std::ranges::binary_search(report.crowd_names, name);
  if (wide_button(widgets, exists ? "Replace crowd" : "Save crowd",
                  {.what = "Writes NAME.throng: the models and all that was chosen for them, a recorded crowd and the "
                           "part of it that is played, all values, cameras and A and B. throng NAME.throng, a drop "
                           "on the window or Open brings all of it back."},
                  can_name_a_preset(name) ? nullptr : no_name)) {
    requests.ask(SaveCrowd{name});
  }
  if (widgets.is_searching()) return;
  for (const std::string& each : report.crowd_names) {
    const NameRow row(widgets, each);
    if (row.button(0, "Open", "Open " + each, {.what = "Its characters, values and camera. The crowd begins anew."})) {
      requests.ask(OpenCrowd{each});
    }
  }
}

}  // namespace

void show_presets_tab(const TabContext& context) {
  show_pair(context);
  show_saving(context);
  context.when_not_searching(show_names);
  show_crowd_files(context);
}

}  // namespace throng::app
