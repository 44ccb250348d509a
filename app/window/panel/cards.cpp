#include "app/window/panel/cards.h"

namespace throng::app {

void begin_fixed_window(const char* name, const Area& place, float rounding, ImGuiWindowFlags more_flags) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, rounding);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1, 1));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));  // ImGui before 1.92 clips in its middle
  ImGui::SetNextWindowPos(place.from);
  ImGui::SetNextWindowSize({place.width(), place.height()});
  ImGui::Begin(name, nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoBringToFrontOnFocus |
                   ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_NoFocusOnAppearing | more_flags);
  ImGui::PopStyleVar(3);
}

Area begin_bar(Widgets& widgets, const char* name, const Area& crowd, float height) {
  const Theme& theme = widgets.theme();
  const Area place{.from = {crowd.from.x + theme.px(bar_margin), crowd.to.y - theme.px(bar_margin + height)},
                   .to = {crowd.to.x - theme.px(bar_margin), crowd.to.y - theme.px(bar_margin)}};
  begin_fixed_window(name, place, theme.px(10));
  widgets.record(name, place);
  widgets.cover(place);
  return place;
}

void begin_clear_window(const char* name, const Area& place) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
  ImGui::SetNextWindowPos(place.from);
  ImGui::SetNextWindowSize({place.width(), place.height()});
  ImGui::Begin(name, nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoBackground |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus);
  ImGui::PopStyleVar();
}

}  // namespace throng::app
