#include "app/overlay/agent_tab.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <vector>

#include "app/overlay/layer_rows.h"
#include "app/overlay/numbers.h"
#include "app/overlay/plots.h"
#include "app/settings/choices.h"
#include "engine/anim/lod/lod.h"

namespace throng::app {
namespace {

constexpr std::size_t history_shown = 240, bytes_a_line = 12, most_bytes_shown = 384, most_events_shown = 8;

void show_who(const TabContext& context, const SelectionReport& selected) {
  Widgets& widgets = context.widgets;
  widgets.section(("Agent " + with_thousands(selected.agent)).c_str());
  widgets.fact("Does", habit_words.at(static_cast<std::size_t>(selected.habit)),
               {.what = "What the crowd has in mind for it."});
  widgets.fact("Posture", posture_words.at(static_cast<std::size_t>(selected.posture)),
               {.what = "Upright, or how a rag-doll is."});
  widgets.fact("Blocks", std::to_string(selected.entities.size()) + ", " + as_bytes(selected.bytes),
               {.what = "Its entities in main memory."});
}

void show_hands(const TabContext& context, const SelectionReport& selected) {
  const auto& [widgets, report, tuning, standard, commands] = context;
  widgets.section("Hands on it");
  const float last = std::max(selected.clip_seconds, 0.01F);
  ImGui::BeginDisabled(selected.clip_seconds <= 0 || selected.posture != Posture::upright);
  float seconds = std::min(selected.held_at.value_or(0), last);
  if (widgets.number("Hold clip at", seconds, 0,
                     {.lowest = 0, .highest = static_cast<double>(last), .decimals = 2, .suffix = " s"},
                     {.what = "Drag to stop it and to move through its clip. Crowd logic holds it in its place.",
                      .unit = "seconds from the clip's start"})) {
    commands.hold_at = seconds;
  }
  ImGui::EndDisabled();
  const float gap = ImGui::GetStyle().ItemSpacing.x, width = (ImGui::GetContentRegionAvail().x - gap) / 2;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::BeginDisabled(!selected.held_at);
  commands.let_go |= widgets.button("Let go", {.what = "It goes on as the crowd wants it."}, width);
  ImGui::EndDisabled();
  ImGui::SetCursorScreenPos({at.x + width + gap, at.y});
  ImGui::BeginDisabled(!selected.can_fall);
  commands.push_over |= widgets.button("Push", {.what = "Makes a rag-doll of it, which falls. Key P."}, width);
  ImGui::EndDisabled();
}

/// One column a frame: as high as its interval is long, and below it a dot in the colour of its bone level.
void show_history(const TabContext& context, const SelectionReport& selected) {
  Widgets& widgets = context.widgets;
  const Theme& theme = widgets.theme();
  widgets.section("Its level of detail, frame by frame");
  const Area plot = widgets.area("LOD history", 64);
  draw_well(theme, plot);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float step = plot.width() / static_cast<float>(history_shown), levels = theme.px(6);
  float x = plot.to.x - step * static_cast<float>(selected.history.size());
  for (const LodOfFrame& moment : selected.history) {
    const float tall =
        (plot.height() - levels - theme.px(2)) * static_cast<float>(moment.interval) / anim::longest_interval;
    if (moment.visible) {
      draw.AddRectFilled({x, plot.to.y - levels - tall}, {x + step, plot.to.y - levels},
                         colour::interval(moment.interval));
      draw.AddRectFilled({x, plot.to.y - levels + theme.px(1)}, {x + step, plot.to.y},
                         colour::bone_level(moment.bone_level));
    }
    x += step;
  }
  widgets.caption("Height: interval, 1 to 16 frames. Below: bone level. Gaps: out of view.");
}

void show_events(const TabContext& context, const SelectionReport& selected) {
  context.widgets.section("What it met");
  if (selected.events.empty()) context.widgets.caption("Nothing since it was selected.");
  for (std::size_t i = 0; i < std::min(selected.events.size(), most_events_shown); ++i) {
    context.widgets.caption(selected.events[i]);
  }
}

std::string hex_line(std::span<const std::uint8_t> block, std::size_t first) {
  std::array<char, 24> text{};  // room for any number
  std::snprintf(text.data(), text.size(), "%04zx ", first);
  std::string line = text.data();
  for (std::size_t i = first; i < std::min(block.size(), first + bytes_a_line); ++i) {
    std::snprintf(text.data(), text.size(), " %02x", static_cast<unsigned>(block[i]));
    line += text.data();
  }
  return line;
}

void show_bytes(const TabContext& context, const EntityRow& entity) {
  const Theme& theme = context.widgets.theme();
  const std::size_t shown = std::min(entity.block.size(), most_bytes_shown);
  const auto lines = static_cast<float>((shown + bytes_a_line - 1) / bytes_a_line);
  const Area area = context.widgets.area("Block bytes", 15 * lines + 8);
  draw_well(theme, area);
  ImVec2 at(area.from.x + theme.px(8), area.from.y + theme.px(4));
  for (std::size_t first = 0; first < shown; first += bytes_a_line, at.y += theme.px(15)) {
    draw_text(theme.small, at, first < 64 ? colour::dim : colour::text, hex_line(entity.block, first));
  }
  if (shown < entity.block.size()) {
    context.widgets.caption("The first " + std::to_string(shown) + " of " + with_thousands(entity.block.size()) +
                            " bytes.");
  }
}

}  // namespace

void AgentTab::show_blocks(const TabContext& context, const SelectionReport& selected) {
  if (selected.entities.empty()) return;
  Widgets& widgets = context.widgets;
  widgets.section("Block");
  std::vector<std::string> names;
  for (const EntityRow& entity : selected.entities) {
    names.push_back(std::to_string(names.size()) + ": " + entity.kind +
                    (entity.clip.empty() ? "" : ", " + entity.clip));
  }
  const auto last = static_cast<int>(names.size()) - 1;
  int entity = static_cast<int>(std::min(entity_, names.size() - 1));
  if (widgets.pick("Entity", entity, last, names, nullptr,
                   {.what = "Whose block is shown below; the last is the pose."})) {
    entity_ = static_cast<std::size_t>(entity);
  }
  const EntityRow& row = selected.entities[static_cast<std::size_t>(entity)];
  for (const BlockField& field : row.fields) widgets.fact(field.name.c_str(), field.value, {});
  widgets.caption("Bytes; the first 64 are written once, a frame changes those after them.");
  show_bytes(context, row);
}

void AgentTab::show(const TabContext& context) {
  if (!context.report.selected) {
    context.widgets.section("Nobody is selected");
    context.widgets.caption("Click at a character.");
    return;
  }
  const SelectionReport& selected = *context.report.selected;
  show_who(context, selected);
  show_layers(context.widgets, selected);
  show_hands(context, selected);
  show_history(context, selected);
  show_events(context, selected);
  show_blocks(context, selected);
}

}  // namespace throng::app
