#include "app/overlay/timeline_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <imgui_internal.h>

#include "app/overlay/numbers.h"
#include "app/overlay/plots.h"

namespace throng::app {
namespace {

constexpr float zoom_a_step = 0.8F, closest = 0.002F;  // of the axis

struct SpanLook {
  ImU32 colour;
  const char* words;
};

/// In the order of PuSpan::Kind.
constexpr std::array<SpanLook, 4> looks = {{{colour::fetch, "fetch: entities are copied into the local store"},
                                            {colour::compute, "compute"},
                                            {colour::write_back, "write back: changed bytes are copied out"},
                                            {colour::wait, "wait"}}};

const SpanLook& look_of(PuSpan::Kind kind) { return looks[static_cast<std::size_t>(kind)]; }

std::string agents_of(const anim::TaskContent& content) {
  const std::string first = with_thousands(content.first_agent), last = with_thousands(content.last_agent);
  const std::string level = content.bone_level == anim::TaskContent::several_levels
                                ? "several bone levels"
                                : "bone level " + std::to_string(content.bone_level);
  if (content.agents == 1) return "agent " + first + ", " + level;
  return with_thousands(content.agents) + " agents from " + first + " to " + last + ", " + level;
}

void show_content(const PuSpan& span, int frame) {
  const auto begin = static_cast<double>(span.begin_ms), end = static_cast<double>(span.end_ms);
  ImGui::BeginTooltip();
  ImGui::TextUnformatted(look_of(span.kind).words);
  ImGui::TextUnformatted(("frame " + std::to_string(frame) + ", " + fixed(begin, 3) + " to " + fixed(end, 3) + " ms, " +
                          fixed(1000 * (end - begin), 1) + " \xC2\xB5s")
                             .c_str());
  if (span.content.agents > 0) ImGui::TextUnformatted(agents_of(span.content).c_str());
  if (span.transfers > 0) {
    ImGui::TextUnformatted((as_bytes(span.bytes_in) + " in, " + as_bytes(span.bytes_out) + " out, " +
                            with_thousands(span.transfers) + " transfers")
                               .c_str());
  }
  ImGui::EndTooltip();
}

/// Milliseconds of the axis to pixels of a lane.
struct Axis {
  float from_ms, to_ms, left, right;

  [[nodiscard]] float x_of(float ms) const { return left + (right - left) * (ms - from_ms) / (to_ms - from_ms); }
};

void draw_spans(const Theme& theme, const Area& lane, std::span<const PuSpan> spans, float start_ms, int frame,
                const Axis& axis) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  for (const PuSpan& span : spans) {
    const float left = axis.x_of(start_ms + span.begin_ms);
    const float right = std::max(axis.x_of(start_ms + span.end_ms), left + theme.px(0.75F));
    if (right < axis.left || left > axis.right) continue;
    const ImVec2 from(std::max(left, axis.left), lane.from.y), to(std::min(right, axis.right), lane.to.y);
    draw.AddRectFilled(from, to, ImGui::GetColorU32(look_of(span.kind).colour));
    if (lane.hovered && ImGui::IsMouseHoveringRect(from, to)) show_content(span, frame);
  }
}

float length_of(const std::deque<TimelineFrame>& frames) {
  float all = 0;
  for (const TimelineFrame& frame : frames) all += frame.length_ms;
  return all;
}

void draw_lanes(const Theme& theme, const Area& area, const std::deque<TimelineFrame>& frames, const Axis& axis) {
  const std::size_t lanes = frames.back().lanes.size();
  const float pitch = area.height() / static_cast<float>(lanes), gap = std::min(theme.px(3), pitch * 0.2F);
  for (std::size_t pu = 0; pu < lanes; ++pu) {
    const float y = area.from.y + pitch * static_cast<float>(pu);
    const Area lane{.from = {area.from.x, y}, .to = {area.to.x, y + pitch - gap}, .hovered = area.hovered};
    draw_well(theme, lane);
    float start = 0;
    for (const TimelineFrame& frame : frames) {
      if (pu < frame.lanes.size()) draw_spans(theme, lane, frame.lanes[pu], start, frame.frame, axis);
      start += frame.length_ms;
    }
    if (pitch < theme.small->FontSize) continue;
    draw_text(theme.small, {area.from.x - theme.px(20), (lane.from.y + lane.to.y - theme.small->FontSize) / 2},
              colour::dim, std::to_string(pu));
  }
}

void draw_borders(const Area& area, const std::deque<TimelineFrame>& frames, const Axis& axis) {
  float start = 0;
  for (const TimelineFrame& frame : frames) {
    const float x = axis.x_of(start);
    start += frame.length_ms;
    if (x <= axis.left || x >= axis.right) continue;
    ImGui::GetWindowDrawList()->AddLine({x, area.from.y}, {x, area.to.y}, ImGui::GetColorU32(colour::text));
  }
}

}  // namespace

void TimelineView::zoom_and_move(const Area& axis) {
  const ImGuiIO& io = ImGui::GetIO();
  const float width = to_ - from_;
  if (axis.hovered && io.MouseWheel != 0) {
    const float share = std::clamp((io.MousePos.x - axis.from.x) / axis.width(), 0.0F, 1.0F);
    const float wanted = std::clamp(width * std::pow(zoom_a_step, io.MouseWheel), closest, 1.0F);
    from_ = std::clamp(from_ + share * (width - wanted), 0.0F, 1.0F - wanted);
    to_ = from_ + wanted;
  }
  if (ImGui::IsItemActive() && io.MouseDelta.x != 0) {
    from_ = std::clamp(from_ - width * io.MouseDelta.x / axis.width(), 0.0F, 1.0F - width);
    to_ = from_ + width;
  }
  if (axis.hovered && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) from_ = 0, to_ = 1;
}

void TimelineView::show(Widgets& widgets, const std::deque<TimelineFrame>& frames) {
  const float length = length_of(frames);
  if (length <= 0) return;
  const Theme& theme = widgets.theme();
  const float lanes = std::clamp(20.0F * static_cast<float>(frames.back().lanes.size()), 60.0F, 150.0F);
  const Area all = widgets.area("Timeline", lanes + 16);
  ImGui::SetItemUsingMouseWheel();
  const Area area{.from = {all.from.x + theme.px(20), all.from.y},
                  .to = {all.to.x, all.to.y - theme.px(16)},
                  .hovered = all.hovered};
  zoom_and_move(area);
  const Axis axis{from_ * length, to_ * length, area.from.x, area.to.x};
  draw_lanes(theme, area, frames, axis);
  draw_borders(area, frames, axis);
  const auto write = [&](float ms, float x, float align) {
    draw_text(theme.small, {x, area.to.y + theme.px(2)}, colour::faint, fixed(static_cast<double>(ms), 3) + " ms",
              align);
  };
  write(axis.from_ms, area.from.x, 0);
  write(axis.to_ms, area.to.x, 1);
  draw_text(theme.small, {(area.from.x + area.to.x) / 2, area.to.y + theme.px(2)}, colour::faint,
            std::to_string(frames.size()) + (frames.size() == 1 ? " frame" : " frames"), 0.5F);
}

}  // namespace throng::app
