#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "throng/lod_rules.h"

#include "app/people/crowd/habits.h"
#include "app/settings/choices.h"
#include "app/window/panel/cards.h"
#include "app/window/panel/controls/plots.h"
#include "app/window/panel/tabs.h"
#include "engine/base/text/size_text.h"

namespace throng::app {
namespace {

constexpr std::size_t history_shown = 240, bytes_a_line = 12, most_bytes_shown = 384, most_events_shown = 8;
constexpr float layer_height = 19, entity_indent = 12, bar_width = 62, narrow_bar_width = 20, percent_width = 44,
                clip_time_width = 84;
constexpr float right_margin = 20;  // as wide as the column of resets, which facts leave free too

void show_who(const TabContext& context, const SelectionReport& selected) {
  Widgets& widgets = context.widgets;
  widgets.section(capitalised(name_of(selected)).c_str());
  widgets.fact("Does", habit_words.at(static_cast<std::size_t>(selected.habit)),
               {.what = "What the crowd has in mind for it."});
  widgets.fact("Posture", posture_words.at(static_cast<std::size_t>(selected.posture)),
               {.what = "Upright, or how a rag-doll is."});
  widgets.fact("Blocks", with_thousands(selected.entities.size()) + ", " + size_text(selected.bytes),
               {.what = "Its entities in main memory."});
  show_view_button(widgets, "View alone", ImGui::GetContentRegionAvail().x, context.requests);
}

float bar_width_in(const Theme& theme, const Area& row) {
  return theme.px(is_narrow(theme, row.width()) ? narrow_bar_width : bar_width);
}

/// Draws a share, 0 to 1, between the words and the figure.
void draw_bar(const Theme& theme, const Area& row, float weight, ImU32 colour) {
  const float right = row.to.x - theme.px(percent_width), left = right - bar_width_in(theme, row);
  const float y = std::floor((row.from.y + row.to.y) / 2), half = theme.px(2.5F);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled({left, y - half}, {right, y + half}, colour::well_hovered, half);
  const float end = left + (right - left) * std::clamp(weight, 0.0F, 1.0F);
  if (weight > 0) draw.AddRectFilled({left, y - half}, {end, y + half}, colour, half);
}

void draw_layer(const Theme& theme, const Area& row, const LayerRow& layer) {
  const float y = row.from.y + theme.px(2);
  draw_text(theme.regular, {row.from.x, y}, colour::text, layer.name + (layer.is_masked ? ", some bones" : ""));
  draw_bar(theme, row, layer.weight, colour::accent);
  draw_text(theme.small, {row.to.x, y + theme.px(1)}, colour::text, as_percent(layer.weight), 1);
}

void draw_entity(const Theme& theme, const Area& row, const EntityRow& entity) {
  const float y = row.from.y + theme.px(3);
  const float times_end = row.to.x - theme.px(percent_width + 8) - bar_width_in(theme, row);
  const ImU32 ink = entity.weight > 0 ? colour::text : colour::dim;
  const float left = row.from.x + theme.px(entity_indent), room = times_end - theme.px(clip_time_width) - left;
  draw_text(theme.small, {left, y}, ink, fitted(theme.small, room, entity.clip.empty() ? entity.kind : entity.clip));
  draw_text(theme.small, {times_end, y}, colour::dim, place_in_clip(entity), 1);
  draw_bar(theme, row, entity.weight, colour::frame);
  draw_text(theme.small, {row.to.x, y}, ink, as_percent(entity.weight), 1);
}

Area layer_row(Widgets& widgets, const std::string& name) {
  Area row = widgets.area(name.c_str(), layer_height);
  row.to.x -= widgets.theme().px(right_margin);
  return row;
}

void show_layers(const TabContext& context, const SelectionReport& selected) {
  if (selected.layers.empty()) return;
  Widgets& widgets = context.widgets;
  const Theme& theme = widgets.theme();
  widgets.section("Channels, and what changes their pose");
  for (std::size_t i = 0; i < selected.layers.size(); ++i) {
    const LayerRow& layer = selected.layers[i];
    draw_layer(theme, layer_row(widgets, "Layer " + std::to_string(i)), layer);
    if (!layer.is_channel) continue;
    for (const std::size_t place : layer.entities) {
      const std::string name = "Layer " + std::to_string(i) + ", entity " + std::to_string(place);
      draw_entity(theme, layer_row(widgets, name), selected.entities[place]);
    }
  }
  widgets.caption("Green: how much of a layer is laid over what is below. Blue: how much of an entity is in the pose.");
}

std::optional<std::string> why_not_held(const SelectionReport& selected) {
  if (selected.clip_seconds <= 0) return "it plays no clip";
  if (selected.posture != Posture::upright) return "it is no longer upright";
  return std::nullopt;
}

void show_hands(const TabContext& context, const SelectionReport& selected) {
  const auto& [widgets, report, tuning, standard, requests, memory] = context;
  widgets.section("Hold its clip");
  const auto last = static_cast<double>(std::max(selected.clip_seconds, 0.01F));
  widgets.begin_idle(why_not_held(selected));
  double seconds = std::min(static_cast<double>(selected.held_at.value_or(0)), last);
  if (widgets.number("Hold clip at", seconds, 0, {.highest = last, .decimals = 2, .suffix = " s"},
                     {.what = "Drag to stop it and to move through its clip. Crowd logic holds it in its place.",
                      .unit = "seconds from the clip's start"})) {
    requests.ask(Hold{selected.agent, static_cast<float>(seconds)});
  }
  widgets.end_idle();
  ButtonRow buttons(widgets, 2);
  buttons.ask(requests, Hold{}, "Let go", {.what = "It goes on as the crowd wants it."},
              selected.held_at ? nullptr : "its clip is not held");
  buttons.ask(requests, Push{selected.agent, ahead_of(report.camera)}, "Push",
              {.what = "Makes a rag-doll of it, which falls. Key P."}, selected.can_fall ? nullptr : cannot_fall);
}

/// Draws a column a frame, as high as the interval is long, above a dot in the colour of the bone level.
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
    const float tall = (plot.height() - levels - theme.px(2)) * static_cast<float>(moment.interval) / longest_interval;
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
  context.widgets.section("Events");
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
  const std::size_t lines = (shown + bytes_a_line - 1) / bytes_a_line;
  const Area area = context.widgets.area("Block bytes", 15 * static_cast<float>(lines) + 8);
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

void show_blocks(const TabContext& context, const SelectionReport& selected) {
  if (selected.entities.empty()) return;
  Widgets& widgets = context.widgets;
  widgets.section("Block");
  std::vector<std::string> names;
  for (const EntityRow& entity : selected.entities) {
    names.push_back(std::to_string(names.size()) + ": " + entity.kind +
                    (entity.clip.empty() ? "" : ", " + entity.clip));
  }
  const auto last = static_cast<int>(names.size()) - 1;
  int entity = static_cast<int>(std::min(context.memory.entity, names.size() - 1));
  if (widgets.pick("Entity", entity, last, names, nullptr,
                   {.what = "Whose block is shown below; the last is the pose."})) {
    context.memory.entity = static_cast<std::size_t>(entity);
  }
  if (widgets.is_searching()) return;
  const EntityRow& row = selected.entities[static_cast<std::size_t>(entity)];
  for (const BlockField& field : row.fields) widgets.fact(field.name.c_str(), field.value, {});
  widgets.caption("Bytes; the first 64 are written once, a frame changes those after them.");
  show_bytes(context, row);
}

}  // namespace

void show_agent_tab(const TabContext& context) {
  if (!context.report.selected) {
    context.widgets.section("No agent is selected");
    context.widgets.caption("Click at a character.");
    return;
  }
  const SelectionReport& selected = *context.report.selected;
  const auto show_unless_searching = [&](const auto& show) {
    if (!context.widgets.is_searching()) show(context, selected);
  };
  show_unless_searching(show_who);
  show_unless_searching(show_layers);
  show_hands(context, selected);
  show_unless_searching(show_history);
  show_unless_searching(show_events);
  show_blocks(context, selected);
}

}  // namespace throng::app
