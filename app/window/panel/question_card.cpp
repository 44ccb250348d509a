#include <array>
#include <optional>
#include <string>

#include "app/window/panel/cards.h"
#include "app/window/panel/dialog.h"
#include "engine/base/text/joined.h"
#include "engine/base/text/plain_text.h"

namespace throng::app {
namespace {

struct AnswerButton {
  UnsavedAnswer answer;
  const char* words;
  const char* name;
  Key key;
  const char* what;
};

constexpr std::array answer_buttons = std::to_array<AnswerButton>({
    {UnsavedAnswer::save, "Save (S)", "unsaved:save", Key::s, "Keeps all of it in a crowd file, then goes on."},
    {UnsavedAnswer::leave, "Leave unsaved (L)", "unsaved:leave", Key::l, "Goes on, and it is lost."},
    {UnsavedAnswer::stay, "Cancel (Esc)", "unsaved:stay", Key::escape, "Everything stays as it is."},
});

std::string question_about(const UnsavedReport& unsaved) {
  const std::string parts = joined(unsaved.parts, ", ", " and ");
  const std::string next =
      unsaved.next.empty() ? "Then the window closes." : "Then " + plain_text(unsaved.next) + " is opened.";
  return "Not saved yet: " + parts + ".\n" + next;
}

}  // namespace

std::optional<UnsavedAnswer> show_question_card(Widgets& widgets, const InputFrame& input,
                                                const UnsavedReport& unsaved) {
  const Theme& theme = widgets.theme();
  const Dialog dialog(widgets, "Save your work?", {480, 170});
  const Area all = dialog.content();
  draw_wrapped(theme.regular, all.from, colour::text, all.width(), question_about(unsaved));
  ImGui::SetCursorScreenPos(dialog.foot().from);
  const float gap = theme.px(8);
  const float width = (all.width() - 2 * gap) / static_cast<float>(answer_buttons.size());
  std::optional<UnsavedAnswer> answer;
  for (const AnswerButton& button : answer_buttons) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    if (widgets.named_button(button.words, button.name, {.what = button.what}, width)) answer = button.answer;
    if (input.was_pressed(button.key)) answer = button.answer;
    ImGui::SetCursorScreenPos({at.x + width + gap, at.y});
  }
  if (input.was_pressed(Key::enter)) answer = UnsavedAnswer::save;
  return answer;
}

}  // namespace throng::app
