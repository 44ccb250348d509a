#include "app/window/panel/notices.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <optional>
#include <sstream>
#include <utility>
#include <vector>

#include "app/window/panel/badges.h"
#include "app/window/panel/cards.h"
#include "app/window/panel/tabs.h"
#include "engine/base/text/joined.h"

namespace throng::app {
namespace {

constexpr float pills_edge = 12, pills_gap = 6, pill_pad_x = 14, pill_pad_y = 5, pill_dot = 4, dot_room = 14,
                cross_room = 18;
constexpr std::size_t most_messages_seen = 4;
constexpr std::size_t most_warnings_at_once = 3;  // that have a line each

/// A rounded line of words with a dot before it and, if it can be closed, a cross behind it; or a sign that a click
/// unfolds it.
struct Pill {
  std::string name;
  ImU32 dot = 0;
  std::string words;
  std::string help = {};
  float presence = 1;
  std::function<void()> close = {};    ///< called by a click; empty: it cannot be closed
  std::optional<bool> is_folded = {};  ///< where it has a list below
  Area place = {};
};

float pill_words_width(const Theme& theme, const Area& crowd, const Pill& pill) {
  const float taken = 2 * pills_edge + 2 * pill_pad_x + dot_room + (pill.close ? cross_room : 0);
  return std::max(crowd.width() - theme.px(taken), theme.px(40));
}

ImVec2 pill_size(const Theme& theme, const Area& crowd, const Pill& pill) {
  const ImVec2 words = wrapped_size(theme.regular, pill_words_width(theme, crowd, pill), pill.words);
  return {words.x + theme.px(2 * pill_pad_x + dot_room + (pill.close ? cross_room : 0)),
          words.y + theme.px(2 * pill_pad_y + 2)};
}

void draw_pill(const Theme& theme, const Area& crowd, const Pill& pill, bool hovered) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const ImVec2 from = pill.place.from;
  const float middle = from.y + theme.px(pill_pad_y + 1) + font_height(theme.regular) / 2;
  const auto seen = [&](ImU32 ink) { return colour::with_alpha(ink, pill.presence); };
  draw.AddRectFilled(from, pill.place.to, seen(colour::panel), theme.px(13));
  draw.AddCircleFilled({from.x + theme.px(pill_pad_x), middle}, theme.px(pill_dot), seen(pill.dot));
  draw_wrapped(theme.regular, {from.x + theme.px(pill_pad_x + dot_room - 3), from.y + theme.px(pill_pad_y)},
               seen(colour::text), pill_words_width(theme, crowd, pill), pill.words);
  if (!pill.close) return;
  const ImVec2 cross(pill.place.to.x - theme.px(pill_pad_x), middle);
  const float arm = theme.px(3.5F);
  const ImU32 ink = seen(hovered ? colour::text : colour::dim);
  if (pill.is_folded) return draw_fold_sign(theme, cross, *pill.is_folded, ink);
  draw.AddLine({cross.x - arm, cross.y - arm}, {cross.x + arm, cross.y + arm}, ink, theme.px(1.5F));
  draw.AddLine({cross.x - arm, cross.y + arm}, {cross.x + arm, cross.y - arm}, ink, theme.px(1.5F));
}

void show_pill(Widgets& widgets, const Area& crowd, const Pill& pill) {
  const bool clicked = pill.close ? widgets.clickable(pill.name, pill.place) : widgets.hoverable(pill.name, pill.place);
  const bool hovered = ImGui::IsItemHovered();
  draw_pill(widgets.theme(), crowd, pill, hovered);
  if (hovered && !pill.help.empty()) show_lines({pill.help});
  if (clicked && pill.close) pill.close();
}

std::vector<Pill> badge_pills(const TabContext& context) {
  std::vector<Pill> pills;
  for (Badge& badge : badges_of(context)) {
    Pill pill{.name = std::string("badge:") + badge.name,
              .dot = badge.dot,
              .words = std::move(badge.words),
              .help = badge.help};
    if (badge.end != nullptr) pill.close = [&context, end = badge.end] { end(context); };
    pills.push_back(std::move(pill));
  }
  return pills;
}

std::vector<std::string> open_warnings(const TabContext& context) {
  std::vector<std::string> open;
  const auto add = [&](const std::string& words) {
    if (!context.memory.notices.warnings.contains(words)) open.push_back(words);
  };
  std::istringstream lines(context.report.notice);
  for (std::string line; std::getline(lines, line);) add(line);
  if (context.widgets.theme().fonts_missing) add("The overlay's fonts cannot be read in the data folder.");
  return open;
}

/// Returns the warnings that share a line, and leaves the others in `open`.
std::vector<std::string> take_shared(std::vector<std::string>& open, NoticeMemory& memory) {
  std::set<std::string> fresh;
  for (const std::string& words : open) {
    if (!memory.alone.contains(words) && !memory.together.contains(words)) fresh.insert(words);
  }
  (fresh.size() > most_warnings_at_once ? memory.together : memory.alone).merge(fresh);
  std::vector<std::string> shared;
  const auto takes = [&](const std::string& words) { return memory.together.contains(words); };
  std::ranges::copy_if(open, std::back_inserter(shared), takes);
  std::erase_if(open, takes);
  return shared;
}

std::vector<Pill> warning_pills(const std::vector<std::string>& alone, const std::vector<std::string>& shared,
                                NoticeMemory& memory) {
  std::vector<Pill> pills;
  for (const std::string& words : alone) {
    pills.push_back({.name = "warning:" + std::to_string(pills.size()),
                     .dot = colour::changed,
                     .words = words,
                     .close = [&memory, words] { memory.warnings.insert(words); }});
  }
  if (shared.empty()) return pills;
  pills.push_back({.name = "remarks",
                   .dot = colour::changed,
                   .words = counted(shared.size(), "remark") + " about what was opened",
                   .help = memory.lists_together ? "A click folds the list." : "A click lists them.",
                   .close = [&memory] { memory.lists_together = !memory.lists_together; },
                   .is_folded = !memory.lists_together});
  return pills;
}

void show_shared(const TabContext& context, const Area& below, const std::vector<std::string>& shared) {
  NoticeMemory& memory = context.memory.notices;
  if (shared.empty()) memory.lists_together = false;
  if (!memory.lists_together) return;
  const CardAnswer answer = show_remarks_card(context.widgets, below, shared);
  if (answer != CardAnswer::none) memory.lists_together = false;
  if (answer == CardAnswer::close_all) memory.warnings.insert(shared.begin(), shared.end());
}

// The newest come first, since there may be no room for all.
std::vector<Pill> message_pills(const TabContext& context) {
  std::vector<Pill> pills;
  std::set<std::uint64_t>& closed = context.memory.notices.messages;
  const auto& all = context.report.messages.all();
  for (auto message = all.rbegin(); message != all.rend() && pills.size() < most_messages_seen; ++message) {
    const float presence = context.report.messages.presence(*message);
    if (presence <= 0 || closed.contains(message->number)) continue;
    pills.push_back({.name = "message:" + std::to_string(pills.size()),
                     .dot = message->kind == Message::Kind::refused ? colour::recording : colour::accent,
                     .words = message->words,
                     .presence = presence,
                     .close = [&closed, number = message->number] { closed.insert(number); }});
  }
  return pills;
}

/// Puts pills side by side from `at` on; a new line begins where there is no room left. Returns the y below them.
float place_in_lines(const Theme& theme, const Area& crowd, ImVec2 at, std::vector<Pill>& pills) {
  const float left = at.x;
  float below = at.y;
  for (Pill& pill : pills) {
    const ImVec2 size = pill_size(theme, crowd, pill);
    if (at.x > left && at.x + size.x > crowd.to.x - theme.px(pills_edge)) at = {left, below};
    pill.place = {.from = at, .to = {at.x + size.x, at.y + size.y}};
    at.x += size.x + theme.px(pills_gap);
    below = std::max(below, pill.place.to.y + theme.px(pills_gap));
  }
  return below;
}

float place_below_each_other(const Theme& theme, const Area& crowd, ImVec2 at, std::vector<Pill>& pills) {
  for (Pill& pill : pills) {
    const ImVec2 size = pill_size(theme, crowd, pill);
    pill.place = {.from = at, .to = {at.x + size.x, at.y + size.y}};
    at.y = pill.place.to.y + theme.px(pills_gap);
  }
  return at.y;
}

// Each pill is a window of its own, so that the pointer reaches the crowd beside them.
void show_pills(Widgets& widgets, const Area& crowd, const char* window, const std::vector<Pill>& pills) {
  for (std::size_t i = 0; i < pills.size(); ++i) {
    begin_fixed_window((window + std::to_string(i)).c_str(), pills[i].place, 0, ImGuiWindowFlags_NoBackground);
    show_pill(widgets, crowd, pills[i]);
    widgets.cover(pills[i].place);
    ImGui::End();
  }
}

}  // namespace

float show_notices(const TabContext& context, const Area& crowd) {
  const Theme& theme = context.widgets.theme();
  NoticeMemory& memory = context.memory.notices;
  std::vector<std::string> alone = open_warnings(context);
  const std::vector<std::string> shared = take_shared(alone, memory);
  std::vector<Pill> badges = badge_pills(context), warnings = warning_pills(alone, shared, memory),
                    messages = message_pills(context);
  const float left = crowd.from.x + theme.px(pills_edge);
  const float top = crowd.from.y + theme.px(pills_edge);
  const float below_badges = place_in_lines(theme, crowd, {left, top}, badges);
  const float below_warnings = place_below_each_other(theme, crowd, {left, below_badges}, warnings);
  const float below = place_below_each_other(theme, crowd, {left, below_warnings}, messages);
  show_pills(context.widgets, crowd, "Badge", badges);
  show_pills(context.widgets, crowd, "Warning", warnings);
  show_pills(context.widgets, crowd, "Message", messages);
  show_shared(context, {.from = {crowd.from.x, below}, .to = crowd.to}, shared);
  return below > top ? below : crowd.from.y;
}

}  // namespace throng::app
