#include "app/window/panel/overlay.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <utility>

#include <imgui.h>

#include "app/files/data_folder.h"
#include "app/show/request/crowd_file.h"
#include "app/show/request/openable_files.h"
#include "app/window/panel/cards.h"
#include "app/window/panel/file_picker.h"
#include "app/window/panel/hotkeys.h"
#include "app/window/panel/imgui_input.h"
#include "app/window/panel/panel_column.h"
#include "app/window/panel/picture_aids.h"
#include "app/window/panel/tabs.h"
#include "app/window/panel/viewer_panel.h"

namespace throng::app {

namespace {

constexpr float column_width = 380, strip_height = 132;
constexpr float least_column_width = 266;      // in which every row can be read
constexpr float usual_of_width = 1.0F / 3.0F;  // that the column takes at most, unless it would be too narrow
constexpr float most_of_width = 0.6F;          // that it takes in any case
constexpr float most_of_height_for_bar = 0.5F;
constexpr float lowest_scale = 0.5F, highest_scale = 4.0F, scale_step = 1.1F;

struct Layout {
  Area crowd, strip, column;
};

/// Returns the width of the column in a picture of `width`; of `dragged` pixels of a plain screen, if it was dragged.
float column_width_in(float width, float scale, std::optional<float> dragged) {
  const float least = std::min(least_column_width * scale, std::floor(width * most_of_width));
  if (dragged) return std::clamp(*dragged * scale, least, std::max(least, std::floor(width * most_of_width)));
  return std::min(column_width * scale, std::max(least, std::floor(width * usual_of_width)));
}

Layout lay_out(const Theme& theme, std::optional<float> dragged, ImVec2 size) {
  const float column_x = size.x - column_width_in(size.x, theme.scale, dragged);
  const float strip_y = size.y - std::min(theme.px(strip_height), std::floor(size.y * 0.4F));
  return {.crowd = {.from = {0, 0}, .to = {column_x, strip_y}},
          .strip = {.from = {0, strip_y}, .to = {column_x, size.y}},
          .column = {.from = {column_x, 0}, .to = size}};
}

using Context = std::unique_ptr<ImGuiContext, decltype(&ImGui::DestroyContext)>;

// ImGui writes to memory that it asks for without a look, so memory that is not there has to be an exception.
Context make_context() {
  ImGui::SetAllocatorFunctions([](std::size_t size, void*) { return ::operator new(size); },
                               [](void* block, void*) { ::operator delete(block); });
  return {ImGui::CreateContext(), &ImGui::DestroyContext};
}

}  // namespace

std::filesystem::path fonts_folder(const std::string& data) {
  const auto fonts = find_data(data_folders(data), "assets/fonts");
  return fonts ? *fonts : std::filesystem::path();
}

float column_share(int width, float scale) {
  const auto all = static_cast<float>(width);
  return column_width_in(all, scale, {}) / all;
}

struct Overlay::State {
  ImGuiContext* before = ImGui::GetCurrentContext();  // in use again once this overlay ends
  Context context = make_context();
  Theme theme;
  UiMap map;
  Widgets widgets{theme, map};
  Tuning standard;
  ClipboardText clipboard;
  InputFrame input;
  OverlaySwitches switches;
  CrowdClick click;
  TabMemory memory;
  PanelColumn column{widgets};
  AidsMemory aids;
  FilePicker picker{is_openable, crowd_file_ending};
  bool has_dialog = false;    ///< which has pointer and keyboard
  bool shows_viewer = false;  ///< which has no strip
  bool is_in_a_change = false;
  std::filesystem::path fonts;
  std::optional<float> dragged_width = {};  ///< of the column, in pixels of a plain screen; none: it has its usual one

  [[nodiscard]] Layout layout() const { return lay_out(theme, dragged_width, ImGui::GetIO().DisplaySize); }
  void make_letters(float scale);
  void show_edge(const Layout& layout);
  void take_keys_of_panel(const FrameReport& report);
  void apply_keys(const FrameReport& report, Tuning& tuning, Requests& requests);
  void show_dialogs(const FrameReport& report, const InputFrame& keys, Requests& requests);
  void save(const FrameReport& report, bool anew, Requests& requests);
  Area below_jobs(Area crowd, const FrameReport& report, Requests& requests);
  void show_crowd(const Layout& layout, const TabContext& context_of_tab);
  void show_viewer(const Layout& layout, const TabContext& context_of_tab);
};

Overlay::Overlay(const std::filesystem::path& fonts, float scale, const Tuning& standard, const Clipboard& clipboard)
    : state_(std::make_unique<State>()) {
  ImGui::SetCurrentContext(state_->context.get());
  state_->fonts = fonts;
  state_->make_letters(scale);
  state_->standard = standard;
  state_->clipboard.clipboard = clipboard;
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.LogFilename = nullptr;
  connect(io, state_->clipboard);
}

Overlay::~Overlay() {
  ImGuiContext* const before = state_->before;
  state_.reset();
  ImGui::SetCurrentContext(before);
}

void Overlay::State::make_letters(float scale) {
  const bool has_ground = theme.panels_have_ground;
  ImFontAtlas& letters = *ImGui::GetIO().Fonts;
  letters.Clear();
  theme = apply_theme(fonts, scale);
  theme.panels_have_ground = has_ground;
  letters.Build();
  letters.SetTexID(imgui::texture_id(1));  // until a renderer has one: with none, ImGui misses text drawn without it
}

bool Overlay::set_scale(float scale) {
  const float wanted = std::clamp(scale * std::pow(scale_step, static_cast<float>(state_->switches.steps_larger)),
                                  lowest_scale, highest_scale);
  if (wanted == state_->theme.scale) return false;
  state_->make_letters(wanted);
  return true;
}

void Overlay::begin_frame(int width, int height, double seconds, const InputFrame& input) {
  state_->input = input;
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = {static_cast<float>(width), static_cast<float>(height)};
  state_->map.width = width;
  state_->map.height = height;
  io.DeltaTime = std::max(static_cast<float>(seconds), 1e-4F);
  // Slow frames must not turn a double click into two clicks, so it may last four frames.
  io.MouseDoubleClickTime = std::max(0.3F, 4 * io.DeltaTime);
  feed(io, input);
  ImGui::NewFrame();
}

Requests Overlay::build(const FrameReport& report, const Tuning& before) {
  State& state = *state_;
  Tuning tuning = before;
  Requests requests;
  state.map.widgets.clear();
  state.map.idle.clear();
  state.map.over_crowd.clear();
  if (!state.input.dropped.empty()) requests.ask(OpenFiles{state.input.dropped});
  const InputFrame all_input = state.input;
  state.has_dialog = state.picker.is_open() || report.unsaved;
  if (state.has_dialog) state.input.pressed.clear();
  state.take_keys_of_panel(report);
  const auto clicked = state.click.update(state.input, !uses_pointer());
  if (clicked && !report.viewer) requests.ask(SelectAt{*clicked});
  state.apply_keys(report, tuning, requests);
  const Layout layout = state.layout();
  state.shows_viewer = report.viewer.has_value();
  const TabContext context{state.widgets, report, tuning, state.standard, requests, state.memory};
  if (!state.switches.hidden) {
    state.show_edge(layout);
    if (report.viewer) {
      state.show_viewer(layout, context);
    } else {
      state.show_crowd(layout, context);
    }
    if (state.switches.log && show_log_card(state.widgets, layout.crowd, report.messages)) state.switches.log = false;
    if (state.switches.help && show_help_card(state.widgets, layout.crowd, state.memory.searched_help)) {
      state.switches.help = false;
    }
    show_picture_aids(context, state.map, layout.crowd, state.aids);
  }
  state.show_dialogs(report, all_input, requests);
  if (state.switches.hidden) show_aids_without_panel(context, state.aids);
  if (tuning != before) requests.ask(Apply{tuning});
  state.is_in_a_change = ImGui::IsAnyItemActive() || state.widgets.focus().is_stepping();
  state.widgets.focus().end_frame(state.theme);
  ImGui::Render();
  state.map.tab = state.column.tab();
  state.map.hidden = state.switches.hidden;
  state.map.help = state.switches.help;
  state.map.shows_b = state.memory.pair.shows_b();
  state.map.focus = state.widgets.focus().name();
  state.map.typing = ImGui::GetIO().WantTextInput;
  return requests;
}

bool Overlay::build_start(const JobReport& job) {
  state_->map.widgets.clear();
  Requests requests;
  show_start_card(state_->widgets, {.from = {0, 0}, .to = ImGui::GetIO().DisplaySize}, job, requests);
  ImGui::Render();
  return last_of<CancelJob>(requests) != nullptr || state_->input.was_pressed(Key::escape);
}

void Overlay::State::take_keys_of_panel(const FrameReport& report) {
  if (input.was_pressed(Key::f6)) switches.hidden = false;
  if (switches.hidden || has_dialog) widgets.focus().give_back();
  widgets.focus().begin_frame(input, {.typing = ImGui::GetIO().WantTextInput,
                                      .list = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup),
                                      .search = !switches.search.empty() && !report.viewer});
}

void Overlay::State::apply_keys(const FrameReport& report, Tuning& tuning, Requests& requests) {
  const bool typing = ImGui::GetIO().WantTextInput;
  const OpenThings open{.list = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup),
                        .typing = typing,
                        .selected = report.selected ? std::optional(report.selected->agent) : std::nullopt,
                        .ahead = ahead_of(report.camera),
                        .viewer = report.viewer ? std::optional(report.viewer->settings) : std::nullopt,
                        .has_moments = report.replay || report.tracks,
                        .kept = report.cameras.kept};
  apply_combinations(input, open, switches, requests);
  if (input.combines()) input.pressed.clear();  // they mean nothing else
  if (typing || has_dialog) return;
  apply_hotkeys(input, open, switches, tuning, requests);
  if (report.replay) apply_replay_keys(input, requests);
  if (report.tracks && !open.viewer) apply_track_keys(input, *report.tracks, tuning, requests);
  if (!open.viewer && !report.replay) apply_pair_key(input, memory.pair, tuning, requests);
}

void Overlay::State::show_dialogs(const FrameReport& report, const InputFrame& keys, Requests& requests) {
  const bool saves = std::exchange(switches.saves, false), saves_anew = std::exchange(switches.saves_anew, false);
  const bool opens = std::exchange(switches.opens_file, false);
  if (report.replay) return;  // it repeats what was recorded, and has no work
  if (!has_dialog && opens) picker.open(FilePicker::Purpose::open);
  if (!has_dialog && (saves || saves_anew)) save(report, saves_anew, requests);
  if (picker.is_open()) {
    const bool opens_it = picker.purpose() == FilePicker::Purpose::open;
    const auto file = picker.show(widgets, has_dialog ? keys : InputFrame(), report.recent_files);
    if (file && opens_it) requests.ask(OpenFiles{{*file}});
    if (file && !opens_it) requests.ask(SaveCrowd{std::filesystem::path(*file).replace_extension().string()});
  } else if (report.unsaved) {
    const auto answer = show_question_card(widgets, keys, *report.unsaved);
    if (answer == UnsavedAnswer::save) save(report, false, requests);
    if (answer == UnsavedAnswer::leave) requests.ask(LeaveUnsaved{});
    if (answer == UnsavedAnswer::stay) requests.ask(KeepWorking{});
  }
}

void Overlay::State::save(const FrameReport& report, bool anew, Requests& requests) {
  if (!anew && !report.crowd.empty()) return requests.ask(SaveCrowd{report.crowd});
  picker.open(FilePicker::Purpose::save);
}

// It is shown before the column, which so lies below it.
void Overlay::State::show_edge(const Layout& layout) {
  const float x = layout.column.from.x, bottom = layout.column.to.y;
  const Area edge{.from = {x, 0}, .to = {x + theme.px(6), bottom}};
  begin_fixed_window("Edge", edge, 0, ImGuiWindowFlags_NoBackground);
  widgets.hoverable("panel edge", edge);
  if (ImGui::IsItemActive() && ImGui::IsMouseDragging(ImGuiMouseButton_Left)) {
    dragged_width = (layout.column.to.x - ImGui::GetMousePos().x) / theme.scale;
  }
  if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) dragged_width.reset();
  if (ImGui::IsItemHovered() || ImGui::IsItemActive()) {
    ImGui::GetWindowDrawList()->AddRectFilled({x, 0}, {x + theme.px(2), bottom}, colour::accent);
  }
  ImGui::End();
}

Area Overlay::State::below_jobs(Area crowd, const FrameReport& report, Requests& requests) {
  crowd.from.y = show_jobs(widgets, crowd, report.jobs, requests);
  return crowd;
}

void Overlay::State::show_crowd(const Layout& layout, const TabContext& context_of_tab) {
  const FrameReport& report = context_of_tab.report;
  Area below_notices = below_jobs(layout.crowd, report, context_of_tab.requests);
  below_notices.from.y = show_notices(context_of_tab, below_notices);
  show_frame_strip(widgets, layout.strip, report, context_of_tab.requests);
  if (last_of<LookAtFrame>(context_of_tab.requests) != nullptr) column.go_to("Scheduling");
  column.show_tabs(layout.column, context_of_tab, switches);
  if (report.replay) show_replay_bar(widgets, layout.crowd, *report.replay, context_of_tab.requests);
  if (report.tracks) show_track_bar(context_of_tab, layout.crowd);
  if (report.selected) show_selection_card(widgets, below_notices, report, context_of_tab.requests);
}

void Overlay::State::show_viewer(const Layout& layout, const TabContext& context_of_tab) {
  show_notices(context_of_tab, below_jobs(layout.crowd, context_of_tab.report, context_of_tab.requests));
  show_bone_name(theme, layout.crowd, *context_of_tab.report.viewer);
  column.show_viewer(layout.column, context_of_tab, switches);
}

ImDrawData* Overlay::draw_data() const { return ImGui::GetDrawData(); }

int Overlay::vertex_count() const { return ImGui::GetDrawData()->TotalVtxCount; }

const UiMap& Overlay::ui_map() const { return state_->map; }

UiRectangle Overlay::crowd_area() const {
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  if (state_->switches.hidden) return {.width = size.x, .height = size.y};
  const Area crowd = state_->layout().crowd;
  return {.width = crowd.width(), .height = state_->shows_viewer ? size.y : crowd.height()};
}

UiRectangle Overlay::free_area(const FrameReport& report) const {
  UiRectangle area = crowd_area();
  const bool has_timeline = report.tracks && !report.viewer && !state_->switches.hidden;
  if (has_timeline) area.height -= std::min(height_of_track_bar(state_->theme), most_of_height_for_bar * area.height);
  return area;
}

int Overlay::panel_width() const { return static_cast<int>(std::lround(state_->dragged_width.value_or(0.0F))); }

void Overlay::set_panel_width(int width) {
  state_->dragged_width = width > 0 ? std::optional(static_cast<float>(width)) : std::nullopt;
}

bool Overlay::uses_pointer() const { return ImGui::GetIO().WantCaptureMouse; }

bool Overlay::uses_keyboard() const { return ImGui::GetIO().WantTextInput || state_->has_dialog; }

void Overlay::leave_ground_out() { state_->theme.panels_have_ground = false; }

std::uint32_t Overlay::panel_color() { return colour::panel | IM_COL32_A_MASK; }

void Overlay::show_legend_only() { state_->switches.hidden = state_->aids.is_legend_alone = true; }

bool Overlay::is_in_a_change() const { return state_->is_in_a_change; }

void Overlay::set_hidden(bool hidden) { state_->switches.hidden = hidden; }

void Overlay::show_tab(const std::string& name) { state_->column.go_to(name); }

TuningPair& Overlay::tuning_pair() { return state_->memory.pair; }

}  // namespace throng::app
