// The rows that edit a value: a number, a switch, one of a few words, one of many, and text.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>
#include <vector>

#include <imgui_internal.h>

#include "app/window/panel/controls/widgets.h"

namespace throng::app {
namespace {

constexpr float least_field_width = 64, field_gap = 8, longest_list = 300;
constexpr float track_below = 17;   // the height of a line with a track alone
constexpr float least_margins = 8;  // of a word in a line of them

void draw_track(const Theme& theme, const Area& place, float knob_place, bool lively) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float y = std::floor((place.from.y + place.to.y) / 2), knob_radius = theme.px(lively ? 6.5F : 5.5F);
  const float margin = theme.px(7), x0 = place.from.x + margin, x1 = place.to.x - margin;
  const float knob = std::lerp(x0, x1, knob_place), half = theme.px(1.5F);
  draw.AddRectFilled({x0, y - half}, {x1, y + half}, ImGui::GetColorU32(colour::well_hovered), half);
  draw.AddRectFilled({x0, y - half}, {knob, y + half}, ImGui::GetColorU32(colour::accent), half);
  draw.AddCircleFilled({knob, y}, knob_radius, ImGui::GetColorU32(lively ? colour::text : colour::accent));
}

std::string word_of(int index, std::span<const std::string> words, const char* none) {
  return index < 0 ? none : words[static_cast<std::size_t>(index)];
}

void draw_closed(const Theme& theme, const Area& place, const std::string& word, bool lively) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled(place.from, place.to, ImGui::GetColorU32(lively ? colour::well_hovered : colour::well),
                     theme.px(4));
  draw_text(theme.small, {place.from.x + theme.px(8), place.from.y + theme.px(4)}, colour::text,
            fitted(theme.small, place.width() - theme.px(8 + 18), word));
  const ImVec2 tip(place.to.x - theme.px(10), place.from.y + theme.px(13));
  draw.AddTriangleFilled({tip.x - theme.px(4), tip.y - theme.px(4)}, {tip.x + theme.px(4), tip.y - theme.px(4)}, tip,
                         colour::dim);
}

// Returns the place in an open list after the keys of this frame.
int walked(int place, int first, int last) {
  place += (ImGui::IsKeyPressed(ImGuiKey_DownArrow) ? 1 : 0) - (ImGui::IsKeyPressed(ImGuiKey_UpArrow) ? 1 : 0);
  if (ImGui::IsKeyPressed(ImGuiKey_Home)) place = first;
  if (ImGui::IsKeyPressed(ImGuiKey_End)) place = last;
  return std::clamp(place, first, std::max(first, last));
}

// A field has room for every number of its track, and for one beyond it that was typed.
float field_width(const Theme& theme, const NumberScale& scale, double value) {
  float width = theme.px(least_field_width);
  for (const double number : {scale.lowest, scale.highest, value}) {
    const float margins = 2 * ImGui::GetStyle().FramePadding.x + theme.px(1);
    width = std::max(width, text_width(theme.regular, written(scale, number)) + margins);
  }
  return std::ceil(width);
}

// Shares the rest of a width evenly, so that long words have as much room around them as short ones.
float margins_of_words(const Theme& theme, float width, std::span<const char* const> words) {
  for (const char* const word : words) width -= text_width(theme.small, word);
  return width / static_cast<float>(words.size());
}

// The list of a row at the foot of the screen opens upwards, where it has more room.
void place_list(const Theme& theme, const Area& row) {
  const float below = ImGui::GetIO().DisplaySize.y - row.to.y, longest = theme.px(longest_list);
  const bool opens_up = below < longest && row.from.y > below;
  ImGui::SetNextWindowPos({row.from.x, opens_up ? row.from.y : row.to.y}, ImGuiCond_Always, {0, opens_up ? 1.0F : 0});
  ImGui::SetNextWindowSizeConstraints({row.width(), 0},
                                      {row.width(), std::min(longest, opens_up ? row.from.y : below)});
}

}  // namespace

bool Widgets::number(const char* label, double& value, double standard, const NumberScale& scale, const Help& help) {
  if (is_left_out(label, help)) return false;
  const std::string standard_text = written(scale, standard);
  Row row = begin_row(label, written(scale, value) != standard_text, help, standard_text);
  const float most = row.is_narrow ? row.control.width() : 0.6F * row.control.width();
  const float field_x = row.control.to.x - std::min(field_width(theme_, scale, value), most);
  const Area field{.from = {field_x, row.control.from.y + theme_.px(1)}, .to = row.control.to};
  const Area beside{.from = row.control.from, .to = {field_x - theme_.px(field_gap), row.control.to.y}};
  const Area track = row.is_narrow ? line_below(row, track_below) : beside;
  bool changed = drag_track(label, track, value, standard, scale);
  stop_at(row, label);
  if (const int steps = focus_.take_step()) {
    const double before = std::exchange(value, stepped(scale, value, steps));
    changed |= value != before;
  }
  changed |= type_field(label, field, value, scale, focus_.take_activation());
  if (!end_row(row)) return changed;
  value = standard;
  return true;
}

bool Widgets::number(const char* label, float& value, float standard, const NumberScale& scale, const Help& help) {
  auto exact = static_cast<double>(value);
  const bool changed = number(label, exact, static_cast<double>(standard), scale, help);
  if (changed) value = static_cast<float>(exact);
  return changed;
}

bool Widgets::drag_track(const char* label, const Area& place, double& value, double standard,
                         const NumberScale& scale) {
  pressable(label, place);
  const bool active = ImGui::IsItemActive(), hovered = ImGui::IsItemHovered();
  const ImGuiID id = ImGui::GetItemID();
  const double before = value;
  if (!active && held_after_reset_ == id) held_after_reset_ = 0;
  if (hovered && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
    held_after_reset_ = id;
    value = standard;
  } else if (active && held_after_reset_ != id) {
    const float margin = theme_.px(7), pointer = ImGui::GetIO().MousePos.x;
    value = value_at(scale, static_cast<double>((pointer - place.from.x - margin) / (place.width() - 2 * margin)));
  }
  draw_track(theme_, place, static_cast<float>(place_of(scale, value)), active || hovered);
  return value != before;
}

bool Widgets::type_field(const char* label, const Area& place, double& value, const NumberScale& scale, bool begins) {
  ImGui::SetCursorScreenPos(place.from);
  ImGui::SetNextItemWidth(place.width());
  const ImGuiID id = ImGui::GetID("field");
  FieldText shown = {};
  written(scale, value).copy(shown.data(), shown.size() - 1);
  const auto typing = typed_.find(id);
  FieldText& text = typing == typed_.end() ? shown : typing->second;
  if (begins) imgui::focus_next_item();
  ImGui::InputText("##field", text.data(), text.size(), ImGuiInputTextFlags_AutoSelectAll);
  record(std::string(label) + ".field", place, true);
  if (ImGui::IsItemActivated()) typed_[id] = text;
  const double before = value;
  if (ImGui::IsItemDeactivatedAfterEdit()) value = meant(scale, text.data()).value_or(value);
  if (ImGui::IsItemDeactivated()) typed_.erase(id);
  return value != before;
}

bool Widgets::toggle(const char* label, bool& value, bool standard, const Help& help) {
  if (is_left_out(label, help)) return false;
  const bool before = value;
  const std::string standard_word = standard ? "on" : "off";
  Row row = begin_row(label, value != standard, help, standard_word);
  const ImVec2 from(row.control.from.x, row.control.from.y + theme_.px(4));
  const ImVec2 size(theme_.px(34), theme_.px(17));
  const bool clicked = pressable(label, rectangle(from, {from.x + size.x, from.y + size.y}));
  const bool hovered = ImGui::IsItemHovered();
  stop_at(row, label);
  if (focus_.take_activation() || clicked) value = !value;
  if (const int step = focus_.take_step()) value = step > 0;
  const float radius = size.y / 2;
  const float knob_x = value ? from.x + size.x - radius : from.x + radius;
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const ImU32 off = hovered ? colour::well_hovered : colour::well;
  draw.AddRectFilled(from, {from.x + size.x, from.y + size.y}, ImGui::GetColorU32(value ? colour::accent : off),
                     radius);
  draw.AddCircleFilled({knob_x, from.y + radius}, radius - theme_.px(3),
                       ImGui::GetColorU32(value ? colour::on_accent : colour::dim));
  draw_text(theme_.small, {from.x + size.x + theme_.px(8), from.y + theme_.px(1)}, colour::dim, value ? "on" : "off");
  if (end_row(row)) value = standard;
  return value != before;
}

bool Widgets::choose(const char* label, int& index, int standard, std::span<const char* const> words, const Help& help,
                     std::span<const char* const> why_not) {
  if (is_left_out(label, help)) return false;
  const int before = index, last = static_cast<int>(words.size()) - 1;
  const Words all{words, why_not};
  const std::string standard_word = words[static_cast<std::size_t>(standard)];
  Row row = begin_row(label, index != standard, help, standard_word);
  const auto fit = [&](float width) { return margins_of_words(theme_, width, words) >= theme_.px(least_margins); };
  const Area room = fit(row.control.width()) ? row.control : room_for_words(row);
  const bool is_wide = !fit(room.width());
  const int last_in_line = is_wide ? last / 2 : last;
  Area line{.from = {room.from.x, room.from.y + theme_.px(1)}, .to = {room.to.x, room.to.y - theme_.px(2)}};
  choose_in_line(label, line, all, 0, last_in_line, index);
  if (is_wide) {
    const float down = line.to.y - line.from.y + theme_.px(2);
    line.from.y += down, line.to.y += down, row.control.to.y += down, row.all.to.y += down;
    choose_in_line(label, line, all, last_in_line + 1, last, index);
  }
  if (focus_.has_keys()) {
    stop_at(row, std::string(label) + ":" + words[static_cast<std::size_t>(before)]);
    if (const int step = focus_.take_step()) index = all.next(index, step, false);
    if (focus_.take_activation()) index = all.next(index, 1, true);
  }
  if (end_row(row)) index = standard;
  return index != before;
}

int Widgets::Words::next(int index, int steps, bool goes_round) const {
  const auto count = static_cast<int>(all.size());
  int found = index;
  for (int place = index; steps != 0;) {
    place += steps > 0 ? 1 : -1;
    if (goes_round) place = (place + count) % count;
    if (place < 0 || place >= count || place == index) return found;
    if (reason(place) != nullptr) continue;
    found = place;
    steps -= steps > 0 ? 1 : -1;
  }
  return found;
}

void Widgets::choose_in_line(const char* label, const Area& line, const Words& words, int first, int last, int& index) {
  ImGui::GetWindowDrawList()->AddRectFilled(line.from, line.to, ImGui::GetColorU32(colour::well), theme_.px(4));
  const auto here = words.all.subspan(static_cast<std::size_t>(first), static_cast<std::size_t>(last - first + 1));
  const float margins = margins_of_words(theme_, line.width(), here);
  float x = line.from.x;
  for (int word = first; word <= last; ++word) {
    const float next = x + text_width(theme_.small, words.all[static_cast<std::size_t>(word)]) + margins;
    show_word(label, rectangle({std::floor(x), line.from.y}, {std::floor(next), line.to.y}), words, word, index);
    x = next;
  }
}

void Widgets::show_word(const char* label, const Area& place, const Words& words, int word, int& index) {
  const char* const text = words.all[static_cast<std::size_t>(word)];
  const char* const why_not = words.reason(word);
  const std::string name = std::string(label) + ":" + text;
  if (why_not != nullptr) {
    hoverable(name, place);
    map_.idle.emplace_back(name, why_not);
    if (ImGui::IsItemHovered()) show_lines({capitalised(text) + " cannot be chosen: " + why_not + "."});
  } else if (pressable(name, place)) {
    index = word;
  }
  const bool hovered = ImGui::IsItemHovered() && why_not == nullptr;
  if (word == index)
    ImGui::GetWindowDrawList()->AddRectFilled(place.from, place.to, ImGui::GetColorU32(colour::accent), theme_.px(4));
  const ImU32 free_ink = hovered ? colour::text : colour::dim;
  const ImU32 ink = word == index ? colour::on_accent : (why_not != nullptr ? colour::faint : free_ink);
  draw_text(theme_.small, {(place.from.x + place.to.x) / 2, place.from.y + theme_.px(4)}, ink, text, 0.5F);
}

bool Widgets::pick(const char* label, int& index, int standard, std::span<const std::string> words, const char* none,
                   const Help& help) {
  if (is_left_out(label, help)) return false;
  const int before = index;
  const std::string standard_word = word_of(standard, words, none);
  Row row = begin_row(label, index != standard, help, standard_word);
  Area place = room_for_words(row);
  place.from.y += theme_.px(1);
  place.to.y -= theme_.px(2);
  const bool clicked = pressable(label, place), hovered = ImGui::IsItemHovered();
  stop_at(row, label);
  if (focus_.take_activation() || clicked) {
    ImGui::OpenPopup("list");
    list_place_ = index;
  }
  draw_closed(theme_, place, word_of(index, words, none), hovered || ImGui::IsPopupOpen("list"));
  place_list(theme_, place);
  if (ImGui::BeginPopup("list")) {
    show_list(label, index, words, none);
    ImGui::EndPopup();
  }
  if (end_row(row)) index = standard;
  return index != before;
}

void Widgets::show_list(const char* label, int& index, std::span<const std::string> words, const char* none) {
  const int first = none == nullptr ? 0 : -1, last = static_cast<int>(words.size()) - 1;
  const bool appears = ImGui::IsWindowAppearing();
  const int place_before = list_place_;
  if (!appears) list_place_ = walked(list_place_, first, last);
  const bool takes = !appears && ImGui::IsKeyPressed(ImGuiKey_Enter) && list_place_ <= last;
  if (takes) index = list_place_;
  if (takes || ImGui::IsKeyPressed(ImGuiKey_Escape)) ImGui::CloseCurrentPopup();
  for (int i = first; i <= last; ++i) {
    const std::string word = word_of(i, words, none);
    ImGui::PushID(i);
    if (ImGui::Selectable(word.c_str(), i == list_place_)) index = i;
    const bool comes_into_view = i == list_place_ && (appears || list_place_ != place_before);
    if (comes_into_view) ImGui::SetScrollHereY();
    ImGui::PopID();
    record(std::string(label) + ":" + word, {.from = ImGui::GetItemRectMin(), .to = ImGui::GetItemRectMax()});
  }
}

bool Widgets::text(const char* label, std::string& value, const char* hint, const Help& help) {
  if (is_left_out(label, help)) return false;
  Row row = begin_row(label, false, help, "");
  const Area room = room_for_words(row);
  const Area field{.from = {room.from.x, room.from.y + theme_.px(1)}, .to = room.to};
  const bool changed = text_field(std::string(label) + ".field", value, hint, field);
  end_row(row);
  return changed;
}

bool Widgets::text_field(const std::string& name, std::string& value, const char* hint, const Area& place,
                         std::size_t most_bytes) {
  std::vector<char> typed(most_bytes + 1);
  value.copy(typed.data(), most_bytes);
  if (focus_.has_keys() && stop(name, place).take_activation()) imgui::focus_next_item();
  ImGui::SetCursorScreenPos(place.from);
  ImGui::SetNextItemWidth(place.width());
  const bool changed = ImGui::InputTextWithHint("##text", hint, typed.data(), typed.size());
  record(name, place, true);
  if (changed) value = typed.data();
  return changed;
}

}  // namespace throng::app
