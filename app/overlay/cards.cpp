#include "app/overlay/cards.h"

#include <array>
#include <vector>

#include "app/overlay/numbers.h"

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
    {"Esc", "deselect; quit"},
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
  const float width = theme.regular->CalcTextSizeA(theme.regular->FontSize, FLT_MAX, 0, words.c_str()).x;
  const float height = theme.px(27);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled(at, {at.x + width + theme.px(38), at.y + height}, colour::panel, height / 2);
  draw.AddCircleFilled({at.x + theme.px(15), at.y + height / 2}, theme.px(4), dot);
  draw_text(theme.regular, {at.x + theme.px(26), at.y + theme.px(5)}, colour::text, words);
  return at.y + height + theme.px(6);
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
  ImGui::SetNextWindowPos(crowd.from);
  ImGui::SetNextWindowSize({crowd.width(), crowd.height()});
  ImGui::Begin("Notices", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoBackground |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus);
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

}  // namespace throng::app
