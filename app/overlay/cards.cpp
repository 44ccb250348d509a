#include "app/overlay/cards.h"

#include <optional>

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include "app/view/fly_camera.h"

namespace throng::app {
namespace {

std::optional<ImVec2> on_screen(const glm::mat4& view_projection, const HeadFigures& head, ImVec2 size) {
  const glm::vec4 clip = view_projection * glm::vec4(head.x, head.y, head.z, 1.0F);
  if (clip.w <= render::Camera::near_distance) return std::nullopt;
  return ImVec2((clip.x / clip.w * 0.5F + 0.5F) * size.x, (0.5F - clip.y / clip.w * 0.5F) * size.y);
}

std::string words_above(const HeadFigures& head) {
  const std::string interval = std::to_string(head.interval);
  return head.bone_level == 0 ? interval : interval + " L" + std::to_string(head.bone_level);
}

void draw_label(const Theme& theme, ImVec2 at, const HeadFigures& head) {
  const std::string words = words_above(head);
  const float width = text_width(theme.small, words), left = at.x - width / 2, top = at.y - theme.small->FontSize;
  const ImVec2 from(left - theme.px(4), top - theme.px(1)), to(left + width + theme.px(4), at.y + theme.px(1));
  ImGui::GetWindowDrawList()->AddRectFilled(from, to, colour::panel, theme.px(3));
  draw_text(theme.small, {left, top}, colour::interval(head.interval), words);
}

/// Begins a window that lets the pointer through, for words over the crowd.
void begin_clear_window(const char* name, const Area& place) {
  ImGui::SetNextWindowPos(place.from);
  ImGui::SetNextWindowSize({place.width(), place.height()});
  ImGui::Begin(name, nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoBackground |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus);
}

}  // namespace

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

void show_head_labels(Widgets& widgets, const Area& crowd, const FrameReport& report) {
  if (report.heads.empty()) return;
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  const render::CameraView view = render::view_of(camera_at(report.camera), size.x / size.y);
  const glm::mat4 view_projection = view.projection * view.view;
  begin_clear_window("Heads", crowd);
  widgets.record("Heads", crowd);
  for (const HeadFigures& head : report.heads) {
    if (const auto at = on_screen(view_projection, head, size)) draw_label(widgets.theme(), *at, head);
  }
  ImGui::End();
}

}  // namespace throng::app
