#include "app/overlay/bone_list.h"

#include <algorithm>
#include <cctype>

#include "app/overlay/bone_order_edit.h"
#include "app/overlay/numbers.h"
#include "app/overlay/plots.h"

namespace throng::app {
namespace {

constexpr float bone_height = 18, border_height = 17, least_height = 150, scroll_a_frame = 6;

std::string lower(std::string text) {
  std::ranges::transform(text, text.begin(),
                         [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return text;
}

std::vector<int> parents_of(const FrameReport& report) {
  std::vector<int> parents;
  for (const BoneRow& bone : report.bones) parents.push_back(bone.parent);
  return parents;
}

void draw_levels_kept(const Theme& theme, ImVec2 right_middle, int last_level, int levels) {
  for (int kept = 0; kept < levels; ++kept) {
    const float x = right_middle.x - theme.px(12) - theme.px(11) * static_cast<float>(levels - 1 - kept);
    const ImU32 ink = kept <= last_level ? colour::bone_level(kept) : colour::well_hovered;
    ImGui::GetWindowDrawList()->AddCircleFilled({x, right_middle.y}, theme.px(3), ImGui::GetColorU32(ink));
  }
}

std::string millimetres(float value) {
  return value == 0 ? "" : fixed(static_cast<double>(value), value < 10 ? 2 : 0) + " mm";
}

void draw_bone(const Theme& theme, const Area& row, const BoneRow& bone, std::size_t place, int levels) {
  const float text_y = row.from.y + theme.px(1), middle = (row.from.y + row.to.y) / 2;
  draw_text(theme.small, {row.from.x + theme.px(24), text_y}, colour::faint, std::to_string(place + 1), 1);
  const float indent = theme.px(32) + std::min(static_cast<float>(bone.depth) * theme.px(6), theme.px(84));
  const float dots = theme.px(11) * static_cast<float>(levels) + theme.px(10), figures = row.to.x - dots;
  ImGui::PushClipRect(row.from, {figures - theme.px(58), row.to.y}, true);
  draw_text(theme.small, {row.from.x + indent, text_y}, colour::text, bone.name);
  ImGui::PopClipRect();
  draw_text(theme.small, {figures, text_y}, colour::dim, millimetres(bone.error_millimetres), 1);
  draw_levels_kept(theme, {row.to.x, middle}, std::clamp(bone.level, 0, 3), levels);
}

// While something is dragged to the edge of the list, the list comes along.
void scroll_with_drag() {
  const float y = ImGui::GetIO().MousePos.y, top = ImGui::GetWindowPos().y, bottom = top + ImGui::GetWindowHeight();
  if (y < top + bone_height) ImGui::SetScrollY(ImGui::GetScrollY() - scroll_a_frame);
  if (y > bottom - bone_height) ImGui::SetScrollY(ImGui::GetScrollY() + scroll_a_frame);
}

}  // namespace

bool BoneList::matches(const BoneRow& bone) const {
  return search_.empty() || lower(bone.name).find(lower(search_)) != std::string::npos;
}

void BoneList::change(const TabContext& context, const BoneLodChoice& choice) {
  const BoneLodChoice now = present_bone_lod(context.report.bones.size(), context.report.level_bone_counts);
  if (choice.bones == now.bones && choice.level_counts == now.level_counts) return;
  undo_.push_back(taken_back(choice, now.level_counts));
  context.commands.bone_lod = choice;
}

void BoneList::show_search(const TabContext& context) {
  context.widgets.text("Search", search_, "part of a name",
                       {.what = "Shows the bones whose names have it. While it is empty, bones can be dragged."});
}

void BoneList::show_buttons(const TabContext& context) {
  const auto& [widgets, report, tuning, standard, commands] = context;
  const float gap = ImGui::GetStyle().ItemSpacing.x, width = (ImGui::GetContentRegionAvail().x - 2 * gap) / 3;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::BeginDisabled(undo_.empty());
  if (widgets.button("Undo", {.what = "Takes back the last change of the order or of a level's end."}, width)) {
    commands.bone_lod = undo_.back();
    undo_.pop_back();
  }
  ImGui::EndDisabled();
  ImGui::SetCursorScreenPos({at.x + width + gap, at.y});
  commands.save_bone_lod |=
      widgets.button("Save order", {.what = "Keeps order and levels beside the model, in MODEL.lod.json."}, width);
  ImGui::SetCursorScreenPos({at.x + 2 * (width + gap), at.y});
  commands.export_lod |= widgets.button(
      "Export LOD", {.what = "Intervals, distances, bone order, errors and mesh ratios as JSON, for another engine."},
      width);
}

void BoneList::show_row(const TabContext& context, std::size_t place) {
  const Theme& theme = context.widgets.theme();
  const BoneRow& bone = context.report.bones[place];
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const Area row{.from = from, .to = {from.x + ImGui::GetContentRegionAvail().x, from.y + theme.px(bone_height)}};
  const std::string name = "Bone " + std::to_string(place);
  context.widgets.clickable(name, row);
  const bool hovered = ImGui::IsMouseHoveringRect(row.from, row.to);
  if (ImGui::IsItemActivated() && search_.empty()) drag_ = {.from = place, .border = false, .over = place};
  if (drag_ && hovered) drag_->over = place;
  if (hovered && !drag_ && ImGui::IsItemHovered()) {
    const std::string what = "Without it and what hangs on it, the surface is off by up to " +
                             fixed(static_cast<double>(bone.error_millimetres), 2) + " mm (99% of poses). It costs " +
                             fixed(static_cast<double>(bone.nanoseconds), 1) + " ns an update, by prediction.";
    context.widgets.tooltip(bone.name.c_str(), {.what = what.c_str()}, "");
  }
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const bool dragged = drag_ && !drag_->border && drag_->from == place;
  if (dragged) draw.AddRectFilled(row.from, row.to, ImGui::GetColorU32(colour::accent_soft));
  draw_bone(theme, row, bone, place, level_count(context.report));
  if (!drag_ || drag_->over != place || dragged) return;
  const bool above = !drag_->border && place < drag_->from;
  const float y = above ? row.from.y : row.to.y;
  draw.AddLine({row.from.x, y}, {row.to.x, y}, ImGui::GetColorU32(colour::accent), theme.px(2));
}

void BoneList::show_border(const TabContext& context, int level, std::size_t bones) {
  const Theme& theme = context.widgets.theme();
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const Area row{.from = from, .to = {from.x + ImGui::GetContentRegionAvail().x, from.y + theme.px(border_height)}};
  context.widgets.clickable("Border " + std::to_string(level), row);
  if (ImGui::IsItemHovered()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeNS);
  if (ImGui::IsItemActivated()) drag_ = {.from = static_cast<std::size_t>(level), .border = true, .over = bones - 1};
  const ImU32 ink = ImGui::GetColorU32(colour::bone_level(level));
  const std::string words = "level " + std::to_string(level) + " keeps the " + std::to_string(bones) + " above";
  const float width = theme.small->CalcTextSizeA(theme.small->FontSize, FLT_MAX, 0, words.c_str()).x;
  const float middle = from.y + theme.px(8);
  draw_text(theme.small, {from.x + theme.px(32), from.y}, colour::bone_level(level), words);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddLine({from.x, middle}, {from.x + theme.px(26), middle}, ink);
  draw.AddLine({from.x + width + theme.px(40), middle}, {row.to.x, middle}, ink);
}

void BoneList::finish_drag(const TabContext& context) {
  if (!drag_) return;
  scroll_with_drag();
  if (ImGui::IsMouseDown(ImGuiMouseButton_Left)) return;
  const Drag drag = *drag_;
  drag_.reset();
  if (drag.over >= context.report.bones.size()) return;
  const BoneLodChoice now = present_bone_lod(context.report.bones.size(), context.report.level_bone_counts);
  change(context, drag.border ? with_border_moved(now, drag.from, static_cast<int>(drag.over) + 1)
                              : with_bone_moved(parents_of(context.report), now, drag.from, drag.over));
}

void BoneList::show(const TabContext& context) {
  const FrameReport& report = context.report;
  if (report.character != character_) undo_.clear();
  character_ = report.character;
  context.widgets.section("Bones, the most visible first");
  show_search(context);
  show_buttons(context);
  const Theme& theme = context.widgets.theme();
  const float height = std::max(theme.px(least_height), ImGui::GetContentRegionAvail().y);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
  ImGui::PushStyleColor(ImGuiCol_ChildBg, colour::well);
  ImGui::BeginChild("Bone list", {0, height});
  const ImVec2 from = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  context.widgets.record("Bone list", {.from = from, .to = {from.x + size.x, from.y + size.y}});
  for (std::size_t i = 0; i < report.bones.size(); ++i) {
    if (matches(report.bones[i])) show_row(context, i);
    const int below = i + 1 < report.bones.size() ? report.bones[i + 1].level : 0;
    for (int level = std::min(report.bones[i].level, 3); level > below; --level) show_border(context, level, i + 1);
  }
  finish_drag(context);
  ImGui::EndChild();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
}

}  // namespace throng::app
