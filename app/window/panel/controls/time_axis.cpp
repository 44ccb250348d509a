#include "app/window/panel/controls/time_axis.h"

#include <algorithm>
#include <cmath>

#include "app/window/panel/controls/plots.h"

namespace throng::app {

float TimeAxis::x_of(double seconds) const {
  const double share = last > first ? std::clamp((seconds - first) / (last - first), 0.0, 1.0) : 0.0;
  return from + (to - from) * static_cast<float>(share);
}

double TimeAxis::time_at(float x) const {
  const double share = std::clamp(static_cast<double>((x - from) / std::max(to - from, 1.0F)), 0.0, 1.0);
  return first + share * (last - first);
}

void TimeAxis::draw_labels(const Theme& theme, const Area& graph) const {
  constexpr float between_labels = 72;
  const float y = graph.to.y + theme.px(1);
  const double length = last - first;
  if (length <= 0.0) return draw_text(theme.small, {from, y}, colour::faint, fixed(first, 2) + " s");
  const float labels = std::max((to - from) / theme.px(between_labels), 1.0F);
  const auto step = static_cast<double>(round_up(static_cast<float>(length) / labels));
  const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-6)), 0, 3);
  for (double tick = std::ceil(first / step - 1e-6) + 0.0; tick * step <= last + 1e-6 * step; ++tick) {
    const float x = x_of(tick * step);
    ImGui::GetWindowDrawList()->AddLine({x, graph.from.y}, {x, graph.to.y}, colour::grid);
    const float align = x - from < theme.px(16) ? 0.0F : (to - x < theme.px(20) ? 1.0F : 0.5F);
    draw_text(theme.small, {x, y}, colour::faint, fixed(tick * step, decimals) + " s", align);
  }
}

}  // namespace throng::app
