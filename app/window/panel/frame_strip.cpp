#include <algorithm>
#include <cmath>
#include <vector>

#include "app/window/panel/cards.h"
#include "app/window/panel/controls/plots.h"

namespace throng::app {
namespace {

constexpr float display_interval_ms = 16.7F;
constexpr float numbers_width = 232, least_graph_width = 40;

std::string short_milliseconds(float value) { return fixed(value, value < 9.995F ? 2 : 1); }

void draw_figure(const Theme& theme, ImVec2 at, const char* name, ImU32 ink, float now, float middle) {
  ImGui::GetWindowDrawList()->AddRectFilled({at.x, at.y + theme.px(3)}, {at.x + theme.px(3), at.y + theme.px(39)}, ink,
                                            theme.px(1));
  draw_text(theme.small, {at.x + theme.px(11), at.y}, colour::dim, name);
  draw_text(theme.large, {at.x + theme.px(11), at.y + theme.px(15)}, colour::text, short_milliseconds(now));
  const float width = text_width(theme.large, short_milliseconds(now));
  draw_text(theme.small, {at.x + width + theme.px(15), at.y + theme.px(22)}, colour::dim, "ms");
  draw_text(theme.small, {at.x + theme.px(11), at.y + theme.px(39)}, colour::faint,
            "median " + short_milliseconds(middle));
}

/// Names the device: the version up to its first blank, the renderer up to its details.
std::string drawn_by(const FrameReport& report) {
  const std::string device = report.gl_renderer.substr(0, report.gl_renderer.find_first_of("(,/"));
  return report.context + ", GL " + report.gl_version.substr(0, report.gl_version.find(' ')) + ", " +
         device.substr(0, 18);
}

void draw_numbers(const Theme& theme, ImVec2 at, const FrameReport& report) {
  draw_figure(theme, at, "Frame", colour::frame, report.frame_ms, at_percent(report.frame_ms_history, 50));
  draw_figure(theme, {at.x + theme.px(108), at.y}, "Animation", colour::accent, report.update_ms,
              at_percent(report.update_ms_history, 50));
  const float rate = report.frame_ms > 0 ? 1000 / report.frame_ms : 0;
  draw_text(theme.small, {at.x, at.y + theme.px(66)}, colour::dim,
            fixed(rate, rate < 10 ? 1 : 0) + " frames/s,  drawing " + short_milliseconds(report.draw_ms) + " ms");
  draw_text(theme.small, {at.x, at.y + theme.px(84)}, colour::faint, drawn_by(report));
}

/// Returns room for nearly all frames, so that one slow frame does not flatten the rest.
float graph_top(const FrameReport& report) {
  return round_up(std::max(20.0F, 1.15F * at_percent(report.frame_ms_history, 95)));
}

void draw_scale(const Area& graph) {
  for (const float share : {0.25F, 0.5F, 0.75F}) {
    const float y = std::floor(graph.to.y - share * graph.height()) + 0.5F;
    ImGui::GetWindowDrawList()->AddLine({graph.from.x, y}, {graph.to.x, y}, colour::grid);
  }
}

float x_of(const Area& graph, int frames_ago) {
  return graph.to.x - graph.width() * static_cast<float>(frames_ago) / static_cast<float>(frames_shown - 1);
}

/// Marks the frames that can be looked at with dots, and the one that is looked at with a line.
void draw_kept_frames(const Theme& theme, const Area& graph, const FrameReport& report) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  for (const int number : report.kept.numbers) {
    draw.AddCircleFilled({x_of(graph, report.frame - number), graph.to.y + theme.px(5)}, theme.px(1.5F), colour::dim,
                         6);
  }
  if (!report.kept.looked_at) return;
  const float x = x_of(graph, report.frame - report.kept.looked_at->number());
  if (x >= graph.from.x) draw.AddLine({x, graph.from.y}, {x, graph.to.y + theme.px(5)}, colour::changed, theme.px(2));
}

// Enter looks at the newest of the frames that are kept; left and right go to the one before and after.
void look_by_keys(PanelFocus& focus, const FrameReport& report, Requests& requests) {
  const std::vector<int>& kept = report.kept.numbers;
  const bool enters = focus.take_activation();
  const int step = focus.take_step();
  if (kept.empty() || (!enters && step == 0)) return;
  const auto last = static_cast<int>(kept.size()) - 1;
  int place = last;
  if (report.kept.looked_at && !enters) {
    place = static_cast<int>(std::ranges::lower_bound(kept, report.kept.looked_at->number()) - kept.begin()) + step;
  }
  requests.ask(LookAtFrame{kept[static_cast<std::size_t>(std::clamp(place, 0, last))]});
}

void show_frame_under_pointer(const Area& graph, const FrameReport& report, Requests& requests) {
  const std::size_t count = std::min(report.frame_ms_history.size(), report.update_ms_history.size());
  const float step = graph.width() / static_cast<float>(frames_shown - 1);
  const auto frames_ago =
      static_cast<std::size_t>(std::max(0.0F, (graph.to.x - ImGui::GetIO().MousePos.x) / step + 0.5F));
  if (!graph.hovered || frames_ago >= count) return;
  const std::size_t index = count - 1 - frames_ago;
  const float x = x_of(graph, static_cast<int>(frames_ago));
  ImGui::GetWindowDrawList()->AddLine({x, graph.from.y}, {x, graph.to.y}, colour::faint);
  show_lines({"frame " + short_milliseconds(report.frame_ms_history[index]) + " ms, animation " +
                  short_milliseconds(report.update_ms_history[index]) + " ms",
              report.kept.numbers.empty() ? "" : "click: what the slow frame nearest to it did, one with a dot"});
  if (ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
    requests.ask(LookAtFrame{report.frame - static_cast<int>(frames_ago)});
  }
}

}  // namespace

void show_frame_strip(Widgets& widgets, const Area& place, const FrameReport& report, Requests& requests) {
  const Theme& theme = widgets.theme();
  begin_fixed_window("Frame strip", place, 0, theme.panels_have_ground ? 0 : ImGuiWindowFlags_NoBackground);
  draw_numbers(theme, {place.from.x + theme.px(16), place.from.y + theme.px(14)}, report);
  Area graph{.from = {place.from.x + theme.px(16 + numbers_width), place.from.y + theme.px(16)},
             .to = {place.to.x - theme.px(58), place.to.y - theme.px(16)}};
  if (graph.width() < theme.px(least_graph_width)) return ImGui::End();
  widgets.pressable("Frame graph", graph);
  graph.hovered = ImGui::IsItemHovered();
  look_by_keys(widgets.stop("Frame graph", graph), report, requests);
  draw_well(theme, graph);
  const float top = graph_top(report);
  draw_scale(graph);
  draw_line(graph, report.frame_ms_history, top, frames_shown, colour::frame, theme.px(1.5F));
  draw_line(graph, report.update_ms_history, top, frames_shown, colour::accent, theme.px(1.5F));
  draw_beside(
      theme, graph,
      std::vector{SideLabel{1, colour::faint, fixed(top, 0) + " ms"},
                  draw_limit(theme, graph, display_interval_ms, top, "16.7 ms"), SideLabel{0, colour::faint, "0"}});
  draw_kept_frames(theme, graph, report);
  show_frame_under_pointer(graph, report, requests);
  ImGui::End();
}

}  // namespace throng::app
