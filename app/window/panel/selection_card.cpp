#include <algorithm>
#include <array>
#include <cmath>

#include "app/people/crowd/habits.h"
#include "app/settings/choices.h"
#include "app/show/camera/fly_camera.h"
#include "app/window/panel/cards.h"
#include "app/window/panel/controls/card.h"
#include "app/window/panel/tracked_person_view.h"

namespace throng::app {
namespace {

constexpr float widest_card = 540, card_margin = 14, card_gap = 12;
constexpr float text_height = 19, entity_height = 18, foot_height = 32;

struct Column {
  const char* title;
  float from, to;  // in shares of the table's width
  float align;     // 0: from the left; 1: to the right
};

constexpr std::array columns = std::to_array<Column>({{"entity", 0.00F, 0.18F, 0},
                                                      {"clip", 0.18F, 0.38F, 0},
                                                      {"at, of s", 0.38F, 0.52F, 1},
                                                      {"in pose", 0.52F, 0.61F, 1},
                                                      {"bytes", 0.61F, 0.69F, 1},
                                                      {"handle", 0.69F, 0.78F, 1},
                                                      {"priority", 0.78F, 0.88F, 1},
                                                      {"memory", 0.88F, 1.00F, 1}});
using Cells = std::array<std::string, columns.size()>;

Cells cells_of(const EntityRow& row) {
  return {row.kind,
          row.clip,
          place_in_clip(row),
          as_percent(row.weight),
          with_thousands(row.block.size()),
          std::to_string(row.handle.pool()) + ":" + std::to_string(row.handle.generation()) + ":" +
              std::to_string(row.handle.index()),
          row.priority == 0 ? "highest" : std::to_string(row.priority),
          row.shared ? "shared" : (row.resident ? "resident" : "transient")};
}

void draw_row(const Theme& theme, const Area& row, ImU32 ink, const Cells& cells) {
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Column& column = columns.at(i);
    const ImVec2 from(row.from.x + column.from * row.width(), row.from.y);
    const ImVec2 to(row.from.x + column.to * row.width(), row.to.y);
    ImGui::PushClipRect(from, to, true);
    draw_text(theme.small, {column.align > 0 ? to.x : from.x, row.from.y}, ink, cells[i], column.align);
    ImGui::PopClipRect();
  }
}

std::string doing(const SelectionReport& selected) {
  const char* const role = selected.role == Role::other ? "plays a clip" : role_names.at(index_of(selected.role));
  const std::string habit = habit_words.at(static_cast<std::size_t>(selected.habit));
  const std::string posture = posture_words.at(static_cast<std::size_t>(selected.posture));
  return habit + ": " + (selected.posture == Posture::upright ? role : posture);
}

std::string whereabouts(const SelectionReport& selected) {
  return "at " + fixed(selected.x, 1) + ", " + fixed(selected.y, 1) + ", " + fixed(selected.z, 1) + " m   " +
         fixed(selected.speed, 2) + " m/s";
}

std::string turn_of(const SelectionReport& selected) {
  return "posed every " + (selected.interval == 1 ? "frame" : std::to_string(selected.interval) + " frames");
}

std::string detail(const SelectionReport& selected) {
  if (!selected.visible) return "out of view, not posed";
  return turn_of(selected) + "   level " + std::to_string(selected.bone_level) + ", " + std::to_string(selected.bones) +
         " bones   mesh " + std::to_string(selected.mesh_lod);
}

std::string blocks(const SelectionReport& selected) {
  return counted(selected.entities.size(), "block") + ", " + with_thousands(selected.bytes) + " bytes   " +
         counted(static_cast<std::size_t>(selected.channels), "channel");
}

std::string pose_words(const SelectionReport& selected) { return selected.visible ? turn_of(selected) : "not posed"; }

float draw_words(const Theme& theme, const Area& card, const SelectionReport& selected) {
  ImVec2 at(card.from.x + theme.px(card_margin), card.from.y + theme.px(4));
  draw_text(theme.small, at, colour::dim, whereabouts(selected));
  at.y += theme.px(text_height);
  draw_text(theme.small, at, colour::dim, detail(selected));
  return at.y + theme.px(text_height + 2);
}

float draw_graph(Widgets& widgets, const Area& card, float y, std::size_t rows, const SelectionReport& selected) {
  const Theme& theme = widgets.theme();
  Area row{.from = {card.from.x + theme.px(card_margin), y},
           .to = {card.to.x - theme.px(card_margin), y + theme.px(entity_height)}};
  const auto next = [&] { row.from.y += theme.px(entity_height), row.to.y += theme.px(entity_height); };
  Cells titles;
  std::ranges::transform(columns, titles.begin(), &Column::title);
  draw_row(theme, row, colour::faint, titles);
  next();
  for (std::size_t i = selected.entities.size() - rows; i < selected.entities.size(); ++i, next()) {
    const EntityRow& entity = selected.entities[i];
    draw_row(theme, row, entity.weight > 0 ? colour::text : colour::dim, cells_of(entity));
    widgets.record("Entity " + std::to_string(i), row);
  }
  return row.from.y + theme.px(5);
}

void show_foot(Widgets& widgets, const Area& card, float y, const FrameReport& report, Requests& requests) {
  const SelectionReport& selected = *report.selected;
  const Theme& theme = widgets.theme();
  const float width = theme.px(92), gap = theme.px(8), right = card.to.x - theme.px(card_margin);
  const std::string words = selected.tracked != nullptr ? pose_words(selected) : blocks(selected);
  draw_text(theme.small, {card.from.x + theme.px(card_margin), y + theme.px(5)}, colour::dim, words);
  const float view_width = theme.px(60);
  ImGui::SetCursorScreenPos({right - view_width - 2 * (width + gap), y});
  show_view_button(widgets, "View", view_width, requests);
  ImGui::SameLine(0, gap);
  widgets.begin_idle(selected.can_fall ? std::nullopt : std::optional<std::string>(cannot_fall));
  if (widgets.button("Push over",
                     {.what = "Makes a rag-doll of it, which falls away from the camera, lies and gets up. Key P."},
                     width))
    requests.ask(Push{selected.agent, ahead_of(report.camera)});
  widgets.end_idle();
  ImGui::SameLine(0, gap);
  if (widgets.button("Deselect", {.what = "As a click beside it, or Esc."}, width)) requests.ask(Select{});
}

// The graph of the speed takes the room that the words, the steps and the buttons leave.
void show_tracked_card(Widgets& widgets, const Area& place, const FrameReport& report, Requests& requests) {
  const Theme& theme = widgets.theme();
  const float width = std::min(theme.px(widest_card), place.width() - 2 * theme.px(card_gap));
  const float wanted = theme.px(tracked_person_height + foot_height);
  const Card card(widgets, "Selected", place,
                  {.at = {place.from.x + theme.px(card_gap), place.from.y + theme.px(card_gap)},
                   .size = {width, std::min(wanted, Card::most_height(theme, place, width))},
                   .title = capitalised(name_of(*report.selected)) + "   " +
                            state_of_tracked(*report.selected, report.tracks->clock.seconds)});
  if (card.was_closed()) requests.ask(Select{});
  if (!card.is_unfolded()) return;
  const Area content = card.content();
  const float foot = std::max(content.to.y, content.from.y + theme.px(least_tracked_person_height + foot_height)) -
                     theme.px(foot_height);
  show_tracked_person(widgets,
                      {.from = {content.from.x + theme.px(card_margin), content.from.y + theme.px(4)},
                       .to = {content.to.x - theme.px(card_margin), foot - theme.px(4)}},
                      report, requests);
  show_foot(widgets, content, foot, report, requests);
}

}  // namespace

void show_view_button(Widgets& widgets, const std::string& name, float width, Requests& requests) {
  if (widgets.named_button("View", name, {.what = "Shows its character alone, clip by clip, while the crowd waits."},
                           width))
    requests.ask(ViewSelected{});
}

glm::vec3 ahead_of(const CameraPose& camera) { return render::forward(camera_at(camera)); }

std::string place_in_clip(const EntityRow& row) {
  if (row.duration_seconds <= 0) return "";
  return fixed(row.position_seconds, 2) + " / " + fixed(row.duration_seconds, 2);
}

void show_selection_card(Widgets& widgets, const Area& place, const FrameReport& report, Requests& requests) {
  const SelectionReport& selected = *report.selected;
  const Theme& theme = widgets.theme();
  if (selected.tracked != nullptr && report.tracks) return show_tracked_card(widgets, place, report, requests);
  const float width = std::min(theme.px(widest_card), place.width() - 2 * theme.px(card_gap));
  const float without_rows = theme.px(4 + 2 * text_height + 2 + entity_height + 5 + foot_height);
  const float for_rows = Card::most_height(theme, place, width) - without_rows;
  const auto room = static_cast<std::size_t>(std::max(for_rows / theme.px(entity_height), 0.0F));
  const std::size_t rows = std::min(selected.entities.size(), room);
  const Card card(widgets, "Selected", place,
                  {.at = {place.from.x + theme.px(card_gap), place.from.y + theme.px(card_gap)},
                   .size = {width, without_rows + static_cast<float>(rows) * theme.px(entity_height)},
                   .title = capitalised(name_of(selected)) + "   " + doing(selected)});
  if (card.was_closed()) requests.ask(Select{});
  if (!card.is_unfolded()) return;
  const Area content = card.content();
  const float y = draw_words(theme, content, selected);
  const float below = draw_graph(widgets, content, y, rows, selected);
  show_foot(widgets, content, below, report, requests);
}

}  // namespace throng::app
