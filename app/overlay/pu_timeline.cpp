#include <algorithm>
#include <array>

#include "app/overlay/numbers.h"
#include "app/overlay/plots.h"

namespace throng::app {
namespace {

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

void show_span(const PuSpan& span) {
  ImGui::BeginTooltip();
  ImGui::TextUnformatted(look_of(span.kind).words);
  const auto begin = static_cast<double>(span.begin_ms), end = static_cast<double>(span.end_ms);
  ImGui::TextUnformatted(
      (fixed(begin, 3) + " to " + fixed(end, 3) + " ms, " + fixed(1000 * (end - begin), 1) + " \xC2\xB5s").c_str());
  ImGui::EndTooltip();
}

void draw_spans(const Theme& theme, const Area& lane, const PuReport& pu, float longest_ms) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  for (const PuSpan& span : pu.spans) {
    const ImVec2 from(lane.from.x + lane.width() * span.begin_ms / longest_ms, lane.from.y);
    const float end_x = lane.from.x + lane.width() * span.end_ms / longest_ms;
    const ImVec2 to(std::max(end_x, from.x + theme.px(1)), lane.to.y);
    draw.AddRectFilled(from, to, ImGui::GetColorU32(look_of(span.kind).colour));
    if (lane.hovered && ImGui::IsMouseHoveringRect(from, to)) show_span(span);
  }
}

}  // namespace

void draw_timeline(const Theme& theme, const Area& area, std::span<const PuReport> pus, float longest_ms) {
  if (pus.empty()) return;
  const float label_width = theme.px(20), axis_height = theme.small->FontSize + theme.px(3);
  const float pitch = (area.height() - axis_height) / static_cast<float>(pus.size());
  const float gap = std::min(theme.px(3), pitch * 0.2F);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  for (std::size_t i = 0; i < pus.size(); ++i) {
    const float y = area.from.y + pitch * static_cast<float>(i);
    const Area lane{
        .from = {area.from.x + label_width, y}, .to = {area.to.x, y + pitch - gap}, .hovered = area.hovered};
    draw.AddRectFilled(lane.from, lane.to, ImGui::GetColorU32(colour::well));
    if (pitch >= theme.small->FontSize) {
      const float text_y = (lane.from.y + lane.to.y - theme.small->FontSize) / 2;
      draw_text(theme.small, {area.from.x, text_y}, colour::dim, std::to_string(i));
    }
    draw_spans(theme, lane, pus[i], longest_ms);
  }
  const float text_y = area.to.y - axis_height + theme.px(2);
  draw_text(theme.small, {area.from.x + label_width, text_y}, colour::faint, "0");
  draw_text(theme.small, {area.to.x, text_y}, colour::faint, fixed(static_cast<double>(longest_ms), 2) + " ms", 1);
}

}  // namespace throng::app
