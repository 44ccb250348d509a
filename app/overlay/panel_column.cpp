#include "app/overlay/panel_column.h"

#include <algorithm>
#include <array>

#include "app/overlay/cards.h"

namespace throng::app {
namespace {

constexpr float header_height = 38, tab_height = 28;

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

}  // namespace

void PanelColumn::go_to(const std::string& tab) {
  const auto* const found = std::ranges::find(tabs, tab, &Tab::name);
  if (found != tabs.end()) tab_ = static_cast<std::size_t>(found - tabs.begin());
}

const char* PanelColumn::tab() const { return tabs.at(tab_).name; }

void PanelColumn::show_tabs(const Area& place, const TabContext& context, OverlaySwitches& switches) {
  begin(place, switches);
  show_tab_bar(place);
  // Each tab is a child of its own and so keeps its scroll position.
  show_below(place, theme_.px(header_height + 2 * tab_height) + 1, tab(), [&] { tabs.at(tab_).show(context); });
  ImGui::End();
}

void PanelColumn::show_viewer(const Area& place, const TabContext& context, OverlaySwitches& switches) {
  const FrameReport& report = context.report;
  begin(place, switches);
  show_below(place, theme_.px(header_height), "Viewer", [&] {
    show_viewer_panel(widgets_, report.characters[report.viewer->character], *report.viewer, viewer_,
                      context.commands.viewer);
  });
  ImGui::End();
}

void PanelColumn::begin(const Area& place, OverlaySwitches& switches) {
  begin_fixed_window("Column", place);
  ImGui::GetWindowDrawList()->AddLine(place.from, {place.from.x, place.to.y}, colour::panel_edge);
  show_header(place, switches);
}

void PanelColumn::show_header(const Area& place, OverlaySwitches& switches) {
  const float y = place.from.y + theme_.px(11);
  draw_text(theme_.strong, {place.from.x + theme_.px(16), y}, colour::text, "Throng");
  float right = place.to.x - theme_.px(16);
  const auto word = [&](const char* words) {
    const float width = text_width(theme_.small, words);
    const Area area{.from = {right - width, place.from.y + theme_.px(6)}, .to = {right, place.from.y + theme_.px(32)}};
    const bool clicked = widgets_.clickable(std::string("header:") + words, area);
    draw_text(theme_.small, {area.from.x, y + theme_.px(1)}, ImGui::IsItemHovered() ? colour::text : colour::faint,
              words);
    right = area.from.x - theme_.px(14);
    return clicked;
  };
  if (word("Hide (Tab)")) switches.hidden = true;
  if (word("Help (F1)")) switches.help = !switches.help;
  if (word("Messages (L)")) switches.log = !switches.log;
}

void PanelColumn::show_tab_bar(const Area& place) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float width = (place.width() - theme_.px(16)) / static_cast<float>(tabs_in_a_row);
  for (std::size_t i = 0; i < tabs.size(); ++i) {
    const std::size_t row = i / tabs_in_a_row, place_in_row = i % tabs_in_a_row;
    const ImVec2 from(place.from.x + theme_.px(8) + width * static_cast<float>(place_in_row),
                      place.from.y + theme_.px(header_height + tab_height * static_cast<float>(row)));
    const Area area{.from = from, .to = {from.x + width, from.y + theme_.px(tab_height)}};
    const std::string name = tabs.at(i).name;
    if (widgets_.clickable("tab:" + name, area)) tab_ = i;
    const bool shown = i == tab_, hovered = ImGui::IsItemHovered();
    draw_text(theme_.regular, {(area.from.x + area.to.x) / 2, from.y + theme_.px(5)},
              shown || hovered ? colour::text : colour::dim, name, 0.5F);
    draw.AddLine({area.from.x, area.to.y}, {area.to.x, area.to.y}, colour::grid);
    if (!shown) continue;
    draw.AddRectFilled({area.from.x + theme_.px(8), area.to.y - theme_.px(2)}, {area.to.x - theme_.px(8), area.to.y},
                       colour::accent);
  }
}

template <class Show>
void PanelColumn::show_below(const Area& place, float top, const char* name, const Show& show) {
  ImGui::SetCursorScreenPos({place.from.x, place.from.y + top});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {theme_.px(16), theme_.px(8)});
  ImGui::BeginChild(name, {place.width(), place.height() - top}, false, ImGuiWindowFlags_AlwaysUseWindowPadding);
  show();
  ImGui::EndChild();
  ImGui::PopStyleVar();
}

}  // namespace throng::app
