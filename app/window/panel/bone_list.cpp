#include "app/window/panel/bone_list.h"

#include <algorithm>
#include <utility>

#include "app/window/panel/tabs.h"

namespace throng::app {
namespace {

constexpr float bone_height = 18, border_height = 17, least_height = 150, scroll_a_frame = 6;

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

double millimetres_off(const BoneRow& bone) { return 1000 * static_cast<double>(bone.lod.error_metres); }

std::string millimetres(double value) { return value == 0 ? "" : fixed(value, value < 10 ? 2 : 0) + " mm"; }

void draw_bone(const Theme& theme, const Area& row, const BoneRow& bone, std::size_t place, int levels) {
  const float text_y = row.from.y + theme.px(1), middle = (row.from.y + row.to.y) / 2;
  draw_text(theme.small, {row.from.x + theme.px(24), text_y}, colour::faint, std::to_string(place + 1), 1);
  const float indent = theme.px(32) + std::min(static_cast<float>(bone.depth) * theme.px(6), theme.px(84));
  const float dots = theme.px(11) * static_cast<float>(levels) + theme.px(10), figures = row.to.x - dots;
  const float left = row.from.x + indent;
  draw_text(theme.small, {left, text_y}, colour::text, fitted(theme.small, figures - theme.px(58) - left, bone.name));
  draw_text(theme.small, {figures, text_y}, colour::dim, millimetres(millimetres_off(bone)), 1);
  draw_levels_kept(theme, {row.to.x, middle}, std::min<int>(bone.lod.level, 3), levels);
}

// The list scrolls along with a bone that is dragged to its edge.
void scroll_with_drag() {
  const float y = ImGui::GetIO().MousePos.y, top = ImGui::GetWindowPos().y, bottom = top + ImGui::GetWindowHeight();
  if (y < top + bone_height) ImGui::SetScrollY(ImGui::GetScrollY() - scroll_a_frame);
  if (y > bottom - bone_height) ImGui::SetScrollY(ImGui::GetScrollY() + scroll_a_frame);
}

void change(const TabContext& context, const BoneLodChoice& choice) {
  const BoneLodChoice now = present_bone_lod(context.report.bones.size(), context.report.level_bone_counts);
  if (choice.bones == now.bones && choice.level_counts == now.level_counts) return;
  context.requests.ask(SetBones{context.report.character, choice});
}

void show_bone_buttons(const TabContext& context) {
  ButtonRow buttons(context.widgets, 3);
  buttons.ask(context.requests, Undo{}, "Undo",
              {.what = "Takes back the last change of the order or of a level's end."},
              context.report.can_undo_bones ? nullptr : "the last change was none of bones");
  buttons.ask(context.requests, SaveBones{}, "Save order",
              {.what = "Keeps order and levels beside the model, in MODEL.lod.json."});
  buttons.ask(context.requests, ExportLod{}, "Export LOD",
              {.what = "Intervals, distances, bone order, errors and mesh ratios as JSON, for another engine."});
}

std::string name_of_bone_row(std::size_t place) { return "Bone " + std::to_string(place); }

// The focus goes along with the bone.
void move_bone_by_keys(const TabContext& context, std::size_t place) {
  PanelFocus& focus = context.widgets.focus();
  const int step = context.memory.bones.search.empty() ? focus.take_step() : 0;
  if (step == 0) return;
  const auto last = static_cast<int>(context.report.bones.size()) - 1;
  const auto to = static_cast<std::size_t>(std::clamp(static_cast<int>(place) + step, 0, last));
  const BoneLodChoice now = present_bone_lod(context.report.bones.size(), context.report.level_bone_counts);
  change(context, with_bone_moved(parents_of(context.report), now, place, to));
  focus.go_to(ImGui::GetID(name_of_bone_row(to).c_str()));
}

void move_border_by_keys(const TabContext& context, int level, std::size_t bones) {
  const int step = context.widgets.focus().take_step();
  if (step == 0) return;
  const BoneLodChoice now = present_bone_lod(context.report.bones.size(), context.report.level_bone_counts);
  change(context, with_border_moved(now, static_cast<std::size_t>(level), static_cast<int>(bones) + step));
}

void show_bone(const TabContext& context, std::size_t place) {
  std::optional<BoneListMemory::Drag>& drag = context.memory.bones.drag;
  const Theme& theme = context.widgets.theme();
  const BoneRow& bone = context.report.bones[place];
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const Area row{.from = from, .to = {from.x + ImGui::GetContentRegionAvail().x, from.y + theme.px(bone_height)}};
  context.widgets.clickable(name_of_bone_row(place), row);
  move_bone_by_keys(context, place);
  const bool hovered = ImGui::IsMouseHoveringRect(row.from, row.to);
  if (ImGui::IsItemActivated() && context.memory.bones.search.empty())
    drag = {.from = place, .border = false, .over = place};
  if (drag && hovered) drag->over = place;
  if (hovered && !drag && ImGui::IsItemHovered()) {
    const std::string what = "Without it and what hangs on it, the surface is off by up to " +
                             fixed(millimetres_off(bone), 2) + " mm (99% of poses). It costs " +
                             fixed(nanoseconds_a_bone(), 1) + " ns an update, by prediction.";
    context.widgets.tooltip(bone.name.c_str(), {.what = what.c_str()}, "");
  }
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const bool dragged = drag && !drag->border && drag->from == place;
  if (dragged) draw.AddRectFilled(row.from, row.to, ImGui::GetColorU32(colour::accent_soft));
  draw_bone(theme, row, bone, place, level_count(context.report));
  if (!drag || drag->over != place || dragged) return;
  const bool above = !drag->border && place < drag->from;
  const float y = above ? row.from.y : row.to.y;
  draw.AddLine({row.from.x, y}, {row.to.x, y}, ImGui::GetColorU32(colour::accent), theme.px(2));
}

void show_border(const TabContext& context, int level, std::size_t bones) {
  std::optional<BoneListMemory::Drag>& drag = context.memory.bones.drag;
  const Theme& theme = context.widgets.theme();
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const Area row{.from = from, .to = {from.x + ImGui::GetContentRegionAvail().x, from.y + theme.px(border_height)}};
  context.widgets.clickable("Border " + std::to_string(level), row);
  move_border_by_keys(context, level, bones);
  if (ImGui::IsItemHovered()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeNS);
  if (ImGui::IsItemActivated()) drag = {.from = static_cast<std::size_t>(level), .border = true, .over = bones - 1};
  const ImU32 ink = ImGui::GetColorU32(colour::bone_level(level));
  const std::string words = "level " + std::to_string(level) + " keeps the " + std::to_string(bones) + " above";
  const float width = text_width(theme.small, words);
  const float middle = from.y + theme.px(8);
  draw_text(theme.small, {from.x + theme.px(32), from.y}, colour::text, words);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddLine({from.x, middle}, {from.x + theme.px(26), middle}, ink);
  draw.AddLine({from.x + width + theme.px(40), middle}, {row.to.x, middle}, ink);
}

void finish_drag(const TabContext& context) {
  std::optional<BoneListMemory::Drag>& drag = context.memory.bones.drag;
  if (!drag) return;
  scroll_with_drag();
  if (ImGui::IsMouseDown(ImGuiMouseButton_Left)) return;
  const BoneListMemory::Drag done = *std::exchange(drag, std::nullopt);
  if (done.over >= context.report.bones.size()) return;
  const BoneLodChoice now = present_bone_lod(context.report.bones.size(), context.report.level_bone_counts);
  change(context, done.border ? with_border_moved(now, done.from, static_cast<int>(done.over) + 1)
                              : with_bone_moved(parents_of(context.report), now, done.from, done.over));
}

}  // namespace

BoneLodChoice with_border_moved(BoneLodChoice choice, std::size_t level, int bones) {
  std::vector<int>& counts = choice.level_counts;
  const auto last = static_cast<int>(counts.size()) - 1, moved = static_cast<int>(level);
  counts[level] = std::clamp(bones, 1 + last - moved, counts.front() - moved);
  for (std::size_t i = level; i-- > 1;) counts[i] = std::max(counts[i], counts[i + 1] + 1);
  for (std::size_t i = level + 1; i < counts.size(); ++i) counts[i] = std::min(counts[i], counts[i - 1] - 1);
  return choice;
}

void show_bone_list(const TabContext& context) {
  const auto& [widgets, report, tuning, standard, requests, memory] = context;
  widgets.section("Bones, the most visible first");
  widgets.text("Search", memory.bones.search, "part of a name",
               {.what = "Shows the bones whose names have it. While it is empty, bones can be dragged."});
  show_bone_buttons(context);
  const float height = std::max(widgets.theme().px(least_height), ImGui::GetContentRegionAvail().y);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
  ImGui::PushStyleColor(ImGuiCol_ChildBg, colour::well);
  ImGui::BeginChild("Bone list", {0, height});
  const ImVec2 from = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  widgets.record("Bone list", {.from = from, .to = {from.x + size.x, from.y + size.y}});
  for (std::size_t i = 0; i < report.bones.size(); ++i) {
    if (has_letters(report.bones[i].name, memory.bones.search)) show_bone(context, i);
    const int below = i + 1 < report.bones.size() ? report.bones[i + 1].lod.level : 0;
    for (int level = std::min<int>(report.bones[i].lod.level, 3); level > below; --level) {
      show_border(context, level, i + 1);
    }
  }
  finish_drag(context);
  ImGui::EndChild();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
}

}  // namespace throng::app
