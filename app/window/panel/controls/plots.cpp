#include "app/window/panel/controls/plots.h"

#include <algorithm>
#include <cmath>

#include "app/window/panel/controls/text_lines.h"

namespace throng::app {
namespace {

ImDrawList& draw_list() { return *ImGui::GetWindowDrawList(); }

float y_of(const Area& area, float value, float highest) {
  return area.to.y - area.height() * std::clamp(value / highest, 0.0F, 1.0F);
}

void draw_distance_axis(const Theme& theme, const Area& plot, float longest) {
  const float step = round_up(longest / 6);
  for (float metres = 0; metres <= longest; metres += step) {
    const float x = plot.from.x + plot.width() * metres / longest;
    draw_list().AddLine({x, plot.from.y}, {x, plot.to.y}, ImGui::GetColorU32(colour::grid));
    const float align = metres == 0 ? 0.0F : (metres + step > longest ? 1.0F : 0.5F);
    draw_text(theme.small, {x, plot.to.y + theme.px(2)}, colour::faint,
              fixed(metres, 0) + (metres + step > longest ? " m" : ""), align);
  }
}

}  // namespace

float at_percent(std::vector<float> values, std::size_t percent) {
  if (values.empty()) return 0;
  const auto place = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) * percent / 100);
  std::ranges::nth_element(values, place);
  return *place;
}

float round_up(float value) {
  const float decade = std::pow(10.0F, std::floor(std::log10(std::max(value, 1e-3F))));
  for (const float factor : {1.0F, 2.0F, 5.0F}) {
    if (factor * decade >= value) return factor * decade;
  }
  return 10 * decade;
}

void draw_well(const Theme& theme, const Area& area) {
  draw_list().AddRectFilled(area.from, area.to, ImGui::GetColorU32(colour::well), theme.px(4));
}

void draw_line(const Area& area, std::span<const float> values, float highest, std::size_t capacity, ImU32 colour,
               float thickness) {
  if (values.size() < 2) return;
  const float step = area.width() / static_cast<float>(capacity - 1);
  const float first = area.to.x - step * static_cast<float>(values.size() - 1);
  draw_list().PushClipRect(area.from, area.to, true);
  for (std::size_t i = 0; i < values.size(); ++i) {
    draw_list().PathLineTo({first + step * static_cast<float>(i), y_of(area, values[i], highest)});
  }
  draw_list().PathStroke(ImGui::GetColorU32(colour), ImDrawFlags_None, thickness);
  draw_list().PopClipRect();
}

void draw_beside(const Theme& theme, const Area& plot, std::span<const SideLabel> labels) {
  const float line = font_height(theme.small);
  std::vector<float> wanted;
  for (const SideLabel& label : labels) wanted.push_back(plot.to.y - label.share * plot.height() - line / 2);
  const std::vector<float> tops = apart(wanted, line, plot.from.y - line / 2, plot.to.y + line / 2);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    draw_text(theme.small, {plot.to.x + theme.px(6), tops[i]}, labels[i].ink, labels[i].words);
  }
}

SideLabel draw_limit(const Theme& theme, const Area& area, float value, float highest, const std::string& words) {
  const float y = std::floor(y_of(area, value, highest)) + 0.5F;
  const float dash = theme.px(4);
  for (float x = area.from.x; x < area.to.x; x += 2 * dash) {
    draw_list().AddLine({x, y}, {std::min(x + dash, area.to.x), y}, colour::with_alpha(colour::changed, 0.6F));
  }
  return {.share = std::clamp(value / highest, 0.0F, 1.0F), .ink = colour::changed, .words = words};
}

void draw_bars(const Theme& theme, const Area& area, const Bars& bars) {
  if (bars.counts.empty()) return;
  const int largest = std::max(1, *std::ranges::max_element(bars.counts));
  const float line = font_height(theme.small) + theme.px(2);
  const float slot = area.width() / static_cast<float>(bars.counts.size());
  const float width = std::min(slot - theme.px(4), theme.px(46));
  const Area plot{.from = {area.from.x, area.from.y + line}, .to = {area.to.x, area.to.y - line}};
  draw_list().AddLine({plot.from.x, plot.to.y}, plot.to, ImGui::GetColorU32(colour::well_hovered));
  for (int i = 0; i < static_cast<int>(bars.counts.size()); ++i) {
    const int count = bars.counts[static_cast<std::size_t>(i)];
    const float middle = plot.from.x + slot * (static_cast<float>(i) + 0.5F);
    const float top = y_of(plot, static_cast<float>(count), static_cast<float>(largest));
    draw_list().AddRectFilled({middle - width / 2, std::min(top, plot.to.y - (count > 0 ? theme.px(1) : 0))},
                              {middle + width / 2, plot.to.y}, ImGui::GetColorU32(bars.colour_of(i)), theme.px(2),
                              ImDrawFlags_RoundCornersTop);
    if (count > 0) draw_text(theme.small, {middle, top - line}, colour::dim, with_thousands(count), 0.5F);
    draw_text(theme.small, {middle, plot.to.y + theme.px(2)}, colour::faint, bars.name_of(i), 0.5F);
  }
}

void draw_steps(const Theme& theme, const Area& area, const Steps& steps) {
  const Area plot{.from = area.from, .to = {area.to.x, area.to.y - font_height(theme.small) - theme.px(4)}};
  draw_distance_axis(theme, plot, steps.longest);
  const auto columns = static_cast<int>(plot.width());
  for (int column = 0; column < columns;) {
    const auto value_of = [&](int x) {
      return steps.value_at(steps.longest * static_cast<float>(x) / static_cast<float>(columns));
    };
    const int value = value_of(column), first = column;
    while (column < columns && value_of(column) == value) ++column;
    const float height = static_cast<float>(value) / static_cast<float>(steps.largest + 1);
    const ImVec2 from(plot.from.x + static_cast<float>(first), plot.to.y - height * plot.height());
    const ImVec2 to(plot.from.x + static_cast<float>(column), plot.to.y);
    const ImU32 ink = steps.colour_of(value);
    draw_list().AddRectFilled(from, to, ImGui::GetColorU32(colour::with_alpha(ink, 0.22F)));
    draw_list().AddRectFilled(from, {to.x, from.y + theme.px(2)}, ImGui::GetColorU32(ink));
    if (to.x - from.x > theme.px(14)) {
      draw_text(theme.small, {(from.x + to.x) / 2, from.y - font_height(theme.small) - theme.px(1)}, colour::dim,
                std::to_string(value), 0.5F);
    }
  }
}

}  // namespace throng::app
