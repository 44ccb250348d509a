#include "app/overlay/cards.h"

#include <array>
#include <optional>

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include "app/view/fly_camera.h"

namespace throng::app {
namespace {

struct HelpLine {
  const char* word;
  const char* meaning;
};

constexpr std::array key_lines = std::to_array<HelpLine>({
    {"W A S D", "fly; Q and E down and up"},
    {"Right drag", "look around"},
    {"Wheel", "flying speed; Shift faster, Ctrl slower"},
    {"Click", "select a character; P pushes it over"},
    {"F", "frame the crowd"},
    {"X", "while held: the exact crowd, nothing skipped"},
    {"B", "compare: the other of two tunings"},
    {"Space", "pause"},
    {"C", "copy the camera as an option"},
    {"Tab", "hide the overlay"},
    {"R", "begin a recording; again, end it"},
    {"F5", "build the shaders again"},
    {"F12", "screenshot"},
    {"F1", "this card"},
    {"Esc", "close the topmost; quit"},
});

constexpr std::array word_lines = std::to_array<HelpLine>({
    {"Agent", "one character of the crowd"},
    {"PU", "processing unit: a thread with a local store"},
    {"Local store", "a PU's own memory; entities are copied in and out"},
    {"Tile", "the agents that a PU is handed at a time"},
    {"Interval", "frames between two updates of an agent"},
    {"Level", "how many bones of the ordered list are evaluated"},
});

constexpr float line_height = 21, word_width = 92, card_width = 430, margin = 18;

float draw_lines(const Theme& theme, ImVec2 at, const char* title, std::span<const HelpLine> lines) {
  draw_text(theme.strong, at, colour::text, title);
  at.y += theme.px(line_height + 3);
  for (const HelpLine& line : lines) {
    draw_text(theme.regular, at, colour::accent, line.word);
    draw_text(theme.regular, {at.x + theme.px(word_width), at.y}, colour::text, line.meaning);
    at.y += theme.px(line_height);
  }
  return at.y + theme.px(10);
}

float draw_pill(const Theme& theme, ImVec2 at, ImU32 dot, const std::string& words) {
  const float width = text_width(theme.regular, words), height = theme.px(27);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled(at, {at.x + width + theme.px(38), at.y + height}, colour::panel, height / 2);
  draw.AddCircleFilled({at.x + theme.px(15), at.y + height / 2}, theme.px(4), dot);
  draw_text(theme.regular, {at.x + theme.px(26), at.y + theme.px(5)}, colour::text, words);
  return at.y + height + theme.px(6);
}

std::optional<ImVec2> on_screen(const glm::mat4& view_projection, const HeadFigures& head, ImVec2 size) {
  const glm::vec4 clip = view_projection * glm::vec4(head.x, head.y, head.z, 1.0F);
  if (clip.w <= render::Camera::near_distance) return std::nullopt;
  return ImVec2((clip.x / clip.w * 0.5F + 0.5F) * size.x, (0.5F - clip.y / clip.w * 0.5F) * size.y);
}

std::string words_above(const HeadFigures& head) {
  const std::string interval = std::to_string(head.interval);
  return head.bone_level == 0 ? interval : interval + " L" + std::to_string(head.bone_level);
}

void draw_label(const Theme& theme, ImVec2 at, const HeadFigures& head) {
  const std::string words = words_above(head);
  const float width = text_width(theme.small, words), left = at.x - width / 2, top = at.y - theme.small->FontSize;
  const ImVec2 from(left - theme.px(4), top - theme.px(1)), to(left + width + theme.px(4), at.y + theme.px(1));
  ImGui::GetWindowDrawList()->AddRectFilled(from, to, colour::panel, theme.px(3));
  draw_text(theme.small, {left, top}, colour::interval(head.interval), words);
}

/// Begins a window that lets the pointer through, for words over the crowd.
void begin_clear_window(const char* name, const Area& place) {
  ImGui::SetNextWindowPos(place.from);
  ImGui::SetNextWindowSize({place.width(), place.height()});
  ImGui::Begin(name, nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoBackground |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus);
}

}  // namespace

void begin_fixed_window(const char* name, const Area& place, float rounding) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, rounding);
  ImGui::SetNextWindowPos(place.from);
  ImGui::SetNextWindowSize({place.width(), place.height()});
  ImGui::Begin(name, nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoBringToFrontOnFocus |
                   ImGuiWindowFlags_NoScrollWithMouse);
  ImGui::PopStyleVar();
}

float show_notices(const Widgets& widgets, const Area& crowd, std::span<const Notice> notices) {
  if (notices.empty()) return crowd.from.y;
  const Theme& theme = widgets.theme();
  begin_clear_window("Notices", crowd);
  ImVec2 at(crowd.from.x + theme.px(12), crowd.from.y + theme.px(12));
  for (const Notice& notice : notices) at.y = draw_pill(theme, at, notice.colour, notice.words);
  ImGui::End();
  return at.y;
}

void show_help_card(Widgets& widgets, const Area& crowd) {
  const Theme& theme = widgets.theme();
  const auto lines = static_cast<float>(key_lines.size() + word_lines.size());
  const float width = theme.px(card_width), height = theme.px(line_height * (lines + 2) + 6 + 10 + 2 * margin);
  const ImVec2 from(crowd.from.x + (crowd.width() - width) / 2, crowd.from.y + (crowd.height() - height) / 2);
  const Area place{.from = from, .to = {from.x + width, from.y + height}};
  begin_fixed_window("Help", place, theme.px(10));
  widgets.record("Help", place);
  const float x = from.x + theme.px(margin + 6);
  const float y = draw_lines(theme, {x, from.y + theme.px(margin)}, "Keys", key_lines);
  draw_lines(theme, {x, y}, "Words", word_lines);
  ImGui::End();
}

void show_head_labels(Widgets& widgets, const Area& crowd, const FrameReport& report) {
  if (report.heads.empty()) return;
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  const render::CameraView view = render::view_of(camera_at(report.camera), size.x / size.y);
  const glm::mat4 view_projection = view.projection * view.view;
  begin_clear_window("Heads", crowd);
  widgets.record("Heads", crowd);
  for (const HeadFigures& head : report.heads) {
    if (const auto at = on_screen(view_projection, head, size)) draw_label(widgets.theme(), *at, head);
  }
  ImGui::End();
}

}  // namespace throng::app
