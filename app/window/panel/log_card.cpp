#include <algorithm>
#include <string>

#include "app/window/panel/cards.h"
#include "app/window/panel/controls/card.h"
#include "app/window/panel/controls/numbers.h"

namespace throng::app {
namespace {

constexpr float log_width = 560, log_age_width = 64, log_margin = 16, log_line_gap = 5;
constexpr float most_of_remarks = 0.4F;  // of the crowd's area: a person who opens the list reads it

std::string ago(double seconds) { return seconds < 60 ? fixed(seconds, 0) + " s" : fixed(seconds / 60, 0) + " min"; }

float log_words_width(const Theme& theme) { return theme.px(log_width - 2 * log_margin - log_age_width); }

float height_of_message(const Theme& theme, const Message& message) {
  return wrapped_size(theme.regular, log_words_width(theme), message.words).y + theme.px(log_line_gap);
}

}  // namespace

bool show_log_card(Widgets& widgets, const Area& crowd, const Messages& messages) {
  const Theme& theme = widgets.theme();
  float height = theme.px(2 * log_margin);
  for (const Message& message : messages.all()) height += height_of_message(theme, message);
  const ImVec2 size(theme.px(log_width), std::max(height, theme.px(60)));
  const Card card(widgets, "Messages", crowd,
                  {.at = {crowd.from.x + theme.px(12), crowd.to.y - theme.px(12)}, .size = size});
  if (!card.is_unfolded()) return card.was_closed();
  ImVec2 at(card.content().from.x + theme.px(log_margin), card.content().from.y + theme.px(log_margin / 2));
  if (messages.all().empty()) draw_text(theme.regular, at, colour::dim, "Nothing was said yet.");
  for (auto message = messages.all().rbegin(); message != messages.all().rend(); ++message) {
    draw_text(theme.regular, at, colour::faint, ago(messages.age(*message)));
    const ImU32 ink = message->kind == Message::Kind::refused ? colour::changed : colour::text;
    draw_wrapped(theme.regular, {at.x + theme.px(log_age_width), at.y}, ink, log_words_width(theme), message->words);
    at.y += height_of_message(theme, *message);
  }
  return card.was_closed();
}

CardAnswer show_remarks_card(Widgets& widgets, const Area& place, std::span<const std::string> remarks) {
  const Theme& theme = widgets.theme();
  const float margin = theme.px(log_margin), button = theme.px(26), gap = theme.px(log_line_gap);
  const float width = std::min(theme.px(log_width), place.width() - theme.px(24)), room = width - 2 * margin;
  float height = 2 * margin + button;
  for (const std::string& remark : remarks) height += gap + wrapped_size(theme.regular, room, remark).y;
  const Card card(
      widgets, "Remarks", place,
      {.at = {place.from.x + theme.px(12), place.from.y}, .size = {width, height}, .most = most_of_remarks});
  if (!card.is_unfolded()) return card.was_closed() ? CardAnswer::fold : CardAnswer::none;
  ImVec2 at(card.content().from.x + margin, card.content().from.y + margin / 2);
  ImGui::SetCursorScreenPos(at);
  const bool closes_all =
      widgets.named_button("Close all", "remarks:close", {.what = "They do not come back."}, theme.px(90));
  at.y += button;
  for (const std::string& remark : remarks) {
    at.y += gap;
    draw_wrapped(theme.regular, at, colour::text, room, remark);
    at.y += wrapped_size(theme.regular, room, remark).y;
  }
  if (closes_all) return CardAnswer::close_all;
  return card.was_closed() ? CardAnswer::fold : CardAnswer::none;
}

}  // namespace throng::app
