#include "app/overlay/cards.h"

namespace throng::app {

void begin_fixed_window(const char* name, const Area& place, float rounding, ImGuiWindowFlags more_flags) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, rounding);
  ImGui::SetNextWindowPos(place.from);
  ImGui::SetNextWindowSize({place.width(), place.height()});
  ImGui::Begin(name, nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoBringToFrontOnFocus |
                   ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_NoFocusOnAppearing | more_flags);
  ImGui::PopStyleVar();
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
