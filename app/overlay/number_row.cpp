// The rows that edit a number: a track to drag and a field to type into.
#include <cmath>

#include <imgui_internal.h>

#include "app/overlay/number_scale.h"
#include "app/overlay/widgets.h"

namespace throng::app {
namespace {

constexpr float field_width = 64, gap = 8;

void draw_track(const Theme& theme, const Area& place, float knob_place, bool lively) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float y = std::floor((place.from.y + place.to.y) / 2), knob_radius = theme.px(lively ? 6.5F : 5.5F);
  const float margin = theme.px(7), x0 = place.from.x + margin, x1 = place.to.x - margin;
  const float knob = std::lerp(x0, x1, knob_place), half = theme.px(1.5F);
  draw.AddRectFilled({x0, y - half}, {x1, y + half}, ImGui::GetColorU32(colour::well_hovered), half);
  draw.AddRectFilled({x0, y - half}, {knob, y + half}, ImGui::GetColorU32(colour::accent), half);
  draw.AddCircleFilled({knob, y}, knob_radius, ImGui::GetColorU32(lively ? colour::text : colour::accent));
}

}  // namespace

bool Widgets::number(const char* label, int& value, int standard, const NumberScale& scale, const Help& help) {
  double edited = value;
  if (!edit_number(label, edited, standard, scale, help)) return false;
  value = static_cast<int>(std::lround(edited));
  return true;
}

bool Widgets::number(const char* label, float& value, float standard, const NumberScale& scale, const Help& help) {
  auto edited = static_cast<double>(value);
  if (!edit_number(label, edited, static_cast<double>(standard), scale, help)) return false;
  value = static_cast<float>(edited);
  return true;
}

bool Widgets::edit_number(const char* label, double& value, double standard, const NumberScale& scale,
                          const Help& help) {
  const std::string standard_text = written(scale, standard);
  const Row row = begin_row(label, written(scale, value) != standard_text, help, standard_text);
  const float field_x = row.control.to.x - theme_.px(field_width);
  const Area track{.from = row.control.from, .to = {field_x - theme_.px(gap), row.control.to.y}};
  const Area field{.from = {field_x, row.control.from.y + theme_.px(1)}, .to = row.control.to};
  bool changed = drag_track(label, track, value, standard, scale);
  changed = type_field(label, field, value, scale) || changed;
  if (row.reset) {
    value = standard;
    changed = true;
  }
  end_row(row, label, help, standard_text);
  return changed;
}

bool Widgets::drag_track(const char* label, const Area& place, double& value, double standard,
                         const NumberScale& scale) {
  clickable(label, place);
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

bool Widgets::type_field(const char* label, const Area& place, double& value, const NumberScale& scale) {
  ImGui::SetCursorScreenPos(place.from);
  ImGui::SetNextItemWidth(place.width());
  const ImGuiID id = ImGui::GetID("field");
  FieldText shown = {};
  written(scale, value).copy(shown.data(), shown.size() - 1);
  const auto typing = typed_.find(id);
  FieldText& text = typing == typed_.end() ? shown : typing->second;
  ImGui::InputText("##field", text.data(), text.size(), ImGuiInputTextFlags_AutoSelectAll);
  record(std::string(label) + ".field", place);
  if (ImGui::IsItemActivated()) typed_[id] = text;
  const double before = value;
  if (ImGui::IsItemDeactivatedAfterEdit()) value = meant(scale, text.data()).value_or(value);
  if (ImGui::IsItemDeactivated()) typed_.erase(id);
  return value != before;
}

}  // namespace throng::app
