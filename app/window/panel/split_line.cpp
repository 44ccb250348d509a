#include <algorithm>
#include <array>
#include <string>

#include "throng/render/crowd_draw.h"

#include "app/window/panel/cards.h"
#include "app/window/panel/picture_aids.h"

namespace throng::app {
namespace {

constexpr float grip_reach = 6;  // pixels to either side of the line at which it can be grabbed
constexpr float grip_half_width = 4, grip_height = 40;

Area place_of_grip(const Theme& theme, const Area& crowd, float x) {
  const float y = (crowd.from.y + crowd.to.y) / 2, half = theme.px(grip_half_width), tall = theme.px(grip_height) / 2;
  return {.from = {x - half, y - tall}, .to = {x + half, y + tall}};
}

void draw_grip(const Theme& theme, const Area& crowd, float x, bool is_lively) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const Area grip = place_of_grip(theme, crowd, x);
  const float y = (grip.from.y + grip.to.y) / 2, quarter = grip.height() / 4;
  if (is_lively) draw.AddLine({x, crowd.from.y}, {x, crowd.to.y}, colour::accent, theme.px(2));
  draw.AddRectFilled(grip.from, grip.to, is_lively ? colour::accent : colour::text, grip.width() / 2);
  for (const float side : {-1.0F, 1.0F}) {
    const float line = x + side * theme.px(1.5F);
    draw.AddLine({line, y - quarter}, {line, y + quarter}, colour::on_accent, theme.px(1));
  }
}

// The line cannot be dragged under the panel, where it could not be grabbed again.
void drag_line(float x, float farthest, LodInspection& look, AidsMemory& memory) {
  const float width = ImGui::GetIO().DisplaySize.x;
  const bool is_left_of_window = !ImGui::IsMousePosValid();
  const float pointer = is_left_of_window ? 0 : ImGui::GetIO().MousePos.x;
  if (ImGui::IsItemActivated()) memory.grabbed_beside = pointer - x;
  const bool moves = ImGui::IsItemActive() && (is_left_of_window || ImGui::GetIO().MouseDelta.x != 0);
  if (moves) look.split_at = std::clamp((pointer - memory.grabbed_beside) / width, 0.0F, farthest / width);
}

void show_grip(const TabContext& context, const Area& crowd, float x, AidsMemory& memory) {
  const Theme& theme = context.widgets.theme();
  const float reach = theme.px(grip_reach);
  const Area place{.from = {x - reach, crowd.from.y}, .to = {x + reach, crowd.to.y}};
  begin_fixed_window("Split line", place, 0, ImGuiWindowFlags_NoBackground);
  context.widgets.clickable("split line", place);
  const bool is_lively = ImGui::IsItemActive() || ImGui::IsItemHovered();
  float& split_at = context.tuning.inspection.split_at;
  if (const int step = context.widgets.focus().take_step()) {
    split_at = std::clamp(split_at + 0.01F * static_cast<float>(step), 0.0F, 1.0F);
  }
  drag_line(x, crowd.to.x - reach, context.tuning.inspection, memory);
  draw_grip(theme, crowd, x, is_lively);
  ImGui::End();
}

/// Returns where words of that width stand: at the top, below other words that are there.
Area place_of_words(const Theme& theme, const Area& crowd, float from, float to, std::span<const Area> taken) {
  Area place{.from = {from, crowd.from.y + theme.px(12)}, .to = {to, crowd.from.y + theme.px(36)}};
  for (std::size_t tries = 0; tries < taken.size(); ++tries) {
    const auto other = std::ranges::find_if(taken, [&](const Area& area) { return overlap(place, area); });
    if (other == taken.end()) break;
    place.from.y = other->to.y + theme.px(6);
    place.to.y = place.from.y + theme.px(24);
  }
  return place;
}

std::string words_right_of_line(const LodInspection& look) {
  if (look.split == Split::shown) return "as shown";
  return "difference \xC3\x97 " + std::to_string(static_cast<int>(render::difference_amplification));
}

}  // namespace

std::vector<Area> show_split_line(const TabContext& context, const Area& crowd, std::span<const Area> taken,
                                  AidsMemory& memory) {
  if (idle_reason("split_at", context.tuning, context.report.situation)) return {};
  const Theme& theme = context.widgets.theme();
  const float x = context.tuning.inspection.split_at * ImGui::GetIO().DisplaySize.x;
  std::vector<Area> places;
  if (x <= crowd.to.x && !context.report.replay) {
    show_grip(context, crowd, x, memory);
    places.push_back(place_of_grip(theme, crowd, x));
  }
  const std::array<std::string, 2> sides = {"exact", words_right_of_line(context.tuning.inspection)};
  begin_clear_window("Split words", crowd);
  for (std::size_t side = 0; side < sides.size(); ++side) {
    const float width = text_width(theme.small, sides.at(side)) + theme.px(16);
    const float from = side == 0 ? x - theme.px(10) - width : x + theme.px(10);
    if (from < crowd.from.x || from + width > crowd.to.x) continue;
    const Area place = place_of_words(theme, crowd, from, from + width, taken);
    ImGui::GetWindowDrawList()->AddRectFilled(place.from, place.to, colour::panel, theme.px(4));
    draw_text(theme.small, {from + theme.px(8), place.from.y + theme.px(5)}, colour::text, sides.at(side));
    context.widgets.record(side == 0 ? "split:left" : "split:right", place);
    places.push_back(place);
  }
  ImGui::End();
  return places;
}

}  // namespace throng::app
