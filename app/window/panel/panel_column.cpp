#include "app/window/panel/panel_column.h"

#include <algorithm>
#include <array>
#include <utility>

#include "app/window/panel/cards.h"

namespace throng::app {
namespace {

constexpr float header_height = 38, search_height = 30, tab_height = 28;

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
constexpr const char* nothing_found =
    "No value has all of these words in its name, its key or its explanation. Take a word away, or ask the help (F1) "
    "what the panel calls it. Values of the selected agent are found once one is selected.";

}  // namespace

void PanelColumn::go_to(const std::string& tab) {
  const auto* const found = std::ranges::find(tabs, tab, &Tab::name);
  if (found != tabs.end()) tab_ = static_cast<std::size_t>(found - tabs.begin());
}

const char* PanelColumn::tab() const { return tabs.at(tab_).name; }

void PanelColumn::show_tabs(const Area& place, const TabContext& context, OverlaySwitches& switches) {
  if (const int further = std::exchange(switches.tabs_further, 0)) change_tab(further, switches);
  begin(place, switches);
  show_search_field(place, switches);
  show_tab_bar(place, switches);
  const float top = theme_.px(header_height + search_height + 2 * tab_height) + 1;
  if (switches.search.empty()) {
    // Each tab is a child of its own and so keeps its scroll position.
    show_below(place, top, tab(), [&] { tabs.at(tab_).show(context); });
  } else {
    show_below(place, top, "Found", [&] { show_found(context, switches); });
  }
  ImGui::End();
}

void PanelColumn::show_viewer(const Area& place, const TabContext& context, OverlaySwitches& switches) {
  const FrameReport& report = context.report;
  begin(place, switches);
  show_below(place, theme_.px(header_height), "Viewer", [&] {
    show_viewer_panel(widgets_, file_name(report.characters[report.viewer->character]), *report.viewer, viewer_,
                      context.requests);
  });
  ImGui::End();
}

void PanelColumn::begin(const Area& place, OverlaySwitches& switches) {
  begin_fixed_window("Column", place, 0, theme_.panels_have_ground ? 0 : ImGuiWindowFlags_NoBackground);
  ImGui::GetWindowDrawList()->AddLine(place.from, {place.from.x, place.to.y}, colour::panel_edge);
  show_header(place, switches);
}

void PanelColumn::show_header(const Area& place, OverlaySwitches& switches) {
  const float y = place.from.y + theme_.px(11);
  draw_text(theme_.strong, {place.from.x + theme_.px(16), y}, colour::text, "Throng");
  constexpr std::array words = {"Messages (L)", "Help (F1)", "Hide (Tab)"};
  const float between = theme_.px(14);
  float left = place.to.x - theme_.px(16) + between;
  for (const char* const word : words) left -= text_width(theme_.small, word) + between;
  const auto is_clicked = [&](const char* word) {
    const Area area{.from = {left, place.from.y + theme_.px(6)},
                    .to = {left + text_width(theme_.small, word), place.from.y + theme_.px(32)}};
    const bool clicked = widgets_.clickable(std::string("header:") + word, area);
    draw_text(theme_.small, {area.from.x, y + theme_.px(1)}, ImGui::IsItemHovered() ? colour::text : colour::faint,
              word);
    left = area.to.x + between;
    return clicked;
  };
  if (is_clicked(words[0])) switches.log = !switches.log;
  if (is_clicked(words[1])) switches.help = !switches.help;
  if (is_clicked(words[2])) switches.hidden = true;
}

void PanelColumn::show_search_field(const Area& place, OverlaySwitches& switches) {
  const float top = place.from.y + theme_.px(header_height), margin = theme_.px(16);
  if (std::exchange(switches.enters_search, false)) imgui::focus_next_item();
  widgets_.text_field("search", switches.search, "Search all values  (/)",
                      {.from = {place.from.x + margin, top}, .to = {place.to.x - margin, top + theme_.px(22)}});
  const bool was_active = ImGui::IsItemActive() || ImGui::IsItemDeactivated();
  if (was_active && ImGui::IsKeyPressed(ImGuiKey_DownArrow)) {
    widgets_.focus().go_to_first_row();
  }
  if (!ImGui::IsItemDeactivated()) return;
  wants_the_only_one_ = ImGui::IsKeyPressed(ImGuiKey_Enter);
  if (ImGui::IsKeyPressed(ImGuiKey_Escape)) switches.search.clear();
}

void PanelColumn::show_found(const TabContext& context, OverlaySwitches& switches) {
  RowSearch search(switches.search);
  widgets_.search_in(&search);
  for (const auto pass : {RowSearch::Pass::names, RowSearch::Pass::explanations}) {
    search.begin_pass(pass);
    ImGui::PushID(static_cast<int>(pass));
    for (const Tab& each : tabs) {
      search.begin_tab(each.name);
      ImGui::PushID(each.name);
      each.show(context);
      ImGui::PopID();
    }
    ImGui::PopID();
  }
  widgets_.search_in(nullptr);
  if (search.found() == 0) {
    widgets_.caption(nothing_found);
    widgets_.record("nothing found", {.from = ImGui::GetItemRectMin(), .to = ImGui::GetItemRectMax()});
  }
  const bool goes_to_the_only_one = std::exchange(wants_the_only_one_, false) && search.found() == 1;
  if (goes_to_the_only_one) search.leave_for(search.last_place());
  if (search.wanted_place()) leave_search_for(*search.wanted_place(), switches);
}

void PanelColumn::change_tab(int further, OverlaySwitches& switches) {
  const int count = static_cast<int>(tabs.size());
  tab_ = static_cast<std::size_t>(((static_cast<int>(tab_) + further) % count + count) % count);
  switches.search.clear();
  if (widgets_.focus().has_keys()) widgets_.focus().go_to_first_row();
}

void PanelColumn::leave_search_for(const RowSearch::Place& place, OverlaySwitches& switches) {
  switches.search.clear();
  go_to(place.tab);
  widgets_.scroll_to_section(place.section);
}

void PanelColumn::show_tab_bar(const Area& place, OverlaySwitches& switches) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float width = (place.width() - theme_.px(16)) / static_cast<float>(tabs_in_a_row);
  for (std::size_t i = 0; i < tabs.size(); ++i) {
    const std::size_t row = i / tabs_in_a_row, place_in_row = i % tabs_in_a_row;
    const ImVec2 from(place.from.x + theme_.px(8) + width * static_cast<float>(place_in_row),
                      place.from.y + theme_.px(header_height + search_height + tab_height * static_cast<float>(row)));
    const Area area{.from = from, .to = {from.x + width, from.y + theme_.px(tab_height)}};
    const std::string name = tabs.at(i).name;
    if (widgets_.clickable("tab:" + name, area)) {
      tab_ = i;
      switches.search.clear();
    }
    const bool shown = i == tab_ && switches.search.empty(), hovered = ImGui::IsItemHovered();
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
