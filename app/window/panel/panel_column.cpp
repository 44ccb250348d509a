#include "app/window/panel/panel_column.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>
#include <vector>

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

// Tabs are of one width, unless a name has no room; then each has as much beside its name as the others.
std::vector<float> widths_of(const Theme& theme, std::span<const Tab> row, float width) {
  constexpr float least_room = 12;
  const float equal = width / static_cast<float>(tabs_in_a_row);
  float words = 0, longest = 0;
  for (const Tab& tab : row) {
    words += text_width(theme.regular, tab.name);
    longest = std::max(longest, text_width(theme.regular, tab.name));
  }
  if (longest + theme.px(least_room) <= equal) return std::vector<float>(row.size(), equal);
  std::vector<float> widths;
  const float room = (width - words) / static_cast<float>(row.size());
  for (const Tab& tab : row) widths.push_back(text_width(theme.regular, tab.name) + room);
  return widths;
}

// "Messages (L)", or without its key.
std::string header_word(const std::string& word, bool with_key) {
  return with_key ? word : word.substr(0, word.find(" ("));
}

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
  constexpr std::array names = {"Messages (L)", "Help (F1)", "Hide (Tab)"};
  const float margin = theme_.px(16), between = theme_.px(14);
  const ImVec2 title(place.from.x + margin, place.from.y + theme_.px(11));
  draw_text(theme_.strong, title, colour::text, "Throng");
  const auto width_of_words = [&](bool with_keys) {
    float width = margin - between;
    for (const char* const name : names) width += text_width(theme_.small, header_word(name, with_keys)) + between;
    return width;
  };
  const float room = place.to.x - title.x - text_width(theme_.strong, "Throng") - between;
  const bool with_keys = width_of_words(true) <= room;
  float left = place.to.x - width_of_words(with_keys);
  const auto is_clicked = [&](const char* name) {
    const float right = left + text_width(theme_.small, header_word(name, with_keys));
    const bool clicked = show_header_word({.from = {left, title.y}, .to = {right, title.y}}, name, with_keys);
    left = right + between;
    return clicked;
  };
  if (is_clicked(names[0])) switches.log = !switches.log;
  if (is_clicked(names[1])) switches.help = !switches.help;
  if (is_clicked(names[2])) switches.hidden = true;
}

bool PanelColumn::show_header_word(const Area& line, const char* name, bool with_key) {
  const Area area{.from = {line.from.x, line.from.y - theme_.px(5)}, .to = {line.to.x, line.to.y + theme_.px(21)}};
  const bool clicked = widgets_.clickable(std::string("header:") + name, area), hovered = ImGui::IsItemHovered();
  draw_text(theme_.small, {line.from.x, line.from.y + theme_.px(1)}, hovered ? colour::text : colour::faint,
            header_word(name, with_key));
  if (hovered && !with_key) show_lines({name});
  return clicked;
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
  const float width = place.width() - theme_.px(16);
  float top = place.from.y + theme_.px(header_height + search_height);
  for (std::size_t first = 0; first < tabs.size(); first += tabs_in_a_row) {
    const auto row = std::span(tabs).subspan(first, std::min(tabs_in_a_row, tabs.size() - first));
    const std::vector<float> widths = widths_of(theme_, row, width);
    float left = place.from.x + theme_.px(8);
    for (std::size_t i = 0; i < row.size(); ++i) {
      show_tab_name(first + i, {.from = {left, top}, .to = {left + widths[i], top + theme_.px(tab_height)}}, switches);
      left += widths[i];
    }
    top += theme_.px(tab_height);
  }
}

void PanelColumn::show_tab_name(std::size_t tab, const Area& area, OverlaySwitches& switches) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const std::string name = tabs.at(tab).name;
  if (widgets_.clickable("tab:" + name, area)) {
    tab_ = tab;
    switches.search.clear();
  }
  const bool shown = tab == tab_ && switches.search.empty(), hovered = ImGui::IsItemHovered();
  draw_text(theme_.regular, {(area.from.x + area.to.x) / 2, area.from.y + theme_.px(5)},
            shown || hovered ? colour::text : colour::dim, name, 0.5F);
  draw.AddLine({area.from.x, area.to.y}, {area.to.x, area.to.y}, colour::grid);
  if (!shown) return;
  draw.AddRectFilled({area.from.x + theme_.px(8), area.to.y - theme_.px(2)}, {area.to.x - theme_.px(8), area.to.y},
                     colour::accent);
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
