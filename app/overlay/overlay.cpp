#include "app/overlay/overlay.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <new>
#include <string>
#include <utility>

#include <imgui.h>

#include "app/overlay/cards.h"
#include "app/overlay/hotkeys.h"
#include "app/overlay/imgui_input.h"
#include "app/overlay/picture_aids.h"
#include "app/overlay/replay_bar.h"
#include "app/overlay/tabs.h"
#include "app/overlay/viewer_panel.h"

namespace throng::app {

namespace {

constexpr float column_width = 380, strip_height = 132, header_height = 38, tab_height = 28;
constexpr float most_of_width = 0.6F;  // that the column takes

struct Tab {
  const char* name;
  void (*show)(const TabContext& context);
};

constexpr std::array tabs = std::to_array<Tab>({{"Crowd", show_crowd_tab},
                                                {"LOD skipping", show_lod_skipping_tab},
                                                {"Per-bone LOD", show_bone_lod_tab},
                                                {"Scheduling", show_scheduling_tab},
                                                {"Agent", show_agent_tab},
                                                {"Presets", show_presets_tab}});
constexpr std::size_t tabs_in_a_row = 3;

struct Layout {
  Area crowd, strip, column;
};

Layout lay_out(const Theme& theme, ImVec2 size) {
  const float column_x = size.x - std::min(theme.px(column_width), std::floor(size.x * most_of_width));
  const float strip_y = size.y - std::min(theme.px(strip_height), std::floor(size.y * 0.4F));
  return {.crowd = {.from = {0, 0}, .to = {column_x, strip_y}},
          .strip = {.from = {0, strip_y}, .to = {column_x, size.y}},
          .column = {.from = {column_x, 0}, .to = size}};
}

using Context = std::unique_ptr<ImGuiContext, decltype(&ImGui::DestroyContext)>;

// ImGui writes to what it asks for without a look, so memory that is not there has to be an exception.
Context make_context() {
  ImGui::SetAllocatorFunctions([](std::size_t size, void*) { return ::operator new(size); },
                               [](void* block, void*) { ::operator delete(block); });
  return {ImGui::CreateContext(), &ImGui::DestroyContext};
}

}  // namespace

float column_share(int width, float scale) {
  const auto all = static_cast<float>(width);
  return std::min(column_width * scale, std::floor(all * most_of_width)) / all;
}

struct Overlay::State {
  Context context = make_context();
  Theme theme;
  UiMap map;
  Widgets widgets{theme, map};
  Tuning standard;
  ClipboardText clipboard;
  InputFrame input;
  OverlaySwitches switches;
  CrowdClick click;
  std::size_t tab = 0;
  TabMemory memory;
  bool showed_b = false;  ///< in the frame before
  ViewerPanelMemory viewer_memory;
  AidsMemory aids;

  void show_tab(const std::string& name);
  void watch_values(const FrameReport& report, const Tuning& tuning);
  void show_header(const Area& column);
  void show_tab_bar(const Area& column);
  void show_crowd(const Layout& layout, const TabContext& context_of_tab);
  void show_column(const Area& column, const TabContext& context_of_tab);
  void show_viewer(const Layout& layout, const TabContext& context_of_tab);
};

Overlay::Overlay(const std::filesystem::path& fonts, float scale, const Tuning& standard, const Clipboard& clipboard)
    : state_(std::make_unique<State>()) {
  ImGui::SetCurrentContext(state_->context.get());
  state_->theme = apply_theme(fonts, scale);
  state_->standard = standard;
  state_->clipboard.clipboard = clipboard;
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.LogFilename = nullptr;
  connect(io, state_->clipboard);
  io.Fonts->Build();
  io.Fonts->SetTexID(&state_->theme);  // until a renderer has one: with none, ImGui misses text drawn without it
}

Overlay::~Overlay() = default;

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

OverlayCommands Overlay::build(const FrameReport& report, Tuning& tuning) {
  State& state = *state_;
  OverlayCommands commands;
  state.map.widgets.clear();
  state.map.idle.clear();
  commands.models = state.input.dropped;
  const auto clicked = state.click.update(state.input, !uses_pointer());
  if (!report.viewer) commands.select_at = clicked;
  if (!uses_keyboard()) {
    const bool list_is_open = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup);
    const auto viewer = report.viewer ? std::optional(report.viewer->settings) : std::nullopt;
    apply_hotkeys(state.input, {.list = list_is_open, .selection = report.selected.has_value(), .viewer = viewer},
                  state.switches, tuning, commands);
    if (report.replay) apply_replay_keys(state.input, commands.replay);
    const bool changes_places = !viewer && std::ranges::count(state.input.pressed, Key::b) > 0;
    if (changes_places) state.memory.pair.change_places(tuning);
    if (!viewer && !report.replay) apply_history_keys(state.input, state.memory.history, tuning);
  }
  const Layout layout = lay_out(state.theme, ImGui::GetIO().DisplaySize);
  if (!state.switches.hidden) {
    const TabContext context{state.widgets, report, tuning, state.standard, commands, state.memory};
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
  state.watch_values(report, tuning);
  ImGui::Render();
  state.map.tab = tabs.at(state.tab).name;
  state.map.hidden = state.switches.hidden;
  state.map.help = state.switches.help;
  state.map.shows_b = state.memory.pair.shows_b();
  state.map.typing = ImGui::GetIO().WantTextInput;
  return commands;
}

void Overlay::State::show_tab(const std::string& name) {
  const auto* const found = std::ranges::find(tabs, name, &Tab::name);
  if (found != tabs.end()) tab = static_cast<std::size_t>(found - tabs.begin());
}

// Values that a replay sets, or that B brings into use, are no step that a person takes back.
void Overlay::State::watch_values(const FrameReport& report, const Tuning& tuning) {
  const bool is_another = std::exchange(showed_b, memory.pair.shows_b()) != memory.pair.shows_b();
  if (report.replay || is_another) memory.history.take(tuning);
  memory.history.watch(tuning, ImGui::IsAnyItemActive());
}

void Overlay::State::show_crowd(const Layout& layout, const TabContext& context_of_tab) {
  const FrameReport& report = context_of_tab.report;
  Area below_notices = layout.crowd;
  below_notices.from.y = show_notices(context_of_tab, layout.crowd);
  show_frame_strip(widgets, layout.strip, report, context_of_tab.commands);
  if (context_of_tab.commands.look_at_frame) show_tab("Scheduling");
  show_column(layout.column, context_of_tab);
  if (report.replay) show_replay_bar(widgets, layout.crowd, *report.replay, context_of_tab.commands.replay);
  if (report.selected) show_selection_card(widgets, below_notices, *report.selected, context_of_tab.commands);
}

void Overlay::State::show_viewer(const Layout& layout, const TabContext& context_of_tab) {
  const auto& [of_tab, report, tuning, usual, commands, remembered] = context_of_tab;
  const Area& column = layout.column;
  show_notices(context_of_tab, layout.crowd);
  show_bone_name(theme, layout.crowd, *report.viewer);
  begin_fixed_window("Column", column);
  ImGui::GetWindowDrawList()->AddLine(column.from, {column.from.x, column.to.y}, colour::panel_edge);
  show_header(column);
  const float top = theme.px(header_height);
  ImGui::SetCursorScreenPos({column.from.x, column.from.y + top});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {theme.px(16), theme.px(8)});
  ImGui::BeginChild("Viewer", {column.width(), column.height() - top}, false, ImGuiWindowFlags_AlwaysUseWindowPadding);
  show_viewer_panel(widgets, report.characters[report.viewer->character], *report.viewer, viewer_memory,
                    commands.viewer);
  ImGui::EndChild();
  ImGui::PopStyleVar();
  ImGui::End();
}

void Overlay::State::show_header(const Area& column) {
  const float y = column.from.y + theme.px(11);
  draw_text(theme.strong, {column.from.x + theme.px(16), y}, colour::text, "Throng");
  float right = column.to.x - theme.px(16);
  const auto word = [&](const char* words) {
    const float width = text_width(theme.small, words);
    const Area place{.from = {right - width, column.from.y + theme.px(6)}, .to = {right, column.from.y + theme.px(32)}};
    const bool clicked = widgets.clickable(std::string("header:") + words, place);
    draw_text(theme.small, {place.from.x, y + theme.px(1)}, ImGui::IsItemHovered() ? colour::text : colour::faint,
              words);
    right = place.from.x - theme.px(14);
    return clicked;
  };
  if (word("Hide (Tab)")) switches.hidden = true;
  if (word("Help (F1)")) switches.help = !switches.help;
  if (word("Messages (L)")) switches.log = !switches.log;
}

void Overlay::State::show_tab_bar(const Area& column) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float width = (column.width() - theme.px(16)) / static_cast<float>(tabs_in_a_row);
  for (std::size_t i = 0; i < tabs.size(); ++i) {
    const std::size_t row = i / tabs_in_a_row, place_in_row = i % tabs_in_a_row;
    const ImVec2 from(column.from.x + theme.px(8) + width * static_cast<float>(place_in_row),
                      column.from.y + theme.px(header_height + tab_height * static_cast<float>(row)));
    const Area place{.from = from, .to = {from.x + width, from.y + theme.px(tab_height)}};
    const std::string name = tabs.at(i).name;
    if (widgets.clickable("tab:" + name, place)) tab = i;
    const bool shown = i == tab, hovered = ImGui::IsItemHovered();
    draw_text(theme.regular, {(place.from.x + place.to.x) / 2, from.y + theme.px(5)},
              shown || hovered ? colour::text : colour::dim, name, 0.5F);
    draw.AddLine({place.from.x, place.to.y}, {place.to.x, place.to.y}, colour::grid);
    if (!shown) continue;
    draw.AddRectFilled({place.from.x + theme.px(8), place.to.y - theme.px(2)}, {place.to.x - theme.px(8), place.to.y},
                       colour::accent);
  }
}

void Overlay::State::show_column(const Area& column, const TabContext& context_of_tab) {
  begin_fixed_window("Column", column);
  ImGui::GetWindowDrawList()->AddLine(column.from, {column.from.x, column.to.y}, colour::panel_edge);
  show_header(column);
  show_tab_bar(column);
  const float top = theme.px(header_height + 2 * tab_height) + 1;
  ImGui::SetCursorScreenPos({column.from.x, column.from.y + top});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {theme.px(16), theme.px(8)});
  // Each tab is a child of its own and so keeps its scroll position.
  ImGui::BeginChild(tabs.at(tab).name, {column.width(), column.height() - top}, false,
                    ImGuiWindowFlags_AlwaysUseWindowPadding);
  tabs.at(tab).show(context_of_tab);
  ImGui::EndChild();
  ImGui::PopStyleVar();
  ImGui::End();
}

ImDrawData* Overlay::draw_data() const { return ImGui::GetDrawData(); }

int Overlay::vertex_count() const { return ImGui::GetDrawData()->TotalVtxCount; }

const UiMap& Overlay::ui_map() const { return state_->map; }

UiRectangle Overlay::crowd_area() const {
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  if (state_->switches.hidden) return {.width = size.x, .height = size.y};
  const Area crowd = lay_out(state_->theme, size).crowd;
  return {.width = crowd.width(), .height = crowd.height()};
}

bool Overlay::uses_pointer() const { return ImGui::GetIO().WantCaptureMouse; }

bool Overlay::uses_keyboard() const { return ImGui::GetIO().WantTextInput; }

void Overlay::set_hidden(bool hidden) { state_->switches.hidden = hidden; }

void Overlay::show_tab(const std::string& name) { state_->show_tab(name); }

bool Overlay::fonts_missing() const { return state_->theme.fonts_missing; }

}  // namespace throng::app
