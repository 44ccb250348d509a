#include "app/window/panel/controls/card.h"

#include <algorithm>
#include <string>

#include <imgui_internal.h>

namespace throng::app {
namespace {

constexpr float least_card_height = 70;  // a window so small that a fifth of it shows nothing keeps one line

float title_bar_height(const Theme& theme) { return font_height(theme.strong) + 2 * ImGui::GetStyle().FramePadding.y; }

ImVec2 inside_of(const Area& crowd, ImVec2 at, ImVec2 size) {
  return {std::clamp(at.x, crowd.from.x, std::max(crowd.from.x, crowd.to.x - size.x)),
          std::clamp(at.y, crowd.from.y, std::max(crowd.from.y, crowd.to.y - size.y))};
}

/// Notes the parts of its title. Returns whether the keyboard closes it; it folds it here.
bool record_card(Widgets& widgets, const std::string& name, const ImGuiWindow& window) {
  const ImRect title = window.TitleBarRect();
  const float button = title.GetHeight();
  const Area fold{.from = title.Min, .to = {title.Min.x + button, title.Max.y}};
  const Area close{.from = {title.Max.x - button, title.Min.y}, .to = title.Max};
  widgets.record_whole(name + ".fold", fold, true);
  widgets.record_whole(name + ".close", close, true);
  if (widgets.stop(name + ".fold", fold).take_activation()) ImGui::SetWindowCollapsed(!window.Collapsed);
  widgets.record_whole(name + ".title",
                       {.from = {title.Min.x + button, title.Min.y}, .to = {title.Max.x - button, title.Max.y}});
  const Area all{.from = window.Pos, .to = {window.Pos.x + window.Size.x, window.Pos.y + window.Size.y}};
  widgets.record_whole(name, all);
  widgets.cover(all);
  return widgets.stop(name + ".close", close).take_activation();
}

}  // namespace

Card::Card(Widgets& widgets, const char* name, const Area& crowd, const Layout& layout) {
  const Theme& theme = widgets.theme();
  const float width = std::min(layout.size.x, crowd.width() - theme.px(24));
  const float height = std::min(layout.size.y, most_height(theme, crowd, width, layout.most));
  const ImVec2 size(width, height + title_bar_height(theme));
  ImGui::SetNextWindowPos(inside_of(crowd, layout.at, size), ImGuiCond_FirstUseEver);
  ImGui::SetNextWindowSize(size);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, theme.px(8));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
  const ImVec2 spacing = ImGui::GetStyle().ItemInnerSpacing;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemInnerSpacing, {imgui::spacing_of_title(spacing.x), spacing.y});
  ImFont* const font = ImGui::GetFont();
  imgui::set_font(theme.strong);
  is_unfolded_ = ImGui::Begin(((layout.title.empty() ? name : layout.title) + "###" + name).c_str(), &stays_open_,
                              ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav |
                                  ImGuiWindowFlags_NoFocusOnAppearing);
  imgui::set_font(font);
  ImGui::PopStyleVar(3);
  const ImGuiWindow& window = *ImGui::GetCurrentWindow();
  const ImVec2 kept = inside_of(crowd, window.Pos, window.Size);
  if (kept.x != window.Pos.x || kept.y != window.Pos.y) ImGui::SetWindowPos(kept);
  if (record_card(widgets, name, window)) stays_open_ = false;
  const ImVec2 from = ImGui::GetCursorScreenPos();
  ImGui::Dummy({1, layout.size.y});  // which says how far it scrolls
  ImGui::SetCursorScreenPos(from);
  content_ = {.from = from, .to = {from.x + ImGui::GetContentRegionAvail().x, from.y + layout.size.y}};
}

Card::~Card() { ImGui::End(); }

float Card::most_height(const Theme& theme, const Area& crowd, float width, float most) {
  const float by_area = std::floor(most * crowd.width() * crowd.height() / std::max(width, 1.0F));
  const float with_title = std::min(by_area, crowd.height());
  return std::max(with_title - title_bar_height(theme), theme.px(least_card_height));
}

}  // namespace throng::app
