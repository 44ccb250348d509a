#pragma once

#include <string>

#include "app/show/report/frame_report.h"
#include "app/show/request/requests.h"
#include "app/window/panel/controls/widgets.h"

namespace throng::app {

/// The reason why an agent cannot be pushed over.
inline constexpr const char* cannot_fall = "it has fallen already, or its body is not known well enough";

/// Shows the strip below the crowd: the cost of the last frame, and of the frames before it. A click at one of these
/// looks at it.
void show_frame_strip(Widgets& widgets, const Area& place, const FrameReport& report, Requests& requests);

/// Shows the keys and explains every word of the panel, or only the entries with the letters of `searched`, which the
/// edits there. Returns whether the person closed the card.
bool show_help_card(Widgets& widgets, const Area& crowd, std::string& searched);

/// Shows the messages so far, the newest first. Returns whether the person closed the card.
bool show_log_card(Widgets& widgets, const Area& crowd, const Messages& messages);

/// Shows what the selected agent, which there is, does, and the end of the graph of entities that makes its pose, as
/// far as there is room; of a person of a recorded crowd, speed and steps over time. The card begins in the upper left
/// of `place`, where there is mostly sky. Closing it deselects the agent.
void show_selection_card(Widgets& widgets, const Area& place, const FrameReport& report, Requests& requests);

/// Shows the button *View*, which asks for the selected agent's character alone, in the clip that it plays. `name`
/// tells it apart in the map.
void show_view_button(Widgets& widgets, const std::string& name, float width, Requests& requests);

/// Returns the way in which an agent is pushed that is seen from a camera.
glm::vec3 ahead_of(const CameraPose& camera);

/// Returns the seconds of a player in its clip, such as "0.42 / 1.03"; nothing for other entities.
std::string place_in_clip(const EntityRow& row);

/// Begins a window of the overlay that stays in its place; end it with ImGui::End().
void begin_fixed_window(const char* name, const Area& place, float rounding = 0, ImGuiWindowFlags more_flags = 0);

/// Begins a bar of that height at the foot of the crowd; end it with ImGui::End(). Returns its place.
Area begin_bar(Widgets& widgets, const char* name, const Area& crowd, float height);

/// Begins a window that lets the pointer through, for words over the crowd; end it with ImGui::End().
void begin_clear_window(const char* name, const Area& place);

}  // namespace throng::app
