#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>

#include <imgui_internal.h>

#include "app/window/panel/controls/plots.h"
#include "app/window/panel/tabs.h"
#include "engine/base/text/size_text.h"

namespace throng::app {
namespace {

constexpr float zoom_a_step = 0.8F, closest = 0.002F;  // of the axis

struct SpanLook {
  ImU32 colour;
  const char* words;
};

/// The looks of the kinds that lanes show, in the order of anim::TraceSpan::Kind.
constexpr std::array<SpanLook, 4> looks = {{{colour::fetch, "fetch: entities are copied into the local store"},
                                            {colour::compute, "compute"},
                                            {colour::write_back, "write back: changed bytes are copied out"},
                                            {colour::wait, "wait"}}};

const SpanLook& look_of(const anim::TraceSpan& span) { return looks.at(static_cast<std::size_t>(span.kind)); }

std::string agents_of(const anim::TaskContent& content) {
  const std::string first = with_thousands(content.first_agent), last = with_thousands(content.last_agent);
  const std::string level = content.bone_level == anim::TaskContent::several_levels
                                ? "several bone levels"
                                : "bone level " + std::to_string(content.bone_level);
  if (content.agents == 1) return "agent " + first + ", " + level;
  return with_thousands(content.agents) + " agents from " + first + " to " + last + ", " + level;
}

void tell_of(const anim::TraceSpan& span, const TimelineFrame& frame) {
  const double begin = frame.time.ms(span.begin), end = frame.time.ms(span.end);
  show_lines({look_of(span).words,
              "frame " + std::to_string(frame.frame) + ", " + fixed(begin, 3) + " to " + fixed(end, 3) + " ms, " +
                  fixed(1000 * (end - begin), 1) + " \xC2\xB5s",
              span.content.agents == 0 ? "" : agents_of(span.content),
              span.transfers == 0 ? ""
                                  : size_text(span.bytes_in) + " in, " + size_text(span.bytes_out) + " out, " +
                                        with_thousands(span.transfers) + " transfers"});
}

/// Turns milliseconds of the axis into pixels of a lane.
struct Axis {
  float from_ms, to_ms, left, right;

  [[nodiscard]] float x_of(float ms) const { return left + (right - left) * (ms - from_ms) / (to_ms - from_ms); }
};

void draw_spans(const Theme& theme, const Area& lane, const TimelineFrame& frame, std::size_t pu, float start_ms,
                const Axis& axis) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const auto x_of = [&](std::uint64_t tick) { return axis.x_of(start_ms + static_cast<float>(frame.time.ms(tick))); };
  for (const anim::TraceSpan& span : frame.lanes[pu]) {
    const float left = x_of(span.begin), right = std::max(x_of(span.end), left + theme.px(0.75F));
    if (right < axis.left || left > axis.right) continue;
    const ImVec2 from(std::max(left, axis.left), lane.from.y), to(std::min(right, axis.right), lane.to.y);
    draw.AddRectFilled(from, to, ImGui::GetColorU32(look_of(span).colour));
    if (lane.hovered && ImGui::IsMouseHoveringRect(from, to)) tell_of(span, frame);
  }
}

/// Milliseconds until the last PU was done.
float length_of(const TimelineFrame& frame) {
  double length = 0;
  for (const std::vector<anim::TraceSpan>& lane : frame.lanes) {
    if (!lane.empty()) length = std::max(length, frame.time.ms(lane.back().end));
  }
  return static_cast<float>(length);
}

void draw_lanes(const Theme& theme, const Area& area, std::span<const TimelineFrame> frames, const Axis& axis) {
  const std::size_t lanes = frames.back().lanes.size();
  const float pitch = area.height() / static_cast<float>(lanes), gap = std::min(theme.px(3), pitch * 0.2F);
  for (std::size_t pu = 0; pu < lanes; ++pu) {
    const float y = area.from.y + pitch * static_cast<float>(pu);
    const Area lane{.from = {area.from.x, y}, .to = {area.to.x, y + pitch - gap}, .hovered = area.hovered};
    draw_well(theme, lane);
    float start = 0;
    for (const TimelineFrame& frame : frames) {
      if (pu < frame.lanes.size()) draw_spans(theme, lane, frame, pu, start, axis);
      start += length_of(frame);
    }
    if (pitch < font_height(theme.small)) continue;
    draw_text(theme.small, {area.from.x - theme.px(20), (lane.from.y + lane.to.y - font_height(theme.small)) / 2},
              colour::dim, std::to_string(pu));
  }
}

void draw_borders(const Area& area, std::span<const TimelineFrame> frames, const Axis& axis) {
  float start = 0;
  for (const TimelineFrame& frame : frames) {
    const float x = axis.x_of(start);
    start += length_of(frame);
    if (x <= axis.left || x >= axis.right) continue;
    ImGui::GetWindowDrawList()->AddLine({x, area.from.y}, {x, area.to.y}, ImGui::GetColorU32(colour::text));
  }
}

void zoom_and_move(const Area& axis, float& from, float& to) {
  const ImGuiIO& io = ImGui::GetIO();
  const float width = to - from;
  if (axis.hovered && io.MouseWheel != 0) {
    const float share = std::clamp((io.MousePos.x - axis.from.x) / axis.width(), 0.0F, 1.0F);
    const float wanted = std::clamp(width * std::pow(zoom_a_step, io.MouseWheel), closest, 1.0F);
    from = std::clamp(from + share * (width - wanted), 0.0F, 1.0F - wanted);
    to = from + wanted;
  }
  if (ImGui::IsItemActive() && io.MouseDelta.x != 0) {
    from = std::clamp(from - width * io.MouseDelta.x / axis.width(), 0.0F, 1.0F - width);
    to = from + width;
  }
  if (axis.hovered && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) from = 0, to = 1;
}

// Left and right go along; with Shift they zoom out and in; Enter shows all.
void zoom_and_move_by_keys(PanelFocus& focus, float& from, float& to) {
  constexpr float share_of_width = 0.1F;
  const float width = to - from;
  if (focus.take_activation()) from = 0, to = 1;
  const int step = focus.take_step();
  if (step == 0) return;
  const bool zooms = std::abs(step) > 1;
  const float wanted = zooms ? std::clamp(width * (step > 0 ? zoom_a_step : 1 / zoom_a_step), closest, 1.0F) : width;
  const float moved = zooms ? (width - wanted) / 2 : static_cast<float>(step) * share_of_width * width;
  from = std::clamp(from + moved, 0.0F, 1.0F - wanted);
  to = from + wanted;
}

std::span<const TimelineFrame> shown_frames(const FrameReport& report) {
  if (report.kept.looked_at) return {&report.kept.looked_at->timeline, 1};
  return report.timeline;
}

}  // namespace

void show_timeline(const TabContext& context) {
  const std::span<const TimelineFrame> frames = shown_frames(context.report);
  float length = 0;
  for (const TimelineFrame& frame : frames) length += length_of(frame);
  if (length <= 0) return;
  Widgets& widgets = context.widgets;
  const Theme& theme = widgets.theme();
  const float lanes = std::clamp(20.0F * static_cast<float>(frames.back().lanes.size()), 60.0F, 150.0F);
  const Area all = widgets.area("Timeline", lanes + 16);
  imgui::take_wheel();
  const Area area{.from = {all.from.x + theme.px(20), all.from.y},
                  .to = {all.to.x, all.to.y - theme.px(16)},
                  .hovered = all.hovered};
  float &from = context.memory.timeline_from, &to = context.memory.timeline_to;
  zoom_and_move(area, from, to);
  zoom_and_move_by_keys(widgets.stop("Timeline", all), from, to);
  const Axis axis{from * length, to * length, area.from.x, area.to.x};
  draw_lanes(theme, area, frames, axis);
  draw_borders(area, frames, axis);
  const auto write = [&](float ms, float x, float align) {
    draw_text(theme.small, {x, area.to.y + theme.px(2)}, colour::faint, fixed(ms, 3) + " ms", align);
  };
  write(axis.from_ms, area.from.x, 0);
  write(axis.to_ms, area.to.x, 1);
  draw_text(theme.small, {(area.from.x + area.to.x) / 2, area.to.y + theme.px(2)}, colour::faint,
            counted(frames.size(), "frame"), 0.5F);
}

}  // namespace throng::app
