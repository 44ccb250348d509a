#include "app/overlay/picture_aids.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace throng::app {
namespace {

constexpr std::array<std::string_view, 4> cards_over_crowd = {"Selected", "Help", "Messages", "Replay"};
constexpr std::array<std::string_view, 3> pills_over_crowd = {"badge:", "warning:", "message:"};

bool lies_over_crowd(std::string_view name) {
  return std::ranges::find(cards_over_crowd, name) != cards_over_crowd.end() ||
         std::ranges::any_of(pills_over_crowd, [&](std::string_view start) { return name.starts_with(start); });
}

std::vector<Area> taken_places(const UiMap& map) {
  std::vector<Area> taken;
  for (const auto& [name, place] : map.widgets) {
    if (!lies_over_crowd(name)) continue;
    taken.push_back({.from = {place.x, place.y}, .to = {place.x + place.width, place.y + place.height}});
  }
  return taken;
}

}  // namespace

bool overlap(const Area& a, const Area& b) {
  return a.from.x < b.to.x && b.from.x < a.to.x && a.from.y < b.to.y && b.from.y < a.to.y;
}

bool is_free(const Area& place, std::span<const Area> taken) {
  return std::ranges::none_of(taken, [&](const Area& other) { return overlap(place, other); });
}

void show_picture_aids(const TabContext& context, const UiMap& map, const Area& crowd, AidsMemory& memory) {
  std::vector<Area> taken = taken_places(map);
  if (const auto legend = show_legend(context, crowd, taken, memory)) taken.push_back(*legend);
  if (context.report.viewer) return;
  const std::vector<Area> words = show_split_line(context, crowd, taken, memory);
  taken.insert(taken.end(), words.begin(), words.end());
  show_head_labels(context, crowd, taken, memory);
}

}  // namespace throng::app
