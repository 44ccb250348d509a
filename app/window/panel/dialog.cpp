#include "app/window/panel/dialog.h"

#include <algorithm>
#include <cmath>

namespace throng::app {
namespace {

constexpr float dialog_margin = 18, dialog_title = 34, dialog_foot = 26;
constexpr ImU32 shade_below = IM_COL32(0, 0, 0, 120);  // over all that takes no click now

Area middle_of_screen(const Theme& theme, ImVec2 size) {
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const ImVec2 fits(std::min(theme.px(size.x), screen.x - theme.px(16)),
                    std::min(theme.px(size.y), screen.y - theme.px(16)));
  const ImVec2 from(std::floor((screen.x - fits.x) / 2), std::floor((screen.y - fits.y) / 2));
  return {.from = from, .to = {from.x + fits.x, from.y + fits.y}};
}

}  // namespace

Dialog::Dialog(Widgets& widgets, const char* title, ImVec2 size) : theme_(widgets.theme()) {
  // One window over everything takes the clicks beside the card.
  ImGui::SetNextWindowPos({0, 0});
  ImGui::SetNextWindowSize(ImGui::GetIO().DisplaySize);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
  ImGui::Begin(title, nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoBackground);
  ImGui::PopStyleVar();
  if (!ImGui::IsWindowFocused(ImGuiFocusedFlags_RootAndChildWindows)) ImGui::SetWindowFocus();
  const Area card = middle_of_screen(theme_, size);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled({0, 0}, ImGui::GetIO().DisplaySize, shade_below);
  draw.AddRectFilled(card.from, card.to, colour::panel | IM_COL32_A_MASK, theme_.px(8));
  draw.AddRect(card.from, card.to, colour::accent_soft, theme_.px(8));
  const float margin = theme_.px(dialog_margin);
  draw_text(theme_.strong, {card.from.x + margin, card.from.y + theme_.px(14)}, colour::text, title);
  widgets.record_whole(title, card);
  content_ = {.from = {card.from.x + margin, card.from.y + theme_.px(14 + dialog_title)},
              .to = {card.to.x - margin, card.to.y - theme_.px(14)}};
}

Dialog::~Dialog() { ImGui::End(); }

Area Dialog::foot() const {
  return {.from = {content_.from.x, content_.to.y - theme_.px(dialog_foot)}, .to = content_.to};
}

}  // namespace throng::app
