#include "app/overlay/layer_rows.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "app/overlay/entity_words.h"

namespace throng::app {
namespace {

constexpr float layer_height = 19, indent = 12, bar_width = 62, percent_width = 44, clip_time_width = 84;
constexpr float right_margin = 20;  // as wide as the column of resets, which facts leave free too

/// A share of what there is, 0 to 1, between the words and the figure.
void draw_bar(const Theme& theme, const Area& row, float weight, ImU32 colour) {
  const float right = row.to.x - theme.px(percent_width), left = right - theme.px(bar_width);
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
  const float times_end = row.to.x - theme.px(percent_width + bar_width + 8);
  const ImU32 ink = entity.weight > 0 ? colour::text : colour::dim;
  ImGui::PushClipRect(row.from, {times_end - theme.px(clip_time_width), row.to.y}, true);
  draw_text(theme.small, {row.from.x + theme.px(indent), y}, ink, entity.clip.empty() ? entity.kind : entity.clip);
  ImGui::PopClipRect();
  draw_text(theme.small, {times_end, y}, colour::dim, place_in_clip(entity), 1);
  draw_bar(theme, row, entity.weight, colour::frame);
  draw_text(theme.small, {row.to.x, y}, ink, as_percent(entity.weight), 1);
}

Area row_of(Widgets& widgets, const std::string& name) {
  Area row = widgets.area(name.c_str(), layer_height);
  row.to.x -= widgets.theme().px(right_margin);
  return row;
}

}  // namespace

void show_layers(Widgets& widgets, const SelectionReport& selected) {
  if (selected.layers.empty()) return;
  widgets.section("Channels, and what changes their pose");
  const Theme& theme = widgets.theme();
  for (std::size_t i = 0; i < selected.layers.size(); ++i) {
    const LayerRow& layer = selected.layers[i];
    draw_layer(theme, row_of(widgets, "Layer " + std::to_string(i)), layer);
    if (!layer.is_channel) continue;
    for (const std::size_t place : layer.entities) {
      const std::string name = "Layer " + std::to_string(i) + ", entity " + std::to_string(place);
      draw_entity(theme, row_of(widgets, name), selected.entities[place]);
    }
  }
  widgets.caption("Green: how much of a layer is laid over what is below. Blue: how much of an entity is in the pose.");
}

}  // namespace throng::app
