#include "app/window/panel/controls/widgets.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include <imgui_internal.h>

namespace throng::app {
namespace {

constexpr float narrow_row = 300;  // a row that is not so wide has its control below its label
constexpr float row_height = 25, label_width = 122, label_gap = 8, reset_width = 20, tooltip_width = 290;
constexpr float most_of_a_fact = 0.6F;  // of its width, that its name takes
constexpr float seconds_until_help = 0.5F;

bool resting_on(const Area& place) {
  const ImGuiContext& context = *ImGui::GetCurrentContext();
  return place.hovered && ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem) &&
         context.ActiveId == 0 && context.HoveredIdTimer > seconds_until_help;
}

/// ImGui ends a program that asks for a button without a size, as of a window in which there is just no room left.
bool invisible_button(const char* name, ImVec2 size) {
  return ImGui::InvisibleButton(name, {std::max(size.x, 1.0F), std::max(size.y, 1.0F)});
}

/// Writes a paragraph in lines of at most that width; none where the text is empty.
void write_paragraph(ImFont* font, ImU32 ink, float width, const std::string& text) {
  if (text.empty()) return;
  imgui::push_font(font);
  ImGui::PushStyleColor(ImGuiCol_Text, ink);
  ImGui::TextUnformatted(wrapped(font, width, text).c_str());
  ImGui::PopStyleColor();
  ImGui::PopFont();
}

}  // namespace

Area rectangle(ImVec2 from, ImVec2 to) {
  return {.from = from, .to = to, .hovered = ImGui::IsMouseHoveringRect(from, to)};
}

void draw_fold_sign(const Theme& theme, ImVec2 middle, bool is_folded, ImU32 ink) {
  const float arm = theme.px(4), way = is_folded ? -1.0F : 1.0F;
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddLine({middle.x - arm, middle.y - way * arm / 2}, {middle.x, middle.y + way * arm / 2}, ink, theme.px(1.5F));
  draw.AddLine({middle.x, middle.y + way * arm / 2}, {middle.x + arm, middle.y - way * arm / 2}, ink, theme.px(1.5F));
}

bool is_narrow(const Theme& theme, float width) { return width < theme.px(narrow_row); }

ButtonRow::ButtonRow(Widgets& widgets, int count)
    : widgets_(widgets),
      in_a_line_(is_narrow(widgets.theme(), ImGui::GetContentRegionAvail().x) ? std::min(count, 2) : count),
      width_((ImGui::GetContentRegionAvail().x - static_cast<float>(in_a_line_ - 1) * ImGui::GetStyle().ItemSpacing.x) /
             static_cast<float>(in_a_line_)) {}

void ButtonRow::go_right() {
  if (shown_ % in_a_line_ != 0) ImGui::SameLine();
  ++shown_;
}

bool ButtonRow::marked_button(const char* words, const std::string& name, const Help& help, bool marked) {
  if (widgets_.is_searching()) return false;
  go_right();
  const bool pressed = widgets_.named_button(words, name, help, width_);
  if (!marked) return pressed;
  const ImVec2 from = ImGui::GetItemRectMin(), to = ImGui::GetItemRectMax();
  const float thick = widgets_.theme().px(2), inset = widgets_.theme().px(5);
  ImGui::GetWindowDrawList()->AddRectFilled({from.x + inset, to.y - thick}, {to.x - inset, to.y}, colour::accent);
  return pressed;
}

bool ButtonRow::button(const char* label, const Help& help, const char* idle) {
  if (widgets_.is_searching()) return false;
  go_right();
  widgets_.begin_idle(idle == nullptr ? std::nullopt : std::optional<std::string>(idle));
  const bool pressed = widgets_.button(label, help, width_);
  widgets_.end_idle();
  return pressed;
}

bool wide_button(Widgets& widgets, const char* label, const Help& help, const char* idle) {
  return ButtonRow(widgets, 1).button(label, help, idle);
}

void Widgets::record(const std::string& name, const Area& place, bool takes_clicks) {
  ImRect seen(place.from, place.to);
  seen.ClipWith(ImGui::GetCurrentWindow()->ClipRect);
  if (seen.GetWidth() > 0 && seen.GetHeight() > 0) record_whole(name, {.from = seen.Min, .to = seen.Max}, takes_clicks);
}

void Widgets::record_whole(const std::string& name, const Area& place, bool takes_clicks) {
  map_.widgets.emplace_back(name, UiRectangle{place.from.x, place.from.y, place.width(), place.height(), takes_clicks});
}

void Widgets::cover(const Area& place) {
  map_.over_crowd.push_back({place.from.x, place.from.y, place.width(), place.height()});
}

PanelFocus& Widgets::stop(const std::string& name, const Area& place) {
  if (focus_.has_keys()) {
    focus_.add(ImGui::GetID(name.c_str()), name, place.from, place.to, PanelFocus::Stop::plain);
  }
  return focus_;
}

bool Widgets::clickable(const std::string& name, const Area& place) {
  const bool clicked = pressable(name, place);
  return focus_.has_keys() ? stop(name, place).take_activation() || clicked : clicked;
}

bool Widgets::invisible(const std::string& name, const Area& place, bool takes_clicks) {
  ImGui::SetCursorScreenPos(place.from);
  const bool clicked = invisible_button(name.c_str(), {place.width(), place.height()});
  record(name, place, takes_clicks);
  return clicked;
}

Area Widgets::area(const char* name, float height) {
  assert(!is_searching());
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const ImVec2 size(ImGui::GetContentRegionAvail().x, theme_.px(height));
  invisible_button(name, size);
  const Area place{.from = from, .to = {from.x + size.x, from.y + size.y}, .hovered = ImGui::IsItemHovered()};
  record(name, place);
  return place;
}

void Widgets::begin_idle(std::optional<std::string> reason, std::string_view key) {
  idle_ = std::move(reason);
  key_ = key;
  ImGui::BeginDisabled(idle_.has_value());
}

void Widgets::end_idle() {
  ImGui::EndDisabled();
  idle_.reset();
  key_ = {};
}

void Widgets::section(const char* title) {
  if (is_searching()) return search_->begin_section(title);
  ImGui::Dummy({0, theme_.px(4)});
  go_to_wanted_section(title);
  draw_title(title, 0);
}

bool Widgets::folding_section(const char* title) {
  if (is_searching()) return search_->begin_section(title), true;
  ImGui::Dummy({0, theme_.px(4)});
  go_to_wanted_section(title);
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const Area line =
      rectangle(from, {from.x + ImGui::GetContentRegionAvail().x, from.y + font_height(theme_.strong) + theme_.px(1)});
  const bool was_folded = folded_.contains(title);
  const bool clicked = clickable(std::string("section:") + title, line);
  const ImU32 ink = ImGui::IsItemHovered() ? colour::text : colour::dim;
  if (clicked && was_folded) folded_.erase(title);
  if (clicked && !was_folded) folded_.insert(title);
  const bool is_folded = was_folded != clicked;
  draw_fold_sign(theme_, {line.to.x - theme_.px(6), (line.from.y + line.to.y) / 2}, is_folded, ink);
  ImGui::SetCursorScreenPos(from);
  draw_title(title, theme_.px(16));
  return !is_folded;
}

void Widgets::go_to_wanted_section(const char* title) {
  if (wanted_section_.empty() || wanted_section_ != title) return;
  ImGui::SetScrollHereY(0);
  wanted_section_.clear();
  folded_.erase(title);
  focus_.go_to_next_row();
}

void Widgets::draw_title(const std::string& title, float free_at_the_right) const {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float right = at.x + ImGui::GetContentRegionAvail().x - free_at_the_right;
  const std::string words = fitted(theme_.strong, right - at.x, title);
  draw_text(theme_.strong, at, colour::text, words);
  const float left = at.x + text_width(theme_.strong, words) + theme_.px(10);
  const float y = std::floor(at.y + font_height(theme_.strong) * 0.55F);
  ImGui::GetWindowDrawList()->AddLine({left, y}, {right, y}, colour::grid);
  ImGui::Dummy({0, font_height(theme_.strong) + theme_.px(1)});
}

bool Widgets::is_left_out(const char* label, const Help& help) {
  if (!is_searching()) return false;
  if (!search_->finds(label, help.what, key_)) return true;
  if (const auto place = search_->take_new_place()) show_found_place(*place);
  return false;
}

// The name of the tab leads there; it is no part of the value that may be disabled.
void Widgets::show_found_place(const RowSearch::Place& place) {
  if (idle_) ImGui::EndDisabled();
  ImGui::Dummy({0, theme_.px(4)});
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const float right = from.x + ImGui::GetContentRegionAvail().x;
  const float width = text_width(theme_.small, place.tab), height = font_height(theme_.strong);
  draw_title(place.section, width + theme_.px(10));
  const ImVec2 below = ImGui::GetCursorScreenPos();
  const Area words{.from = {right - width, from.y}, .to = {right, from.y + height}};
  if (clickable("found:" + place.tab + "/" + place.section, words)) search_->leave_for(place);
  draw_text(theme_.small, words.from, ImGui::IsItemHovered() ? colour::text : colour::accent, place.tab);
  ImGui::SetCursorScreenPos(below);
  if (idle_) ImGui::BeginDisabled();
}

void Widgets::caption(const std::string& text) const {
  if (is_searching()) return;
  write_paragraph(theme_.small, colour::dim, ImGui::GetContentRegionAvail().x, text);
}

void Widgets::tooltip(const char* title, const Help& help, const std::string& standard) const {
  tooltip_at(ImGui::GetMousePos().y, title, help, standard);
}

void Widgets::tooltip_at(float y, const char* title, const Help& help, const std::string& standard) const {
  // It lies beside the column, so that the value it explains stays in sight, and follows the pointer down the screen.
  const float x = ImGui::GetWindowPos().x - theme_.px(10);
  ImGui::SetNextWindowPos({x, y}, ImGuiCond_Always, {1, y / ImGui::GetIO().DisplaySize.y});
  ImGui::BeginTooltip();
  const float margins = 2 * ImGui::GetStyle().WindowPadding.x;
  const float width = std::clamp(x - margins, 1.0F, theme_.px(tooltip_width));
  std::string measure = help.unit;
  if (!standard.empty()) measure += (measure.empty() ? "default " : ", default ") + standard;
  write_paragraph(theme_.strong, colour::text, width, title);
  if (idle_) write_paragraph(theme_.regular, colour::changed, width, "No effect: " + *idle_ + ".");
  write_paragraph(theme_.regular, colour::text, width, help.what);
  write_paragraph(theme_.small, colour::dim, width, measure);
  write_paragraph(theme_.small, colour::changed, width, help.cost);
  ImGui::EndTooltip();
}

void Widgets::steady_caption(const std::string& text) const {
  constexpr float lines = 3;
  if (is_searching()) return;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  draw_wrapped(theme_.small, at, colour::dim, width, text);
  const float kept_free = lines * font_height(theme_.small);
  ImGui::Dummy({width, std::max(kept_free, wrapped_size(theme_.small, width, text).y)});
}

Widgets::Row Widgets::begin_row(const char* label, bool changed, const Help& help, const std::string& standard) {
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const float right = from.x + ImGui::GetContentRegionAvail().x, bottom = from.y + theme_.px(row_height);
  const Area words = rectangle(from, {from.x + theme_.px(label_width), bottom});
  Row row{.label = label,
          .help = help,
          .standard = standard,
          .all = rectangle(from, {right, bottom}),
          .control = rectangle({words.to.x, from.y}, {right - theme_.px(reset_width), bottom}),
          .changed = changed,
          .is_narrow = app::is_narrow(theme_, right - from.x)};
  ImGui::PushID(label);
  hoverable(std::string(label) + ".label", words);
  row.reset = changed && ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
  if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled) && resting_on(words)) tooltip(label, help, standard);
  if (idle_) map_.idle.emplace_back(label, *idle_);
  if (changed) {
    const float x = from.x - theme_.px(8);
    ImGui::GetWindowDrawList()->AddRectFilled({x, from.y + theme_.px(5)}, {x + theme_.px(3), bottom - theme_.px(5)},
                                              colour::changed, theme_.px(1));
  }
  const ImU32 ink = words.hovered || changed ? colour::text : colour::dim;
  draw_text(theme_.regular, {from.x, from.y + theme_.px(4)}, ink,
            fitted(theme_.regular, words.width() - theme_.px(label_gap), label));
  return row;
}

// Adds a line to a row, as wide as label and control.
Area Widgets::line_below(Row& row, float height) const {
  const Area line = rectangle({row.all.from.x, row.all.to.y}, {row.control.to.x, row.all.to.y + theme_.px(height)});
  row.all.to.y = row.control.to.y = line.to.y;
  row.control.hovered |= line.hovered;
  return line;
}

Area Widgets::room_for_words(Row& row) const { return row.is_narrow ? line_below(row, row_height) : row.control; }

void Widgets::stop_at(Row& row, const std::string& name) {
  if (!focus_.has_keys()) return;
  focus_.add(ImGui::GetID(row.label), name, row.all.from, row.control.to, PanelFocus::Stop::row);
  row.reset |= row.changed && focus_.take_reset();
  row.explains = focus_.is_at_last_added() && focus_.rests() && !ImGui::IsPopupOpen("list");
}

bool Widgets::end_row(Row& row) {
  if (row.changed) row.reset |= reset_arrow(row.label, row.all);
  if (resting_on(row.control) && typed_.empty()) tooltip(row.label, row.help, row.standard);
  if (row.explains && typed_.empty()) tooltip_at(row.all.from.y, row.label, row.help, row.standard);
  ImGui::PopID();
  ImGui::SetCursorScreenPos(row.all.from);
  ImGui::Dummy({row.all.width(), row.all.height()});
  return row.reset;
}

bool Widgets::reset_arrow(const char* label, const Area& row) {
  const Area place = rectangle({row.to.x - theme_.px(reset_width), row.from.y}, row.to);
  const bool clicked = clickable(std::string(label) + ".reset", place);
  const ImVec2 middle((place.from.x + place.to.x) / 2 + theme_.px(2), (place.from.y + place.to.y) / 2);
  const float radius = theme_.px(4.5F);
  const ImU32 ink = ImGui::IsItemHovered() ? colour::changed : colour::dim;
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.PathArcTo(middle, radius, -2.4F, 2.6F, 16);
  draw.PathStroke(ink, ImDrawFlags_None, theme_.px(1.5F));
  const ImVec2 tip(middle.x + radius * std::cos(-2.4F), middle.y + radius * std::sin(-2.4F));
  draw.AddTriangleFilled({tip.x - theme_.px(2.5F), tip.y - theme_.px(3)}, {tip.x + theme_.px(3.5F), tip.y},
                         {tip.x - theme_.px(2), tip.y + theme_.px(3)}, ink);
  return clicked;
}

bool Widgets::named_button(const char* words, const std::string& name, const Help& help, float width) {
  if (is_searching()) return false;
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const Area place = rectangle(from, {from.x + width, from.y + theme_.px(26)});
  const bool clicked = clickable(name, place);
  const bool hovered = ImGui::IsItemHovered(), held = ImGui::IsItemActive();
  if (idle_) map_.idle.emplace_back(name, *idle_);
  const ImU32 fill = held ? colour::accent_soft : (hovered ? colour::well_hovered : colour::well);
  ImGui::GetWindowDrawList()->AddRectFilled(place.from, place.to, ImGui::GetColorU32(fill), theme_.px(4));
  draw_text(theme_.regular, {(place.from.x + place.to.x) / 2, from.y + theme_.px(5)}, colour::text,
            fitted(theme_.regular, width - theme_.px(label_gap), words), 0.5F);
  if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled) && resting_on(place)) tooltip(words, help, "");
  return clicked;
}

void Widgets::fact(const char* label, const std::string& value, const Help& help) {
  if (is_searching()) return;
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const Area place = rectangle(from, {from.x + ImGui::GetContentRegionAvail().x, from.y + theme_.px(19)});
  hoverable(label, place);
  const float right = place.to.x - theme_.px(reset_width), room = right - from.x;
  const std::string name = fitted(theme_.regular, most_of_a_fact * room, label);
  const float left = text_width(theme_.regular, name) + theme_.px(label_gap);
  const std::string shown = fitted(theme_.regular, room - left, value);
  const bool says_more = *help.what != '\0' || shown != value;
  if (ImGui::IsItemHovered() && resting_on(place) && says_more) {
    tooltip(shown == value ? label : (std::string(label) + ": " + value).c_str(), help, "");
  }
  draw_text(theme_.regular, from, colour::dim, name);
  draw_text(theme_.regular, {right, from.y}, colour::text, shown, 1);
}

}  // namespace throng::app
