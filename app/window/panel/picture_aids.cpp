#include "app/window/panel/picture_aids.h"

#include <algorithm>

namespace throng::app {
bool overlap(const Area& a, const Area& b) {
  return a.from.x < b.to.x && b.from.x < a.to.x && a.from.y < b.to.y && b.from.y < a.to.y;
}

bool is_free(const Area& place, std::span<const Area> taken) {
  return std::ranges::none_of(taken, [&](const Area& other) { return overlap(place, other); });
}

void show_picture_aids(const TabContext& context, const UiMap& map, const Area& crowd, AidsMemory& memory) {
  std::vector<Area> taken;
  for (const UiRectangle& place : map.over_crowd) {
    taken.push_back({.from = {place.x, place.y}, .to = {place.x + place.width, place.y + place.height}});
  }
  if (const auto legend = show_legend(context, crowd, taken, memory)) taken.push_back(*legend);
  if (context.report.viewer) return;
  const std::vector<Area> words = show_split_line(context, crowd, taken, memory);
  taken.insert(taken.end(), words.begin(), words.end());
  show_head_labels(context, crowd, taken, memory);
}

void show_aids_without_panel(const TabContext& context, AidsMemory& memory) {
  const Area whole{.from = {0, 0}, .to = ImGui::GetIO().DisplaySize};
  const auto legend = memory.is_legend_alone ? show_legend(context, whole, {}, memory) : std::nullopt;
  if (!context.tuning.ids || context.report.viewer) return;
  std::vector<Area> taken;
  if (legend) taken.push_back(*legend);
  show_head_labels(context, whole, taken, memory);
}

}  // namespace throng::app
