#include <algorithm>

#include "app/window/panel/cards.h"
#include "app/window/panel/picture_aids.h"
#include "engine/base/text/joined.h"

namespace throng::app {
namespace {

constexpr float legend_margin = 12, legend_padding = 10, legend_row = 17, legend_swatch = 11, legend_gap = 14;
constexpr float ramp_height = 12, ramp_width = 190, ramp_rows = 2;
constexpr float legend_title_room = 20;  // for the sign that folds it

std::string agents_words(const LegendStep& step) {
  return step.agents ? with_thousands(static_cast<std::uint64_t>(std::max(*step.agents, 0))) : "";
}

constexpr const char* counted_words = "in view";

bool is_counted(const LegendPart& part) {
  return std::ranges::any_of(part.steps, [](const LegendStep& step) { return step.agents.has_value(); });
}

ImVec2 legend_size(const Theme& theme, const std::vector<LegendPart>& parts, bool is_folded) {
  float width = 0, rows = is_folded ? 1 : 0;
  for (const LegendPart& part : parts) {
    const float count = is_counted(part) ? text_width(theme.small, counted_words) + theme.px(legend_gap) : 0;
    width = std::max(width, text_width(theme.small, part.title) + count + theme.px(legend_title_room));
    if (is_folded) continue;
    rows += 1 + static_cast<float>(part.steps.size()) + (part.ramp ? ramp_rows : 0);
    if (part.ramp) width = std::max(width, theme.px(ramp_width));
    for (const LegendStep& step : part.steps) {
      const std::string agents = agents_words(step);
      const float room = agents.empty() ? 0 : text_width(theme.small, agents) + theme.px(legend_gap);
      width = std::max(width, theme.px(legend_swatch + 8) + text_width(theme.small, step.words) + room);
    }
    for (const std::string& line : part.notes) {
      width = std::max(width, text_width(theme.small, line));
      ++rows;
    }
  }
  if (is_folded) width = text_width(theme.small, "Legend") + theme.px(legend_title_room);
  const float between = is_folded ? 0 : theme.px(6) * static_cast<float>(parts.size() - 1);
  return {std::ceil(width + theme.px(2 * legend_padding)),
          std::ceil(theme.px(legend_row) * rows + between + theme.px(12))};
}

/// Finds room for a card of that size at the lower left, or to the right of cards that are there already.
std::optional<Area> room_for_legend(const Theme& theme, const Area& crowd, std::span<const Area> taken, ImVec2 size) {
  const float edge = theme.px(legend_margin);
  float bottom = crowd.to.y - edge;
  for (const Area& other : taken) {  // the bar of a replay
    const bool is_bar = other.to.y > bottom - 1 && other.width() > 0.8F * crowd.width();
    if (is_bar) bottom = other.from.y - theme.px(6);
  }
  Area place{.from = {crowd.from.x + edge, bottom - size.y}, .to = {crowd.from.x + edge + size.x, bottom}};
  for (std::size_t tries = 0; tries <= taken.size(); ++tries) {
    if (place.to.x > crowd.to.x || place.from.y < crowd.from.y) return std::nullopt;
    const auto other = std::ranges::find_if(taken, [&](const Area& area) { return overlap(place, area); });
    if (other == taken.end()) return place;
    place.from.x = other->to.x + theme.px(6);
    place.to.x = place.from.x + size.x;
  }
  return std::nullopt;
}

void draw_swatch(const Theme& theme, ImVec2 at, std::uint32_t color) {
  const ImVec2 to(at.x + theme.px(legend_swatch), at.y + theme.px(legend_swatch));
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  if (color != 0) draw.AddRectFilled(at, to, color | IM_COL32_A_MASK);
  if (color == 0 || color == IM_COL32_A_MASK) draw.AddRect(at, to, colour::dim);
}

/// Draws the parts below each other, and notes each step in the map.
class LegendDrawing {
 public:
  LegendDrawing(Widgets& widgets, const Area& place)
      : widgets_(widgets),
        theme_(widgets.theme()),
        left_(place.from.x + theme_.px(legend_padding)),
        right_(place.to.x - theme_.px(legend_padding)),
        y_(place.from.y + theme_.px(6)) {}

  void draw(const LegendPart& part) {
    if (is_counted(part))
      draw_text(theme_.small, {right_ - theme_.px(steps_ == 0 ? legend_title_room : 0), y_}, colour::dim, counted_words,
                1);
    write(colour::text, part.title);
    if (part.ramp) draw(*part.ramp);
    for (const LegendStep& step : part.steps) draw(step);
    for (const std::string& line : part.notes) write(colour::dim, line);
    y_ += theme_.px(6);
  }

 private:
  void draw(const LegendRamp& ramp) {
    const float from = left_ + theme_.px(4), to = right_ - theme_.px(12);  // words at the ends reach beyond
    const float top = y_ + theme_.px(2), bottom = top + theme_.px(ramp_height);
    const auto x_at = [&](float share) { return from + share * (to - from); };
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    for (std::size_t i = 1; i < ramp.colors.size(); ++i) {
      const auto pieces = static_cast<float>(ramp.colors.size() - 1);
      const std::uint32_t left = ramp.colors[i - 1] | IM_COL32_A_MASK, right = ramp.colors[i] | IM_COL32_A_MASK;
      draw.AddRectFilledMultiColor({x_at(static_cast<float>(i - 1) / pieces), top},
                                   {x_at(static_cast<float>(i) / pieces), bottom}, left, right, right, left);
    }
    for (const LegendTick& tick : ramp.ticks) {
      const float x = x_at(tick.share);
      draw.AddLine({x, bottom}, {x, bottom + theme_.px(3)}, colour::dim);
      draw_text(theme_.small, {x, bottom + theme_.px(3)}, colour::text, tick.words, 0.5F);
    }
    const Area row{.from = {left_, y_}, .to = {right_, y_ + ramp_rows * theme_.px(legend_row)}};
    widgets_.record("legend.ramp", row);
    y_ = row.to.y;
  }
  void draw(const LegendStep& step) {
    draw_swatch(theme_, {left_, y_ + theme_.px(3)}, step.color);
    draw_text(theme_.small, {left_ + theme_.px(legend_swatch + 8), y_}, colour::text, step.words);
    draw_text(theme_.small, {right_, y_}, colour::dim, agents_words(step), 1);
    const Area row{.from = {left_, y_}, .to = {right_, y_ + theme_.px(legend_row)}};
    widgets_.record("legend:" + std::to_string(steps_++), row);
    y_ = row.to.y;
  }
  void write(ImU32 ink, const std::string& words) {
    draw_text(theme_.small, {left_, y_}, ink, words);
    y_ += theme_.px(legend_row);
  }

  Widgets& widgets_;
  const Theme& theme_;
  float left_, right_, y_;
  int steps_ = 0;
};

LegendPart moment_of(const FrameReport& report) {
  return {.title = fixed(report.seconds, 2) + " s, " + counted_people(static_cast<std::size_t>(report.people)),
          .steps = {}};
}

/// Shows the sign at the right of the first line. A click anywhere in that line folds the card, and unfolds it.
void show_fold(Widgets& widgets, const Area& place, bool& is_folded) {
  const Theme& theme = widgets.theme();
  const Area line{.from = place.from, .to = {place.to.x, place.from.y + theme.px(legend_row + 7)}};
  if (widgets.clickable("legend.fold", line)) is_folded = !is_folded;
  const ImVec2 middle(line.to.x - theme.px(legend_padding + 4), line.from.y + theme.px(6 + legend_row / 2 - 1));
  draw_fold_sign(theme, middle, is_folded, ImGui::IsItemHovered() ? colour::text : colour::dim);
}

}  // namespace

std::optional<Area> show_legend(const TabContext& context, const Area& crowd, std::span<const Area> taken,
                                AidsMemory& memory) {
  std::vector<LegendPart> parts = legend_of(context.report, context.tuning, memory.heads.size());
  if (memory.is_legend_alone) parts.insert(parts.begin(), moment_of(context.report));
  if (parts.empty()) return std::nullopt;
  Widgets& widgets = context.widgets;
  const Theme& theme = widgets.theme();
  bool is_folded = memory.legend_is_folded;
  auto place = room_for_legend(theme, crowd, taken, legend_size(theme, parts, is_folded));
  if (!place && memory.is_legend_alone) {
    place = {.from = crowd.from, .to = crowd.from};
    place->to.x += legend_size(theme, parts, false).x, place->to.y += legend_size(theme, parts, false).y;
  } else if (!place && !is_folded) {
    is_folded = true;
    place = room_for_legend(theme, crowd, taken, legend_size(theme, parts, true));
  }
  if (!place) return std::nullopt;
  begin_fixed_window("Legend", *place, theme.px(8));
  widgets.record("legend", *place);
  if (!memory.is_legend_alone) show_fold(widgets, *place, memory.legend_is_folded);
  LegendDrawing drawing(widgets, *place);
  if (is_folded) {
    drawing.draw({.title = "Legend", .steps = {}});
  } else {
    for (const LegendPart& part : parts) drawing.draw(part);
  }
  ImGui::End();
  return place;
}

}  // namespace throng::app
